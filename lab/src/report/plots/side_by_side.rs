//! The shape of quads in rows of meshes: ours and those of programs of others.

use super::axis::Spread;
use super::chart::Chart;
use super::ratios::Rows;
use crate::experiment::{Job, RunRecord};
use crate::paper::Paper;
use crate::report::summary::{Cell, Summary};

/// Makes the charts of results that were measured from files.
pub fn all(summary: &Summary) -> Vec<Chart> {
    let mean = chart(summary, "side_by_side_mean", "mean scaled Jacobian", |run| {
        run.measured.quality_mean
    });
    let folded = chart(summary, "side_by_side_folded", "folded quads, %", |run| {
        Some(100.0 * run.measured.folded_quads? as f64 / run.measured.quads? as f64)
    });
    let caption = "The farther right, the better. Gmsh, MeshLab, Blender and the greedy program may \
                   leave triangles, which are not counted here: see the table.";
    let mean = Chart {
        title: "Shape of the quads, pairings side by side".into(),
        caption: caption.into(),
        ..mean
    };
    let caption = "Quads of scaled Jacobian 0 and less. The farther left, the better.";
    let folded = Chart {
        title: "Folded quads, pairings side by side".into(),
        caption: caption.into(),
        ..folded
    };
    vec![mean, folded]
}

fn chart(
    summary: &Summary,
    stem: &str,
    quantity: &str,
    number: impl Fn(&RunRecord) -> Option<f64>,
) -> Chart {
    let cells = summary.measured_from_files(Paper::Comparison);
    let mut jobs: Vec<Job> = Vec::new();
    for cell in &cells {
        if !jobs.contains(&cell.id.job) {
            jobs.push(cell.id.job);
        }
    }
    let mut rows = Rows::new(summary, Paper::Comparison);
    for job in jobs {
        let on = |mesh: &str| cells.iter().find(|cell| cell.mesh() == mesh && cell.id.job == job);
        rows.add(&job.label(), job.facts().look, false, |mesh| {
            let cell: &Cell = on(mesh)?;
            Some((cell.mean(&number)?, false))
        });
    }
    let chart = rows.chart(stem, "", quantity, ["", ""]);
    Chart { x_spread: Spread::Linear, line: None, ..chart }
}
