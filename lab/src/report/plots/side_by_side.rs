//! The shape of quads in rows of meshes: ours and those of programs of others.

use super::axis::Spread;
use super::chart::Chart;
use super::ratios::{Ratio, Rows};
use crate::algorithms::Look;
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
    // With two augmentations, or as programs of others, two jobs may have one look.
    let looks = Look::distinct(&jobs.iter().map(|job| job.facts().look).collect::<Vec<_>>());
    for (job, look) in jobs.into_iter().zip(looks) {
        let on = |mesh: &str| cells.iter().find(|cell| cell.mesh() == mesh && cell.id.job == job);
        rows.add(&job.label(), look, false, |mesh| {
            let cell: &Cell = on(mesh)?;
            Some(Ratio::of([cell], cell.mean(&number)?).exact())
        });
    }
    // No times are shown, so that no remark on times is needed.
    let mut chart = rows.chart(stem, "", "", ["", ""]);
    chart.notes.retain(|note| Some(note) == Note::StandIn.legend().as_ref());
    Chart { x_spread: Spread::Linear, line: None, ..chart }
}

#[cfg(test)]
mod tests {
    use triquad::augmentation::Augmentation;
    use triquad::pairing::Algorithm;

    use super::*;
    use crate::experiment::{Measured, MeshId, Results, RunId, Task};

    /// A run on one mesh, whose quads are folded in the mean.
    fn run(job: Job) -> RunRecord {
        let id = RunId { mesh: MeshId { name: "x".into(), ..MeshId::default() }, job };
        let measured = Measured {
            triangles: Some(2000),
            quads: Some(1000),
            quality_mean: Some(-0.25),
            quality_one_percent: Some(-0.5),
            total_seconds: Some(1.0),
            folded_quads: Some(700),
            ..Measured::default()
        };
        RunRecord { id, measured, ..RunRecord::default() }
    }

    #[test]
    fn no_two_series_look_alike_and_all_points_are_within_the_frame() {
        let published = Job::published(Algorithm::PulliSegal);
        // Two names whose looks are the same.
        let others = ["a", "m"].map(|name| Job::program(Task::Convert, name));
        assert_eq!(others[0].facts().look, others[1].facts().look);
        let jobs = [published, published.with_augmentation(Augmentation::Local)];
        let records = jobs.into_iter().chain(others).map(run).collect();
        let summary = Summary::new(&Results { records, ..Results::default() });
        let totals = super::super::growth::totals(&summary);
        let charts = all(&summary).into_iter().chain(totals).filter(|chart| !chart.is_empty());
        let charts: Vec<Chart> = charts.collect();
        assert!(charts.len() > 2);
        for chart in charts {
            let (x, _) = chart.axes();
            let (low, high) = x.bounds();
            for (at, series) in chart.series.iter().enumerate() {
                let alike = chart.series[..at].iter().find(|other| other.look == series.look);
                assert_eq!(alike.map(|other| &other.name), None, "{}", series.name);
                let places = series.points.iter().filter_map(|point| x.place(point.x));
                assert!(places.into_iter().all(|at| (low..=high).contains(&at)), "{}", chart.stem);
            }
        }
    }
}
