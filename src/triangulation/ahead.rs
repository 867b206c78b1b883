//! What the cache is told to fetch before it is needed: neighbours in a mesh may lie far apart in
//! memory.

use super::{HalfEdgeId, Id, ShrinkingTriangulation, VertexId, VertexSplit};
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

    /// Has the cache fetch what the splits of the last of the receipts `pending` will need, in steps,
    /// as what lies round an edge is only known when the edge is there.
    #[inline]
    pub(crate) fn prefetch_splits(&self, pending: &[VertexSplit]) {
        /// How many receipts ahead each step is done.
        const AHEAD: [usize; 3] = [16, 8, 4];
        let [edge, near, far] = AHEAD.map(|by| {
            let place = pending.len().checked_sub(by);
            place.map(|place| pending[place].half_edge())
        });
        if let Some(h) = edge {
            self.prefetch(h);
        }
        if let Some(h) = near {
            [h, h.next(), h.prev()].into_iter().for_each(|side| self.prefetch(self.twin(side)));
        }
        if let Some(h) = far {
            let hp = self.twin(h);
            [hp.next(), hp.prev()].into_iter().for_each(|side| self.prefetch(self.twin(side)));
            [hp, h.prev(), hp.prev()]
                .into_iter()
                .for_each(|side| self.prefetch_star(self.origin(side)));
        }
    }
}
