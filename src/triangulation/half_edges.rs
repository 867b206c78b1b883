//! The half-edge structure: origin and twin of each side of each triangle, in one array.

use super::ids::{HalfEdgeId, IdVec, TriangleId, VertexId};
use crate::mesh::Faces;
use crate::prefetch::prefetch;

/// A triangulation of one or more closed, oriented surfaces.
///
/// The type is the proof: it is only made by [`Triangulation::build`], which checks every law of
/// Definition 2.2. 24 bytes a triangle.
#[derive(Clone, Debug, PartialEq)]
pub struct Triangulation {
    pub(super) sides: IdVec<HalfEdgeId, Side>,
    pub(super) vertices: usize,
    pub(super) unreferenced: usize,
    pub(super) components: usize,
}

/// One half-edge. Origin and twin are stored together because they are usually read together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Side {
    /// The vertex that it leaves.
    pub(crate) origin: VertexId,
    /// The other side of its edge.
    pub(crate) twin: HalfEdgeId,
}

impl Triangulation {
    /// Returns the vertex that half-edge `h` leaves.
    #[inline]
    pub fn origin(&self, h: HalfEdgeId) -> VertexId {
        self.sides[h].origin
    }

    /// Returns the other side of the edge of `h`.
    #[inline]
    pub fn twin(&self, h: HalfEdgeId) -> HalfEdgeId {
        self.sides[h].twin
    }

    /// Returns the vertices that half-edge `h` leaves and leads to.
    #[inline]
    pub(crate) fn ends(&self, h: HalfEdgeId) -> [VertexId; 2] {
        [h, h.next()].map(|h| self.origin(h))
    }

    /// Returns the three corners of triangle `f`, counter-clockwise.
    pub fn corners(&self, f: TriangleId) -> [VertexId; 3] {
        f.half_edges().map(|h| self.sides[h].origin)
    }

    /// Returns the corners of all triangles as faces over the vertices. O(n).
    pub fn to_faces(&self) -> Faces {
        Faces::uniform(3, self.sides.as_slice().iter().map(|side| side.origin.0).collect())
    }

    /// Iterates over all triangles in file order.
    pub fn triangles(&self) -> impl ExactSizeIterator<Item = TriangleId> + use<> {
        (0..self.triangle_count()).map(TriangleId::new)
    }

    /// Returns all half-edges in order of their ids.
    pub(crate) fn sides(&self) -> &[Side] {
        self.sides.as_slice()
    }

    /// Prefetches half-edge `h`.
    #[inline]
    pub(crate) fn prefetch(&self, h: HalfEdgeId) {
        prefetch(self.sides.as_slice(), h.index());
    }
}
