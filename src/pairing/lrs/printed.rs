//! Expansion as published (Algorithms 3.1 to 3.4): on the input triangulation 𝒯, with marks on its
//! edges for the matching M and for flips.
//!
//! Departs from the printed text where that leaves things open or is wrong. Of the two edges that
//! [u, x] becomes when it splits, the one at u stays in M. Flipped edges are also logged: The marks
//! alone do not determine 𝒦: two flipped edges may share a triangle, and then their order matters.
//! And 𝒦 is made once, when all vertices are back.

use super::expanded::{Expanded, ExpansionObserver};
use super::marks::{EdgeMark, EdgeMarks};
use crate::irreducible::Contracted;
use crate::triangulation::{
    Connectivity, Displacements, ExpandingTriangulation, HalfEdgeId, Surroundings, Triangulation,
    VertexSplit,
};

/// The state of the expansion.
pub(super) struct PrintedExpansion {
    /// 𝒯, as far as it has been expanded.
    pub(super) t: ExpandingTriangulation,
    pub(super) marks: EdgeMarks,
    /// The edges flipped, each by one half-edge, in the order of time; those without the mark have
    /// been flipped back.
    pub(super) flips: Vec<HalfEdgeId>,
}

/// A vertex v that has come back to its vertex u, with the names of [`Surroundings`]: before, [u,
/// x] had the sides tb and ta, and [u, y] tc and td.
struct Split {
    at: Surroundings,
    /// Number of edges at v.
    degree: u32,
    /// Membership of [u, x] and [u, y] in M.
    matched: [bool; 2],
}

/// Expands all vertices, the last contracted first (Algorithm 3.1). O(n).
pub(super) fn expand_all(
    reduction: Contracted,
    observer: &mut impl ExpansionObserver<PrintedExpansion>,
) -> PrintedExpansion {
    let Contracted { triangulation, mut splits, .. } = reduction;
    let t = triangulation.into_expanding();
    let marks = EdgeMarks::new(t.half_edge_id_count());
    let mut expansion = PrintedExpansion { t, marks, flips: Vec::new() };
    while let Some(split) = splits.pop() {
        expansion.t.prefetch_splits(&splits);
        expansion.expand(split);
        observer.expanded(&expansion, &splits);
    }
    expansion
}

impl PrintedExpansion {
    /// Expands one vertex and pairs its triangles (Algorithm 3.1, lines 4 to 19).
    fn expand(&mut self, split: VertexSplit) {
        let e = self.split(split);
        if e.matched == [false; 2] {
            self.match_edge(e.at.h);
        } else if e.degree == 3 {
            self.match_degree_three(&e);
        } else if e.degree == 4 && !self.is_opposite_flipped(&e) {
            self.match_degree_four(&e);
        } else {
            self.match_greater_degree(&e);
        }
    }

    /// Splits vertices. The edges [u, x] and [u, y] keep their marks; [v, x] and [v, y] are new.
    fn split(&mut self, split: VertexSplit) -> Split {
        let at = self.t.surroundings(&split);
        let marks = &mut self.marks;
        let kept = [at.tb, at.tc];
        debug_assert!(
            !kept.iter().any(|&side| marks.has(side, EdgeMark::Flipped)),
            "they are in 𝒦"
        );
        let matched = kept.map(|side| marks.has(side, EdgeMark::Matched));
        let degree = self.t.split(split, &at);
        marks.split(&at);
        debug_assert!([at.h, at.hp, at.a, at.d].iter().all(|&side| marks.is_plain(side)));
        Split { at, degree, matched }
    }

    /// Pairs the triangles of a vertex of degree 3 (Algorithm 3.2). The paper has [x, y] flipped
    /// back whenever it is flipped; it is if and only if both [u, x] and [u, y] are in M.
    fn match_degree_three(&mut self, e: &Split) {
        let xy = e.at.td.next();
        let both = e.matched == [true; 2];
        debug_assert_eq!(self.marks.has(xy, EdgeMark::Flipped), both);
        if both {
            for side in [xy, self.t.twin(xy)] {
                self.marks.remove(side, EdgeMark::Flipped);
            }
            self.match_edge(xy);
        } else if e.matched[0] {
            self.match_edge(e.at.d);
        } else {
            self.match_edge(e.at.a);
        }
    }

    /// Returns whether [x, z] or [y, z] is flipped, where z is the fourth neighbour of v.
    fn is_opposite_flipped(&self, e: &Split) -> bool {
        let xz = e.at.ta.next().next();
        let yz = e.at.td.next();
        [xz, yz].iter().any(|&side| self.marks.has(side, EdgeMark::Flipped))
    }

    /// Algorithm 3.3.
    fn match_degree_four(&mut self, e: &Split) {
        if e.matched == [true; 2] {
            let vz = e.at.ta.next();
            self.match_edge(vz);
        } else {
            self.match_greater_degree(e);
        }
    }

    /// Algorithm 3.4.
    fn match_greater_degree(&mut self, e: &Split) {
        for (matched, side) in e.matched.into_iter().zip([e.at.a, e.at.d]) {
            if matched {
                self.add(side, EdgeMark::Flipped);
                self.flips.push(side);
            }
        }
        self.match_edge(e.at.h);
    }

    fn match_edge(&mut self, h: HalfEdgeId) {
        debug_assert!(self.marks.is_plain(h), "a flipped edge is not in 𝒦");
        self.add(h, EdgeMark::Matched);
    }

    fn add(&mut self, h: HalfEdgeId, mark: EdgeMark) {
        for side in [h, self.t.twin(h)] {
            self.marks.add(side, mark);
        }
    }

    /// Iterates over the flips that have not been flipped back, in the order of time. An edge is
    /// flipped at most once, when it is new, so its mark is enough.
    pub(super) fn lasting_flips(&self) -> impl Iterator<Item = HalfEdgeId> {
        self.flips.iter().copied().filter(|&h| self.marks.has(h, EdgeMark::Flipped))
    }

    /// Flips the edges in the order of time and returns 𝒦 with the matching of its triangles. O(n).
    pub(super) fn finish(self) -> Expanded {
        let flips: Vec<HalfEdgeId> = self.lasting_flips().collect();
        let Self { t, mut marks, .. } = self;
        let mut k = t.into_triangulation();
        let mut places = Displacements::new(marks.len());
        for (i, &h) in flips.iter().enumerate() {
            prefetch_flips(&flips[i..], &k, &places, &marks);
            let moves = k.flip(places.current(h));
            places.follow(&moves);
            marks.follow(&moves);
        }
        Expanded::new(k, &marks, flips.len())
    }
}

/// Prefetches what the flips after the first of `pending` read. It does so in three steps, because
/// the neighbours' addresses are known only once the edge has been loaded.
#[inline]
fn prefetch_flips(
    pending: &[HalfEdgeId],
    k: &Triangulation,
    places: &Displacements,
    marks: &EdgeMarks,
) {
    /// Distance of each step in flips.
    const AHEAD: [usize; 3] = [16, 8, 4];
    let [edge, near, far] = AHEAD.map(|by| pending.get(by).copied());
    let fetch_edge = |h| {
        k.prefetch(h);
        places.prefetch(h);
        marks.prefetch(h);
    };
    edge.into_iter().for_each(fetch_edge);
    if let Some(h) = near {
        fetch_edge(k.twin(h));
        [h.next(), h.prev()].into_iter().for_each(|side| k.prefetch(k.twin(side)));
    }
    if let Some(h) = far {
        let t = k.twin(h);
        [t.next(), t.prev()].into_iter().for_each(|side| k.prefetch(k.twin(side)));
    }
}
