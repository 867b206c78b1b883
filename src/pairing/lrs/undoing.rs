//! Flipping edges back, once all vertices are there.
//!
//! More vertices have come back since an edge was flipped, and there are more ways to pair what is
//! around without the flip.

use super::marks::{Mark, Marks};
use super::search::Search;
use crate::triangulation::{HalfEdgeId, ShrinkingTriangulation, Triangulation, VertexId};

/// 𝒦 and its matching while flips are undone.
pub(super) struct Undoing<'a> {
    /// What 𝒦 has been made from.
    pub(super) input: &'a Triangulation,
    pub(super) k: ShrinkingTriangulation,
    /// Which edges of 𝒦 are in M, and which are flips.
    pub(super) marks: Marks,
    pub(super) search: Search,
    /// How many triangles are looked round before a flip is left as it is.
    pub(super) limit: usize,
}

impl Undoing<'_> {
    /// Undoes those of the `flips`, each the edge of the input that it was, in the order of time, that
    /// can be undone, and says how many cannot. O(m) searches and walks round a vertex, for m of them.
    pub(super) fn undo_all(&mut self, mut flips: Vec<HalfEdgeId>) -> usize {
        let mut lasting = 0;
        // The newest first: it may be in the way of older ones, and they are not in its way.
        while let Some(h) = flips.pop() {
            self.prefetch(&flips);
            lasting += usize::from(!self.undo(h));
        }
        lasting
    }

    /// Has the cache fetch what undoing the last of the flips `pending` will need, in steps, as what
    /// lies round an edge is only known when the edge is there.
    fn prefetch(&self, pending: &[HalfEdgeId]) {
        /// How many flips ahead each step is done.
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

    /// Flips an edge back to edge `h` of the input, if there is one to be and the pairing can be mended
    /// within the limit.
    fn undo(&mut self, h: HalfEdgeId) -> bool {
        let Some(s) = self.flip_of(self.input.ends(h)) else { return false };
        if !self.marks.has(s, Mark::Matched) && !self.make_way(s) {
            return false;
        }
        let moves = self.k.flip(s);
        self.marks.follow(&moves);
        for (_, side) in &moves[2..] {
            self.marks.remove(*side, Mark::Flipped);
        }
        true
    }

    /// The edge of 𝒦 that is a flip and becomes the edge with these ends when it is flipped, if there
    /// is one.
    fn flip_of(&self, [one, other]: [VertexId; 2]) -> Option<HalfEdgeId> {
        let (centre, apex) =
            if self.k.degree(one) <= self.k.degree(other) { (one, other) } else { (other, one) };
        let opposite = self.k.spokes(centre).map(HalfEdgeId::next);
        let faces_apex = |&s: &HalfEdgeId| self.k.origin(self.k.twin(s).prev()) == apex;
        opposite.filter(|&s| self.marks.has(s, Mark::Flipped)).find(faces_apex)
    }

    /// Has the mates of the two triangles at `s` paired otherwise, if they would be in one triangle's way
    /// once the edge of `s` is flipped. False, and nothing has changed, if that cannot be.
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
            self.marks.remove(side, Mark::Matched);
        }
        for side in [s, t] {
            self.marks.add(side, Mark::Matched);
            self.marks.add(side, Mark::Inner);
        }
        let Self { k, marks, search, limit, .. } = self;
        let found = search.pair(mates, *limit, k, marks, |_| true);
        for side in [s, t] {
            self.marks.remove(side, Mark::Inner);
        }
        if !found {
            [s, t].into_iter().for_each(|side| self.marks.remove(side, Mark::Matched));
            for side in [one, other].into_iter().chain(mates) {
                self.marks.add(side, Mark::Matched);
            }
        }
        found
    }
}
