//! The common ground of closed and open triangulations: corners, and the sides across edges.

use std::ops::Range;

use super::half_edges::Triangulation;
use super::ids::{HalfEdgeId, TriangleId, VertexId};
use super::open::OpenTriangulation;
use crate::prefetch::prefetch;

/// A surface cut into triangles, closed or not.
///
/// [`Triangulation`] is closed and two-sided by its type. [`OpenTriangulation`] may have a boundary
/// and may be one-sided. No other type implements the trait.
pub trait Surface: Sync + sealed::Sealed {
    /// Returns the number of triangles n_f.
    fn triangle_count(&self) -> usize;

    /// Returns the number of vertices in the file; vertex ids are below it.
    fn vertex_id_count(&self) -> usize;

    /// Returns the vertex that half-edge `h` leaves.
    fn origin(&self, h: HalfEdgeId) -> VertexId;

    /// Returns the other side of the edge of `h`, or `None` on the boundary.
    fn across(&self, h: HalfEdgeId) -> Option<HalfEdgeId>;

    /// Returns whether every edge has two sides.
    fn is_closed(&self) -> bool;

    /// Starts to load half-edge `h` into the cache.
    fn prefetch(&self, h: HalfEdgeId);

    /// Returns the vertices that half-edge `h` leaves and leads to.
    #[inline]
    fn ends(&self, h: HalfEdgeId) -> [VertexId; 2] {
        [h, h.next()].map(|h| self.origin(h))
    }

    /// Iterates over all triangles in file order.
    fn triangles(&self) -> impl ExactSizeIterator<Item = TriangleId> {
        (0..self.triangle_count()).map(TriangleId::new)
    }

    /// Iterates over all edges in the order in which the triangles first pass them. O(n).
    ///
    /// Each edge is given by the lower of its sides. Triangles come in file order, and each begins
    /// at its first corner.
    fn edges(&self) -> impl Iterator<Item = HalfEdgeId> {
        self.edges_of(0..self.triangle_count())
    }

    /// Iterates over the edges whose lower side belongs to one of these triangles.
    fn edges_of(&self, triangles: Range<usize>) -> impl Iterator<Item = HalfEdgeId> {
        let is_first = |h: &HalfEdgeId| self.across(*h).is_none_or(|twin| *h < twin);
        triangles.map(TriangleId::new).flat_map(TriangleId::half_edges).filter(is_first)
    }
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::Triangulation {}
    impl Sealed for super::OpenTriangulation {}
}

impl Surface for Triangulation {
    fn triangle_count(&self) -> usize {
        self.triangle_count()
    }

    fn vertex_id_count(&self) -> usize {
        self.vertex_id_count()
    }

    #[inline]
    fn origin(&self, h: HalfEdgeId) -> VertexId {
        self.origin(h)
    }

    #[inline]
    fn across(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        Some(self.twin(h))
    }

    fn is_closed(&self) -> bool {
        true
    }

    #[inline]
    fn prefetch(&self, h: HalfEdgeId) {
        self.prefetch(h);
    }
}

impl Surface for OpenTriangulation {
    fn triangle_count(&self) -> usize {
        self.sides.len() / 3
    }

    fn vertex_id_count(&self) -> usize {
        self.vertices
    }

    #[inline]
    fn origin(&self, h: HalfEdgeId) -> VertexId {
        self.sides[h].origin
    }

    #[inline]
    fn across(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        self.sides[h].twin.some()
    }

    fn is_closed(&self) -> bool {
        self.boundary_edges == 0
    }

    #[inline]
    fn prefetch(&self, h: HalfEdgeId) {
        prefetch(self.sides.as_slice(), h.index());
    }
}
