//! Prefetching for contractions and splits: neighbours in a mesh may lie far apart in memory.

use super::contraction::ShrinkingTriangulation;
use super::expansion::{Connectivity, ExpandingTriangulation};
use super::ids::{HalfEdgeId, VertexId};
use super::receipt::VertexSplit;
use crate::prefetch::prefetch;

impl ShrinkingTriangulation {
    /// Prefetches half-edge `h`.
    #[inline]
    pub(crate) fn prefetch(&self, h: HalfEdgeId) {
        prefetch(self.sides.as_slice(), h.index());
    }

    /// Prefetches the data of vertex `v`.
    #[inline]
    pub(crate) fn prefetch_star(&self, v: VertexId) {
        prefetch(self.star.as_slice(), v.index());
    }
}

impl ExpandingTriangulation {
    /// Prefetches what the splits of the last receipts of `pending` read. It does so in three
    /// steps, because the neighbours' addresses are known only once the edge has been loaded. The
    /// last 15 splits are not prefetched.
    #[inline]
    pub(crate) fn prefetch_splits(&self, pending: &[VertexSplit]) {
        /// Distance of the first step in receipts; the others follow at a half and a quarter of it.
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
