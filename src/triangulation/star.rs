//! Walking round a vertex.

use super::{HalfEdgeId, IdVec};

/// Half-edges that leave a vertex, clockwise.
#[derive(Clone, Debug)]
pub struct Spokes<'a> {
    twin: &'a IdVec<HalfEdgeId, HalfEdgeId>,
    at: Option<HalfEdgeId>,
    end: HalfEdgeId,
}

impl<'a> Spokes<'a> {
    /// All the way round, from `first`.
    pub(super) fn round(twin: &'a IdVec<HalfEdgeId, HalfEdgeId>, first: HalfEdgeId) -> Self {
        Self { twin, at: Some(first), end: first }
    }

    /// From `first` to before `end`, which leaves the same vertex; none if they are equal.
    pub(super) fn between(
        twin: &'a IdVec<HalfEdgeId, HalfEdgeId>,
        first: HalfEdgeId,
        end: HalfEdgeId,
    ) -> Self {
        Self { twin, at: (first != end).then_some(first), end }
    }
}

impl Iterator for Spokes<'_> {
    type Item = HalfEdgeId;

    #[inline]
    fn next(&mut self) -> Option<HalfEdgeId> {
        let h = self.at?;
        let after = self.twin[h].next();
        self.at = (after != self.end).then_some(after);
        Some(h)
    }
}
