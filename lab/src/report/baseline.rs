//! Our tables against a baseline, number by number: the papers' printed ones, or another folder's.

use std::collections::BTreeSet;

use super::number::{quotient, significant};
use super::summary::{Cell, Summary};
use super::tables::{self, ReportTable, Row, TableCell, Value};
use crate::csv_text;
use crate::experiment::{Job, RunRecord};
use crate::meshes::paper;
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

/// The comparison with a baseline.
#[derive(Clone, Debug, PartialEq)]
pub struct AgainstBaseline {
    /// The tables with a number that both have.
    pub tables: Vec<BaselineTable>,
    /// Meshes of another size than the baseline's, of which numbers that depend on it are left out.
    pub other_sizes: Vec<OtherSize>,
    /// Reason why there are no tables; empty if there are any.
    pub why_none: String,
}

/// A mesh of another size than the baseline's of that name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OtherSize {
    /// The mesh.
    pub mesh: String,
    /// Triangles here.
    pub ours: u64,
    /// Triangles in the baseline.
    pub theirs: u64,
}

/// Compares the tables of `ours` with the papers' printed numbers. O(cells²).
pub fn against_paper(ours: &Summary) -> AgainstBaseline {
    let tables = tables::all(ours);
    let sizes = Sizes::new(ours, |mesh| paper::named(mesh).map(|mesh| u64::from(mesh.triangles())));
    let compared = compared(&tables, &sizes, |_, row, column| {
        let cell = &row.cells[column];
        Some(TableCell { ours: cell.paper.clone(), ..TableCell::default() })
    });
    let theirs = |cell: &Cell| printed_numbers(&tables, cell);
    AgainstBaseline::new(ours, compared, sizes, theirs)
}

/// Returns the names of the numbers that the papers print of a job on a mesh.
fn printed_numbers(tables: &[ReportTable], cell: &Cell) -> Vec<String> {
    let job = cell.id.job;
    if Job::named(job.algorithm()) != Ok(job) {
        return Vec::new();
    }
    let own_columns = format!("{}_", job.algorithm().replace('-', "_"));
    let mut names = Vec::new();
    for table in tables {
        let has_rows_of_algorithms = table.columns.iter().any(|column| column.name == ALGORITHM);
        let is_of_job = |row: &&Row| {
            let is_same = !has_rows_of_algorithms || algorithm(table, row) == job.facts().label;
            row.mesh == cell.mesh() && is_same
        };
        for row in table.rows.iter().filter(is_of_job) {
            let printed = row.cells.iter().zip(&table.columns);
            let printed = printed.filter(|(cell, _)| cell.paper.number().is_some());
            names.extend(printed.filter_map(|(_, column)| match has_rows_of_algorithms {
                true => Some(column.name.clone()),
                false => column.name.strip_prefix(&own_columns).map(str::to_owned),
            }));
        }
    }
    names
}

/// Compares the tables of `ours` with those of `baseline`. O(cells²).
pub fn against(ours: &Summary, baseline: &Summary) -> AgainstBaseline {
    let their_tables = tables::all(baseline);
    let sizes = Sizes::new(ours, |mesh| triangles(baseline, mesh));
    let compared = compared(&tables::all(ours), &sizes, |table, row, column| {
        let theirs = their_tables.iter().find(|theirs| theirs.file == table.file)?;
        let name = &table.columns[column].name;
        let column = theirs.columns.iter().position(|column| column.name == *name)?;
        let is_same = |other: &&Row| {
            (&other.mesh, algorithm(theirs, other)) == (&row.mesh, algorithm(table, row))
        };
        Some(theirs.rows.iter().find(is_same)?.cells[column].clone())
    });
    let theirs = |cell: &Cell| {
        let is_same = |other: &&Cell| (other.mesh(), other.id.job) == (cell.mesh(), cell.id.job);
        baseline.cells().iter().filter(is_same).flat_map(numbers).collect()
    };
    AgainstBaseline::new(ours, compared, sizes, theirs)
}

/// Returns the triangles of a mesh; of several scales, those of the largest.
fn triangles(summary: &Summary, mesh: &str) -> Option<u64> {
    let cells = summary.cells().iter().filter(|cell| cell.mesh() == mesh);
    cells.filter_map(|cell| cell.count(|measured| measured.triangles)).next()
}

/// Returns the names of the numbers that the runs of a cell have.
fn numbers(cell: &Cell) -> Vec<String> {
    let of_run = |run: &RunRecord| run.measured.names();
    let is_size = |name: &str| name == "components" || NOT_COMPARED.contains(&name);
    let names: BTreeSet<String> = cell.ok_runs().flat_map(of_run).collect();
    names.into_iter().filter(|name| !is_size(name)).collect()
}

/// The meshes that are smaller or larger than the baseline's.
struct Sizes(Vec<OtherSize>);

impl Sizes {
    /// Sizes that differ by less are the same: a scan's copies differ by some triangles.
    const SAME: f64 = 1.05;

    fn new(ours: &Summary, theirs: impl Fn(&str) -> Option<u64>) -> Self {
        let mut others: Vec<OtherSize> = Vec::new();
        for cell in ours.cells() {
            let mesh = cell.mesh();
            let both = triangles(ours, mesh).zip(theirs(mesh));
            let Some((ours, theirs)) = both.filter(|(ours, theirs)| ours.min(theirs) > &0) else {
                continue;
            };
            let ratio = ours.max(theirs) as f64 / ours.min(theirs) as f64;
            if ratio > Self::SAME && others.iter().all(|other| other.mesh != mesh) {
                others.push(OtherSize { mesh: mesh.to_owned(), ours, theirs });
            }
        }
        Self(others)
    }

    fn differ(&self, mesh: &str) -> bool {
        self.0.iter().any(|other| other.mesh == mesh)
    }
}

impl AgainstBaseline {
    /// Adds to the tables why there are none. `theirs` names the baseline's numbers of the job and
    /// mesh of a cell.
    fn new(
        ours: &Summary,
        (tables, left_out): (Vec<BaselineTable>, BTreeSet<String>),
        sizes: Sizes,
        theirs: impl Fn(&Cell) -> Vec<String>,
    ) -> Self {
        let other_sizes = sizes.0.into_iter().filter(|other| left_out.contains(&other.mesh));
        let other_sizes: Vec<OtherSize> = other_sizes.collect();
        let why_none = match (tables.is_empty(), other_sizes.is_empty()) {
            (false, _) => String::new(),
            (true, false) => other_sizes_in_words(&other_sizes),
            (true, true) => {
                let cells = ours.cells().iter().filter(|cell| !numbers(cell).is_empty());
                let shared =
                    cells.map(|cell| (cell, theirs(cell))).find(|(_, all)| !all.is_empty());
                shared.map_or(NOTHING_SHARED.into(), |(cell, theirs)| {
                    format!(
                        "both have {} on {}, but no number of it in one table: here {}, there {}",
                        cell.id.job.algorithm(),
                        cell.mesh(),
                        numbers(cell).join(", "),
                        theirs.join(", ")
                    )
                })
            }
        };
        Self { tables, other_sizes, why_none }
    }

    /// Returns what is left out, in words; `None` if nothing is.
    pub fn left_out(&self) -> Option<String> {
        (!self.other_sizes.is_empty()).then(|| other_sizes_in_words(&self.other_sizes))
    }
}

const NOTHING_SHARED: &str = "the two share no mesh with the same algorithm";

/// Names the meshes of another size, those that differ alike together.
fn other_sizes_in_words(meshes: &[OtherSize]) -> String {
    let factor = |other: &OtherSize| {
        let ratio = other.ours.max(other.theirs) as f64 / other.ours.min(other.theirs) as f64;
        let ratio = if ratio < 9.95 { format!("{ratio:.1}") } else { format!("{ratio:.0}") };
        let word = if other.ours < other.theirs { "smaller" } else { "larger" };
        format!("{ratio} times {word}")
    };
    let mut groups: Vec<(String, Vec<&str>)> = Vec::new();
    for other in meshes {
        let factor = factor(other);
        match groups.iter_mut().find(|group| group.0 == factor) {
            Some(group) => group.1.push(&other.mesh),
            None => groups.push((factor, vec![&other.mesh])),
        }
    }
    let groups = groups.iter().map(|(factor, meshes)| format!("{} {factor}", meshes.join(", ")));
    let groups: Vec<String> = groups.collect();
    format!("meshes differ in size from the baseline's ({})", groups.join("; "))
}

/// Pairs the numbers of `tables` with those that `baseline` finds; tables without any are left out.
/// Numbers that depend on the size of a mesh are left out where the sizes differ; returns the names
/// of these meshes, too.
fn compared(
    tables: &[ReportTable],
    sizes: &Sizes,
    baseline: impl Fn(&ReportTable, &Row, usize) -> Option<TableCell>,
) -> (Vec<BaselineTable>, BTreeSet<String>) {
    let mut left_out = BTreeSet::new();
    let compare = |table: &ReportTable| {
        let mut rows = Vec::new();
        for row in &table.rows {
            let is_of_other_size = sizes.differ(&row.mesh);
            let is_repeated = is_repeated(table, row, &baseline);
            for (column, cell) in row.cells.iter().enumerate() {
                let name = &table.columns[column].name;
                // `rs_n` and the like are numbers of runs, too.
                let is_compared = !NOT_COMPARED.contains(&name.as_str()) && !name.ends_with("_n");
                let is_noise = is_of_spread(name) && !is_repeated;
                if !is_compared || is_noise || cell.ours.number().is_none() {
                    continue;
                }
                let theirs = baseline(table, row, column);
                let theirs = theirs.filter(|theirs| theirs.ours.number().is_some());
                if theirs.is_some() && is_of_other_size && depends_on_size(name, &cell.ours) {
                    left_out.insert(row.mesh.clone());
                    continue;
                }
                rows.extend(theirs.map(|theirs| baseline_row(table, row, column, &theirs)));
            }
        }
        BaselineTable { file: table.file, title: table.title, rows }
    };
    let compared = tables.iter().map(compare).filter(|table| !table.rows.is_empty()).collect();
    (compared, left_out)
}

/// Returns whether a number describes how repetitions spread.
fn is_of_spread(name: &str) -> bool {
    ["_median", "_quartile", "_least", "_greatest"].iter().any(|ending| name.ends_with(ending))
}

/// Returns whether both sides of a row have more than one run.
fn is_repeated(
    table: &ReportTable,
    row: &Row,
    baseline: impl Fn(&ReportTable, &Row, usize) -> Option<TableCell>,
) -> bool {
    let Some(column) = table.columns.iter().position(|column| column.name == RUNS) else {
        return false;
    };
    let theirs = baseline(table, row, column);
    let is_repeated = |cell: &TableCell| cell.ours.number().is_some_and(|runs| runs > 1.0);
    is_repeated(&row.cells[column]) && theirs.as_ref().is_some_and(is_repeated)
}

/// Returns whether a number is another on a mesh of another size: all but shares and shapes are.
fn depends_on_size(name: &str, value: &Value) -> bool {
    let is_share = matches!(value, Value::Percent(_)) || name.ends_with("percent");
    !is_share && !matches!(value, Value::Jacobian(_))
}

const ALGORITHM: &str = "algorithm";
const RUNS: &str = "n";

fn algorithm(table: &ReportTable, row: &Row) -> String {
    let place = table.columns.iter().position(|column| column.name == ALGORITHM);
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
