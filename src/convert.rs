//! The chain from triangles to quads, and the only readings of the clock.

use std::borrow::Cow;
use std::ops::ControlFlow;

use crate::augmentation::{Augmentation, AugmentationStats, make_maximum};
use crate::clock::{Clock, SystemClock};
use crate::dual::{DualGraph, Matching};
use crate::mesh::{FaceList, Faces};
use crate::pairing::{Algorithm, InitialPairing};
use crate::quadrangulation::{
    CheckReport, Mismatch, Quadrangulation, check_faces, check_retriangulated_faces,
};
use crate::random::Random;
use crate::triangulation::{Survey, Triangulation};

const PETERSEN: &str = "a bridgeless 3-regular graph has a perfect matching (Theorem 2.1)";

/// How to convert.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Settings {
    /// How triangles are paired at first.
    pub algorithm: Algorithm,
    /// How the pairing is made perfect.
    pub augmentation: Augmentation,
    /// Master seed of everything random.
    pub seed: u64,
}

impl Default for Settings {
    fn default() -> Self {
        Self { algorithm: Algorithm::Triquad, augmentation: Augmentation::Local, seed: 0 }
    }
}

/// A stage of a conversion, for those who want to show that something happens.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Adjacency and validation.
    Building,
    /// The initial pairing.
    Pairing,
    /// Augmenting paths: how many are known to be needed.
    Augmenting(usize),
    /// Quads and their check.
    Checking,
}

/// Is told what a conversion does, and may stop it between two augmenting paths.
pub trait Progress {
    /// A stage begins.
    fn stage(&mut self, _stage: Stage) {}
    /// One more augmenting path has been found; whether to look for the next.
    fn path_found(&mut self) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}

impl Progress for () {}

/// A conversion's result, counts and times. Times are in seconds.
#[derive(Clone, Debug)]
pub struct Conversion<'t> {
    /// The quads.
    pub quadrangulation: Quadrangulation,
    /// The triangulation whose triangles were paired.
    pub triangulation: Cow<'t, Triangulation>,
    /// Triangles k that the initial pairing left unpaired: column (c) of the paper's tables.
    pub unpaired_triangles: usize,
    /// Edges of the triangulation whose triangles were paired that the input does not have.
    pub edge_flips: usize,
    /// What the augmentation did.
    pub augmentation: AugmentationStats,
    /// Column (a): from the triangulation to the initial pairing, its dual graph included.
    pub pairing_seconds: f64,
    /// Column (d): from the initial pairing to the perfect one.
    pub augmentation_seconds: f64,
}

/// What converting a face list told: counts and, in seconds, times.
#[derive(Clone, Debug, PartialEq)]
pub struct Summary {
    /// Referenced vertices n_v.
    pub vertices: usize,
    /// Edges n_e of the triangulation.
    pub edges: usize,
    /// Triangles n_f.
    pub triangles: usize,
    /// Genus, summed over components.
    pub genus: usize,
    /// Connected components.
    pub components: usize,
    /// Column (c), see [`Conversion`].
    pub unpaired_triangles: usize,
    /// See [`Conversion`].
    pub edge_flips: usize,
    /// What the augmentation did.
    pub augmentation: AugmentationStats,
    /// What the check of the result found.
    pub check: CheckReport,
    /// Adjacency and validation, with the flips of `--orient`.
    pub build_seconds: f64,
    /// Column (a), see [`Conversion`].
    pub pairing_seconds: f64,
    /// Column (d), see [`Conversion`].
    pub augmentation_seconds: f64,
    /// The check of the result, from the two meshes alone.
    pub check_seconds: f64,
}

impl Summary {
    /// Column (b): the share of triangles that the initial pairing paired, in percent.
    pub fn paired_percent(&self) -> f64 {
        100.0 * (self.triangles - self.unpaired_triangles) as f64 / self.triangles as f64
    }

    /// Column (e): (a) + (d).
    pub fn total_seconds(&self) -> f64 {
        self.pairing_seconds + self.augmentation_seconds
    }
}

/// Why there is no quad mesh.
#[derive(Clone, Debug, thiserror::Error)]
pub enum ConvertError {
    /// The input is no triangulation of closed surfaces; the survey tells why.
    #[error("{0}")]
    Refused(Box<Survey>),
    /// The result failed its check: a mistake of ours.
    #[error("the result failed its check, please report this: {0}")]
    Wrong(Mismatch),
    /// [`Progress`] said to stop before the pairing was perfect: counts and times so far.
    #[error("stopped after {} augmenting paths", .0.augmentation.paths)]
    Stopped(Box<Summary>),
}

/// Converts a triangulation. O(k n) time in the worst case for k triangles left unpaired at first,
/// linear on every mesh measured.
///
/// ```
/// use triquad::{Quadrangulation, Triangulation, convert, mesh::FaceList};
///
/// let tetrahedron = vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
/// let points = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let triangulation = Triangulation::build(&FaceList::from_triangles(points, tetrahedron))?;
/// let quadrangulation: Quadrangulation = convert(&triangulation, &Default::default());
/// assert_eq!(quadrangulation.len(), 2);
/// # Ok::<(), Box<triquad::Survey>>(())
/// ```
pub fn convert(triangulation: &Triangulation, settings: &Settings) -> Quadrangulation {
    convert_timed(triangulation, settings, &SystemClock::default(), &mut ()).quadrangulation
}

/// Like [`convert`], with counts and times.
///
/// # Panics
/// If `progress` stops it: see [`pair`].
pub fn convert_timed<'t>(
    triangulation: &'t Triangulation,
    settings: &Settings,
    clock: &impl Clock,
    progress: &mut dyn Progress,
) -> Conversion<'t> {
    let paired = pair(triangulation, settings, clock, progress);
    let perfect = paired.matching.certify(&paired.dual).expect(PETERSEN);
    Conversion {
        quadrangulation: Quadrangulation::new(&paired.triangulation, &perfect),
        triangulation: paired.triangulation,
        unpaired_triangles: paired.unpaired_triangles,
        edge_flips: paired.edge_flips,
        augmentation: paired.augmentation,
        pairing_seconds: paired.pairing_seconds,
        augmentation_seconds: paired.augmentation_seconds,
    }
}

/// What both stages of a conversion lead to. Times are in seconds.
#[derive(Clone, Debug)]
pub struct Paired<'t> {
    /// The triangulation whose triangles were paired.
    pub triangulation: Cow<'t, Triangulation>,
    /// Its dual graph.
    pub dual: DualGraph,
    /// The pairs: a perfect matching, unless the augmentation was stopped.
    pub matching: Matching,
    /// Whether it was stopped.
    pub stopped: bool,
    /// Column (c), see [`Conversion`].
    pub unpaired_triangles: usize,
    /// See [`Conversion`].
    pub edge_flips: usize,
    /// What the augmentation did.
    pub augmentation: AugmentationStats,
    /// Column (a), see [`Conversion`].
    pub pairing_seconds: f64,
    /// Column (d), as far as it went.
    pub augmentation_seconds: f64,
}

/// Pairs triangles and augments until the pairing is perfect or `progress` says to stop: a few paths
/// are enough for an estimate where the whole would take too long.
pub fn pair<'t>(
    triangulation: &'t Triangulation,
    settings: &Settings,
    clock: &impl Clock,
    progress: &mut dyn Progress,
) -> Paired<'t> {
    progress.stage(Stage::Pairing);
    let mut random = Random::stream(settings.seed, &[settings.algorithm.id()]);
    let (initial, pairing_seconds) =
        clock.time(|| settings.algorithm.pair(triangulation, &mut random));
    let InitialPairing { triangulation, dual, matching, edge_flips } = initial;
    let unpaired_triangles = matching.unpaired_count();

    progress.stage(Stage::Augmenting(unpaired_triangles / 2));
    let mut stopped = false;
    let on_path = &mut || {
        let flow = progress.path_found();
        stopped = flow.is_break();
        flow
    };
    let ((matching, augmentation), augmentation_seconds) =
        clock.time(|| make_maximum(&dual, matching, settings.augmentation, on_path));
    Paired {
        triangulation,
        dual,
        matching,
        stopped,
        unpaired_triangles,
        edge_flips,
        augmentation,
        pairing_seconds,
        augmentation_seconds,
    }
}

/// What [`convert_mesh`] makes of a face list.
#[derive(Clone, Debug)]
pub struct ConvertedMesh {
    /// The vertices of the input and the quads.
    pub quads: FaceList,
    /// The triangles that were paired: those of the input, or others on the same vertices.
    pub triangles: Faces,
    /// Counts and times.
    pub summary: Summary,
}

/// Like [`convert_mesh`], without the triangles.
///
/// # Errors
/// The input breaks a law.
pub fn convert_list(
    list: FaceList,
    flip_faces: bool,
    settings: &Settings,
    clock: &impl Clock,
    progress: &mut dyn Progress,
) -> Result<(FaceList, Summary), ConvertError> {
    let converted = convert_mesh(list, flip_faces, settings, clock, progress)?;
    Ok((converted.quads, converted.summary))
}

/// Converts a face list into one of quads on the same vertices, checks the result, and tells counts
/// and times. With `flip_faces`, faces that disagree on orientation are flipped first.
///
/// # Errors
/// The input breaks a law, or `progress` stopped the augmentation.
///
/// # Cost
/// As for [`convert`]; at its peak about 100 bytes a triangle, the list included.
pub fn convert_mesh(
    mut list: FaceList,
    flip_faces: bool,
    settings: &Settings,
    clock: &impl Clock,
    progress: &mut dyn Progress,
) -> Result<ConvertedMesh, ConvertError> {
    progress.stage(Stage::Building);
    let (built, build_seconds) =
        clock.time(|| Triangulation::build_oriented(&mut list, flip_faces));
    let triangulation = built.map_err(ConvertError::Refused)?;
    let paired = pair(&triangulation, settings, clock, progress);
    let mut summary = Summary {
        vertices: triangulation.vertex_count(),
        edges: triangulation.edge_count(),
        triangles: triangulation.triangle_count(),
        genus: triangulation.genus(),
        components: triangulation.component_count(),
        unpaired_triangles: paired.unpaired_triangles,
        edge_flips: paired.edge_flips,
        augmentation: paired.augmentation,
        check: CheckReport::default(),
        build_seconds,
        pairing_seconds: paired.pairing_seconds,
        augmentation_seconds: paired.augmentation_seconds,
        check_seconds: 0.0,
    };
    let perfect = match paired.matching.certify(&paired.dual) {
        Ok(perfect) => perfect,
        Err(_) if paired.stopped => return Err(ConvertError::Stopped(Box::new(summary))),
        Err(_) => unreachable!("{PETERSEN}"),
    };
    let quadrangulation = Quadrangulation::new(&paired.triangulation, &perfect);
    drop((perfect, paired.dual));

    progress.stage(Stage::Checking);
    let quads = quadrangulation.faces();
    let flipped = match &paired.triangulation {
        Cow::Borrowed(_) => None,
        Cow::Owned(flipped) => Some(flipped.faces()),
    };
    let (check, check_seconds) = clock.time(|| check_result(&quads, flipped.as_ref(), &list));
    summary.check = check.map_err(ConvertError::Wrong)?;
    summary.check_seconds = check_seconds;
    let attributes = quadrangulation.carry_attributes(&paired.triangulation, &triangulation, &list);
    let given = std::mem::replace(&mut list.faces, quads);
    list.cut_from.clear();
    list.attributes = attributes.map(Box::new);
    Ok(ConvertedMesh { quads: list, triangles: flipped.unwrap_or(given), summary })
}

/// Checks quads against the triangles that were paired, and those, if they are `flipped`, against
/// the triangles given.
fn check_result(
    quads: &Faces,
    flipped: Option<&Faces>,
    given: &FaceList,
) -> Result<CheckReport, Mismatch> {
    let vertices = given.positions.len();
    if let Some(flipped) = flipped {
        check_retriangulated_faces(flipped, &given.faces, vertices)?;
    }
    check_faces(quads, flipped.unwrap_or(&given.faces), vertices)
}
