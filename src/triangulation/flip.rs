//! Edge flips (Lemos et al., Definition 3.3), each edge at most once.
//!
//! Half-edges are named by their places, so a flip moves two of them into the other triangle.
//! Callers holding half-edge ids from before the flip must translate them (see [`Displacements`]).
//! Departs from the paper, which marks flipped edges and derives the flipped triangulation from the
//! marks: flips are not independent, as two flipped edges may share a triangle, so they are made
//! one after the other.

use super::contraction::ShrinkingTriangulation;
use super::expansion::ExpandingTriangulation;
use super::half_edges::{Side, Triangulation};
use super::ids::{HalfEdgeId, IdVec};
use crate::prefetch::prefetch;

/// Present places of half-edges that have made way for flipped edges. 12 bytes a triangle.
#[derive(Clone, Debug)]
pub(crate) struct Displacements {
    /// For a place taken by a flipped edge, where what it displaced there first has gone, plus one;
    /// zero for other places. No other edge ever comes to a place that a flipped edge has taken.
    moved: Vec<u32>,
}

impl Displacements {
    /// Makes the table for `half_edges` half-edges, none of them moved. O(n).
    pub(crate) fn new(half_edges: usize) -> Self {
        Self { moved: vec![0; half_edges] }
    }

    /// Returns the present place of the half-edge that was `h` at first and whose edge has not been
    /// flipped. O(1) unless many edges nearby have been flipped.
    #[inline]
    pub(crate) fn current(&self, h: HalfEdgeId) -> HalfEdgeId {
        let mut at = h;
        while self.moved[at.index()] != 0 {
            at = HalfEdgeId(self.moved[at.index()] - 1);
        }
        at
    }

    /// Prefetches the entry of `h`.
    #[inline]
    pub(crate) fn prefetch(&self, h: HalfEdgeId) {
        prefetch(&self.moved, h.index());
    }

    /// Records the flip of an edge that had not been flipped before.
    #[inline]
    pub(crate) fn follow(&mut self, moves: &Moves) {
        for (from, to) in moves[..2].iter().copied() {
            let moved = &mut self.moved[from.index()];
            // A place that a flipped edge already had is never translated.
            if *moved == 0 {
                *moved = to.0 + 1;
            }
        }
    }
}

/// Moves of one flip, each from a place to a place. First come the two sides that change triangles,
/// then both sides of the edge.
pub(crate) type Moves = [(HalfEdgeId, HalfEdgeId); 4];

impl Triangulation {
    /// Flips the edge at `s`: the two triangles at it form a quadrilateral, and it becomes the
    /// other diagonal. Four flips give the same triangles, each beginning with another corner.
    ///
    /// The result is a triangulation if both ends have more than three edges and the other diagonal
    /// is no edge yet. The caller must ensure that. O(1).
    ///
    /// # Panics
    /// In debug builds, if the flip would make a loop.
    pub(crate) fn flip(&mut self, s: HalfEdgeId) -> Moves {
        flip(&mut self.sides, s)
    }
}

impl ExpandingTriangulation {
    /// Flips like [`Triangulation::flip`], for an edge that is not contracted.
    pub(crate) fn flip(&mut self, s: HalfEdgeId) -> Moves {
        flip(&mut self.sides, s)
    }
}

impl ShrinkingTriangulation {
    /// Flips like [`Triangulation::flip`], for an edge that is not contracted.
    pub(crate) fn flip(&mut self, s: HalfEdgeId) -> Moves {
        let t = self.twin(s);
        let [a, b] = [s, t].map(|side| self.origin(side));
        let [c, d] = self.apexes(s);
        let moves = flip(&mut self.sides, s);
        for (end, outgoing) in [(a, s), (b, t)] {
            self.star[end].outgoing = outgoing;
            self.star[end].degree -= 1;
        }
        [c, d].into_iter().for_each(|end| self.star[end].degree += 1);
        moves
    }
}

/// ```text
///       c                  c          places s, s1, s2 and t, t1, t2:
///      / \               / | \        abc becomes adc, bad becomes bcd;
///  s2 /   \ s1      s2  /  |  \  t    what was at t1 is now at s,
///    a -s- b    ->     a s1|t1 b      what was at s1 is now at t,
///  t1 \   / t2      s   \  |  /  t2   the edge itself is at s1 and t1.
///      \ /               \ | /
///       d                  d
/// ```
#[inline]
fn flip(sides: &mut IdVec<HalfEdgeId, Side>, s: HalfEdgeId) -> Moves {
    let t = sides[s].twin;
    let [s1, s2, t1, t2] = [s.next(), s.prev(), t.next(), t.prev()];
    let [below, above] = [t1, s1].map(|side| sides[side].twin);
    debug_assert_ne!(sides[s2].origin, sides[t2].origin, "a flip would make a loop");
    sides[s1].origin = sides[t2].origin;
    sides[t1].origin = sides[s2].origin;
    for (one, other) in [(s, below), (t, above), (s1, t1)] {
        sides[one].twin = other;
        sides[other].twin = one;
    }
    [(t1, s), (s1, t), (s, s1), (t, t1)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Mesh;

    #[test]
    fn flips_turn_by_a_quarter() {
        let corners = vec![
            [0, 2, 4],
            [2, 1, 4],
            [1, 3, 4],
            [3, 0, 4],
            [2, 0, 5],
            [1, 2, 5],
            [3, 1, 5],
            [0, 3, 5],
        ];
        let octahedron = Mesh::from_triangles(vec![[0.0; 3]; 6], corners);
        let given = Triangulation::build(&octahedron).unwrap();
        for h in given.triangles().flat_map(|f| f.half_edges()) {
            let mut turned = given.clone();
            let mut at = h;
            for quarter in 1..=12 {
                let [.., (from, to), _] = turned.flip(at);
                assert_eq!(from, at);
                at = to;
                let list = octahedron.clone().with_faces(turned.to_faces());
                // The other diagonal joins two opposite corners of the octahedron.
                assert_eq!(Triangulation::build(&list).unwrap(), turned, "{quarter}");
            }
            assert_eq!((at, turned), (h, given.clone()));
        }
    }
}
