//! A table as the page shows it: the paper's number under ours, and how they differ.

use serde::Serialize;

use super::provenance::commands_id;
use crate::meshes::Origin;
use crate::report::notes::Note;
use crate::report::number::significant;
use crate::report::statistics::Statistics;
use crate::report::summary::Summary;
use crate::report::tables::{ReportTable, Row, TableCell, Value};

/// Most columns of a table in letters of the usual size.
const NARROW: usize = 12;

/// A table.
#[derive(Clone, Serialize)]
pub struct TableView {
    id: String,
    name: String,
    title: &'static str,
    file: &'static str,
    columns: Vec<String>,
    /// True if it has so many columns that they must be narrow.
    wide: bool,
    rows: Vec<RowView>,
    notes: Vec<String>,
    commands: Option<String>,
}

#[derive(Clone, Serialize)]
struct RowView {
    /// True if it is the first of its mesh.
    first: bool,
    name: String,
    about: &'static str,
    cells: Vec<CellView>,
}

#[derive(Clone, Serialize)]
struct CellView {
    text: String,
    /// Quartiles of the runs whose mean is shown.
    quartiles: String,
    paper: String,
    difference: String,
    class: &'static str,
}

impl TableView {
    /// Prepares a table of `summary`.
    pub fn new(table: &ReportTable, summary: &Summary) -> Self {
        let name = table.paper.map_or("Table".into(), |paper| format!("Table {}", paper.number));
        let is_comparable = !table.notes.iter().any(|note| matches!(note, Note::Scale(_)));
        let shown = table.columns.iter().filter(|column| column.is_shown);
        let headings = shown.map(|column| column.heading.clone());
        let columns: Vec<String> = std::iter::once("mesh".to_owned()).chain(headings).collect();
        let before = std::iter::once(None).chain(table.rows.iter().map(|row| Some(&row.mesh)));
        let row = |(row, before): (&Row, Option<&String>)| RowView {
            first: before != Some(&row.mesh),
            name: format!("{}{}", row.mesh, row.origin.map_or("", Origin::dagger)),
            about: row.origin.map_or("", Origin::id),
            cells: table
                .columns
                .iter()
                .zip(&row.cells)
                .filter(|(column, _)| column.is_shown)
                .map(|(_, cell)| CellView::new(cell, is_comparable))
                .collect(),
        };
        Self {
            id: id_of(table.file),
            name,
            title: table.title,
            file: table.file,
            wide: columns.len() > NARROW,
            columns,
            rows: table.rows.iter().zip(before).map(row).collect(),
            notes: table.notes.iter().map(Note::sentence).chain(errata(table)).collect(),
            commands: match (table.group, table.paper) {
                (Some((paper, group)), _) => commands_id(summary, paper, group),
                (None, Some(_)) => None,
                (None, None) => Some("commands".into()),
            },
        }
    }

    /// Gives it another title.
    pub fn rename(&mut self, title: &'static str) {
        self.title = title;
    }
}

/// Returns where links to a table lead: `table-4-4-ii` for `table_4_4_ii.csv`.
pub fn id_of(file: &str) -> String {
    file.trim_end_matches(".csv").replace('_', "-")
}

/// Returns a sentence on each row of the paper that contradicts itself.
fn errata(table: &ReportTable) -> impl Iterator<Item = String> {
    table.rows.iter().filter(|row| !row.errata.is_empty()).map(|row| {
        let algorithm = row.cells.iter().find(|cell| matches!(cell.ours, Value::Algorithm(_)));
        let label = algorithm.map_or(String::new(), |cell| format!(" {}", cell.ours.display()));
        format!("The paper's row {}{label}: {}", row.mesh, row.errata)
    })
}

impl CellView {
    fn new(cell: &TableCell, is_comparable: bool) -> Self {
        let text = match shown(&cell.ours) {
            text if text.is_empty() => "–".into(),
            text if cell.is_extrapolated => format!("{text} *"),
            text => text,
        };
        let (difference, class) =
            if is_comparable { difference(cell) } else { (String::new(), "") };
        Self { text, quartiles: quartiles(cell), paper: shown(&cell.paper), difference, class }
    }
}

/// Returns a value without the digit of a mean that is a whole number.
fn shown(value: &Value) -> String {
    let text = value.display();
    match (value, text.strip_suffix(".0")) {
        (Value::Mean(_), Some(whole)) => whole.into(),
        _ => text,
    }
}

/// Returns the quartiles of the runs, where they differ.
fn quartiles(cell: &TableCell) -> String {
    let is_mean = matches!(cell.ours, Value::Seconds(_) | Value::Mean(_));
    let Some(found) = Statistics::from_values(&cell.sample).filter(|_| is_mean) else {
        return String::new();
    };
    if found.lower_quartile == found.upper_quartile {
        return String::new();
    }
    let bound = |value: f64| match cell.ours {
        Value::Mean(_) => shown(&Value::Mean(value)),
        _ => Value::Seconds(value).display(),
    };
    format!("{} to {}", bound(found.lower_quartile), bound(found.upper_quartile))
}

/// Returns how ours differs from the paper's, in words that need no colour.
fn difference(cell: &TableCell) -> (String, &'static str) {
    let (Some(ours), Some(paper)) = (cell.ours.number(), cell.paper.number()) else {
        return (String::new(), "");
    };
    // Those of another machine are shown, not compared.
    if matches!(cell.ours, Value::Seconds(_)) {
        return (String::new(), "");
    }
    // Equal to the digits printed.
    if cell.ours.field() == cell.paper.field() {
        return ("= equal".into(), "same");
    }
    if paper == 0.0 || ours == 0.0 {
        return ("≠".into(), "more");
    }
    let ratio = ours / paper;
    if (ratio - 1.0).abs() <= 0.05 {
        return (format!("≈ × {ratio:.3}"), "same");
    }
    let (arrow, class) = if ratio > 1.0 { ("▲", "more") } else { ("▼", "less") };
    (format!("{arrow} × {}", significant(ratio)), class)
}
