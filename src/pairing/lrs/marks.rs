//! EdgeMarks on the edges of a triangulation that is being expanded.

use crate::dual::DualGraph;
use crate::prefetch::prefetch;
use crate::triangulation::{HalfEdgeId, IdVec, Moves, Surroundings, TriangleId};

/// A mark on an edge; an edge may have several.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub(super) enum EdgeMark {
    /// It is in M.
    Matched = 1,
    /// Marked in 𝒯: 𝒦 has its flip in its stead. Marked in 𝒦: it is such a flip.
    Flipped = 2,
    /// A search has come to the edge's triangle, and goes on beyond the edge.
    Inner = 4,
    /// The first tree of a search has come to the edge's triangle through the edge.
    FirstOuter = 8,
    /// The second tree has.
    SecondOuter = 16,
}

/// The marks of searches.
const VISITS: u8 = EdgeMark::Inner as u8 | EdgeMark::FirstOuter as u8 | EdgeMark::SecondOuter as u8;

/// EdgeMarks for every half-edge; the first two are those of edges, the same on both sides. 3 bytes
/// a triangle.
pub(super) struct EdgeMarks(IdVec<HalfEdgeId, u8>);

impl EdgeMarks {
    /// Makes no marks for `half_edges` half-edges. O(n).
    pub(super) fn new(half_edges: usize) -> Self {
        Self(IdVec::filled(0, half_edges))
    }

    /// Returns the number of half-edges.
    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    /// Prefetches the marks of `h`.
    #[inline]
    pub(super) fn prefetch(&self, h: HalfEdgeId) {
        prefetch(self.0.as_slice(), h.index());
    }

    /// Returns whether `h` has this mark.
    #[inline]
    pub(super) fn has(&self, h: HalfEdgeId, mark: EdgeMark) -> bool {
        self.0[h] & mark as u8 != 0
    }

    /// Returns whether `h` has no mark.
    #[inline]
    pub(super) fn is_plain(&self, h: HalfEdgeId) -> bool {
        self.0[h] == 0
    }

    /// Returns whether `h` and `g` have the same marks.
    #[cfg(test)]
    pub(super) fn agree(&self, h: HalfEdgeId, g: HalfEdgeId) -> bool {
        self.0[h] == self.0[g]
    }

    /// Gives `h` one more mark.
    #[inline]
    pub(super) fn add(&mut self, h: HalfEdgeId, mark: EdgeMark) {
        self.0[h] |= mark as u8;
    }

    /// Removes a mark from `h`.
    #[inline]
    pub(super) fn remove(&mut self, h: HalfEdgeId, mark: EdgeMark) {
        self.0[h] &= !(mark as u8);
    }

    /// Updates the marks after the split round `at`: the edges [u, x] and [u, y] keep their marks,
    /// [v, x] and [v, y] are new.
    #[inline]
    pub(super) fn split(&mut self, at: &Surroundings) {
        self.0[at.b] = self.0[at.tb];
        self.0[at.c] = self.0[at.tc];
        self.0[at.ta] = 0;
        self.0[at.td] = 0;
    }

    /// Returns whether a search has come to `h`.
    #[inline]
    pub(super) fn is_visited(&self, h: HalfEdgeId) -> bool {
        self.0[h] & VISITS != 0
    }

    /// Returns whether a search has gone on beyond `h`, or come back through it in `tree`.
    #[inline]
    pub(super) fn is_seen(&self, h: HalfEdgeId, tree: EdgeMark) -> bool {
        self.0[h] & (EdgeMark::Inner as u8 | tree as u8) != 0
    }

    /// Removes the marks of searches from `h`.
    #[inline]
    pub(super) fn remove_visits(&mut self, h: HalfEdgeId) {
        self.0[h] &= !VISITS;
    }

    /// Returns the side of the triangle of `h` whose edge is in M.
    #[inline]
    pub(super) fn matched_side(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        let sides = h.triangle().half_edges();
        // Branch-free: the side is unpredictable.
        let [first, second, third] = sides.map(|side| self.has(side, EdgeMark::Matched));
        let place = usize::from(second) + 2 * usize::from(third);
        (first | second | third).then(|| HalfEdgeId::new(sides[0].index() + place))
    }

    /// Returns the side of the triangle of `h` whose edge is in M, if it is not that of `h`.
    #[inline]
    pub(super) fn matched_beyond(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        let (next, previous) = (h.next(), h.prev());
        let [is_next, is_previous] = [next, previous].map(|side| self.has(side, EdgeMark::Matched));
        (is_next | is_previous).then_some(if is_next { next } else { previous })
    }

    /// Returns for every triangle the one across the side whose edge is in M, or none. O(n).
    pub(super) fn mates(&self, dual: &DualGraph) -> Vec<TriangleId> {
        let (marks, _) = self.0.as_slice().as_chunks::<3>();
        let mate = |(marks, f): (&[u8; 3], TriangleId)| {
            // Branch-free: the side is unpredictable. All ones for the one in M.
            let [first, second, third] =
                marks.map(|mark| u32::from(mark & EdgeMark::Matched as u8 != 0).wrapping_neg());
            let [one, two, three] = dual.sides_or_none(f).map(|across| across.0);
            let none = TriangleId::NONE.0 & !(first | second | third);
            TriangleId(first & one | second & two | third & three | none)
        };
        marks.iter().zip(dual.triangles()).map(mate).collect()
    }

    /// Moves the marks to the places to which a flip has moved half-edges.
    #[inline]
    pub(super) fn follow(&mut self, moves: &Moves) {
        let marks = moves.map(|(from, _)| self.0[from]);
        for (mark, (_, to)) in marks.into_iter().zip(moves) {
            self.0[*to] = mark;
        }
    }
}
