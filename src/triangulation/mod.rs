//! Triangulations of closed, oriented surfaces (Lemos et al., Definition 2.2), as half-edges.
//!
//! Triangle `f` owns half-edges `3f`, `3f + 1`, `3f + 2`, counter-clockwise; `next` and `prev` are
//! arithmetic, and two flat arrays hold the rest: the origin and the twin of every half-edge.
//! Several components are allowed, each a closed surface; so are vertices that no triangle uses.

mod build;
mod contraction;
mod euler;
mod flip;
mod ids;
mod laws;
mod star;
mod survey;

use crate::mesh::Faces;

pub use contraction::{LinkMarks, ShrinkingTriangulation, VertexSplit};
pub(crate) use flip::{Moves, Places};
pub use ids::{HalfEdgeId, Id, IdVec, TriangleId, VertexId};
pub use laws::{Element, Law, Violation};
pub use star::Spokes;
pub use survey::Survey;

/// A triangulation of one or more closed, oriented surfaces.
///
/// The type is the proof: it is only made by [`Triangulation::build`], which checks every law of
/// Definition 2.2. 24 bytes a triangle.
#[derive(Clone, Debug, PartialEq)]
pub struct Triangulation {
    origin: IdVec<HalfEdgeId, VertexId>,
    twin: IdVec<HalfEdgeId, HalfEdgeId>,
    vertices: usize,
    unreferenced: usize,
    components: usize,
}

impl Triangulation {
    /// The vertex that half-edge `h` leaves.
    #[inline]
    pub fn origin(&self, h: HalfEdgeId) -> VertexId {
        self.origin[h]
    }

    /// The other side of the edge of `h`.
    #[inline]
    pub fn twin(&self, h: HalfEdgeId) -> HalfEdgeId {
        self.twin[h]
    }

    /// The three corners of triangle `f`, counter-clockwise.
    pub fn corners(&self, f: TriangleId) -> [VertexId; 3] {
        f.half_edges().map(|h| self.origin[h])
    }

    /// The corners of all triangles as faces over the vertices. O(n).
    pub fn faces(&self) -> Faces {
        Faces::uniform(3, self.origin.as_slice().iter().map(|vertex| vertex.0).collect())
    }

    /// All triangles in file order.
    pub fn triangles(&self) -> impl ExactSizeIterator<Item = TriangleId> + use<> {
        (0..self.triangle_count()).map(TriangleId::new)
    }

    /// Twins of all half-edges in order.
    pub(crate) fn twins(&self) -> &[HalfEdgeId] {
        self.twin.as_slice()
    }
}
