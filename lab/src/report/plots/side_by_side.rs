//! The shape of quads in rows of meshes: ours and those of programs of others.

use super::axis::Spread;
use super::chart::Chart;
use super::ratios::Rows;
use crate::experiment::{Job, RunRecord};
use crate::paper::Paper;
use crate::report::notes::Note;
use crate::report::summary::{Cell, Summary};

/// Makes the charts of results that were measured from files.
pub fn all(summary: &Summary) -> Vec<Chart> {
    // A pairing that leaves out what is hard to pair must not look better for it.
    let mean = chart(summary, "side_by_side_mean", |run| {
        let paired = 2.0 * run.measured.quads? as f64 / run.measured.triangles? as f64;
        Some(paired * run.measured.quality_mean?)
    });
    let caption = "The sum of the scaled Jacobians of all quads, divided by half the number of \
                   triangles: the farther right, the better.";
    let mean = Chart {
        title: "Shape of the quads, pairings side by side".into(),
        x_name: "mean scaled Jacobian; triangles left over count as 0".into(),
        caption: caption.into(),
        ..mean
    };
    let folded = chart(summary, "side_by_side_folded", |run| {
        Some(100.0 * run.measured.folded_quads? as f64 / run.measured.quads? as f64)
    });
    let caption = "Quads of scaled Jacobian 0 and less: the farther left, the better. Triangles left \
                   over are not counted.";
    let folded = Chart {
        title: "Folded quads, pairings side by side".into(),
        x_name: "folded quads, % of the quads".into(),
        caption: caption.into(),
        ..folded
    };
    vec![mean, folded]
}

fn chart(summary: &Summary, stem: &str, number: impl Fn(&RunRecord) -> Option<f64>) -> Chart {
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
    // No times are shown, so that no remark on times is needed.
    let notes = Note::on(cells.into_iter()).into_iter().filter(|note| *note == Note::StandIn);
    let notes = notes.filter_map(|note| note.legend()).collect();
    let chart = rows.chart(stem, "", "", ["", ""]);
    Chart { x_spread: Spread::Linear, line: None, notes, ..chart }
}
