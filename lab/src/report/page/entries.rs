//! The papers' tables and figures by their numbers, each with what we have for it.

use serde::Serialize;

use super::figure::Figure;
use super::table::{View, id_of};
use super::{Parts, Pictured};
use crate::report::paper::{Paper, Table};
use crate::report::plots::Plot;

/// A paper with its tables and figures.
#[derive(Serialize)]
pub struct PaperPart<'a> {
    id: &'static str,
    name: &'static str,
    citation: &'static str,
    entries: Vec<Entry<'a>>,
}

/// A table or figure.
#[derive(Serialize)]
struct Entry<'a> {
    id: String,
    name: String,
    heading: String,
    /// What is said if there is nothing.
    empty: Option<&'static str>,
    table: Option<View>,
    plots: Vec<&'a Plot>,
    pictures: Vec<Figure>,
}

/// Figures of the comparison paper that are pictures of quads, with their algorithms.
const QUADS: [(&str, &str); 4] = [("5.11", "sg"), ("5.12", "ps"), ("5.13", "ds"), ("5.14", "lrs")];

/// Both papers, every table and the figures that show results.
pub fn papers<'a>(parts: &Parts<'a>) -> Vec<PaperPart<'a>> {
    let mut comparison = tables(parts, Paper::Comparison);
    for (number, algorithm) in QUADS {
        let heading = format!("quads made by {}", algorithm.to_uppercase());
        let own = pictures(parts, |p| p.shown.subject == "quads" && p.shown.algorithm == algorithm);
        comparison.push(figure(number, &heading, Vec::new(), own));
    }
    let mut irreducible = tables(parts, Paper::Irreducible);
    let of_box = pictures(parts, |picture| picture.shown.subject == "box");
    irreducible.push(figure("14", "the box with 3,844 cavities", Vec::new(), of_box));
    let figures = [
        ("15", "times of RS, S and BF on the first group"),
        ("16", "times of RS, S and BF on the second group"),
        ("17", "times of RS, S and BF on the third group"),
        ("18", "times of RS, S and BF on the fourth group"),
    ];
    for (number, heading) in figures {
        let name = format!("Figure {number}");
        let own = parts.plots.iter().filter(|plot| plot.figure == name).collect();
        irreducible.push(figure(number, heading, own, Vec::new()));
    }
    vec![
        PaperPart {
            id: "comparison",
            name: "Comparison paper",
            citation: Paper::Comparison.citation(),
            entries: comparison,
        },
        PaperPart {
            id: "irreducible",
            name: "Paper on irreducible triangulations",
            citation: Paper::Irreducible.citation(),
            entries: irreducible,
        },
    ]
}

/// The tables of a paper; one that we do not have is said to be missing.
fn tables<'a>(parts: &Parts<'a>, paper: Paper) -> Vec<Entry<'a>> {
    let of_paper = Table::ALL.into_iter().filter(|table| table.paper() == paper);
    let entry = |table: Table| {
        let name = format!("Table {}", table.number());
        let ours = parts.tables.iter().find(|ours| ours.number == table.number());
        let plots: Vec<&Plot> = parts.plots.iter().filter(|plot| plot.figure == name).collect();
        let has_runs = parts.summary.cells().iter().any(|cell| !cell.runs.is_empty());
        let id = ours.map_or_else(|| plain_id(table.file()), id_of);
        Entry {
            id,
            heading: format!("{name}: {}", table.title()),
            name,
            empty: (!has_runs || ours.is_none()).then_some("No run is recorded for this table."),
            table: ours.map(|table| View::of(table, parts.summary)),
            plots,
            pictures: Vec::new(),
        }
    };
    of_paper.map(entry).collect()
}

fn plain_id(file: &str) -> String {
    file.trim_end_matches(".csv").replace('_', "-")
}

fn figure<'a>(
    number: &str,
    heading: &str,
    plots: Vec<&'a Plot>,
    pictures: Vec<Figure>,
) -> Entry<'a> {
    let nothing = plots.is_empty() && pictures.is_empty();
    let name = format!("Figure {number}");
    Entry {
        id: format!("figure-{}", number.replace('.', "-")),
        heading: format!("{name}: {heading}"),
        name,
        empty: nothing.then_some("Nothing is recorded for this figure."),
        table: None,
        plots,
        pictures,
    }
}

fn pictures(parts: &Parts, test: impl Fn(&Pictured) -> bool) -> Vec<Figure> {
    parts.pictures.iter().filter(|picture| test(picture)).filter_map(Figure::of).collect()
}

/// Plots that are no counterpart of a figure or table, and do not stand elsewhere.
pub fn other_plots<'a>(parts: &Parts<'a>) -> Vec<&'a Plot> {
    let other = |plot: &&Plot| plot.figure.is_empty() && plot.stem != "lrs_against_ps";
    parts.plots.iter().filter(other).collect()
}

/// Pictures of algorithms that the paper does not show.
pub fn other_pictures(parts: &Parts) -> Vec<Figure> {
    let shown = |algorithm: &str| QUADS.iter().any(|quads| quads.1 == algorithm);
    pictures(parts, |picture| picture.shown.subject == "quads" && !shown(&picture.shown.algorithm))
}

/// Tables that the papers do not have.
pub fn other_tables(parts: &Parts) -> Vec<View> {
    let ours = parts.tables.iter().filter(|table| table.number.is_empty());
    ours.map(|table| View::of(table, parts.summary)).filter(|view| !view.is_empty()).collect()
}
