//! Plots of records: counterparts of the second paper's Figures 15 to 18, of the first one's tables,
//! and of what neither shows.
//!
//! A chart says what is shown, `draw` draws it with `plotters`; the text is set in a font
//! that is part of the program, so that nothing of the system is needed and each byte is the same
//! everywhere.

mod against;
mod axis;
mod chart;
mod draw;
mod growth;
mod render;
mod sheet;
mod stacks;

use chart::Chart;
use serde::Serialize;

use super::summary::Summary;

/// A plot, ready to be written.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Plot {
    /// Number of the figure or table of the papers whose counterpart it is, such as `Figure 15`;
    /// empty if it has none.
    pub figure: String,
    /// What is shown.
    pub title: String,
    /// How to read it.
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

/// What a plot is called and what is said of it.
struct Words {
    figure: &'static str,
    stem: String,
    caption: String,
}

/// Every plot that there is something for. O(cells²), and O(pixels) for each.
pub fn all(summary: &Summary) -> Vec<Plot> {
    charts(summary).map(plot).collect()
}

/// The plot whose files have that name, if there is something for it.
pub fn named(summary: &Summary, stem: &str) -> Option<Plot> {
    charts(summary).find(|(words, _)| words.stem == stem).map(plot)
}

fn charts(summary: &Summary) -> impl Iterator<Item = (Words, Chart)> {
    let charts = [growth::figures(summary), stacks::all(summary), against::all(summary)];
    let charts = charts.into_iter().flatten().chain(growth::totals(summary));
    charts.filter(|(_, chart)| !chart.is_empty())
}

fn plot((words, chart): (Words, Chart)) -> Plot {
    Plot {
        figure: words.figure.into(),
        title: chart.title.clone(),
        caption: words.caption,
        stem: words.stem,
        svg: render::svg(&chart),
        png: render::png(&chart),
        csv: chart.csv(),
    }
}
