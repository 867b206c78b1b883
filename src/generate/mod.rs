//! Meshes made to order: the boxes of both papers, what simplification makes of them, and stand-ins
//! for scans that are not at hand.
//!
//! A [`Recipe`] fixes every byte of its mesh. [`paper`] knows the recipes of the papers' meshes by
//! name, and a [`Cache`] makes each mesh once.

mod cache;
pub mod paper;

pub use cache::Cache;
pub use triquad_generators::box_mesh::{BoxShape, ImpossibleBox};

use triquad_generators::{Surface, organic};

use crate::mesh::{FaceList, MeshError};
use crate::random::Random;
use crate::simplify::{Simplifier, SimplifyError};
use crate::triangulation::Triangulation;

/// How often a stand-in's source has the vertices that are left of it.
const OVERSAMPLING: u32 = 3;

/// What mesh is wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Recipe {
    /// A box with shafts (Lemos et al., section 4; Ramaswami-Siqueira, section 5.1).
    Box(BoxShape),
    /// A box simplified to so many vertices.
    SimplifiedBox {
        /// The box.
        of: BoxShape,
        /// Vertices that are left.
        vertices: u32,
    },
    /// A surface like a scan: smooth, irregular, simplified from three times as many vertices.
    StandIn {
        /// Vertices that are left.
        vertices: u32,
        /// Genus.
        genus: u32,
        /// Seed of its shape.
        seed: u64,
    },
}

/// Why a mesh cannot be made.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum GenerateError {
    /// There is no such box.
    #[error("{0}")]
    Box(#[from] ImpossibleBox),
    /// Simplification cannot get there.
    #[error("{0}")]
    Simplify(#[from] SimplifyError),
    /// A stand-in's source would have too many half-edges.
    #[error("a stand-in of {0} vertices needs a source of more than 2^31 half-edges")]
    TooLarge(u32),
    /// The cache could not be written.
    #[error("the cache: {0}")]
    Cache(#[from] MeshError),
}

impl Recipe {
    /// Makes the mesh. Linear time for a box; simplification takes O(n log n) for the n vertices that
    /// it begins with.
    ///
    /// # Errors
    /// There is no such mesh, and why.
    pub fn make(&self) -> Result<FaceList, GenerateError> {
        match *self {
            Self::Box(shape) => Ok(into_list(shape.surface()?)),
            Self::SimplifiedBox { of, vertices } => {
                simplified(&into_list(of.surface()?), &[vertices], |_| Ok(()))
            }
            Self::StandIn { vertices, genus, seed } => {
                simplified(&stand_in_source(vertices, genus, seed)?, &[vertices], |_| Ok(()))
            }
        }
    }

    /// A name that no other recipe has, fit for a file.
    pub fn key(&self) -> String {
        let of_box = |b: BoxShape| format!("box-{}-{}-{}", b.vertices, b.cavities, b.holes);
        match *self {
            Self::Box(shape) => of_box(shape),
            Self::SimplifiedBox { of, vertices } => format!("{}-to-{vertices}", of_box(of)),
            Self::StandIn { vertices, genus, seed } => {
                format!("stand-in-{vertices}-{genus}-{seed}")
            }
        }
    }

    /// Whether making the mesh takes longer than reading it from a file.
    fn is_costly(&self) -> bool {
        !matches!(self, Self::Box(_))
    }
}

fn into_list(surface: Surface) -> FaceList {
    FaceList::from_triangles(surface.positions, surface.triangles)
}

fn stand_in_source(vertices: u32, genus: u32, seed: u64) -> Result<FaceList, GenerateError> {
    let source = vertices.checked_mul(OVERSAMPLING).filter(|&source| source < 1 << 28);
    let source = source.ok_or(GenerateError::TooLarge(vertices))?;
    let mut random = Random::stream(seed, &["stand-in", &vertices.to_string(), &genus.to_string()]);
    Ok(into_list(organic::surface(genus, source, &mut |bound| random.below(bound))))
}

/// Simplifies `list` to each of `targets`, descending; all but the last go to `on_the_way`.
fn simplified(
    list: &FaceList,
    targets: &[u32],
    mut on_the_way: impl FnMut(FaceList) -> Result<(), GenerateError>,
) -> Result<FaceList, GenerateError> {
    let triangulation = Triangulation::build(list).expect("what is generated is a triangulation");
    let mut simplifier = Simplifier::new(triangulation, &list.positions);
    let (&last, before) = targets.split_last().expect("something is wanted");
    for &target in before {
        simplifier.reduce_to(target as usize)?;
        on_the_way(simplifier.result().0)?;
    }
    simplifier.reduce_to(last as usize)?;
    Ok(simplifier.result().0)
}
