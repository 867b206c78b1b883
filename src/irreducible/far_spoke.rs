//! A spoke of the vertex at the other end of an edge at u.

use crate::triangulation::{HalfEdgeId, ShrinkingTriangulation, VertexId};

/// A spoke that moves from v to u if [u, v] is contracted.
#[derive(Clone, Copy)]
pub(super) struct FarSpoke {
    pub(super) spoke: HalfEdgeId,
    /// The other end, which u gains as a neighbour.
    pub(super) end: VertexId,
    /// The other side of the edge that faces v and will face u.
    pub(super) across: HalfEdgeId,
}

impl FarSpoke {
    #[inline]
    pub(super) fn new(k: &ShrinkingTriangulation, spoke: HalfEdgeId) -> Self {
        let facing = spoke.next();
        Self { spoke, end: k.origin(facing), across: k.twin(facing) }
    }
}
