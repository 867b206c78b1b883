//! The papers' tables and figures by their numbers, each with what we have for it.

use serde::Serialize;

use super::parts::{Parts, PictureFile};
use super::picture::PictureView;
use super::table::{TableView, id_of};
use crate::algorithms::AlgorithmFacts;
use crate::paper::{Paper, Table};
use crate::pictures::Subject;
use crate::report::plots::{Counterpart, Plot};
use crate::report::tables::ReportTable;

/// A paper with its tables and figures.
#[derive(Serialize)]
pub struct PaperSection<'a> {
    id: &'static str,
    name: &'static str,
    citations: &'static [&'static str],
    entries: Vec<Entry<'a>>,
}

/// A table or figure.
#[derive(Serialize)]
struct Entry<'a> {
    id: String,
    name: String,
    heading: String,
    /// A sentence if there is nothing.
    empty: Option<&'static str>,
    table: Option<TableView>,
    plots: Vec<&'a Plot>,
    pictures: Vec<PictureView>,
}

/// Figures of the comparison paper that are pictures of quads, with their algorithms.
const QUADS: [(&str, &str); 4] = [("5.11", "sg"), ("5.12", "ps"), ("5.13", "ds"), ("5.14", "lrs")];

/// Makes a section for each paper: every table, and the figures that show results.
pub fn papers<'a>(parts: &Parts<'a>) -> Vec<PaperSection<'a>> {
    let mut comparison = tables(parts, Paper::Comparison);
    for (number, algorithm) in QUADS {
        let label = AlgorithmFacts::named(algorithm).map_or(algorithm, |facts| facts.label);
        let own = pictures(parts, |picture| picture.record.algorithm == algorithm);
        comparison.push(figure(number, &format!("quads made by {label}"), Vec::new(), own));
    }
    let mut irreducible = tables(parts, Paper::Irreducible);
    let of_box = pictures(parts, |picture| picture.record.subject == Subject::Box);
    irreducible.push(figure("14", "the box with 3,844 cavities", Vec::new(), of_box));
    for (number, group) in [(15, "first"), (16, "second"), (17, "third"), (18, "fourth")] {
        let heading = format!("times of RS, S and BF on the {group} group");
        let own = plots(parts, Counterpart::Figure(number));
        irreducible.push(figure(&number.to_string(), &heading, own, Vec::new()));
    }
    let section = |paper: Paper, name, entries| PaperSection {
        id: paper.experiment(),
        name,
        citations: paper.citations(),
        entries,
    };
    vec![
        section(Paper::Comparison, "Comparison paper", comparison),
        section(Paper::Irreducible, "Paper on irreducible triangulations", irreducible),
    ]
}

/// Makes the entries of a paper's tables; one without runs has a sentence instead.
fn tables<'a>(parts: &Parts<'a>, paper: Paper) -> Vec<Entry<'a>> {
    let has_runs =
        |ours: &ReportTable| ours.rows.iter().any(|row| parts.summary.has_mesh(paper, &row.mesh));
    let entry = |table: Table| {
        let name = format!("Table {}", table.number);
        let ours = parts.tables.iter().find(|ours| ours.paper == Some(table));
        let ours = ours.filter(|&ours| has_runs(ours));
        Entry {
            id: id_of(table.file),
            heading: format!("{name}: {}", table.title),
            name,
            empty: ours.is_none().then_some("No run is recorded for this table."),
            table: ours.map(|table| TableView::new(table, parts.summary)),
            plots: plots(parts, Counterpart::Table(table)),
            pictures: Vec::new(),
        }
    };
    Table::ALL.into_iter().filter(|table| table.paper == paper).map(entry).collect()
}

fn figure<'a>(
    number: &str,
    heading: &str,
    plots: Vec<&'a Plot>,
    pictures: Vec<PictureView>,
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

fn plots<'a>(parts: &Parts<'a>, of: Counterpart) -> Vec<&'a Plot> {
    parts.plots.iter().filter(|plot| plot.counterpart == of).collect()
}

fn pictures(parts: &Parts, test: impl Fn(&PictureFile) -> bool) -> Vec<PictureView> {
    parts.pictures.iter().filter(|picture| test(picture)).filter_map(PictureView::new).collect()
}

/// Returns the plots that are no counterpart of anything.
pub fn other_plots<'a>(parts: &Parts<'a>) -> Vec<&'a Plot> {
    plots(parts, Counterpart::Nothing)
}

/// Returns the pictures of algorithms that the paper does not show.
pub fn other_pictures(parts: &Parts) -> Vec<PictureView> {
    let shown = |algorithm: &str| QUADS.iter().any(|quads| quads.1 == algorithm);
    pictures(parts, |PictureFile { record, .. }| {
        record.subject == Subject::Quads && !shown(&record.algorithm)
    })
}

/// Returns the tables that the papers do not have.
pub fn other_tables(parts: &Parts) -> Vec<TableView> {
    let ours = parts.tables.iter().filter(|table| table.paper.is_none() && !table.rows.is_empty());
    ours.map(|table| TableView::new(table, parts.summary)).collect()
}
