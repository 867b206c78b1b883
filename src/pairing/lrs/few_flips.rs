//! Expansion that flips an edge only where nothing else is found: what the authors of the paper
//! leave to be done (section 5).
//!
//! Works on 𝒦 itself. Where a vertex comes back and edges that split are in M, two triangles have
//! lost their mates. A short search looks for a way to re-pair what is around so that both are
//! paired, and only if there is none are edges flipped as in Algorithm 3.4. Algorithms 3.2 and 3.3
//! are such searches of length one. At the end, edges are flipped back where another short search
//! makes up for it: more vertices have come back since, and there are more ways.
//!
//! Of the edges of 41 scans and parts 0.08 to 1.2 % stay flipped, 3 to 130 times fewer than as
//! published, in 1.2 to 1.5 times the time.

use std::ops::RangeInclusive;

use super::Expanded;
use super::marks::{Mark, Marks};
use super::search::Search;
use crate::irreducible::Reduction;
use crate::triangulation::{
    HalfEdgeId, IdVec, Places, ShrinkingTriangulation, Triangulation, VertexId, VertexSplit,
};

/// How many triangles are looked round before an edge is flipped.
const LIMIT: usize = 8;

/// How many triangles are looked round before a flip is left as it is: the fewer flips there are,
/// the more, as all searches together may look round all triangles so many times.
const LAST_LIMITS: RangeInclusive<usize> = 32..=400;
const LAST_ROUNDS: usize = 2;

/// Looks on while vertices come back; production looks away.
pub(super) trait Observer: Sized {
    /// A vertex has been expanded and its triangles have been paired; others are `pending`.
    fn expanded(&mut self, _run: &Run, _pending: &[VertexSplit]) {}
}

impl Observer for () {}

/// The state of the expansion.
pub(super) struct Run {
    /// 𝒦, as far as it has been expanded.
    pub(super) k: ShrinkingTriangulation,
    /// Which edges of 𝒦 are in M, and which are flips.
    pub(super) marks: Marks,
    places: Places,
    /// The vertices into which others have been contracted that are not back yet.
    splits_again: IdVec<VertexId, bool>,
    /// The one that splits now.
    centre: VertexId,
    search: Search,
    /// The edges flipped, each by the half-edge that it is in 𝒯, in the order of time.
    pub(super) flips: Vec<HalfEdgeId>,
}

/// Expands all vertices, the last contracted first. O(n).
pub(super) fn expand_all(reduction: Reduction, observer: &mut impl Observer) -> Run {
    let Reduction { triangulation: k, mut splits, .. } = reduction;
    let splits_again = Run::find_centres(&k, &splits);
    let mut run = Run {
        marks: Marks::new(k.half_edge_id_count()),
        places: Places::new(k.half_edge_id_count()),
        k,
        splits_again,
        centre: VertexId::NONE,
        search: Search::default(),
        flips: Vec::new(),
    };
    while let Some(split) = splits.pop() {
        run.k.prefetch_splits(&splits);
        run.expand(split);
        observer.expanded(&run, &splits);
    }
    run
}

impl Run {
    /// Which vertices others have been contracted into. O(n), and O(m log n) lookups for m of them: all
    /// contractions into one are in a row.
    fn find_centres(k: &ShrinkingTriangulation, splits: &[VertexSplit]) -> IdVec<VertexId, bool> {
        let mut is_centre = IdVec::filled(false, k.vertex_id_count());
        let centre_of = |split: &VertexSplit| k.origin(split.half_edge());
        let mut rest = splits;
        while let Some(first) = rest.first() {
            let centre = centre_of(first);
            debug_assert!(!is_centre[centre], "contractions into a vertex are in a row");
            is_centre[centre] = true;
            rest = &rest[rest.partition_point(|split| centre_of(split) == centre)..];
        }
        is_centre
    }

    /// Expands one vertex and pairs its triangles. Half-edges have the names of
    /// [`super::printed`].
    fn expand(&mut self, split: VertexSplit) {
        let h = split.half_edge();
        self.split_at(self.k.origin(h));
        let hp = self.k.twin(h);
        let [a, b, c, d] = [h.next(), h.prev(), hp.next(), hp.prev()];
        let Self { k, marks, places, .. } = self;
        // Wherever a flipped edge has displaced another, there is a flipped edge now.
        k.split_among_flips(split, |g| marks.has(g, Mark::Flipped).then(|| places.of(g)));
        let [ta, tb, tc, td] = [a, b, c, d].map(|side| self.k.twin(side));
        let matched = [tb, tc].map(|side| self.marks.has(side, Mark::Matched));
        self.marks.copy(tb, b);
        self.marks.copy(tc, c);
        self.marks.clear(ta);
        self.marks.clear(td);
        let ends = match matched {
            [false, false] => return self.match_edge(h),
            [true, true] => [ta, td],
            [true, false] => [ta, hp],
            [false, true] => [td, h],
        };
        let Self { k, marks, splits_again, search, .. } = self;
        // An edge that may split at both ends would be in the way of a flip.
        let allowed = |h| !(splits_again[k.origin(h)] && splits_again[k.destination(h)]);
        if search.pair(ends, LIMIT, k, marks, allowed) {
            return;
        }
        for (side, matched) in [a, d].into_iter().zip(matched) {
            if matched {
                self.flip(side);
            }
        }
        self.match_edge(h);
    }

    /// Notes that `centre` splits now. All that has been contracted into one vertex comes back in a
    /// row, so the one that split before is whole.
    fn split_at(&mut self, centre: VertexId) {
        if centre != self.centre {
            if let Some(before) = self.centre.some() {
                self.splits_again[before] = false;
            }
            self.centre = centre;
        }
    }

    fn match_edge(&mut self, h: HalfEdgeId) {
        for side in [h, self.k.twin(h)] {
            self.marks.add(side, Mark::Matched);
        }
    }

    /// Flips an edge that has just come back.
    fn flip(&mut self, side: HalfEdgeId) {
        let moves = self.k.flip(side);
        self.places.follow(&moves);
        self.marks.follow(&moves);
        for (_, place) in &moves[2..] {
            self.marks.add(*place, Mark::Flipped);
        }
        self.flips.push(side);
    }

    /// 𝒦 and the matching of its triangles, when all vertices are back, with the flips undone that can
    /// be. O(n).
    pub(super) fn finish(mut self, input: &Triangulation) -> Expanded {
        let mut flips = std::mem::take(&mut self.flips);
        let limit = LAST_ROUNDS * input.triangle_count() / flips.len().max(1);
        let limit = limit.clamp(*LAST_LIMITS.start(), *LAST_LIMITS.end());
        let mut lasting = 0;
        // The newest first: it may be in the way of older ones, and they are not in its way.
        while let Some(h) = flips.pop() {
            self.prefetch_undoing(input, &flips);
            lasting += usize::from(!self.undo(input, h, limit));
        }
        Expanded::new(self.k.into_triangulation(), &self.marks, lasting)
    }

    /// Has the cache fetch what undoing the last of the flips `pending` will need, in steps, as what
    /// lies round an edge is only known when the edge is there.
    fn prefetch_undoing(&self, input: &Triangulation, pending: &[HalfEdgeId]) {
        /// How many flips ahead each step is done.
        const AHEAD: [usize; 3] = [12, 8, 4];
        let [edge, ends, spokes] =
            AHEAD.map(|by| pending.len().checked_sub(by).map(|place| pending[place]));
        if let Some(h) = edge {
            input.prefetch(h);
        }
        for v in ends.into_iter().flat_map(|h| input.ends(h)) {
            self.k.prefetch_star(v);
        }
        for spoke in
            spokes.into_iter().flat_map(|h| input.ends(h)).filter_map(|v| self.k.outgoing(v))
        {
            self.k.prefetch(spoke);
        }
    }

    /// Flips an edge back to edge `h` of the input, if there is one to be and the pairing can be mended
    /// with `limit` triangles looked round.
    fn undo(&mut self, input: &Triangulation, h: HalfEdgeId, limit: usize) -> bool {
        let Some(s) = self.flip_of(input.ends(h)) else { return false };
        if !self.marks.has(s, Mark::Matched) && !self.make_way(s, limit) {
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
    fn make_way(&mut self, s: HalfEdgeId, limit: usize) -> bool {
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
        let Self { k, marks, search, .. } = self;
        let found = search.pair(mates, limit, k, marks, |_| true);
        for side in [s, t] {
            self.marks.remove(side, Mark::Inner);
        }
        if !found {
            [s, t].into_iter().for_each(|side| self.marks.remove(side, Mark::Matched));
            [one, other].into_iter().for_each(|side| self.match_edge(side));
        }
        found
    }
}
