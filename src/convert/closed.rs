//! Conversion of closed surfaces into quads alone.

use std::borrow::Cow;

use super::converted::{Converted, Quadrangulated};
use super::converter::Converter;
use super::error::ConvertError;
use super::progress::Stage;
use super::report::{Report, Size};
use crate::augmentation::make_maximum;
use crate::clock::SystemClock;
use crate::dual::{DualGraph, Matching, PerfectMatching};
use crate::matching::weighted::SolveError;
use crate::mesh::{Faces, Mesh};
use crate::pairing::{Algorithm, InitialPairing, Proof, best};
use crate::quadrangulation::quality::Quality;
use crate::quadrangulation::{
    CheckError, CheckReport, Quadrangulation, SharpEdges, check_faces, check_retriangulated_faces,
};
use crate::random::Random;
use crate::triangulation::Triangulation;

impl Converter<'_> {
    /// Converts a mesh whose triangulation is given.
    pub(super) fn run_closed(
        &mut self,
        input: Triangulation,
        mesh: Cow<'_, Mesh>,
        build_seconds: f64,
    ) -> Result<Converted, ConvertError> {
        let Paired { triangulation: paired, dual, perfect, mut report, proof, given_up } =
            self.pair(&input, Some(&mesh))?;
        report.build_seconds = build_seconds;
        report.unreferenced_vertices = mesh.positions().len() - report.vertices;
        let quadrangulation = Quadrangulation::new(&paired, &perfect);
        drop((perfect, dual));
        let removed = quadrangulation.removed();
        let sharp_edges = Some(SharpEdges::new(&*paired, mesh.positions(), removed));
        let attributes = quadrangulation.carry_attributes(&paired, &input, &mesh);
        let losses = quadrangulation.attribute_losses(&paired, &input, &mesh);
        let quads = quadrangulation.into_faces();
        let flipped = match paired {
            Cow::Borrowed(_) => None,
            Cow::Owned(flipped) => Some(flipped.to_faces()),
        };
        // The check has arrays of its own, as large as these.
        drop(input);

        self.enter(Stage::Checking);
        let (check, check_seconds) = self.time(|_| check_result(&quads, flipped.as_ref(), &mesh));
        let check = check?;
        let mut mesh = mesh.into_owned();
        let given = mesh.replace_faces(quads);
        let triangles = flipped.unwrap_or(given);
        let mesh = mesh.attach(attributes);
        let quality = Some(Quality::new(&mesh));
        let CheckReport { quads, degree_two_vertices, .. } = check;
        let report = Report {
            quads,
            degree_two_vertices,
            // The same fields whether the surface turns out to be closed or not.
            leftover_triangles: self.open.then_some(0),
            is_proved_fewest: self.open,
            quality,
            sharp_edges,
            check_seconds: report.check_seconds + check_seconds,
            ..report
        };
        Ok(Converted { mesh, triangles, report, losses, proof, given_up })
    }

    /// Converts a triangulation without coordinates. The result is not checked.
    ///
    /// # Errors
    /// The conversion was stopped.
    ///
    /// # Cost
    /// As for [`Converter::run`].
    pub fn quadrangulate<'t>(
        &mut self,
        triangulation: &'t Triangulation,
    ) -> Result<Quadrangulated<'t>, ConvertError> {
        let paired = self.pair(triangulation, None)?;
        let quadrangulation = Quadrangulation::new(&paired.triangulation, &paired.perfect);
        let report = Report { quads: quadrangulation.len(), ..paired.report };
        Ok(Quadrangulated { quadrangulation, triangulation: paired.triangulation, report })
    }

    /// Pairs triangles and augments until the pairing is perfect.
    fn pair<'t>(
        &mut self,
        triangulation: &'t Triangulation,
        mesh: Option<&Mesh>,
    ) -> Result<Paired<'t>, ConvertError> {
        let mut report = self.report(Size::from(triangulation));
        self.enter(Stage::Pairing);
        let initial = match mesh {
            Some(mesh) if self.algorithm == Algorithm::Best => {
                self.pair_by_cost(triangulation, mesh, &mut report)?
            }
            _ => self.pair_by_name(triangulation, mesh, &mut report),
        };
        let InitialPairing { triangulation, dual, matching, edge_flips, proof } = initial;
        report.edge_flips = edge_flips;
        report.unpaired_triangles = matching.unpaired_count();
        let mut given_up = Vec::new();
        if let Some(proof) = &proof {
            let (verdict, seconds) = self.time(|_| proof.verify(&dual, &matching));
            verdict?;
            report.check_seconds = seconds;
            report.is_proved_least = true;
            given_up =
                proof.given_up.iter().map(|&h| triangulation.ends(h).map(u32::from)).collect();
        }
        let proof = proof.filter(|_| self.keep_proof);
        let found = Found { triangulation, dual, matching, proof, given_up };
        self.make_perfect(found, report)
    }

    /// Pairs by the chosen algorithm, without costs.
    fn pair_by_name<'t>(
        &mut self,
        triangulation: &'t Triangulation,
        mesh: Option<&Mesh>,
        report: &mut Report,
    ) -> InitialPairing<'t> {
        let mut random = Random::stream(self.seed, &[self.algorithm.id()]);
        let system = SystemClock::default();
        let ((initial, shuffle_seconds), seconds) = self.time(|settings| {
            let clock = settings.clock.unwrap_or(&system);
            let Self { algorithm, lrs_order, .. } = *settings;
            algorithm.pair_by_clock(triangulation, mesh, lrs_order, &mut random, clock)
        });
        report.shuffle_seconds = shuffle_seconds;
        report.pairing_seconds = seconds;
        initial
    }

    /// Pairs at the least total cost.
    fn pair_by_cost<'t>(
        &mut self,
        triangulation: &'t Triangulation,
        mesh: &Mesh,
        report: &mut Report,
    ) -> Result<InitialPairing<'t>, ConvertError> {
        let (objective, cost_seconds) =
            self.time(|settings| settings.aims.objective(triangulation, mesh));
        let objective = objective?;
        report.cost_seconds = cost_seconds;
        let (initial, seconds) = self.time(|settings| {
            let mut silent = ();
            let progress = settings.progress.as_deref_mut().unwrap_or(&mut silent);
            best(triangulation, objective, &mut |news| progress.searching(news.roots))
        });
        report.pairing_seconds = cost_seconds + seconds;
        let initial = initial.map_err(|error| unsolved(error, report))?;
        if let Some(proof) = &initial.proof {
            self.note(proof, report);
        }
        Ok(initial)
    }

    /// Writes what a proof is about into the report.
    pub(super) fn note(&self, proof: &Proof, report: &mut Report) {
        report.total_cost = Some(proof.cost);
        if !self.aims.keep.is_empty() {
            report.kept_edges = Some(proof.objective.kept().len());
            report.given_up_edges = Some(proof.given_up.len());
        }
    }

    /// Augments until the matching is perfect.
    fn make_perfect<'t>(
        &mut self,
        found: Found<'t>,
        mut report: Report,
    ) -> Result<Paired<'t>, ConvertError> {
        let Found { triangulation, dual, matching, proof, given_up } = found;
        self.enter(Stage::Augmenting(report.unpaired_triangles / 2));
        let ((matching, paths), augmentation_seconds) = self.time(|settings| {
            let mut silent = ();
            let progress = settings.progress.as_deref_mut().unwrap_or(&mut silent);
            make_maximum(&dual, matching, settings.augmentation, &mut || progress.path_found())
        });
        report.paths = paths;
        report.augmentation_seconds = augmentation_seconds;
        match matching.certify(&dual) {
            Ok(perfect) => Ok(Paired { triangulation, dual, perfect, report, proof, given_up }),
            Err(_) => {
                // A bridgeless 3-regular graph has a perfect matching (Theorem 2.1).
                report.stopped = true;
                Err(ConvertError::Stopped(Box::new(report)))
            }
        }
    }
}

/// Says why `best` has no answer.
pub(super) fn unsolved(error: SolveError, report: &mut Report) -> ConvertError {
    match error {
        SolveError::Stopped { .. } => {
            report.stopped = true;
            ConvertError::Stopped(Box::new(report.clone()))
        }
        error => ConvertError::Costs(error),
    }
}

/// An initial pairing with its proof, taken apart.
struct Found<'t> {
    triangulation: Cow<'t, Triangulation>,
    dual: DualGraph,
    matching: Matching,
    proof: Option<Proof>,
    given_up: Vec<[u32; 2]>,
}

/// A perfect pairing, and what it pairs.
struct Paired<'t> {
    triangulation: Cow<'t, Triangulation>,
    dual: DualGraph,
    perfect: PerfectMatching,
    report: Report,
    proof: Option<Proof>,
    given_up: Vec<[u32; 2]>,
}

/// Checks quads against the triangles that were paired, and those, if they are `flipped`, against
/// the triangles given.
fn check_result(
    quads: &Faces,
    flipped: Option<&Faces>,
    given: &Mesh,
) -> Result<CheckReport, CheckError> {
    let vertices = given.positions().len();
    if let Some(flipped) = flipped {
        check_retriangulated_faces(flipped, given.faces(), vertices)?;
    }
    check_faces(quads, flipped.unwrap_or(given.faces()), vertices)
}
