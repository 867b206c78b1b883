//! Pairings side by side: ours and those of programs of others, all measured from their files.

use super::columns::{self, mean, mean_count, of_cell};
use super::own::of_cells;
use super::table::{ReportTable, Value};
use crate::experiment::RunRecord;
use crate::paper::Paper;
use crate::report::summary::{Cell, Summary};

/// Makes the table, if there are such results.
pub fn table(summary: &Summary) -> Option<ReportTable> {
    let cells = summary.measured_from_files(Paper::Comparison);
    if cells.is_empty() {
        return None;
    }
    let names = ("table_side_by_side.csv", "Pairings side by side, measured from their files");
    let least = |cell: &Cell| {
        let found = cell.statistics(|run| run.measured.quality_minimum)?;
        Some(Value::Jacobian(found.minimum))
    };
    let columns = [
        mean("triangles_left", 0, Value::Mean, triangles_left),
        mean("scaled_jacobian_mean", 0, Value::Jacobian, |run| run.measured.quality_mean),
        mean("scaled_jacobian_one_percent", 0, Value::Jacobian, |run| {
            run.measured.quality_one_percent
        })
        .heading("scaled jacobian, worst 1 %"),
        of_cell("scaled_jacobian_minimum", 0, least),
        mean_count("folded_quads", 0, |measured| measured.folded_quads),
        mean_count("sharp_edges_kept", 0, |measured| measured.sharp_edges_kept),
        mean_count("sharp_edges", 0, |measured| measured.sharp_edges).heading("of sharp edges"),
        mean_count("edge_flips", 0, |measured| measured.edge_flips),
        mean_count("degree_two_vertices", 0, |measured| measured.degree_two_vertices),
        mean("total_seconds", 0, Value::Seconds, RunRecord::whole_total_seconds)
            .heading("pairing, s"),
        mean("process_seconds", 0, Value::Seconds, |run| run.process_seconds)
            .heading("from file to file, s"),
        of_cell("peak_memory_bytes", 0, |cell| {
            cell.mean_count(|measured| measured.peak_memory_bytes).map(Value::Bytes)
        }),
        columns::ok_runs("n", 0),
        columns::outcomes("outcomes", 0),
    ];
    let columns = columns::mesh().into_iter().chain(columns);
    Some(of_cells(names, cells.into_iter(), columns))
}

/// Returns how many triangles of the mesh are in no quad of the result.
fn triangles_left(run: &RunRecord) -> Option<f64> {
    Some(run.measured.triangles? as f64 - 2.0 * run.measured.quads? as f64)
}
