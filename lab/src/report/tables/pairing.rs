//! Tables 4.3 and 4.4 of the comparison paper: four algorithms, with the augmentation as published.

use super::ReportTable;
use super::columns::{self, MESH, cells_of, header, mean, printed};
use crate::experiment::RunRecord;
use crate::report::number::{mean_count, or_empty, percent, quotient, seconds, significant};
use crate::report::paper::PairingRow;
use crate::report::statistics::Statistics;
use crate::report::summary::{Cell, Summary};

/// The columns that the paper has too: means over the runs that ended well.
pub const PRINTED: [&str; 5] = [
    "pairing_seconds",
    "paired_percent",
    "unpaired_triangles",
    "augmentation_seconds",
    "total_seconds",
];

/// What stands beside them.
pub const BESIDE: [&str; 8] = [
    "n",
    "total_seconds_median",
    "total_seconds_lower_quartile",
    "total_seconds_upper_quartile",
    "edge_flips",
    "edge_flips_percent",
    "outcomes",
    "extrapolated",
];

const PAPER: [&str; 9] = [
    "paper_pairing_seconds",
    "paper_paired_percent",
    "paper_unpaired_triangles",
    "paper_augmentation_seconds",
    "paper_total_seconds",
    "ratio_unpaired_triangles",
    "ratio_pairing_seconds",
    "ratio_total_seconds",
    "paper_errata",
];

/// Tables 4.3, 4.4(i) and 4.4(ii).
pub fn all(summary: &Summary) -> Vec<ReportTable> {
    let tables =
        [("4.3", "table_4_3.csv"), ("4.4(i)", "table_4_4_i.csv"), ("4.4(ii)", "table_4_4_ii.csv")];
    tables.map(|(number, file)| table(summary, number, file)).into()
}

fn table(summary: &Summary, number: &'static str, file: &'static str) -> ReportTable {
    let paper = printed(number);
    let printed_rows = paper.pairing_rows();
    let (mut rows, mut shown) = (Vec::new(), Vec::new());
    for (mesh, algorithm) in lines(&printed_rows) {
        let row = printed_rows.iter().find(|row| row.mesh == mesh && row.algorithm == algorithm);
        let cell = summary.cell("comparison", mesh, algorithm, None, "tarjan");
        if row.is_none() && cell.is_none() {
            continue;
        }
        rows.push(line(summary, mesh, algorithm, cell, row));
        shown.extend(cell);
    }
    let mut notes = columns::notes(&shown);
    if number != "4.3" {
        notes.push("The paper measured SG and DS too, but does not print their rows.".into());
    }
    notes.push("Ratios: ours divided by the paper's; its machine is of 2008.".into());
    ReportTable {
        number,
        file,
        title: paper.title().into(),
        header: header(&[&["mesh", "algorithm"], &PRINTED, &MESH, &BESIDE, &PAPER]),
        rows,
        notes,
    }
}

/// Every mesh of the printed rows with each of the four algorithms.
fn lines(rows: &[PairingRow]) -> impl Iterator<Item = (&str, &'static str)> {
    let mut meshes: Vec<&str> = rows.iter().map(|row| row.mesh.as_str()).collect();
    meshes.dedup();
    meshes.into_iter().flat_map(|mesh| ["sg", "ps", "ds", "lrs"].map(|algorithm| (mesh, algorithm)))
}

fn line(
    summary: &Summary,
    mesh: &str,
    algorithm: &str,
    cell: Option<&Cell>,
    paper: Option<&PairingRow>,
) -> Vec<String> {
    let mut row = vec![mesh.to_owned(), algorithm.to_owned()];
    row.extend(printed_columns(cell));
    row.extend(columns::of_mesh(cells_of(summary, "comparison", mesh)));
    row.extend(beside_columns(cell));
    row.extend(paper_columns(cell, paper));
    row
}

/// The columns [`PRINTED`].
pub fn printed_columns(cell: Option<&Cell>) -> [String; 5] {
    let of = |number: Number| describe(cell, number);
    [
        mean(of(|run| run.pairing_seconds), seconds),
        mean(of(|run| run.paired_percent), percent),
        mean(of(unpaired), mean_count),
        mean(of(RunRecord::whole_augmentation_seconds), seconds),
        mean(of(RunRecord::whole_total_seconds), seconds),
    ]
}

/// The columns [`BESIDE`].
pub fn beside_columns(cell: Option<&Cell>) -> [String; 8] {
    let total = describe(cell, RunRecord::whole_total_seconds);
    let flips = describe(cell, |run| run.edge_flips.map(|flips| flips as f64));
    let edges = cell.and_then(|cell| cell.count(|run| run.edges));
    let flipped = quotient(flips.map(|flips| flips.mean), edges.map(|edges| edges as f64));
    [
        cell.map_or(0, |cell| cell.ok_runs().count()).to_string(),
        or_empty(total, |total| seconds(total.median)),
        or_empty(total, |total| seconds(total.lower_quartile)),
        or_empty(total, |total| seconds(total.upper_quartile)),
        mean(flips, mean_count),
        or_empty(flipped, |share| significant(100.0 * share)),
        columns::outcomes(cell),
        columns::extrapolated(cell),
    ]
}

/// The columns [`PAPER`].
fn paper_columns(cell: Option<&Cell>, paper: Option<&PairingRow>) -> [String; 9] {
    let ratio = |number: Number, printed: fn(&PairingRow) -> f64| {
        let ours = describe(cell, number).map(|statistics| statistics.mean);
        columns::ratio(ours, paper.map(printed))
    };
    [
        or_empty(paper, |row| seconds(row.pairing_seconds)),
        or_empty(paper, |row| percent(row.paired_percent)),
        or_empty(paper, |row| mean_count(row.unpaired_triangles)),
        or_empty(paper, |row| seconds(row.augmentation_seconds)),
        or_empty(paper, |row| seconds(row.total_seconds)),
        ratio(unpaired, |row| row.unpaired_triangles),
        ratio(|run| run.pairing_seconds, |row| row.pairing_seconds),
        ratio(RunRecord::whole_total_seconds, |row| row.total_seconds),
        or_empty(paper, |row| row.errata.clone()),
    ]
}

/// A number of a run.
type Number = fn(&RunRecord) -> Option<f64>;

fn describe(cell: Option<&Cell>, number: Number) -> Option<Statistics> {
    cell?.statistics(number)
}

fn unpaired(run: &RunRecord) -> Option<f64> {
    run.unpaired_triangles.map(|count| count as f64)
}
