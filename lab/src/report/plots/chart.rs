//! What a plot shows, before it is drawn: axes, series of points, bars.

use super::axis::{Axis, Spread};
use crate::report::fit::PowerLaw;
use crate::report::number::significant;
use crate::report::summary::Cell;

/// A plot before it is drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// Over the plot; also what it is called.
    pub title: String,
    /// Quantity and unit along the bottom.
    pub x_name: String,
    /// Quantity and unit along the side; empty for rows.
    pub y_name: String,
    /// How x is spread.
    pub x_spread: Spread,
    /// How y is spread.
    pub y_spread: Spread,
    /// Names of the rows if y is spread in rows.
    pub rows: Vec<String>,
    /// Points.
    pub series: Vec<Series>,
    /// Bars, in rows.
    pub bars: Vec<Bar>,
    /// A value of x at which a line is drawn, and what lies on either side of it.
    pub line: Option<(f64, [String; 2])>,
    /// What has to be known to read the plot; written below it.
    pub notes: Vec<String>,
}

/// Points that belong together.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Written beside it.
    pub name: String,
    /// How it looks.
    pub look: Look,
    /// In the order in which they are joined.
    pub points: Vec<Point>,
    /// Whether lines join them.
    pub joined: bool,
    /// The power law through them.
    pub fit: Option<PowerLaw>,
}

/// A mean over the runs of a cell.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// Name of the mesh.
    pub mesh: String,
    /// `real`, `generated`, `simplified` or `stand-in`.
    pub mesh_kind: String,
    /// Along the bottom.
    pub x: f64,
    /// Along the side; a row's number, from 0.
    pub y: f64,
    /// Least and greatest of the runs, along the side, where that is shown.
    pub range: Option<(f64, f64)>,
    /// Whether the augmentation was stopped and its time extrapolated.
    pub extrapolated: bool,
}

/// A part of a row.
#[derive(Clone, Debug, PartialEq)]
pub struct Bar {
    /// The row, from 0.
    pub row: usize,
    /// Name of the mesh.
    pub mesh: String,
    /// `real`, `generated`, `simplified` or `stand-in`.
    pub mesh_kind: String,
    /// What is shown, as in tables.
    pub label: String,
    /// Seconds of the pairing, and of pairing and augmentation; none if no run ended well.
    pub parts: Option<[f64; 2]>,
    /// Written to the right of it.
    pub text: String,
    /// Whether the augmentation was stopped and its time extrapolated.
    pub extrapolated: bool,
    /// The paper's total in seconds.
    pub paper: Option<f64>,
}

/// Mark of a point; each is told from the others without its colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// A disc.
    Circle,
    /// A square on its side.
    Square,
    /// A triangle on its side.
    Up,
    /// A triangle on its tip.
    Down,
    /// A square on its tip.
    Diamond,
    /// Two strokes.
    Cross,
}

/// Colour and mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Look {
    /// Of Okabe and Ito's palette, which no common colour blindness confounds.
    pub colour: [u8; 3],
    /// Of every point.
    pub mark: Mark,
}

/// Okabe and Ito's palette (*Color Universal Design*, 2008), without its yellow, which is hardly
/// seen on white.
pub const ORANGE: [u8; 3] = [230, 159, 0];
/// Of the same palette.
pub const SKY: [u8; 3] = [86, 180, 233];
/// Of the same palette.
pub const GREEN: [u8; 3] = [0, 158, 115];
/// Of the same palette.
pub const BLUE: [u8; 3] = [0, 114, 178];
/// Of the same palette.
pub const VERMILION: [u8; 3] = [213, 94, 0];
/// Of the same palette.
pub const PURPLE: [u8; 3] = [204, 121, 167];
/// For the papers' own numbers.
pub const GREY: [u8; 3] = [110, 110, 110];

/// How an algorithm looks in every plot.
pub fn look_of(algorithm: &str, variant: Option<&str>) -> Look {
    let (colour, mark) = match (algorithm, variant) {
        ("sg", _) => (ORANGE, Mark::Circle),
        ("ps" | "rs", _) => (BLUE, Mark::Square),
        ("ds" | "brute-force", _) => (GREEN, Mark::Up),
        ("lrs", Some("few-flips")) => (PURPLE, Mark::Cross),
        ("lrs" | "schipper", _) => (VERMILION, Mark::Diamond),
        ("gw", _) => (SKY, Mark::Down),
        _ => (GREY, Mark::Circle),
    };
    Look { colour, mark }
}

impl Chart {
    /// The axes that show everything.
    pub fn axes(&self) -> (Axis, Axis) {
        let points = || self.series.iter().flat_map(|series| &series.points);
        let of_bars =
            self.bars.iter().flat_map(|bar| bar.parts.into_iter().flatten().chain(bar.paper));
        // What lies on either side of the line needs room to be named.
        let line = self.line.iter().flat_map(|line| [0.4 * line.0, 2.5 * line.0]);
        let x = Axis::of(self.x_spread, points().map(|point| point.x).chain(of_bars).chain(line));
        if self.y_spread == Spread::Rows {
            return (x, Axis::rows(&self.rows));
        }
        let ranges = points().filter_map(|point| point.range).flat_map(|(low, high)| [low, high]);
        (x, Axis::of(self.y_spread, points().map(|point| point.y).chain(ranges)))
    }

    /// Whether there is nothing to be drawn.
    pub fn is_empty(&self) -> bool {
        self.series.iter().all(|series| series.points.is_empty()) && self.bars.is_empty()
    }

    /// The numbers shown, as comma-separated values.
    pub fn csv(&self) -> String {
        let mut writer = csv::Writer::from_writer(Vec::new());
        let write = "memory takes everything";
        if self.bars.is_empty() {
            writer.write_record(self.point_header()).expect(write);
            for series in &self.series {
                for point in &series.points {
                    writer.write_record(self.point_row(series, point)).expect(write);
                }
            }
        } else {
            writer.write_record(BAR_HEADER).expect(write);
            for bar in &self.bars {
                writer.write_record(bar_row(bar)).expect(write);
            }
        }
        String::from_utf8(writer.into_inner().expect(write)).expect("made of strings")
    }

    fn point_header(&self) -> Vec<&str> {
        let y: &[&str] = if self.y_spread == Spread::Rows {
            &["row"]
        } else {
            &[&self.y_name, "minimum", "maximum", "exponent", "exponent_low", "exponent_high"]
        };
        let mut names = vec!["series", "mesh", "mesh_kind", "extrapolated", self.x_name.as_str()];
        names.extend(y);
        names
    }

    fn point_row(&self, series: &Series, point: &Point) -> Vec<String> {
        let yes = |yes: bool| if yes { "yes".to_owned() } else { String::new() };
        let or_empty = |value: Option<f64>| value.map(significant).unwrap_or_default();
        let mut row = vec![series.name.clone(), point.mesh.clone(), point.mesh_kind.clone()];
        row.extend([yes(point.extrapolated), format!("{}", point.x)]);
        if self.y_spread == Spread::Rows {
            row.push(self.rows.get(point.y as usize).cloned().unwrap_or_default());
            return row;
        }
        row.push(format!("{}", point.y));
        let range = point
            .range
            .map_or(["".into(), "".into()], |(low, high)| [format!("{low}"), format!("{high}")]);
        row.extend(range);
        let interval = series.fit.and_then(|fit| fit.interval);
        row.push(or_empty(series.fit.map(|fit| fit.exponent)));
        row.extend([or_empty(interval.map(|i| i.0)), or_empty(interval.map(|i| i.1))]);
        row
    }
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
    let or_empty = |value: Option<f64>| value.map(|value| format!("{value}")).unwrap_or_default();
    [
        bar.mesh.clone(),
        bar.mesh_kind.clone(),
        bar.label.clone(),
        or_empty(bar.parts.map(|parts| parts[0])),
        or_empty(bar.parts.map(|parts| parts[1])),
        if bar.extrapolated { "yes".into() } else { String::new() },
        or_empty(bar.paper),
        bar.text.clone(),
    ]
}

/// What must be known of these cells to read a plot of them; short, for it stands in the plot.
pub fn notes<'a>(cells: impl Iterator<Item = &'a Cell> + Clone) -> Vec<String> {
    let any = |test: fn(&Cell) -> bool| cells.clone().any(test);
    let mut notes = Vec::new();
    for scale in ["small", "demo"] {
        if cells.clone().any(|cell| cell.scale == scale) {
            notes.push(format!("scale {scale}: meshes smaller than the paper's of these names"));
        }
    }
    let told = [
        (
            any(Cell::is_stand_in),
            "hollow or hatched, † : a stand-in for the paper's scan, of other shape",
        ),
        (any(Cell::is_extrapolated), "* : extrapolated from a part of the augmenting paths"),
        (any(Cell::is_parallel), "runs went on side by side: times are not ranked"),
    ];
    notes.extend(told.iter().filter(|told| told.0).map(|told| told.1.to_owned()));
    notes
}
