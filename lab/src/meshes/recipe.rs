//! Definitions of meshes: recipes, and the kinds of meshes in records.

use std::path::PathBuf;

use triquad::mesh::{Mesh, MeshError};
use triquad::random::Random;
use triquad::simplify::{Rule, Simplifier, SimplifyError};
use triquad::triangulation::Triangulation;
use triquad_generators::box_mesh::{
    BoxShape, ImpossibleBoxError, ImpossiblePaperBoxError, PaperBox, Walls,
};
use triquad_generators::{Surface, classic, organic};

/// Origin of a mesh in records.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum MeshKind {
    /// A file.
    #[default]
    Real,
    /// Made to order with exact counts.
    Generated,
    /// Simplified from a generated mesh.
    Simplified,
    /// Made in place of a scan that was not at hand: its counts, another shape.
    StandIn,
}

impl MeshKind {
    /// Returns the name in records.
    pub fn id(self) -> &'static str {
        match self {
            Self::Real => "real",
            Self::Generated => "generated",
            Self::Simplified => "simplified",
            Self::StandIn => "stand-in",
        }
    }
}

/// Vertices of a stand-in's source for each that is left, at least.
const OVERSAMPLING: u64 = 3;

/// Everything that fixes the bytes of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Recipe {
    /// A box with shafts and an exact number of vertices.
    Box(BoxShape),
    /// A box of the papers' kind (Lemos et al., section 4; Ramaswami-Siqueira, section 5.1).
    PaperBox {
        /// Its size.
        shape: PaperBox,
        /// The diagonals of its walls.
        walls: Walls,
        /// Seed of those that are drawn.
        seed: u64,
    },
    /// A box of the papers' kind, simplified to so many vertices by [`Rule::Plain`].
    SimplifiedBox {
        /// The box, with the usual diagonals.
        of: PaperBox,
        /// Vertices that are left.
        vertices: u32,
    },
    /// The bipyramid over a polygon with a vertex in each triangle (Ramaswami-Siqueira, Figure 6).
    StarredBipyramid {
        /// Sides of the polygon.
        sides: u32,
    },
    /// A surface like a scan: smooth, irregular, simplified from three times as many vertices or
    /// from the fewest that resolve its shape ([`organic::minimum_vertices`]), whichever is more.
    StandIn {
        /// Vertices that are left.
        vertices: u32,
        /// Genus.
        genus: u32,
        /// Seed of its shape.
        seed: u64,
    },
}

/// Reason why a mesh cannot be made.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum GenerateError {
    /// There is no such box.
    #[error("{0}")]
    Box(#[from] ImpossibleBoxError),
    /// There is no such box of the papers' kind.
    #[error("{0}")]
    PaperBox(#[from] ImpossiblePaperBoxError),
    /// Simplification cannot get there.
    #[error("{0}")]
    Simplify(#[from] SimplifyError),
    /// A stand-in's source would have too many half-edges.
    #[error("the stand-in would be simplified from {half_edges} half-edges, more than 2^31")]
    TooLarge {
        /// Number it would have.
        half_edges: u64,
    },
    /// The cache could not be written.
    #[error("the cache in {}: {error}", folder.display())]
    Cache {
        /// Folder of the cache.
        folder: PathBuf,
        /// The fault.
        error: MeshError,
    },
}

impl Recipe {
    /// Makes the mesh. Linear time for a box; simplification takes O(n log n) for the n vertices
    /// that it begins with.
    ///
    /// # Errors
    /// There is no such mesh, and why.
    pub fn make(&self) -> Result<Mesh, GenerateError> {
        match *self {
            Self::Box(shape) => Ok(into_list(shape.surface()?)),
            Self::PaperBox { shape, walls, seed } => paper_box(shape, walls, seed),
            Self::SimplifiedBox { of, vertices } => {
                let source = paper_box(of, Walls::default(), 0)?;
                simplified(&source, Rule::Plain, &[], vertices, |_, _| Ok(()))
            }
            Self::StarredBipyramid { sides } => Ok(into_list(classic::starred_bipyramid(sides))),
            Self::StandIn { vertices, genus, seed } => {
                let source = stand_in_source(vertices, genus, seed)?;
                simplified(&source, Rule::Guarded, &[], vertices, |_, _| Ok(()))
            }
        }
    }

    /// Returns a name that no other recipe has, fit for a file.
    pub fn key(&self) -> String {
        let of_box = |b: BoxShape| format!("box-{}-{}-{}", b.vertices, b.cavities, b.holes);
        let of_paper_box = |b: PaperBox| format!("paper-box-{}-{}-{}", b.shafts, b.depth, b.holes);
        match *self {
            Self::Box(shape) => of_box(shape),
            Self::PaperBox { shape, walls, seed } => {
                format!("{}-{}-{seed}", of_paper_box(shape), walls.id())
            }
            Self::SimplifiedBox { of, vertices } => format!("{}-to-{vertices}", of_paper_box(of)),
            Self::StarredBipyramid { sides } => format!("starred-bipyramid-{sides}"),
            Self::StandIn { vertices, genus, seed } => {
                format!("stand-in-{vertices}-{genus}-{seed}")
            }
        }
    }

    /// Returns whether making the mesh takes longer than reading it from a file.
    pub(super) fn is_costly(&self) -> bool {
        matches!(self, Self::SimplifiedBox { .. } | Self::StandIn { .. })
    }
}

fn into_list(surface: Surface) -> Mesh {
    Mesh::from_triangles(surface.positions, surface.triangles)
}

pub(super) fn paper_box(shape: PaperBox, walls: Walls, seed: u64) -> Result<Mesh, GenerateError> {
    let mut random = Random::stream(seed, &["paper-box"]);
    Ok(into_list(shape.surface(walls, &mut |bound| random.below(bound))?))
}

fn stand_in_source(vertices: u32, genus: u32, seed: u64) -> Result<Mesh, GenerateError> {
    let source = (OVERSAMPLING * u64::from(vertices)).max(organic::minimum_vertices(genus));
    // E = 3 (V - 2 + 2g) by Euler's formula.
    let half_edges = 6 * (source - 2 + 2 * u64::from(genus));
    if half_edges > 1 << 31 {
        return Err(GenerateError::TooLarge { half_edges });
    }
    let source = u32::try_from(source).expect("there are fewer vertices than half-edges");
    let mut random = Random::stream(seed, &["stand-in", &vertices.to_string(), &genus.to_string()]);
    Ok(into_list(organic::surface(genus, source, &mut |bound| random.below(bound))))
}

/// Simplifies `list` by `rule` to `vertices`, and calls `on_the_way` with the mesh at each of
/// `stops`, descending.
pub(super) fn simplified(
    list: &Mesh,
    rule: Rule,
    stops: &[u32],
    vertices: u32,
    mut on_the_way: impl FnMut(u32, Mesh) -> Result<(), GenerateError>,
) -> Result<Mesh, GenerateError> {
    let triangulation = Triangulation::build(list).expect("what is generated is a triangulation");
    let mut simplifier = Simplifier::with_rule(triangulation, list.positions(), rule);
    for &stop in stops {
        simplifier.reduce_to(stop as usize)?;
        on_the_way(stop, simplifier.result().0)?;
    }
    simplifier.reduce_to(vertices as usize)?;
    Ok(simplifier.result().0)
}
