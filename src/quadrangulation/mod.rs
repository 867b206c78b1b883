//! The last stage: a quadrilateral for every pair of triangles (Lemos et al., section 2).
//!
//! # Examples
//!
//! A pair of triangles, the shape of its quad, and the check of a whole mesh:
//!
//! ```
//! use triquad::mesh::{Faces, Mesh};
//! use triquad::quadrangulation::quality::{Quality, scaled_jacobian};
//!
//! let square = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
//! assert_eq!(scaled_jacobian(square), 1.0);
//! let quads = Mesh::new(square.to_vec(), Faces::uniform(4, vec![0, 1, 2, 3]));
//! assert_eq!(Quality::new(&quads).folded, 0);
//! ```
//!
//! Edges to keep, and costs of edges:
//!
//! ```
//! use triquad::quadrangulation::{DefaultCost, EdgeQuad, Keep, edge_costs};
//! use triquad::triangulation::HalfEdgeId;
//! use triquad::{Mesh, Triangulation};
//!
//! let corners = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
//! let mesh = Mesh::from_triangles(corners, vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
//! let surface = Triangulation::build(&mesh)?;
//! let mut keep = Keep::default();
//! keep.sharp = Some(80.0);
//! assert_eq!(keep.find(&surface, &mesh).expect("no edge is listed").len(), 6);
//! let costs = edge_costs(&surface, mesh.positions(), &DefaultCost);
//! assert_eq!(costs.len(), surface.triangle_count());
//! let quad = EdgeQuad::across(&surface, mesh.positions(), HalfEdgeId::new(0));
//! assert!(quad.fold_cosine() < 0.1);
//! # Ok::<(), Box<triquad::Survey>>(())
//! ```
//!
//! The checks have examples where they stand. What [`Converter`](crate::Converter) calls has no
//! examples of its own: attributes that are carried over, listed costs, losses.

mod check;
mod check_error;
mod check_mixed;
mod cost;
mod edge_ends;
mod edge_quad;
mod keep;
mod listed_costs;
mod losses;
mod mixed;
pub mod quality;
mod retriangulation;
mod seams;
mod sharp_edges;

use crate::dual::PerfectMatching;
use crate::mesh::{Attributes, CornerIndices, Faces, Mesh};
use crate::parallel::{collect, map, ranges};
use crate::triangulation::{HalfEdgeId, IdVec, TriangleId, Triangulation, VertexId};

pub(crate) use check::check_faces;
pub use check::{CheckReport, check};
pub use check_error::{CheckError, FaceFault};
pub(crate) use check_mixed::check_mixed_faces;
pub use check_mixed::{MixedCheck, check_mixed};
pub use cost::{Cost, DefaultCost, ShapeCost, edge_costs};
pub use edge_quad::EdgeQuad;
use edge_quad::quad_corners;
pub use keep::{Keep, NoSuchEdgeError};
pub use listed_costs::{CostCountError, listed_costs};
pub use losses::{AttributeLosses, Border};
pub use mixed::MixedFaces;
pub(crate) use retriangulation::check_retriangulated_faces;
pub use retriangulation::{check_retriangulation, common_edges};
pub use sharp_edges::SharpEdges;

/// A quadrangulation of the surface of a triangulation, on the same vertices.
///
/// It arises by removing the common edge of each pair of triangles. Orientation, vertices and all
/// other edges are those of the triangulation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quadrangulation {
    /// For each quad, the side of its lower triangle that was removed.
    removed: Vec<HalfEdgeId>,
    corners: Vec<[VertexId; 4]>,
}

impl Quadrangulation {
    /// Removes the common edge of every pair of `matching` in `triangulation`. O(n).
    ///
    /// Quads come in the order of their lower triangles, each starting where the removed edge
    /// starts, counter-clockwise.
    ///
    /// # Panics
    /// If two mates have no common edge: the matching is that of another triangulation.
    pub fn new(triangulation: &Triangulation, matching: &PerfectMatching) -> Self {
        let sides_of = |lower| {
            let pairs = matching.pairs_from(lower);
            pairs.map(|(lower, upper)| common_side(triangulation, lower, upper)).collect()
        };
        let removed = map(ranges(triangulation.triangle_count()), sides_of);
        let removed: Vec<HalfEdgeId> = <[Vec<_>]>::concat(&removed);
        let corners = collect(removed.len(), |quad| quad_across(triangulation, removed[quad]));
        Self { removed, corners }
    }

    /// Returns for each quad the side of its lower triangle that was removed.
    pub fn removed(&self) -> &[HalfEdgeId] {
        &self.removed
    }

    /// Returns the number of quads, half the number of triangles.
    pub fn len(&self) -> usize {
        self.corners.len()
    }

    /// Returns whether there is no quad.
    pub fn is_empty(&self) -> bool {
        self.corners.is_empty()
    }

    /// Returns the corners of all quads, counter-clockwise.
    pub fn quads(&self) -> &[[VertexId; 4]] {
        &self.corners
    }

    /// Returns the quads as faces over the vertices of the triangulation. O(n).
    pub fn to_faces(&self) -> Faces {
        Faces::uniform(4, self.corners.as_flattened().iter().map(|vertex| vertex.0).collect())
    }

    /// Returns the quads as faces and drops the rest. O(n).
    pub fn into_faces(self) -> Faces {
        let corners = self.corners.into_flattened();
        Faces::uniform(4, corners.into_iter().map(|vertex| vertex.0).collect())
    }

    /// Carries the attributes of `list` over to the quads; `None` if it has none. O(n).
    ///
    /// `paired` is the triangulation whose triangles were paired, `input` that of `list`: the same,
    /// or another on the same vertices. A corner where both triangles of a quad meet takes the
    /// indices of the lower one. A quad belongs to the sections of its lower triangle.
    ///
    /// # Panics
    /// If `paired` is not the triangulation of the quads, or `input` has other vertices.
    pub fn carry_attributes(
        &self,
        paired: &Triangulation,
        input: &Triangulation,
        list: &Mesh,
    ) -> Option<Attributes> {
        let given = list.attributes()?;
        let corners = CornerFinder::new(input);
        let sources: Vec<_> = self
            .removed
            .iter()
            .flat_map(|&side| corner_sources(paired, side))
            .map(|h| corners.find(h, paired.origin(h)))
            .collect();
        let sources = sources.iter().map(|h| h.index());
        let quad_at = |face: usize| self.removed.partition_point(|side| (side.0 / 3) < face as u32);
        Some(carry(given, sources, quad_at))
    }

    /// Counts what the quads cannot keep of the attributes of `list`. O(n log s) for s sections.
    ///
    /// The arguments are those of [`Quadrangulation::carry_attributes`].
    ///
    /// # Panics
    /// If `paired` is not the triangulation of the quads, or `input` has other vertices.
    pub fn attribute_losses(
        &self,
        paired: &Triangulation,
        input: &Triangulation,
        list: &Mesh,
    ) -> AttributeLosses {
        let Some(attributes) = list.attributes() else { return AttributeLosses::default() };
        let corners = CornerFinder::new(input);
        let corner = |h| corners.find(h, paired.origin(h)).index();
        losses::count(attributes, input, paired, &self.removed, corner)
    }
}

/// Carries attributes over to faces whose corners come from those at `sources`; `face_at` has for
/// each old face the first new one that is not before it.
fn carry(
    given: &Attributes,
    sources: impl Iterator<Item = usize> + Clone,
    face_at: impl Fn(usize) -> usize,
) -> Attributes {
    let gather = |given: &CornerIndices| given.gather(sources.clone());
    Attributes {
        texture_coordinates: given.texture_coordinates.clone(),
        normals: given.normals.clone(),
        corner_texture: gather(&given.corner_texture),
        corner_normal: gather(&given.corner_normal),
        sections: given.sections.moved(face_at),
        libraries: given.libraries.clone(),
    }
}

/// Finds corners of a triangulation for corners of another that was made from it by flips.
struct CornerFinder<'t> {
    input: &'t Triangulation,
    /// For each vertex some half-edge that leaves it.
    outgoing: IdVec<VertexId, HalfEdgeId>,
}

impl<'t> CornerFinder<'t> {
    fn new(input: &'t Triangulation) -> Self {
        let mut outgoing = IdVec::filled(HalfEdgeId::NONE, input.vertex_id_count());
        for h in input.triangles().flat_map(TriangleId::half_edges) {
            outgoing[input.origin(h)] = h;
        }
        Self { input, outgoing }
    }

    /// Returns the corner at `vertex` that is `h`, or of the same triangle, or of one beside it, or
    /// any.
    fn find(&self, h: HalfEdgeId, vertex: VertexId) -> HalfEdgeId {
        let own = [h, h.next(), h.prev()];
        let beside = own.map(|side| self.input.twin(side).prev());
        let is_at_vertex = |&h: &HalfEdgeId| self.input.origin(h) == vertex;
        own.into_iter().chain(beside).find(is_at_vertex).unwrap_or(self.outgoing[vertex])
    }
}

/// Returns the side of `lower` beyond which `upper` lies.
fn common_side(triangulation: &Triangulation, lower: TriangleId, upper: TriangleId) -> HalfEdgeId {
    let is_common = |h: &HalfEdgeId| triangulation.twin(*h).triangle() == upper;
    lower.half_edges().into_iter().find(is_common).expect("mates share an edge")
}

/// Returns the half-edges that leave the corners of the quad made by removing the edge of `side`.
fn corner_sources(triangulation: &Triangulation, side: HalfEdgeId) -> [HalfEdgeId; 4] {
    quad_corners([side, triangulation.twin(side)])
}

fn quad_across(triangulation: &Triangulation, side: HalfEdgeId) -> [VertexId; 4] {
    corner_sources(triangulation, side).map(|h| triangulation.origin(h))
}
