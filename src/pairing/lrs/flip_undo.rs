//! Flipping edges back, once all vertices are there.
//!
//! More vertices have come back since an edge was flipped, and there are more ways to pair what is
//! around without the flip.

use super::marks::{EdgeMark, EdgeMarks};
use super::path_search::PathSearch;
use crate::triangulation::{HalfEdgeId, ShrinkingTriangulation, Triangulation, VertexId};

/// 𝒦 and its matching while flips are undone.
pub(super) struct FlipUndo<'a> {
    /// The triangulation that 𝒦 has been made from.
    pub(super) input: &'a Triangulation,
    pub(super) k: ShrinkingTriangulation,
    /// Marks of the edges of 𝒦 that are in M, and of those that are flips.
    pub(super) marks: EdgeMarks,
    pub(super) search: PathSearch,
    /// Search limit, in triangles, for each flip.
    pub(super) limit: usize,
}

impl FlipUndo<'_> {
    /// Undoes the `flips` that can be undone and returns the number of the others. Each flip is
    /// given by the input edge that it was, in the order of time. O(m) searches and walks round a
    /// vertex, for m flips.
    pub(super) fn undo_all(&mut self, mut flips: Vec<HalfEdgeId>) -> usize {
        let mut lasting = 0;
        // The newest first: it may be in the way of older ones, and they are not in its way.
        while let Some(h) = flips.pop() {
            self.prefetch(&flips);
            lasting += usize::from(!self.undo(h));
        }
        lasting
    }

    /// Prefetches what undoing the last flips of `pending` reads. It does so in three steps,
    /// because the neighbours' addresses are known only once the edge has been loaded.
    fn prefetch(&self, pending: &[HalfEdgeId]) {
        /// Distance of each step in flips.
        const AHEAD: [usize; 3] = [12, 8, 4];
        let [edge, ends, spokes] =
            AHEAD.map(|by| pending.len().checked_sub(by).map(|place| pending[place]));
        if let Some(h) = edge {
            self.input.prefetch(h);
        }
        for v in ends.into_iter().flat_map(|h| self.input.ends(h)) {
            self.k.prefetch_star(v);
        }
        for spoke in
            spokes.into_iter().flat_map(|h| self.input.ends(h)).filter_map(|v| self.k.outgoing(v))
        {
            self.k.prefetch(spoke);
        }
    }

    /// Undoes the flip of input edge `h` if that flip still exists and the pairing can be repaired
    /// within the limit. Returns whether it did.
    fn undo(&mut self, h: HalfEdgeId) -> bool {
        let Some(s) = self.flip_of(self.input.ends(h)) else { return false };
        if !self.marks.has(s, EdgeMark::Matched) && !self.make_way(s) {
            return false;
        }
        let moves = self.k.flip(s);
        self.marks.follow(&moves);
        for (_, side) in &moves[2..] {
            self.marks.remove(*side, EdgeMark::Flipped);
        }
        true
    }

    /// Returns the edge of 𝒦 that is a flip and becomes the edge with these ends when it is
    /// flipped, if there is one.
    fn flip_of(&self, [one, other]: [VertexId; 2]) -> Option<HalfEdgeId> {
        let (centre, apex) =
            if self.k.degree(one) <= self.k.degree(other) { (one, other) } else { (other, one) };
        let opposite = self.k.spokes(centre).map(HalfEdgeId::next);
        let faces_apex = |&s: &HalfEdgeId| self.k.origin(self.k.twin(s).prev()) == apex;
        opposite.filter(|&s| self.marks.has(s, EdgeMark::Flipped)).find(faces_apex)
    }

    /// Re-pairs the mates of the two triangles at `s` if flipping would leave both matched edges in
    /// one triangle. Returns false, and changes nothing, if no other pairing is found.
    fn make_way(&mut self, s: HalfEdgeId) -> bool {
        let t = self.k.twin(s);
        let sides = [s, t].map(|side| self.marks.matched_side(side));
        let [Some(one), Some(other)] = sides else { return true };
        // Flipped, the triangle of s has the sides before s and after t, that of t the other two.
        if (one == s.prev()) != (other == t.next()) {
            return true;
        }
        let mates = [one, other].map(|side| self.k.twin(side));
        for side in [one, other].into_iter().chain(mates) {
            self.marks.remove(side, EdgeMark::Matched);
        }
        for side in [s, t] {
            self.marks.add(side, EdgeMark::Matched);
            self.marks.add(side, EdgeMark::Inner);
        }
        let Self { k, marks, search, limit, .. } = self;
        let found = search.pair(mates, *limit, k, marks, |_| true);
        for side in [s, t] {
            self.marks.remove(side, EdgeMark::Inner);
        }
        if !found {
            [s, t].into_iter().for_each(|side| self.marks.remove(side, EdgeMark::Matched));
            for side in [one, other].into_iter().chain(mates) {
                self.marks.add(side, EdgeMark::Matched);
            }
        }
        found
    }
}
