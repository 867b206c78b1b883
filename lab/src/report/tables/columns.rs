//! Columns that several tables have.

use crate::experiment::RunRecord;
use crate::report::number::{or_empty, quotient, significant};
use crate::report::paper::Table;
use crate::report::statistics::Statistics;
use crate::report::summary::{Cell, Summary};

/// What tells the reader what a mesh is.
pub const MESH: [&str; 4] = ["mesh_kind", "vertices", "triangles", "genus"];

/// The columns [`MESH`] of a mesh, from whichever of its cells knows.
pub fn of_mesh<'a>(cells: impl Iterator<Item = &'a Cell> + Clone) -> [String; 4] {
    let kind = cells.clone().map(|cell| cell.mesh_kind.clone()).next().unwrap_or_default();
    let count = |number: fn(&RunRecord) -> Option<u64>| {
        or_empty(cells.clone().find_map(|cell| cell.count(number)), |n| n.to_string())
    };
    [kind, count(|run| run.vertices), count(|run| run.triangles), count(|run| run.genus)]
}

/// How the runs of a cell ended, or `not planned`.
pub fn outcomes(cell: Option<&Cell>) -> String {
    cell.map_or("not planned".into(), Cell::outcome_text)
}

/// `yes` where times are extrapolated from a part of the augmenting paths.
pub fn extrapolated(cell: Option<&Cell>) -> String {
    if cell.is_some_and(Cell::is_extrapolated) { "yes".into() } else { String::new() }
}

/// The mean, written by `write`; empty if there is none.
pub fn mean(statistics: Option<Statistics>, write: fn(f64) -> String) -> String {
    or_empty(statistics.map(|statistics| statistics.mean), write)
}

/// Ours divided by the paper's.
pub fn ratio(ours: Option<f64>, paper: Option<f64>) -> String {
    or_empty(quotient(ours, paper), significant)
}

/// Names as owned strings.
pub fn header(groups: &[&[&str]]) -> Vec<String> {
    groups.iter().flat_map(|group| group.iter()).map(|&name| name.to_owned()).collect()
}

/// What must be known of these cells to read a table of them.
pub fn notes(cells: &[&Cell]) -> Vec<String> {
    let any = |test: fn(&Cell) -> bool| cells.iter().any(|cell| test(cell));
    let mut notes = Vec::new();
    for scale in ["small", "demo"] {
        if cells.iter().any(|cell| cell.scale == scale) {
            notes.push(format!(
                "Scale {scale}: the meshes are smaller than the paper's of the same names, so that \
                 counts that depend on size and times cannot be compared with the printed ones."
            ));
        }
    }
    if any(Cell::is_stand_in) {
        notes.push(
            "A stand-in has the vertex count and genus of the paper's scan, not its shape or \
             connectivity."
                .into(),
        );
    }
    if any(Cell::is_extrapolated) {
        notes.push(
            "Extrapolated: the augmentation was stopped after some of its paths, and its time is \
             that of the paths made, by rule of three for all of them."
                .into(),
        );
    }
    if any(Cell::is_parallel) {
        notes.push(
            "Runs went on beside others on the same machine: times are neither ranked nor divided \
             by each other."
                .into(),
        );
    }
    if any(|cell| cell.missing() > 0 || cell.runs.iter().any(|run| !run.is_ok())) {
        notes.push("Runs that are missing or did not end well: see the column of outcomes.".into());
    }
    notes
}

/// The printed table of that number.
pub fn printed(number: &str) -> Table {
    Table::numbered(number).expect("a table that the papers have")
}

/// The cells of a mesh in an experiment.
pub fn cells_of<'a, 'n>(
    summary: &'a Summary,
    experiment: &'n str,
    mesh: &'n str,
) -> impl Iterator<Item = &'a Cell> + Clone {
    summary.cells().iter().filter(move |cell| cell.experiment == experiment && cell.mesh == mesh)
}
