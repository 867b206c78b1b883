//! The builder of a conversion, and the chain of its stages.

use std::borrow::Cow;
use std::fmt;

use super::converted::{Converted, Quadrangulated};
use super::error::ConvertError;
use super::progress::{Progress, Stage};
use super::report::Report;
use crate::augmentation::{Augmentation, make_maximum};
use crate::clock::{Clock, SystemClock};
use crate::dual::{DualGraph, Matching, PerfectMatching};
use crate::matching::weighted::SolveError;
use crate::mesh::{Faces, Mesh};
use crate::pairing::{Algorithm, InitialPairing, best};
use crate::quadrangulation::quality::Quality;
use crate::quadrangulation::{
    CheckReport, Cost, DefaultCost, Mismatch, Quadrangulation, SharpEdges, check_faces,
    check_retriangulated_faces, edge_costs,
};
use crate::random::Random;
use crate::triangulation::Triangulation;

/// Converts triangle meshes of closed surfaces into quads on the same vertices.
///
/// ```
/// use triquad::{Algorithm, Converter, Mesh};
///
/// let positions = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let mesh = Mesh::from_triangles(positions, vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
/// let quads = Converter::new().algorithm(Algorithm::PulliSegal).seed(7).run(&mesh)?;
/// assert_eq!(quads.mesh().faces().len(), 2);
/// # Ok::<(), triquad::ConvertError>(())
/// ```
pub struct Converter<'a> {
    algorithm: Algorithm,
    augmentation: Augmentation,
    seed: u64,
    orient: bool,
    cost: &'a dyn Cost,
    clock: Option<&'a dyn Clock>,
    progress: Option<&'a mut dyn Progress>,
}

impl fmt::Debug for Converter<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Converter")
            .field("algorithm", &self.algorithm)
            .field("augmentation", &self.augmentation)
            .field("seed", &self.seed)
            .field("orient", &self.orient)
            .finish_non_exhaustive()
    }
}

impl Default for Converter<'_> {
    fn default() -> Self {
        Self::new()
    }
}

impl<'a> Converter<'a> {
    /// Makes a converter by `best` with [`DefaultCost`], augmentation `local` and seed 0.
    pub fn new() -> Self {
        Self {
            algorithm: Algorithm::Best,
            augmentation: Augmentation::Local,
            seed: 0,
            orient: false,
            cost: &DefaultCost,
            clock: None,
            progress: None,
        }
    }

    /// Sets the algorithm of the initial pairing.
    #[must_use]
    pub fn algorithm(self, algorithm: Algorithm) -> Self {
        Self { algorithm, ..self }
    }

    /// Sets the kind of augmentation that makes the pairing perfect.
    #[must_use]
    pub fn augmentation(self, augmentation: Augmentation) -> Self {
        Self { augmentation, ..self }
    }

    /// Sets the master seed of everything random. Equal seeds give equal results everywhere.
    #[must_use]
    pub fn seed(self, seed: u64) -> Self {
        Self { seed, ..self }
    }

    /// Sets whether faces are flipped first where neighbours disagree on orientation.
    #[must_use]
    pub fn orient(self, orient: bool) -> Self {
        Self { orient, ..self }
    }

    /// Sets what `best` minimises the sum of, in place of [`DefaultCost`].
    #[must_use]
    pub fn cost(self, cost: &'a dyn Cost) -> Self {
        Self { cost, ..self }
    }

    /// Sets the clock that the report's times are read from.
    #[must_use]
    pub fn clock(self, clock: &'a dyn Clock) -> Self {
        Self { clock: Some(clock), ..self }
    }

    /// Sets the receiver of progress events, which can also stop the conversion.
    #[must_use]
    pub fn progress(self, progress: &'a mut dyn Progress) -> Self {
        Self { progress: Some(progress), ..self }
    }

    /// Converts a mesh, borrowed or owned, and checks the result.
    ///
    /// An owned mesh gives its arrays to the result; of a borrowed one they are copied.
    ///
    /// # Errors
    /// The mesh is no triangulation of closed surfaces, or the conversion was stopped.
    ///
    /// # Cost
    /// Linear on every mesh measured; O(k n) in the worst case for k triangles left unpaired at
    /// first. About 100 bytes a triangle at the peak, the mesh included.
    pub fn run<'m>(&mut self, mesh: impl Into<Cow<'m, Mesh>>) -> Result<Converted, ConvertError> {
        let mut mesh = mesh.into();
        self.enter(Stage::Building);
        let (built, build_seconds) = self.time(|settings| settings.build(&mut mesh));
        let triangulation = built?;
        let mut paired = self.pair(&triangulation, Some(mesh.positions()))?;
        paired.report.build_seconds = build_seconds;
        let quadrangulation = Quadrangulation::new(&paired.triangulation, &paired.perfect);
        let sharp_edges = Some(SharpEdges::new(
            &paired.triangulation,
            mesh.positions(),
            quadrangulation.removed(),
        ));
        drop((paired.perfect, paired.dual));

        self.enter(Stage::Checking);
        let quads = quadrangulation.faces();
        let flipped = match &paired.triangulation {
            Cow::Borrowed(_) => None,
            Cow::Owned(flipped) => Some(flipped.faces()),
        };
        let (check, check_seconds) = self.time(|_| check_result(&quads, flipped.as_ref(), &mesh));
        let check = check?;
        let attributes =
            quadrangulation.carry_attributes(&paired.triangulation, &triangulation, &mesh);
        let losses = quadrangulation.attribute_losses(&paired.triangulation, &triangulation, &mesh);
        let mut mesh = mesh.into_owned();
        let given = mesh.replace_faces(quads);
        let triangles = flipped.unwrap_or(given);
        let mesh = mesh.attach(attributes);
        let quality = Some(Quality::new(&mesh));
        let CheckReport { quads, degree_two_vertices, .. } = check;
        let report = Report {
            quads,
            degree_two_vertices,
            quality,
            sharp_edges,
            check_seconds: paired.report.check_seconds + check_seconds,
            ..paired.report
        };
        Ok(Converted { mesh, triangles, report, losses })
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

    /// Builds the triangulation. Faces are flipped in a copy if the mesh is borrowed.
    fn build(&self, mesh: &mut Cow<'_, Mesh>) -> Result<Triangulation, ConvertError> {
        let survey = match Triangulation::build(mesh) {
            Ok(triangulation) => return Ok(triangulation),
            Err(survey) => survey,
        };
        if self.orient && survey.only_orientation_is_wrong() {
            survey.orient(mesh.to_mut());
            return Ok(Triangulation::build(mesh)?);
        }
        Err(survey.into())
    }

    /// Pairs triangles and augments until the pairing is perfect.
    fn pair<'t>(
        &mut self,
        triangulation: &'t Triangulation,
        positions: Option<&[[f64; 3]]>,
    ) -> Result<Paired<'t>, ConvertError> {
        let mut report = Report::new(self.algorithm, self.augmentation, self.seed, triangulation);
        self.enter(Stage::Pairing);
        let initial = match positions {
            Some(positions) if self.algorithm == Algorithm::Best => {
                self.pair_by_cost(triangulation, positions, &mut report)?
            }
            _ => self.pair_by_name(triangulation, &mut report),
        };
        let InitialPairing { triangulation, dual, matching, edge_flips, proof } = initial;
        report.edge_flips = edge_flips;
        report.unpaired_triangles = matching.unpaired_count();
        if let Some(proof) = proof {
            let (verdict, seconds) = self.time(|_| proof.verify(&dual, &matching));
            verdict?;
            report.check_seconds = seconds;
            report.is_proved_least = true;
        }
        self.make_perfect(triangulation, dual, matching, report)
    }

    /// Pairs by the chosen algorithm, without costs.
    fn pair_by_name<'t>(
        &mut self,
        triangulation: &'t Triangulation,
        report: &mut Report,
    ) -> InitialPairing<'t> {
        let mut random = Random::stream(self.seed, &[self.algorithm.id()]);
        let (initial, seconds) =
            self.time(|settings| settings.algorithm.pair(triangulation, &mut random));
        report.pairing_seconds = seconds;
        initial
    }

    /// Pairs at the least total cost.
    fn pair_by_cost<'t>(
        &mut self,
        triangulation: &'t Triangulation,
        positions: &[[f64; 3]],
        report: &mut Report,
    ) -> Result<InitialPairing<'t>, ConvertError> {
        let (costs, cost_seconds) =
            self.time(|settings| edge_costs(triangulation, positions, settings.cost));
        let (initial, seconds) = self.time(|settings| {
            let mut silent = ();
            let progress = settings.progress.as_deref_mut().unwrap_or(&mut silent);
            best(triangulation, costs, &mut |news| progress.searching(news.roots))
        });
        report.cost_seconds = cost_seconds;
        report.pairing_seconds = cost_seconds + seconds;
        match initial {
            Ok(initial) => {
                report.total_cost = initial.proof.as_ref().map(|proof| proof.cost);
                Ok(initial)
            }
            Err(SolveError::Stopped { .. }) => {
                report.stopped = true;
                Err(ConvertError::Stopped(Box::new(report.clone())))
            }
            Err(error) => Err(ConvertError::Costs(error)),
        }
    }

    /// Augments until the matching is perfect.
    fn make_perfect<'t>(
        &mut self,
        triangulation: Cow<'t, Triangulation>,
        dual: DualGraph,
        matching: Matching,
        mut report: Report,
    ) -> Result<Paired<'t>, ConvertError> {
        self.enter(Stage::Augmenting(report.unpaired_triangles / 2));
        let ((matching, paths), augmentation_seconds) = self.time(|settings| {
            let mut silent = ();
            let progress = settings.progress.as_deref_mut().unwrap_or(&mut silent);
            make_maximum(&dual, matching, settings.augmentation, &mut || progress.path_found())
        });
        report.paths = paths;
        report.augmentation_seconds = augmentation_seconds;
        match matching.certify(&dual) {
            Ok(perfect) => Ok(Paired { triangulation, dual, perfect, report }),
            Err(_) => {
                // A bridgeless 3-regular graph has a perfect matching (Theorem 2.1).
                report.stopped = true;
                Err(ConvertError::Stopped(Box::new(report)))
            }
        }
    }

    fn enter(&mut self, stage: Stage) {
        if let Some(progress) = &mut self.progress {
            progress.stage(stage);
        }
    }

    /// Runs `work` and returns its result with the seconds that passed.
    fn time<T>(&mut self, work: impl FnOnce(&mut Self) -> T) -> (T, f64) {
        let system = SystemClock::default();
        let clock = self.clock.unwrap_or(&system);
        let start = clock.seconds();
        let result = work(self);
        (result, clock.seconds() - start)
    }
}

/// A perfect pairing, and what it pairs.
struct Paired<'t> {
    triangulation: Cow<'t, Triangulation>,
    dual: DualGraph,
    perfect: PerfectMatching,
    report: Report,
}

/// Checks quads against the triangles that were paired, and those, if they are `flipped`, against
/// the triangles given.
fn check_result(
    quads: &Faces,
    flipped: Option<&Faces>,
    given: &Mesh,
) -> Result<CheckReport, Mismatch> {
    let vertices = given.positions().len();
    if let Some(flipped) = flipped {
        check_retriangulated_faces(flipped, given.faces(), vertices)?;
    }
    check_faces(quads, flipped.unwrap_or(given.faces()), vertices)
}
