//! A short search for an alternating path between two unpaired triangles of 𝒦.
//!
//! Two trees grow in turns, breadth first and without blossoms, until an outer triangle of one meets
//! one of the other: with as much searched, a path may be twice as long as with one tree.

use super::marks::{Mark, Marks};
use crate::triangulation::{HalfEdgeId, ShrinkingTriangulation, TriangleId};

/// How many triangles a search may look round.
const LIMIT: usize = 24;

/// What a search remembers; kept from one to the next to be allocated once.
#[derive(Default)]
pub(super) struct Search {
    outer: Vec<Outer>,
}

/// A triangle that a tree has reached, at an even distance from its root.
#[derive(Clone, Copy)]
struct Outer {
    triangle: TriangleId,
    tree: Mark,
    /// How it was reached; none for a root.
    step: Option<Step>,
}

/// From an outer triangle to the mate of a neighbour.
#[derive(Clone, Copy)]
struct Step {
    /// The place of the outer triangle before in [`Search::outer`].
    before: u32,
    /// Its side beyond which the neighbour lies.
    side: HalfEdgeId,
    /// The side of the neighbour beyond which its mate lies.
    matched: HalfEdgeId,
}

impl Search {
    /// Pairs two unpaired triangles by an alternating path that takes in no edge but those that `allowed`
    /// lets in, if there is one near. O(1).
    pub(super) fn pair(
        &mut self,
        ends: [TriangleId; 2],
        k: &ShrinkingTriangulation,
        marks: &mut Marks,
        allowed: impl Fn(HalfEdgeId) -> bool,
    ) -> bool {
        let path = self.find(ends, k, marks, allowed);
        for Step { matched, .. } in self.outer.iter().filter_map(|outer| outer.step) {
            marks.remove(matched, Mark::Inner);
            let across = k.twin(matched);
            marks.remove(across, Mark::FirstOuter);
            marks.remove(across, Mark::SecondOuter);
        }
        let Some((side, tips)) = path else { return false };
        add(k, marks, side);
        for tip in tips {
            let mut at = self.outer[tip];
            while let Some(Step { before, side, matched }) = at.step {
                for side in [matched, k.twin(matched)] {
                    marks.remove(side, Mark::Matched);
                }
                add(k, marks, side);
                at = self.outer[before as usize];
            }
        }
        true
    }

    /// A side between outer triangles of both trees, and which they are.
    fn find(
        &mut self,
        ends: [TriangleId; 2],
        k: &ShrinkingTriangulation,
        marks: &mut Marks,
        allowed: impl Fn(HalfEdgeId) -> bool,
    ) -> Option<(HalfEdgeId, [usize; 2])> {
        self.outer.clear();
        for (triangle, tree) in ends.into_iter().zip([Mark::FirstOuter, Mark::SecondOuter]) {
            self.outer.push(Outer { triangle, tree, step: None });
        }
        let mut at = 0;
        while at < self.outer.len().min(LIMIT) {
            let Outer { triangle, tree, .. } = self.outer[at];
            for side in triangle.half_edges() {
                if marks.has(side, Mark::Matched) || !allowed(side) {
                    continue;
                }
                let across = k.twin(side);
                let met = match marks.matched_side(across) {
                    Some(matched) => self.reach(at, tree, [side, matched], k, marks),
                    None => across.triangle() == ends[usize::from(tree == Mark::FirstOuter)],
                };
                if met {
                    let is_met = |outer: &Outer| outer.triangle == across.triangle();
                    let other = self.outer.iter().position(is_met).expect("it is outer");
                    return Some((side, [at, other]));
                }
            }
            at += 1;
        }
        None
    }

    /// Grows `tree` by the triangle across side `matched` of a neighbour, if it is new; says whether
    /// the neighbour is an outer triangle of the other tree.
    #[inline]
    fn reach(
        &mut self,
        before: usize,
        tree: Mark,
        [side, matched]: [HalfEdgeId; 2],
        k: &ShrinkingTriangulation,
        marks: &mut Marks,
    ) -> bool {
        let visits = [Mark::Inner, Mark::FirstOuter, Mark::SecondOuter];
        if let Some(visit) = visits.into_iter().find(|&visit| marks.has(matched, visit)) {
            return visit != Mark::Inner && visit != tree;
        }
        let mate = k.twin(matched);
        marks.add(matched, Mark::Inner);
        marks.add(mate, tree);
        let step = Some(Step { before: before as u32, side, matched });
        self.outer.push(Outer { triangle: mate.triangle(), tree, step });
        false
    }
}

fn add(k: &ShrinkingTriangulation, marks: &mut Marks, side: HalfEdgeId) {
    for side in [side, k.twin(side)] {
        marks.add(side, Mark::Matched);
    }
}
