//! Our tables against a baseline, number by number: the papers' printed ones, or another folder's.

use super::number::{quotient, significant};
use super::summary::Summary;
use super::tables::{self, ReportTable, Row, TableCell, Value};
use crate::csv_text;
use triquad::random::Random;

/// Resamples of a ratio of means.
const RESAMPLES: usize = 1000;

/// Columns that say how large a mesh is or how often something was run.
const NOT_COMPARED: [&str; 5] = ["vertices", "edges", "triangles", "genus", "n"];

/// A table against its baseline.
#[derive(Clone, Debug, PartialEq)]
pub struct BaselineTable {
    /// File of the table.
    pub file: &'static str,
    /// Its title.
    pub title: &'static str,
    /// The numbers that both have.
    pub rows: Vec<BaselineRow>,
}

/// A number of ours and of the baseline.
#[derive(Clone, Debug, PartialEq)]
pub struct BaselineRow {
    /// The mesh.
    pub mesh: String,
    /// The algorithm; empty in tables with a column for each.
    pub algorithm: String,
    /// The column.
    pub number: String,
    /// Ours.
    pub ours: Value,
    /// The baseline's.
    pub theirs: Value,
    /// Ours divided by theirs.
    pub ratio: Option<f64>,
    /// 95 % of the bootstrap of the ratio of means, where something was repeated.
    pub interval: Option<(f64, f64)>,
}

/// Compares the tables of `ours` with the papers' printed numbers. O(cells²).
pub fn against_paper(ours: &Summary) -> Vec<BaselineTable> {
    let printed = |row: &Row, column: usize| {
        let cell = &row.cells[column];
        Some(TableCell { ours: cell.paper.clone(), ..TableCell::default() })
    };
    compared(&tables::all(ours), |_, row, column| printed(row, column))
}

/// Compares the tables of `ours` with those of `baseline`. O(cells²).
pub fn against(ours: &Summary, baseline: &Summary) -> Vec<BaselineTable> {
    let theirs = tables::all(baseline);
    compared(&tables::all(ours), |table, row, column| {
        let theirs = theirs.iter().find(|theirs| theirs.file == table.file)?;
        let name = &table.columns[column].name;
        let column = theirs.columns.iter().position(|column| column.name == *name)?;
        let is_same = |other: &&Row| {
            (&other.mesh, algorithm(theirs, other)) == (&row.mesh, algorithm(table, row))
        };
        Some(theirs.rows.iter().find(is_same)?.cells[column].clone())
    })
}

/// Pairs the numbers of `tables` with those that `baseline` finds; tables without any are left out.
fn compared(
    tables: &[ReportTable],
    baseline: impl Fn(&ReportTable, &Row, usize) -> Option<TableCell>,
) -> Vec<BaselineTable> {
    let compare = |table: &ReportTable| {
        let mut rows = Vec::new();
        for row in &table.rows {
            for (column, cell) in row.cells.iter().enumerate() {
                let name = &table.columns[column].name;
                // `rs_n` and the like are numbers of runs, too.
                let is_compared = !NOT_COMPARED.contains(&name.as_str()) && !name.ends_with("_n");
                if !is_compared || cell.ours.number().is_none() {
                    continue;
                }
                let theirs = baseline(table, row, column);
                let theirs = theirs.filter(|theirs| theirs.ours.number().is_some());
                rows.extend(theirs.map(|theirs| baseline_row(table, row, column, &theirs)));
            }
        }
        BaselineTable { file: table.file, title: table.title, rows }
    };
    tables.iter().map(compare).filter(|table| !table.rows.is_empty()).collect()
}

fn algorithm(table: &ReportTable, row: &Row) -> String {
    let place = table.columns.iter().position(|column| column.name == "algorithm");
    place.map_or(String::new(), |place| row.cells[place].ours.display())
}

fn baseline_row(table: &ReportTable, row: &Row, column: usize, theirs: &TableCell) -> BaselineRow {
    let (ours, algorithm) = (&row.cells[column], algorithm(table, row));
    let number = table.columns[column].name.clone();
    let words = ["baseline", table.file, &row.mesh, &algorithm, &number];
    BaselineRow {
        mesh: row.mesh.clone(),
        ratio: quotient(ours.ours.number(), theirs.ours.number()),
        interval: interval(ours, theirs, Random::stream(0, &words)),
        ours: ours.ours.clone(),
        theirs: theirs.ours.clone(),
        algorithm,
        number,
    }
}

/// Returns 95 % of the resampled ratios of means; `None` where nothing was repeated.
fn interval(ours: &TableCell, theirs: &TableCell, mut random: Random) -> Option<(f64, f64)> {
    if ours.sample.len() < 2 && theirs.sample.len() < 2 {
        return None;
    }
    let mut mean = |cell: &TableCell| -> Option<f64> {
        let runs = cell.sample.len() as u32;
        if runs < 2 {
            return cell.ours.number();
        }
        let sum: f64 = (0..runs).map(|_| cell.sample[random.below(runs) as usize]).sum();
        Some(sum / f64::from(runs))
    };
    let mut ratios: Vec<f64> =
        (0..RESAMPLES).filter_map(|_| quotient(mean(ours), mean(theirs))).collect();
    ratios.sort_by(f64::total_cmp);
    let tail = ratios.len() / 40;
    (!ratios.is_empty()).then(|| (ratios[tail], ratios[ratios.len() - 1 - tail]))
}

impl BaselineTable {
    /// Returns the table as comma-separated values.
    pub fn csv(&self) -> String {
        let header =
            ["mesh", "algorithm", "number", "ours", "theirs", "ratio", "ratio_low", "ratio_high"];
        let rows = self.rows.iter().map(BaselineRow::fields);
        csv_text::of_texts(std::iter::once(header.map(str::to_owned)).chain(rows))
    }
}

impl BaselineRow {
    /// Returns the fields of the file.
    pub fn fields(&self) -> [String; 8] {
        let bounds = self
            .interval
            .map_or_else(Default::default, |(low, high)| [significant(low), significant(high)]);
        let [low, high] = bounds;
        [
            self.mesh.clone(),
            self.algorithm.clone(),
            self.number.clone(),
            self.ours.field(),
            self.theirs.field(),
            self.ratio.map(significant).unwrap_or_default(),
            low,
            high,
        ]
    }
}
