//! What the cache is told to fetch before it is needed: neighbours in a mesh may lie far apart in
//! memory.

use super::{
    ExpandingTriangulation, HalfEdgeId, Id, Links, ShrinkingTriangulation, VertexId, VertexSplit,
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
}

impl ExpandingTriangulation {
    /// Has the cache fetch what the splits of the last of the receipts `pending` will need, in steps,
    /// as what lies round an edge is only known when the edge is there. The last few splits of all do
    /// without.
    #[inline]
    pub(crate) fn prefetch_splits(&self, pending: &[VertexSplit]) {
        /// How many receipts ahead the first step is done; the others half of it, and a quarter.
        const AHEAD: usize = 16;
        let Some(ahead) = pending.last_chunk::<AHEAD>() else { return };
        let [edge, near, far] = [0, AHEAD / 2, AHEAD * 3 / 4].map(|place| ahead[place].half_edge());
        let fetch = |h: HalfEdgeId| prefetch(self.sides.as_slice(), h.index());
        fetch(edge);
        [near, near.next(), near.prev()].into_iter().for_each(|side| fetch(self.twin(side)));
        let hp = self.twin(far);
        [hp.next(), hp.prev()].into_iter().for_each(|side| fetch(self.twin(side)));
    }
}
