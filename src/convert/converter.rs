//! The builder of a conversion, and its first stage; `closed` and `mixed` have the others.

use std::borrow::Cow;
use std::fmt;

use super::aims::Aims;
use super::converted::Converted;
use super::error::ConvertError;
use super::progress::{Progress, Stage};
use super::report::{Report, Size};
use crate::augmentation::Augmentation;
use crate::clock::{Clock, SystemClock};
use crate::irreducible::Discipline;
use crate::mesh::Mesh;
use crate::pairing::{Algorithm, LRS_ORDER};
use crate::quadrangulation::{Cost, Keep};
use crate::triangulation::{Law, OpenTriangulation, Survey, Triangulation};

/// Converts triangle meshes into quads on the same vertices: of closed surfaces, and of others with
/// [`Converter::open`].
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
    pub(super) algorithm: Algorithm,
    pub(super) lrs_order: Discipline,
    pub(super) augmentation: Augmentation,
    pub(super) seed: u64,
    pub(super) orient: bool,
    pub(super) open: bool,
    pub(super) aims: Aims<'a>,
    pub(super) keep_proof: bool,
    pub(super) clock: Option<&'a dyn Clock>,
    pub(super) progress: Option<&'a mut dyn Progress>,
}

impl fmt::Debug for Converter<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Converter")
            .field("algorithm", &self.algorithm)
            .field("lrs_order", &self.lrs_order)
            .field("augmentation", &self.augmentation)
            .field("seed", &self.seed)
            .field("orient", &self.orient)
            .field("open", &self.open)
            .field("aims", &self.aims)
            .finish_non_exhaustive()
    }
}

impl Default for Converter<'_> {
    fn default() -> Self {
        Self::new()
    }
}

impl<'a> Converter<'a> {
    /// Makes a converter by `best` with [`DefaultCost`](crate::DefaultCost), augmentation `local`
    /// and seed 0.
    pub fn new() -> Self {
        Self {
            algorithm: Algorithm::Best,
            lrs_order: LRS_ORDER,
            augmentation: Augmentation::Local,
            seed: 0,
            orient: false,
            open: false,
            aims: Aims::default(),
            keep_proof: false,
            clock: None,
            progress: None,
        }
    }

    /// Sets the algorithm of the initial pairing.
    #[must_use]
    pub fn algorithm(self, algorithm: Algorithm) -> Self {
        Self { algorithm, ..self }
    }

    /// Sets the order in which `lrs` tests the edges at a vertex, in place of [`LRS_ORDER`].
    #[must_use]
    pub fn lrs_order(self, lrs_order: Discipline) -> Self {
        Self { lrs_order, ..self }
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

    /// Sets what `best` minimises the sum of, in place of [`DefaultCost`](crate::DefaultCost).
    #[must_use]
    pub fn cost(self, cost: &'a dyn Cost) -> Self {
        Self { aims: Aims { cost: Some(cost), ..self.aims }, ..self }
    }

    /// Sets all aims of `best` together: its cost, edges to keep, triangles that may be left.
    #[must_use]
    pub fn aims(self, aims: Aims<'a>) -> Self {
        Self { aims, ..self }
    }

    /// Sets the costs edge by edge, in place of [`Converter::cost`].
    ///
    /// For their order see [`listed_costs`](crate::quadrangulation::listed_costs). With
    /// [`Converter::orient`] it is that of the faces as flipped.
    #[must_use]
    pub fn edge_costs(self, costs: Vec<i32>) -> Self {
        Self { aims: Aims { listed_costs: Some(costs), ..self.aims }, ..self }
    }

    /// Sets the edges that no quad shall lie across. `best` only.
    ///
    /// As few of them as can be are given up so that as many triangles as can be are paired. That
    /// ranks above all costs.
    #[must_use]
    pub fn keep(self, keep: Keep) -> Self {
        Self { aims: Aims { keep, ..self.aims }, ..self }
    }

    /// Sets whether no edge to keep is given up. The fewest triangles are left over instead.
    #[must_use]
    pub fn strict(self, strict: bool) -> Self {
        Self { aims: Aims { strict, ..self.aims }, ..self }
    }

    /// Sets whether surfaces may have a boundary or be one-sided.
    ///
    /// The fewest triangles are left over, provably. Some algorithms refuse such surfaces; see
    /// [`Algorithm::works_on_open`].
    #[must_use]
    pub fn open(self, open: bool) -> Self {
        Self { open, ..self }
    }

    /// Sets the price at which any triangle may be left over, in the unit of the costs. `best`
    /// only.
    ///
    /// Then no quad costs more than twice the price.
    #[must_use]
    pub fn quad_dominant(self, price: i32) -> Self {
        Self { aims: Aims { price: Some(price), ..self.aims }, ..self }
    }

    /// Sets whether the result keeps the proof that it is the best. `best` only.
    #[must_use]
    pub fn keep_proof(self, keep_proof: bool) -> Self {
        Self { keep_proof, ..self }
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
    /// The mesh is no triangulation of closed surfaces, nor of open ones if they are allowed; costs
    /// or edges to keep do not fit it; or the conversion was stopped.
    ///
    /// # Cost
    /// Nearly linear on every mesh measured, except for `lrs` at high genus and degree. On closed
    /// surfaces O(n log n) with `tq`, `sg`, `ps` or `gw` and augmentation `local`; no such bound is
    /// proved for `best`. About 100 bytes a triangle at the peak, the mesh included.
    pub fn run<'m>(&mut self, mesh: impl Into<Cow<'m, Mesh>>) -> Result<Converted, ConvertError> {
        let mut mesh = mesh.into();
        if let Some(aim) = self.aims.only_for_best().filter(|_| self.algorithm != Algorithm::Best) {
            return Err(ConvertError::NeedsBest { aim, algorithm: self.algorithm });
        }
        self.enter(Stage::Building);
        let (built, build_seconds) = self.time(|settings| settings.build(&mut mesh));
        match built? {
            Built::Closed(surface) if self.aims.may_leave_triangles() => {
                let report = Report { build_seconds, ..self.report(Size::from(&surface)) };
                self.run_mixed(&surface, mesh, report)
            }
            Built::Closed(surface) => self.run_closed(surface, mesh, build_seconds),
            Built::Open(surface, survey) => {
                self.require_open_algorithm()?;
                let report = Report {
                    build_seconds,
                    boundary_loops: Some(survey.boundary_loops),
                    non_orientable_genus: survey.non_orientable_genus(),
                    ..self.report(Size::from(&*survey))
                };
                self.run_mixed(&surface, mesh, report)
            }
        }
    }

    /// Builds the surface. Faces are flipped in a copy if the mesh is borrowed.
    fn build(&self, mesh: &mut Cow<'_, Mesh>) -> Result<Built, ConvertError> {
        let mut survey = match Triangulation::build(mesh) {
            Ok(triangulation) => return Ok(Built::Closed(triangulation)),
            Err(survey) => survey,
        };
        if self.orient && survey.only_orientation_is_wrong() {
            survey.orient(mesh.to_mut());
            return Ok(Built::Closed(Triangulation::build(mesh)?));
        }
        if !self.open || !survey.is_open_surface(self.orient) {
            if self.orient && !survey.faces_to_flip.is_empty() {
                survey.orient(mesh.to_mut());
                *survey = Survey::new(mesh);
            }
            // What is allowed is no reason, so it comes last.
            let is_allowed = |law| self.open && matches!(law, Law::NoBoundary | Law::Orientable);
            survey.violations.sort_by_key(|violation| is_allowed(violation.law));
            return Err(survey.into());
        }
        if self.orient {
            survey.orient(mesh.to_mut());
        }
        Ok(Built::Open(OpenTriangulation::join(mesh), survey))
    }

    /// Checks that the algorithm pairs triangles of open surfaces.
    fn require_open_algorithm(&self) -> Result<(), ConvertError> {
        let can = self.algorithm.works_on_open();
        can.then_some(()).ok_or(ConvertError::NeedsClosed(self.algorithm))
    }

    /// Makes the report of a conversion that begins.
    pub(super) fn report(&self, size: Size) -> Report {
        let lrs_order = self.lrs_order;
        Report { lrs_order, ..Report::new(self.algorithm, self.augmentation, self.seed, size) }
    }

    pub(super) fn enter(&mut self, stage: Stage) {
        if let Some(progress) = &mut self.progress {
            progress.stage(stage);
        }
    }

    /// Runs `work` and returns its result with the seconds that passed.
    pub(super) fn time<T>(&mut self, work: impl FnOnce(&mut Self) -> T) -> (T, f64) {
        let system = SystemClock::default();
        let clock = self.clock.unwrap_or(&system);
        let start = clock.seconds();
        let result = work(self);
        (result, clock.seconds() - start)
    }
}

/// The surface of a mesh.
enum Built {
    Closed(Triangulation),
    /// Open or one-sided, with its counts.
    Open(OpenTriangulation, Box<Survey>),
}
