//! Expansion that flips an edge only where nothing else is found: what the authors of the paper
//! leave to be done (section 5).
//!
//! Works on 𝒦 itself. Where a vertex comes back and edges that split are in M, two triangles have
//! lost their mates. A short search tries to re-pair the surroundings so that both are
//! paired, and only if there is none are edges flipped as in Algorithm 3.4. Algorithms 3.2 and 3.3
//! are such searches of length one. At the end, edges are flipped back where another short search
//! makes up for it: more vertices have come back since, and there are more ways.
//!
//! Of the edges of 41 scans and parts 0.08 to 1.2 % stay flipped, 3 to 130 times fewer than as
//! published, in 1.2 to 1.5 times the time.

use std::ops::RangeInclusive;

use super::expanded::{Expanded, ExpansionObserver};
use super::flip_undo::FlipUndo;
use super::marks::{EdgeMark, EdgeMarks};
use super::path_search::PathSearch;
use crate::irreducible::Contracted;
use crate::triangulation::{
    Connectivity, Displacements, ExpandingTriangulation, HalfEdgeId, IdVec, ShrinkingTriangulation,
    Surroundings, Triangulation, VertexId, VertexSplit,
};

/// Search limit, in triangles, before an edge is flipped.
const LIMIT: usize = 8;

/// Search limit, in triangles, when undoing a flip. It shrinks as the number of flips grows so that
/// all searches together stay linear.
const LAST_LIMITS: RangeInclusive<usize> = 32..=400;
const LAST_ROUNDS: usize = 2;

/// The state of the expansion.
pub(super) struct FewFlipsExpansion {
    /// 𝒦, as far as it has been expanded.
    pub(super) k: ExpandingTriangulation,
    /// Marks of the edges of 𝒦 that are in M, and of those that are flips.
    pub(super) marks: EdgeMarks,
    places: Displacements,
    /// The vertices into which others have been contracted that are not back yet.
    splits_again: IdVec<VertexId, bool>,
    /// Number of those vertices.
    centres: usize,
    /// The one that splits now.
    centre: VertexId,
    search: PathSearch,
    /// The edges flipped, each by the half-edge that it is in 𝒯, in the order of time.
    pub(super) flips: Vec<HalfEdgeId>,
}

/// Expands all vertices, the last contracted first. O(n).
pub(super) fn expand_all(
    reduction: Contracted,
    observer: &mut impl ExpansionObserver<FewFlipsExpansion>,
) -> FewFlipsExpansion {
    let Contracted { triangulation, mut splits, .. } = reduction;
    let k = triangulation.into_expanding();
    let splits_again = FewFlipsExpansion::find_centres(&k, &splits);
    let mut expansion = FewFlipsExpansion {
        marks: EdgeMarks::new(k.half_edge_id_count()),
        places: Displacements::new(k.half_edge_id_count()),
        k,
        centres: splits_again.as_slice().iter().filter(|&&splits| splits).count(),
        splits_again,
        centre: VertexId::NONE,
        search: PathSearch::default(),
        flips: Vec::new(),
    };
    while let Some(split) = splits.pop() {
        expansion.k.prefetch_splits(&splits);
        expansion.expand(split);
        observer.expanded(&expansion, &splits);
    }
    expansion
}

impl FewFlipsExpansion {
    /// Marks the vertices into which others have been contracted. O(n), and O(m log n) lookups for
    /// m of them, as all contractions into one vertex are in a row.
    fn find_centres(k: &ExpandingTriangulation, splits: &[VertexSplit]) -> IdVec<VertexId, bool> {
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
    /// [`Surroundings`].
    fn expand(&mut self, split: VertexSplit) {
        let Self { k, marks, places, .. } = self;
        // Wherever a flipped edge has displaced another, there is a flipped edge now.
        let moved = |g| marks.has(g, EdgeMark::Flipped).then(|| places.current(g));
        let at = k.surroundings_among_flips(&split, moved);
        let matched = [at.tb, at.tc].map(|side| marks.has(side, EdgeMark::Matched));
        k.split(split, &at);
        marks.split(&at);
        let Surroundings { h, hp, a, d, ta, td, .. } = at;
        self.split_at(self.k.origin(h));
        let ends = match matched {
            [false, false] => return self.match_edge(h),
            [true, true] => [ta, td],
            [true, false] => [ta, hp],
            [false, true] => [td, h],
        };
        let Self { k, marks, splits_again, centres, search, .. } = self;
        // An edge that may split at both ends would be in the way of a flip.
        let splits = |v| splits_again[v];
        let allowed =
            |h: HalfEdgeId| *centres < 2 || !(splits(k.origin(h)) && splits(k.origin(h.next())));
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
                self.centres -= 1;
            }
            self.centre = centre;
        }
    }

    fn match_edge(&mut self, h: HalfEdgeId) {
        for side in [h, self.k.twin(h)] {
            self.marks.add(side, EdgeMark::Matched);
        }
    }

    /// Flips an edge that has just come back.
    fn flip(&mut self, side: HalfEdgeId) {
        let moves = self.k.flip(side);
        self.places.follow(&moves);
        self.marks.follow(&moves);
        for (_, place) in &moves[2..] {
            self.marks.add(*place, EdgeMark::Flipped);
        }
        self.flips.push(side);
    }

    /// Undoes the flips that can be undone and returns 𝒦 with the matching of its triangles. O(n).
    pub(super) fn finish(self, input: &Triangulation) -> Expanded {
        let Self { k, marks, search, flips, places, .. } = self;
        // Large, and not needed any more: edges that are flipped back are found by their ends.
        drop(places);
        let limit = LAST_ROUNDS * input.triangle_count() / flips.len().max(1);
        let limit = limit.clamp(*LAST_LIMITS.start(), *LAST_LIMITS.end());
        let k = ShrinkingTriangulation::from(k.into_triangulation());
        let mut undoing = FlipUndo { input, k, marks, search, limit };
        let lasting = undoing.undo_all(flips);
        let FlipUndo { k, marks, .. } = undoing;
        Expanded::new(k.into_triangulation(), &marks, lasting)
    }
}
