//! A claim's number on every mesh, from records.

use super::bootstrap::{self, Draw, Sample};
use crate::experiment::{Job, Measured, RunRecord};
use crate::meshes::Origin;
use crate::paper::Paper;
use crate::report::claims::{AtPrice, Claim, ClaimKind, Expression, Factor, MeshNumber};
use crate::report::path_price::PathPrice;
use crate::report::summary::{Cell, Summary};
use triquad::random::Random;

/// Seconds below which times are too noisy to be compared.
const SHORTEST: f64 = 1e-4;

/// A claim's number, mesh by mesh.
#[derive(Default)]
pub struct Evidence {
    /// The numbers, in the order of the meshes.
    pub points: Vec<MeshNumber>,
    /// Resamples of each; none where nothing was repeated.
    pub draws: Vec<Vec<Draw>>,
    /// The meshes among them that are stand-ins.
    pub stand_ins: Vec<String>,
    /// Notes on some of them.
    pub remarks: Vec<(String, String)>,
    /// The other meshes, with the reason.
    pub missing: Vec<(String, String)>,
}

/// Reason why there is no number.
#[derive(Debug, thiserror::Error)]
enum NoNumberError {
    #[error("divided by 0")]
    DividedByZero,
    #[error("not run")]
    NotRun,
    #[error("{0} not planned")]
    NotPlanned(&'static str),
    #[error("{algorithm}: {number} below 0.1 ms")]
    TooShort { algorithm: &'static str, number: &'static str },
    #[error("{algorithm} without {number}")]
    Without { algorithm: &'static str, number: &'static str },
    #[error("{algorithm}: {outcomes}")]
    Failed { algorithm: &'static str, outcomes: String },
}

/// Returns the number of `claim` on its meshes, as far as the records have it.
pub fn evidence(claim: &Claim, summary: &Summary) -> Evidence {
    let mut evidence = Evidence::default();
    for mesh in claim.mesh_names() {
        let view = ClaimOnMesh { summary, claim, mesh: &mesh };
        match view.point() {
            Ok((point, draws)) => {
                evidence.points.push(point);
                evidence.draws.push(draws);
                let is_stand_in = view.cells().any(Cell::is_stand_in);
                evidence.stand_ins.extend(is_stand_in.then(|| mesh.clone()));
                evidence.remarks.extend(view.remark().map(|remark| (mesh.clone(), remark)));
            }
            Err(why) => evidence.missing.push((mesh.clone(), why.to_string())),
        }
    }
    evidence
}

/// A claim on one of its meshes.
struct ClaimOnMesh<'a> {
    summary: &'a Summary,
    claim: &'a Claim,
    mesh: &'a str,
}

impl<'a> ClaimOnMesh<'a> {
    /// Returns the number and its resamples, or why there is none.
    fn point(&self) -> Result<(MeshNumber, Vec<Draw>), NoNumberError> {
        let samples = self.samples(&self.claim.value)?;
        let along = match self.claim.predicate.along() {
            Some(along) => self.samples(along)?,
            None => Vec::new(),
        };
        let random = Random::stream(0, &["bootstrap", &self.claim.id, self.mesh]);
        let value = bootstrap::product(&samples);
        if !value.is_finite() {
            return Err(NoNumberError::DividedByZero);
        }
        let draws = bootstrap::draws(&samples, &along, random);
        let point = MeshNumber {
            mesh: self.mesh.to_owned(),
            value,
            interval: bootstrap::interval(&draws),
            along: if along.is_empty() { 0.0 } else { bootstrap::product(&along) },
            triangles: self.of_mesh(|measured| measured.triangles),
            genus: self.of_mesh(|measured| measured.genus),
        };
        Ok((point, draws))
    }

    fn samples<'e>(
        &self,
        expression: &'e Expression,
    ) -> Result<Vec<(&'e Factor, Sample)>, NoNumberError> {
        let sample = |factor: &'e Factor| Ok((factor, self.sample(factor)?));
        expression.factors.iter().map(sample).collect()
    }

    /// Returns the runs of a factor, by repetition.
    fn sample(&self, factor: &Factor) -> Result<Sample, NoNumberError> {
        let Some(job) = factor.job else {
            let value = self.cells().flat_map(|cell| &cell.runs).find_map(factor.number.of);
            return value.map(|value| vec![(0, value)]).ok_or(NoNumberError::NotRun);
        };
        let (algorithm, number) = (job.algorithm(), factor.number.name);
        let cell = self.cell(job).ok_or(NoNumberError::NotPlanned(algorithm))?;
        let price = self.price(factor);
        let of = |run: &RunRecord| match price {
            Some((price, at_price)) => at_price(price, run),
            None => (factor.number.of)(run),
        };
        let sample: Sample = cell
            .ok_runs()
            .filter_map(|run| Some((run.repetition, of(run)?)))
            .filter(|(_, value)| value.is_finite())
            .collect();
        let mean = sample.iter().map(|run| run.1).sum::<f64>() / sample.len() as f64;
        if factor.number.is_time && mean < SHORTEST {
            Err(NoNumberError::TooShort { algorithm, number })
        } else if !sample.is_empty() {
            Ok(sample)
        } else if cell.ok_runs().next().is_some() {
            Err(NoNumberError::Without { algorithm, number })
        } else {
            Err(NoNumberError::Failed { algorithm, outcomes: cell.outcome_text() })
        }
    }

    /// Returns the price of a path by `rebuild`, and the number at it: ratios of times in the
    /// comparison paper are judged by it, where it was timed and augmentation is in the number.
    fn price(&self, factor: &Factor) -> Option<(PathPrice, AtPrice)> {
        let Claim { kind, experiment, .. } = *self.claim;
        let is_priced = (kind, experiment) == (ClaimKind::Ratio, Paper::Comparison);
        let at_price = factor.number.at_price.filter(|_| is_priced)?;
        Some((PathPrice::of(self.summary, self.mesh, factor.job?)?, at_price))
    }

    fn cell(&self, job: Job) -> Option<&'a Cell> {
        self.summary.cell(self.claim.experiment, self.mesh, job)
    }

    fn cells(&self) -> impl Iterator<Item = &'a Cell> {
        self.summary.of_mesh(self.claim.experiment, self.mesh)
    }

    fn of_mesh(&self, count: fn(&Measured) -> Option<u64>) -> f64 {
        self.cells().find_map(|cell| cell.count(count)).map_or(f64::NAN, |count| count as f64)
    }

    /// Returns whether times of augmentations are prices of paths by `rebuild`.
    fn is_priced(&self) -> bool {
        self.claim.value.factors.iter().any(|factor| self.price(factor).is_some())
    }

    /// Returns origin of the mesh, extrapolation and augmentation, to stand beside the number.
    fn remark(&self) -> Option<String> {
        let origin = self.cells().next().and_then(|cell| cell.origin).map(Origin::id);
        let jobs = self.claim.value.factors.iter().filter_map(|factor| factor.job);
        let mut cells = jobs.filter_map(|job| self.cell(job));
        let extrapolated = cells.any(Cell::is_extrapolated) && self.claim.is_about_times();
        let how =
            if self.is_priced() { Some("rebuild") } else { extrapolated.then_some("extrapolated") };
        let remarks = [origin, how];
        let remarks: Vec<&str> = remarks.into_iter().flatten().collect();
        (!remarks.is_empty()).then(|| remarks.join(", "))
    }
}
