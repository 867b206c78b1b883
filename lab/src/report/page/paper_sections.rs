//! The papers' tables and figures by their numbers, each with what we have for it.

use serde::Serialize;

use super::parts::{Parts, PictureFile};
use super::picture::PictureView;

use super::table::{TableView, id_of};
use super::topic::Topic;
use crate::algorithms::AlgorithmFacts;
use crate::paper::{Paper, Table};
use crate::pictures::Subject;
use crate::report::plots::{Counterpart, Plot};
use crate::report::tables::{AUGMENTATION, Column, ReportTable, Row};

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

/// Makes a section for each paper: every table, and the figures that show results. Beside own
/// results there are only those with content, and of tables only the meshes with runs.
pub fn papers<'a>(parts: &Parts<'a>, topic: &Topic) -> Vec<PaperSection<'a>> {
    let mut comparison = tables(parts, Paper::Comparison, topic);
    // Pictures of an own mesh are no counterpart of the papers' figures.
    let figures = if topic.is_own() { &[][..] } else { &QUADS };
    for (number, algorithm) in figures {
        let label = AlgorithmFacts::named(algorithm).map_or(*algorithm, |facts| facts.label);
        let own = pictures(parts, |picture| picture.record.algorithm == *algorithm);
        comparison.push(figure(number, &format!("quads made by {label}"), Vec::new(), own));
    }
    let mut irreducible = tables(parts, Paper::Irreducible, topic);
    let of_box =
        pictures(parts, |picture| picture.record.subject == Subject::Box && !topic.is_own());
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
    let mut papers = vec![
        section(Paper::Comparison, "Comparison paper", comparison),
        section(Paper::Irreducible, "Paper on irreducible triangulations", irreducible),
    ];
    if topic.is_own() {
        papers.iter_mut().for_each(|paper| paper.entries.retain(Entry::has_content));
        papers.retain(|paper| !paper.entries.is_empty());
    }
    papers
}

impl Entry<'_> {
    fn has_content(&self) -> bool {
        self.table.is_some() || !self.plots.is_empty() || !self.pictures.is_empty()
    }
}

/// Makes the entries of a paper's tables; one without runs has a sentence instead.
fn tables<'a>(parts: &Parts<'a>, paper: Paper, topic: &Topic) -> Vec<Entry<'a>> {
    let has_runs = |row: &Row| parts.summary.has_mesh(paper, &row.mesh);
    let view = |ours: &ReportTable| {
        let mut ours = ours.clone();
        if topic.is_own() {
            ours.rows.retain(has_runs);
        }
        TableView::new(&ours, parts.summary)
    };
    let entry = |table: Table| {
        let name = format!("Table {}", table.number);
        let ours = parts.tables.iter().find(|ours| ours.paper == Some(table));
        let ours = ours.filter(|ours| ours.rows.iter().any(has_runs));
        Entry {
            id: id_of(table.file),
            heading: format!("{name}: {}", table.title),
            name,
            empty: ours.is_none().then_some("No run is recorded for this table."),
            table: ours.map(view),
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

/// Returns the pictures of algorithms that the paper does not show; beside own results, of all.
pub fn other_pictures(parts: &Parts, topic: &Topic) -> Vec<PictureView> {
    let shown = |algorithm: &str| !topic.is_own() && QUADS.iter().any(|quads| quads.1 == algorithm);
    pictures(parts, |PictureFile { record, .. }| {
        record.subject == Subject::Quads && !shown(&record.algorithm)
    })
}

/// Returns the tables that the papers do not have.
pub fn other_tables(parts: &Parts) -> Vec<TableView> {
    views(&without_counterpart(parts), parts)
}

/// Returns the same in the order in which somebody looks for own results, without tables that have
/// nothing but sizes of meshes. That of augmentations comes last, and only if a row has both.
pub fn own_tables(parts: &Parts) -> Vec<TableView> {
    const FIRST: [&str; 2] = ["table_data.csv", "table_side_by_side.csv"];
    const SIZES: [&str; 4] = ["vertices", "triangles", "genus", "n"];
    let mut tables = without_counterpart(parts);
    let is_of_pairs = |table: &ReportTable| table.file == AUGMENTATION;
    tables.retain(|table| {
        let is_result = |(_, column): &(usize, &Column)| match is_of_pairs(table) {
            true => Some(*column) == table.columns.last(),
            false => !SIZES.contains(&column.name.as_str()),
        };
        let mut results = table.columns.iter().enumerate().filter(is_result);
        results.any(|(at, _)| table.rows.iter().any(|row| row.cells[at].ours.number().is_some()))
    });
    tables.sort_by_key(|table| {
        let place = FIRST.iter().position(|file| *file == table.file);
        (place.unwrap_or(FIRST.len()), is_of_pairs(table))
    });
    let mut views = views(&tables, parts);
    for (view, table) in views.iter_mut().zip(tables) {
        view.rename(own_title(table));
    }
    views
}

/// Returns the title of a table without what it says of the papers and their edge flips.
fn own_title(table: &ReportTable) -> &'static str {
    match table.file {
        "table_quality.csv" => "Scaled Jacobian of the quads by algorithm",
        _ => table.title,
    }
}

fn without_counterpart<'a>(parts: &Parts<'a>) -> Vec<&'a ReportTable> {
    parts.tables.iter().filter(|table| table.paper.is_none() && !table.rows.is_empty()).collect()
}

fn views(tables: &[&ReportTable], parts: &Parts) -> Vec<TableView> {
    tables.iter().map(|table| TableView::new(table, parts.summary)).collect()
}
