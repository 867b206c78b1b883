//! Plots of records: counterparts of the second paper's Figures 15 to 18, of the first one's
//! tables, and of what neither shows.
//!
//! A chart has the content, `draw` draws it with `plotters`. The text is set in a font that is part
//! of the program, so that nothing of the system is needed and each byte is the same everywhere.

mod axis;
mod canvas;
mod chart;
mod draw;
mod growth;
mod image_files;
mod ratios;
mod side_by_side;
mod time_bars;

use serde::Serialize;

pub use chart::Counterpart;

use chart::Chart;

use super::summary::Summary;

/// A plot, ready to be written.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Plot {
    /// The part of the papers that it belongs to.
    #[serde(skip)]
    pub counterpart: Counterpart,
    /// Its title.
    pub title: String,
    /// Advice for reading it.
    pub caption: String,
    /// Name of its files, without the ending.
    pub stem: String,
    /// As SVG.
    pub svg: String,
    /// As PNG.
    #[serde(skip)]
    pub png: Vec<u8>,
    /// The numbers shown.
    #[serde(skip)]
    pub csv: String,
}

/// Draws every plot that there is something for. O(cells²), and O(pixels) for each.
pub fn all(summary: &Summary) -> Vec<Plot> {
    charts(summary).map(Plot::from).collect()
}

/// Draws the plot whose files have that name, if there is something for it.
pub fn named(summary: &Summary, stem: &str) -> Option<Plot> {
    charts(summary).find(|chart| chart.stem == stem).map(Plot::from)
}

fn charts(summary: &Summary) -> impl Iterator<Item = Chart> {
    let charts = [growth::figures(summary), time_bars::all(summary), ratios::all(summary)];
    let charts = charts.into_iter().flatten().chain(growth::totals(summary));
    let charts = charts.chain(side_by_side::all(summary));
    charts.filter(|chart| !chart.is_empty())
}

impl From<Chart> for Plot {
    fn from(chart: Chart) -> Self {
        Self {
            svg: image_files::svg(&chart),
            png: image_files::png(&chart),
            csv: chart.csv(),
            counterpart: chart.counterpart,
            title: chart.title,
            caption: chart.caption,
            stem: chart.stem,
        }
    }
}
