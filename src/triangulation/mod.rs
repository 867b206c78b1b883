//! Triangulations of closed, oriented surfaces (Lemos et al., Definition 2.2), as half-edges.
//!
//! Triangle `f` owns half-edges `3f`, `3f + 1`, `3f + 2`, counter-clockwise; `next` and `prev` are
//! arithmetic, and a flat array holds the rest: the origin and the twin of every half-edge.
//! Several components are allowed, each a closed surface; so are vertices that no triangle uses.

mod ahead;
mod build;
mod contraction;
mod euler;
mod expansion;
mod flip;
mod ids;
mod laws;
mod link;
mod star;
mod surroundings;
mod survey;

use crate::mesh::Faces;
use crate::prefetch::prefetch;

pub(crate) use contraction::Contraction;
pub use contraction::{ShrinkingTriangulation, VertexSplit};
pub(crate) use expansion::{ExpandingTriangulation, Links};
pub(crate) use flip::{Moves, Places};
pub use ids::{HalfEdgeId, Id, IdVec, TriangleId, VertexId};
pub use laws::{Element, Law, Violation};
pub use link::LinkMarks;
pub use star::Spokes;
pub(crate) use surroundings::Surroundings;
pub use survey::Survey;

/// A triangulation of one or more closed, oriented surfaces.
///
/// The type is the proof: it is only made by [`Triangulation::build`], which checks every law of
/// Definition 2.2. 24 bytes a triangle.
#[derive(Clone, Debug, PartialEq)]
pub struct Triangulation {
    sides: IdVec<HalfEdgeId, Side>,
    vertices: usize,
    unreferenced: usize,
    components: usize,
}

/// What is stored of a half-edge; together, as who asks for one mostly needs the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Side {
    /// The vertex that it leaves.
    pub(crate) origin: VertexId,
    /// The other side of its edge.
    pub(crate) twin: HalfEdgeId,
}

impl Triangulation {
    /// The vertex that half-edge `h` leaves.
    #[inline]
    pub fn origin(&self, h: HalfEdgeId) -> VertexId {
        self.sides[h].origin
    }

    /// The other side of the edge of `h`.
    #[inline]
    pub fn twin(&self, h: HalfEdgeId) -> HalfEdgeId {
        self.sides[h].twin
    }

    /// The vertices that half-edge `h` leaves and leads to.
    #[inline]
    pub(crate) fn ends(&self, h: HalfEdgeId) -> [VertexId; 2] {
        [h, h.next()].map(|h| self.origin(h))
    }

    /// The three corners of triangle `f`, counter-clockwise.
    pub fn corners(&self, f: TriangleId) -> [VertexId; 3] {
        f.half_edges().map(|h| self.sides[h].origin)
    }

    /// The corners of all triangles as faces over the vertices. O(n).
    pub fn faces(&self) -> Faces {
        Faces::uniform(3, self.sides.as_slice().iter().map(|side| side.origin.0).collect())
    }

    /// All triangles in file order.
    pub fn triangles(&self) -> impl ExactSizeIterator<Item = TriangleId> + use<> {
        (0..self.triangle_count()).map(TriangleId::new)
    }

    /// All half-edges in order.
    pub(crate) fn sides(&self) -> &[Side] {
        self.sides.as_slice()
    }

    /// Has the cache fetch half-edge `h`.
    #[inline]
    pub(crate) fn prefetch(&self, h: HalfEdgeId) {
        prefetch(self.sides.as_slice(), h.index());
    }
}
