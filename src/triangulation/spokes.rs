//! Walking round a vertex.

use super::half_edges::Side;
use super::ids::{HalfEdgeId, IdVec};

/// Half-edges that leave a vertex, clockwise.
#[derive(Clone, Debug)]
pub struct Spokes<'a> {
    sides: &'a IdVec<HalfEdgeId, Side>,
    at: Option<HalfEdgeId>,
    end: HalfEdgeId,
}

impl<'a> Spokes<'a> {
    /// Starts a walk all the way round, from `first`.
    pub(super) fn round(sides: &'a IdVec<HalfEdgeId, Side>, first: HalfEdgeId) -> Self {
        Self { sides, at: Some(first), end: first }
    }

    /// Starts a walk from `first` to before `end`, which leaves the same vertex. It is empty if
    /// they are equal.
    pub(super) fn between(
        sides: &'a IdVec<HalfEdgeId, Side>,
        first: HalfEdgeId,
        end: HalfEdgeId,
    ) -> Self {
        Self { sides, at: (first != end).then_some(first), end }
    }
}

impl Iterator for Spokes<'_> {
    type Item = HalfEdgeId;

    #[inline]
    fn next(&mut self) -> Option<HalfEdgeId> {
        let h = self.at?;
        let after = self.sides[h].twin.next();
        self.at = (after != self.end).then_some(after);
        Some(h)
    }
}
