//! Times with the augmentation `rebuild`, from the price of its paths.
//!
//! A path takes as long there whichever it is, so few are timed. The price of one, times the paths
//! of a run, gives the augmentation of that run.

use triquad::augmentation::Augmentation;
use triquad::pairing::Algorithm;

use super::statistics::Statistics;
use super::summary::{Cell, Summary};
use crate::experiment::{Job, RunRecord};
use crate::paper::Paper;

/// Seconds that `rebuild` takes for a path, by mesh and algorithm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathPrice(f64);

impl PathPrice {
    /// Returns the price on a mesh of the comparison paper: that of the algorithm, or else that of
    /// another one there; `None` where no path was timed. O(cells).
    pub fn of(summary: &Summary, mesh: &str, job: Job) -> Option<Self> {
        let rebuild = |job: Job| job.with_augmentation(Augmentation::Rebuild);
        let is_timed = |cell: &&Cell| cell.id.job == rebuild(cell.id.job);
        let timed = || summary.of_mesh(Paper::Comparison, mesh).filter(is_timed);
        let own = timed().filter(|cell| cell.id.job == rebuild(job)).find_map(price);
        own.or_else(|| timed().find_map(price)).map(Self)
    }

    /// Describes column (e) of an algorithm with `rebuild`: the runs of `tarjan`, their paths at
    /// the price of `rebuild`.
    pub fn total(summary: &Summary, mesh: &str, algorithm: Algorithm) -> Option<Statistics> {
        let job = Job::published(algorithm);
        let price = Self::of(summary, mesh, job)?;
        summary.cell(Paper::Comparison, mesh, job)?.statistics(|run| price.total_seconds(run))
    }

    /// Returns column (d) of a run; its own seconds where it has no path.
    pub fn augmentation_seconds(self, run: &RunRecord) -> Option<f64> {
        match run.measured.unpaired_triangles? {
            0 => run.measured.augmentation_seconds,
            unpaired => Some(unpaired as f64 / 2.0 * self.0),
        }
    }

    /// Returns column (e) of a run.
    pub fn total_seconds(self, run: &RunRecord) -> Option<f64> {
        Some(run.measured.pairing_seconds? + self.augmentation_seconds(run)?)
    }
}

/// Returns the mean seconds of a path of a cell; programs that are not ours have none.
fn price(cell: &Cell) -> Option<f64> {
    cell.mean(|run| {
        let paths = run.stopped_after_paths.or(run.measured.augmenting_paths)?;
        (paths > 0).then_some(run.measured.augmentation_seconds? / paths as f64)
    })
    .filter(|_| !cell.id.job.is_program())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiment::{Measured, Results};

    fn run(augmentation: Augmentation, measured: Measured) -> RunRecord {
        let algorithm = Algorithm::PulliSegal;
        let mut run = RunRecord { stopped_after_paths: Some(4), measured, ..RunRecord::default() };
        run.id.mesh.name = "A1".into();
        run.id.job = Job::Convert { algorithm, augmentation };
        run
    }

    #[test]
    fn a_run_costs_as_many_prices_as_it_has_paths() {
        let timed = Measured {
            augmentation_seconds: Some(2.0),
            unpaired_triangles: Some(100),
            ..Measured::default()
        };
        let results =
            Results { records: vec![run(Augmentation::Rebuild, timed)], ..Results::default() };
        let summary = Summary::new(&results);
        let ps = Job::published(Algorithm::PulliSegal);
        let sg = Job::published(Algorithm::SimpleGreedy);
        let price = PathPrice::of(&summary, "A1", ps);
        assert_eq!(price, Some(PathPrice(0.5)));
        assert_eq!(PathPrice::of(&summary, "A1", sg), price);
        assert_eq!(PathPrice::of(&summary, "A2", ps), None);
        let other = |unpaired| Measured {
            pairing_seconds: Some(1.0),
            augmentation_seconds: Some(0.25),
            unpaired_triangles: Some(unpaired),
            ..Measured::default()
        };
        let total = |unpaired| {
            price.unwrap().total_seconds(&run(Augmentation::Tarjan, other(unpaired))).unwrap()
        };
        assert_eq!([total(0), total(2), total(40)], [1.25, 1.5, 11.0]);
    }
}
