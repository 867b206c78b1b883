//! A claim's number on every mesh, from records.

use super::Evidence;
use super::bootstrap::{self, Sample};
use crate::report::claims::{Claim, Expression, Factor, Need, Point};
use crate::report::number::significant;
use crate::report::summary::{Cell, Summary};
use triquad::random::Random;

/// Seconds below which a time says too little to be compared.
const SHORTEST: f64 = 1e-4;

/// The number of `claim` on its meshes, as far as the records have it.
pub fn evidence(claim: &Claim, summary: &Summary) -> Evidence {
    let mut evidence = Evidence::default();
    for mesh in claim.mesh_names() {
        let place = Place { summary, claim, mesh: &mesh };
        match place.point() {
            Ok(point) => {
                evidence.points.push(point);
                evidence.remarks.extend(place.remark().map(|remark| (mesh.clone(), remark)));
            }
            Err(why) => evidence.missing.push((mesh.clone(), why)),
        }
    }
    evidence
}

/// A mesh, looked at for a claim.
struct Place<'a> {
    summary: &'a Summary,
    claim: &'a Claim,
    mesh: &'a str,
}

impl<'a> Place<'a> {
    /// The number, or why there is none.
    fn point(&self) -> Result<Point, String> {
        let samples = self.samples(&self.claim.value)?;
        let along = match self.claim.predicate.along() {
            Some(along) => bootstrap::product(&self.samples(along)?),
            None => 0.0,
        };
        let random = Random::stream(0, &["bootstrap", &self.claim.id, self.mesh]);
        let value = bootstrap::product(&samples);
        if !value.is_finite() {
            return Err("divided by 0".into());
        }
        if self.claim.needs.contains(&Need::PaperMesh) && self.cells().any(Cell::is_stand_in) {
            return Err(format!("{}, but a stand-in, not the paper's mesh", significant(value)));
        }
        Ok(Point {
            mesh: self.mesh.to_owned(),
            value,
            interval: bootstrap::interval(&samples, random),
            along,
            triangles: self.of_mesh(|run| run.triangles),
            genus: self.of_mesh(|run| run.genus),
        })
    }

    fn samples<'e>(&self, expression: &'e Expression) -> Result<Vec<(&'e Factor, Sample)>, String> {
        let sample = |factor: &'e Factor| Ok((factor, self.sample(factor)?));
        expression.factors.iter().map(sample).collect()
    }

    /// The runs of a factor, by repetition.
    fn sample(&self, factor: &Factor) -> Result<Sample, String> {
        let Some(algorithm) = &factor.algorithm else {
            let value = self.cells().flat_map(|cell| &cell.runs).find_map(factor.number.of);
            return value.map(|value| vec![(0, value)]).ok_or_else(|| "not run".into());
        };
        let cell = self.cell(algorithm).ok_or_else(|| format!("{algorithm} not planned"))?;
        let sample: Sample = cell
            .ok_runs()
            .filter_map(|run| Some((run.repetition, (factor.number.of)(run)?)))
            .filter(|(_, value)| value.is_finite())
            .collect();
        let mean = sample.iter().map(|run| run.1).sum::<f64>() / sample.len() as f64;
        if factor.number.is_time && mean < SHORTEST {
            Err(format!("{algorithm}: {} below 0.1 ms", factor.number.name))
        } else if !sample.is_empty() {
            Ok(sample)
        } else if cell.ok_runs().next().is_some() {
            Err(format!("{algorithm} without {}", factor.number.name))
        } else {
            Err(format!("{algorithm}: {}", cell.outcome_text()))
        }
    }

    /// The algorithm as its paper ran it.
    fn cell(&self, algorithm: &str) -> Option<&'a Cell> {
        let how = if self.claim.experiment == "comparison" { "tarjan" } else { "file" };
        self.summary.cell(&self.claim.experiment, self.mesh, algorithm, None, how)
    }

    fn cells(&self) -> impl Iterator<Item = &'a Cell> {
        let (experiment, mesh) = (&self.claim.experiment, self.mesh);
        let cells = self.summary.cells().iter();
        cells.filter(move |cell| cell.experiment == *experiment && cell.mesh == mesh)
    }

    fn of_mesh(&self, number: fn(&crate::experiment::RunRecord) -> Option<u64>) -> f64 {
        self.cells().find_map(|cell| cell.count(number)).map_or(f64::NAN, |count| count as f64)
    }

    /// What a reader must know of the number beside it.
    fn remark(&self) -> Option<String> {
        let kind = self.cells().map(|cell| cell.mesh_kind.as_str()).next();
        let factors = self.claim.value.factors.iter();
        let algorithms = factors.filter_map(|factor| factor.algorithm.as_deref());
        let mut cells = algorithms.filter_map(|algorithm| self.cell(algorithm));
        let extrapolated = cells.any(Cell::is_extrapolated) && self.claim.is_about_times();
        let remarks =
            [kind.filter(|kind| !kind.is_empty()), extrapolated.then_some("extrapolated")];
        let remarks: Vec<&str> = remarks.into_iter().flatten().collect();
        (!remarks.is_empty()).then(|| remarks.join(", "))
    }
}
