//! Content of a plot before it is drawn: words, axes, series of points, bars.

use super::axis::{Axis, Spread};
use crate::algorithms::Look;
use crate::csv_text;
use crate::meshes::Origin;
use crate::paper::Table;
use crate::report::notes::Note;
use crate::report::number::significant;
use crate::report::power_law::PowerLaw;
use crate::report::summary::Cell;

/// The part of the papers that a plot belongs to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Counterpart {
    /// Nothing.
    #[default]
    Nothing,
    /// The figure of that number in the paper on irreducible triangulations.
    Figure(u8),
    /// A table.
    Table(Table),
    /// The question whether LRS beats PS.
    LrsAgainstPs,
}

/// A plot before it is drawn.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chart {
    /// The part of the papers that it belongs to.
    pub counterpart: Counterpart,
    /// Name of its files, without the ending.
    pub stem: String,
    /// Advice for reading it.
    pub caption: String,
    /// Title over the plot.
    pub title: String,
    /// Quantity and unit along the bottom.
    pub x_name: String,
    /// Quantity and unit along the side; empty for rows.
    pub y_name: String,
    /// Spread of x.
    pub x_spread: Spread,
    /// Spread of y.
    pub y_spread: Spread,
    /// Names of the rows if y is spread in rows.
    pub rows: Vec<String>,
    /// Points.
    pub series: Vec<Series>,
    /// Bars, in rows.
    pub bars: Vec<Bar>,
    /// A value of x at which a line is drawn, and what lies on either side of it.
    pub line: Option<(f64, [&'static str; 2])>,
    /// Notes for reading the plot, written below it.
    pub notes: Vec<String>,
}

/// Points that belong together.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Written beside it.
    pub name: String,
    /// Colour and mark.
    pub look: Look,
    /// True if the numbers are the paper's.
    pub is_printed: bool,
    /// Points, in the order in which they are joined.
    pub points: Vec<Point>,
    /// True if lines join them.
    pub joined: bool,
    /// The power law through them.
    pub fit: Option<PowerLaw>,
}

/// A mean over the runs of a cell.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// Name of the mesh.
    pub mesh: String,
    /// Origin of the mesh.
    pub origin: Option<Origin>,
    /// Along the bottom.
    pub x: f64,
    /// Along the side; a row's number, from 0.
    pub y: f64,
    /// Least and greatest of the runs, along the side, where that is shown.
    pub range: Option<(f64, f64)>,
    /// True if the augmentation was stopped and its time extrapolated.
    pub extrapolated: bool,
}

/// A part of a row.
#[derive(Clone, Debug, PartialEq)]
pub struct Bar {
    /// The row, from 0.
    pub row: usize,
    /// Name of the mesh.
    pub mesh: String,
    /// Origin of the mesh.
    pub origin: Option<Origin>,
    /// The algorithm, as in tables.
    pub label: String,
    /// Seconds of the pairing, and of pairing and augmentation; none if no run ended well.
    pub parts: Option<[f64; 2]>,
    /// Written to the right of it.
    pub text: String,
    /// True if the augmentation was stopped and its time extrapolated.
    pub extrapolated: bool,
    /// The paper's total in seconds.
    pub paper: Option<f64>,
}

impl Chart {
    /// Returns the axes that show everything.
    pub fn axes(&self) -> (Axis, Axis) {
        let points = || self.series.iter().flat_map(|series| &series.points);
        let of_bars =
            self.bars.iter().flat_map(|bar| bar.parts.into_iter().flatten().chain(bar.paper));
        // What lies on either side of the line needs room to be named.
        let line = self.line.iter().flat_map(|line| [0.4 * line.0, 2.5 * line.0]);
        let x = Axis::new(self.x_spread, points().map(|point| point.x).chain(of_bars).chain(line));
        if self.y_spread == Spread::Rows {
            return (x, Axis::rows(&self.rows));
        }
        let ranges = points().filter_map(|point| point.range).flat_map(|(low, high)| [low, high]);
        (x, Axis::new(self.y_spread, points().map(|point| point.y).chain(ranges)))
    }

    /// Returns whether there is nothing to be drawn.
    pub fn is_empty(&self) -> bool {
        self.series.iter().all(|series| series.points.is_empty()) && self.bars.is_empty()
    }

    /// Returns the numbers shown, as comma-separated values.
    pub fn csv(&self) -> String {
        if !self.bars.is_empty() {
            let header = BAR_HEADER.map(str::to_owned);
            return csv_text::of_texts(
                std::iter::once(header).chain(self.bars.iter().map(bar_row)),
            );
        }
        let rows = self
            .series
            .iter()
            .flat_map(|series| series.points.iter().map(|point| self.point_row(series, point)));
        csv_text::of_texts(std::iter::once(self.point_header()).chain(rows))
    }

    fn point_header(&self) -> Vec<String> {
        let y: &[&str] = if self.y_spread == Spread::Rows {
            &["row"]
        } else {
            &[&self.y_name, "minimum", "maximum", "exponent", "exponent_low", "exponent_high"]
        };
        let names = ["series", "mesh", "mesh_kind", "extrapolated", self.x_name.as_str()];
        names.iter().chain(y).map(|&name| name.to_owned()).collect()
    }

    fn point_row(&self, series: &Series, point: &Point) -> Vec<String> {
        let kind = if series.is_printed { "printed" } else { point.origin.map_or("", Origin::id) };
        let mut row = vec![series.name.clone(), point.mesh.clone(), kind.into()];
        row.extend([yes(point.extrapolated), point.x.to_string()]);
        if self.y_spread == Spread::Rows {
            row.push(self.rows.get(point.y as usize).cloned().unwrap_or_default());
            return row;
        }
        row.push(point.y.to_string());
        row.extend(optional(point.range, |value| value.to_string()));
        row.push(series.fit.map(|fit| significant(fit.exponent)).unwrap_or_default());
        row.extend(optional(series.fit.and_then(|fit| fit.interval), significant));
        row
    }
}

fn yes(yes: bool) -> String {
    if yes { "yes".into() } else { String::new() }
}

fn optional(pair: Option<(f64, f64)>, write: fn(f64) -> String) -> [String; 2] {
    pair.map_or_else(Default::default, |(low, high)| [write(low), write(high)])
}

const BAR_HEADER: [&str; 8] = [
    "mesh",
    "mesh_kind",
    "algorithm",
    "pairing_seconds",
    "total_seconds",
    "extrapolated",
    "paper_total_seconds",
    "text",
];

fn bar_row(bar: &Bar) -> [String; 8] {
    let or_empty = |value: Option<f64>| value.map(|value| value.to_string()).unwrap_or_default();
    [
        bar.mesh.clone(),
        bar.origin.map_or("", Origin::id).into(),
        bar.label.clone(),
        or_empty(bar.parts.map(|parts| parts[0])),
        or_empty(bar.parts.map(|parts| parts[1])),
        yes(bar.extrapolated),
        or_empty(bar.paper),
        bar.text.clone(),
    ]
}

/// Returns what must be known of these cells to read a plot of them.
pub fn legends<'a>(cells: impl Iterator<Item = &'a Cell> + Clone) -> Vec<String> {
    Note::on(cells).iter().filter_map(Note::legend).collect()
}
