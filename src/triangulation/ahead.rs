//! What the cache is told to fetch before it is needed: neighbours in a mesh may lie far apart in
//! memory.

use super::{
    ExpandingTriangulation, HalfEdgeId, Id, IdVec, ShrinkingTriangulation, Side, VertexId,
    VertexSplit,
};
use crate::prefetch::prefetch;

impl ShrinkingTriangulation {
    /// Has the cache fetch half-edge `h`.
    #[inline]
    pub(crate) fn prefetch(&self, h: HalfEdgeId) {
        prefetch(self.sides.as_slice(), h.index());
    }

    /// Has the cache fetch what is known of vertex `v`.
    #[inline]
    pub(crate) fn prefetch_star(&self, v: VertexId) {
        prefetch(self.star.as_slice(), v.index());
    }

    /// Has the cache fetch what the splits of the last of the receipts `pending` will need.
    #[inline]
    pub(crate) fn prefetch_splits(&self, pending: &[VertexSplit]) {
        if let Some(h) = prefetch_splits(&self.sides, pending) {
            [self.twin(h), h.prev(), self.twin(h).prev()]
                .into_iter()
                .for_each(|side| self.prefetch_star(self.origin(side)));
        }
    }
}

impl ExpandingTriangulation {
    /// Has the cache fetch what the splits of the last of the receipts `pending` will need.
    #[inline]
    pub(crate) fn prefetch_splits(&self, pending: &[VertexSplit]) {
        prefetch_splits(&self.sides, pending);
    }
}

/// Has the cache fetch half-edges for splits, in steps, as what lies round an edge is only known when
/// the edge is there; gives back the nearest split whose triangles at the edge are there.
#[inline]
fn prefetch_splits(sides: &IdVec<HalfEdgeId, Side>, pending: &[VertexSplit]) -> Option<HalfEdgeId> {
    /// How many receipts ahead each step is done.
    const AHEAD: [usize; 3] = [16, 8, 4];
    let [edge, near, far] = AHEAD.map(|by| {
        let place = pending.len().checked_sub(by);
        place.map(|place| pending[place].half_edge())
    });
    let fetch = |h: HalfEdgeId| prefetch(sides.as_slice(), h.index());
    if let Some(h) = edge {
        fetch(h);
    }
    if let Some(h) = near {
        [h, h.next(), h.prev()].into_iter().for_each(|side| fetch(sides[side].twin));
    }
    if let Some(h) = far {
        let hp = sides[h].twin;
        [hp.next(), hp.prev()].into_iter().for_each(|side| fetch(sides[side].twin));
    }
    far
}
