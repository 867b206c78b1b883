//! A table of typed cells, ours and the paper's side by side, and its printer of comma-separated
//! values. The page prints the same table as HTML.

use crate::csv_text;
use crate::experiment::Job;
use crate::meshes::Origin;
use crate::paper::{Paper, Table};
use crate::report::notes::Note;
use crate::report::number::{grouped, quotient, seconds, significant};

/// A table, ready to be printed.
#[derive(Clone, Debug, PartialEq)]
pub struct ReportTable {
    /// The printed table that it mirrors; `None` for those of our own.
    pub paper: Option<Table>,
    /// The group of meshes in it, if there is one.
    pub group: Option<(Paper, &'static str)>,
    /// Its file in the results folder.
    pub file: &'static str,
    /// Its content in a few words.
    pub title: &'static str,
    /// Its columns, that of meshes excluded.
    pub columns: Vec<Column>,
    /// Its rows.
    pub rows: Vec<Row>,
    /// Notes for reading it.
    pub notes: Vec<Note>,
}

/// A column of a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    /// Name in the file, with the unit.
    pub name: String,
    /// Name on the page.
    pub heading: String,
    /// True if it is on the page; it is in the file anyway.
    pub is_shown: bool,
    /// The paper's counterpart.
    pub beside: Beside,
}

/// The paper's counterpart of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beside {
    /// Nothing.
    Nothing,
    /// Its numbers.
    Printed,
    /// Its numbers, and the file has the ratio of ours to these.
    PrintedAndRatio,
}

/// A row: a mesh, and a cell for each column.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Name of the mesh.
    pub mesh: String,
    /// Origin of the mesh, if it was run.
    pub origin: Option<Origin>,
    /// The cells, in the order of the columns.
    pub cells: Vec<TableCell>,
    /// The error in the paper's row, or empty.
    pub errata: String,
}

/// A cell of a row.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TableCell {
    /// Ours.
    pub ours: Value,
    /// The paper's.
    pub paper: Value,
    /// True if ours is extrapolated.
    pub is_extrapolated: bool,
    /// The numbers of the runs whose mean ours is; empty where it is no mean.
    pub sample: Vec<f64>,
}

/// A number with its unit, or a text.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Value {
    /// Nothing.
    #[default]
    Missing,
    /// A text.
    Text(String),
    /// An algorithm.
    Algorithm(Job),
    /// A count.
    Count(u64),
    /// A mean of counts.
    Mean(f64),
    /// A time in seconds.
    Seconds(f64),
    /// Per cent.
    Percent(f64),
    /// A number of unknown size, such as a ratio.
    Ratio(f64),
    /// A ratio to the digits that the papers print.
    PrintedRatio(f64),
    /// A scaled Jacobian.
    Jacobian(f64),
    /// Bytes.
    Bytes(f64),
}

impl Value {
    /// Returns the number, if it is one.
    pub fn number(&self) -> Option<f64> {
        match *self {
            Self::Count(count) => Some(count as f64),
            Self::Mean(value)
            | Self::Seconds(value)
            | Self::Percent(value)
            | Self::Ratio(value)
            | Self::PrintedRatio(value)
            | Self::Jacobian(value)
            | Self::Bytes(value) => Some(value),
            Self::Missing | Self::Text(_) | Self::Algorithm(_) => None,
        }
    }

    /// Returns the value as a field of a file, to the digits that the papers print.
    pub fn field(&self) -> String {
        match self {
            Self::Missing => String::new(),
            Self::Text(text) => text.clone(),
            Self::Algorithm(job) => job.algorithm().into(),
            Self::Count(count) => count.to_string(),
            Self::Mean(value) => format!("{value:.1}"),
            Self::Seconds(value) => format!("{value:.8}"),
            Self::Percent(value) => format!("{value:.4}"),
            Self::Ratio(value) => significant(*value),
            Self::PrintedRatio(value) => format!("{value:.2}"),
            // What rounds to 0 has no sign.
            Self::Jacobian(value) => format!("{:.4}", (1e4 * value).round() / 1e4 + 0.0),
            Self::Bytes(value) => format!("{value:.0}"),
        }
    }

    /// Returns the value as the page shows it, to the digits that a reader needs.
    pub fn display(&self) -> String {
        match self {
            Self::Text(text) => text.clone(),
            Self::Algorithm(job) => job.facts().label.into(),
            Self::Seconds(value) => seconds(*value),
            other => grouped(&other.field()),
        }
    }
}

impl ReportTable {
    /// Returns the fields of the file: our columns, the paper's, ratios (counts first), errata.
    pub fn fields(&self) -> (Vec<String>, Vec<Vec<String>>) {
        let places = |test: &dyn Fn(&Column) -> bool| -> Vec<usize> {
            (0..self.columns.len()).filter(|&c| test(&self.columns[c])).collect()
        };
        let printed = places(&|column| column.beside != Beside::Nothing);
        let mut ratios = places(&|column| column.beside == Beside::PrintedAndRatio);
        let is_time = |column: &usize| {
            self.rows.iter().any(|row| matches!(row.cells[*column].paper, Value::Seconds(_)))
        };
        ratios.sort_by_key(is_time);
        let named = |prefix: &'static str, places: &[usize]| -> Vec<String> {
            places.iter().map(|&c| format!("{prefix}{}", self.columns[c].name)).collect()
        };
        let mut header = vec!["mesh".to_owned()];
        header.extend(self.columns.iter().map(|column| column.name.clone()));
        header.extend(named("paper_", &printed).into_iter().chain(named("ratio_", &ratios)));
        header.extend(self.paper.map(|_| "paper_errata".to_owned()));
        let row = |row: &Row| {
            let mut fields = vec![row.mesh.clone()];
            fields.extend(row.cells.iter().map(|cell| cell.ours.field()));
            fields.extend(printed.iter().map(|&c| row.cells[c].paper.field()));
            fields.extend(ratios.iter().map(|&c| row.cells[c].ratio().field()));
            fields.extend(self.paper.map(|_| row.errata.clone()));
            fields
        };
        (header, self.rows.iter().map(row).collect())
    }

    /// Returns the table as comma-separated values, names first, lines ended by `\n`.
    pub fn csv(&self) -> String {
        let (header, rows) = self.fields();
        csv_text::of_texts(std::iter::once(header).chain(rows))
    }
}

impl TableCell {
    /// Returns ours divided by the paper's.
    fn ratio(&self) -> Value {
        quotient(self.ours.number(), self.paper.number()).map_or(Value::Missing, Value::Ratio)
    }
}
