//! A short search for an alternating path between two unpaired triangles of 𝒦.
//!
//! Two trees grow in turns, breadth first and without blossoms, until an outer triangle of one
//! meets one of the other. For the same search limit, paths may be twice as long as with one tree.

use super::marks::{EdgeMark, EdgeMarks};
use crate::triangulation::{Connectivity, HalfEdgeId};

/// Memory of a search, kept from one to the next so that it is allocated once.
#[derive(Default)]
pub(super) struct PathSearch {
    /// The two unpaired triangles first.
    outer: Vec<Outer>,
}

/// A triangle that a tree has reached, at an even distance from its root.
#[derive(Clone, Copy)]
struct Outer {
    /// Its side to the triangle before, its mate; any side of a root.
    back: HalfEdgeId,
    /// The other side of `back`.
    matched: HalfEdgeId,
    /// The side beyond which that mate lies, of the outer triangle before.
    side: HalfEdgeId,
    /// The place of that in [`PathSearch::outer`].
    before: u32,
    tree: EdgeMark,
}

impl PathSearch {
    /// Pairs two unpaired triangles, each given by a side, by an alternating path. At most `limit`
    /// triangles are searched, and the path adds only edges that are `allowed`. Returns whether it
    /// found a path.
    pub(super) fn pair(
        &mut self,
        ends: [HalfEdgeId; 2],
        limit: usize,
        k: &impl Connectivity,
        marks: &mut EdgeMarks,
        allowed: impl Fn(HalfEdgeId) -> bool,
    ) -> bool {
        if let Some(side) = side_between(ends, k, &allowed) {
            add(k, marks, side);
            return true;
        }
        let path = self.find(ends, limit, k, marks, allowed);
        for outer in &self.outer[2..] {
            marks.remove_visits(outer.matched);
            marks.remove_visits(outer.back);
        }
        let Some((side, tips)) = path else { return false };
        add(k, marks, side);
        for mut at in tips {
            while at > 1 {
                let Outer { back, matched, side, before, .. } = self.outer[at];
                marks.remove(matched, EdgeMark::Matched);
                marks.remove(back, EdgeMark::Matched);
                add(k, marks, side);
                at = before as usize;
            }
        }
        true
    }

    /// Finds a side between outer triangles of both trees. Returns it with their places.
    fn find(
        &mut self,
        ends: [HalfEdgeId; 2],
        limit: usize,
        k: &impl Connectivity,
        marks: &mut EdgeMarks,
        allowed: impl Fn(HalfEdgeId) -> bool,
    ) -> Option<(HalfEdgeId, [usize; 2])> {
        self.outer.clear();
        for (back, tree) in ends.into_iter().zip([EdgeMark::FirstOuter, EdgeMark::SecondOuter]) {
            let none = HalfEdgeId::NONE;
            self.outer.push(Outer { back, matched: none, side: none, before: 0, tree });
        }
        let mut at = 0;
        while at < self.outer.len().min(limit) {
            if let Some(met) = self.look_round(at, ends, k, marks, &allowed) {
                return Some(met);
            }
            at += 1;
        }
        None
    }

    /// Grows a tree by the triangles beyond the outer triangle `at`. If it meets the other tree,
    /// returns the side between them and both outer triangles.
    #[inline]
    fn look_round(
        &mut self,
        at: usize,
        ends: [HalfEdgeId; 2],
        k: &impl Connectivity,
        marks: &mut EdgeMarks,
        allowed: &impl Fn(HalfEdgeId) -> bool,
    ) -> Option<(HalfEdgeId, [usize; 2])> {
        let Outer { back, tree, .. } = self.outer[at];
        let goal = usize::from(tree == EdgeMark::FirstOuter);
        let sides = [back.next(), back.prev(), back];
        for &side in &sides[..if at < 2 { 3 } else { 2 }] {
            let across = k.twin(side);
            let allowed = allowed(side);
            let met = match marks.matched_beyond(across) {
                // One branch, as each of the conditions is unpredictable.
                Some(matched) if marks.is_seen(matched, tree) | !allowed => false,
                Some(matched) => self.reach(at, tree, [side, matched], k, marks),
                None => allowed && across.triangle() == ends[goal].triangle(),
            };
            if met {
                let is_met = |outer: &Outer| outer.back.triangle() == across.triangle();
                let other = self.outer.iter().position(is_met).expect("it is outer");
                return Some((side, [at, other]));
            }
        }
        None
    }

    /// Grows `tree` by the triangle beyond side `matched` of a neighbour that it has not seen.
    /// Returns true instead if that is an outer triangle of the other tree.
    #[inline]
    fn reach(
        &mut self,
        before: usize,
        tree: EdgeMark,
        [side, matched]: [HalfEdgeId; 2],
        k: &impl Connectivity,
        marks: &mut EdgeMarks,
    ) -> bool {
        if marks.is_visited(matched) {
            return true;
        }
        let back = k.twin(matched);
        marks.add(matched, EdgeMark::Inner);
        marks.add(back, tree);
        self.outer.push(Outer { back, matched, side, before: before as u32, tree });
        false
    }
}

/// Returns the side of the triangle of `one` that leads to that of `other`, if there is an allowed
/// one. This resolves two thirds of all searches.
#[inline]
fn side_between(
    [one, other]: [HalfEdgeId; 2],
    k: &impl Connectivity,
    allowed: &impl Fn(HalfEdgeId) -> bool,
) -> Option<HalfEdgeId> {
    let goal = other.triangle();
    let mut found = HalfEdgeId::NONE;
    // Branch-free: the side is unpredictable.
    for side in [one, one.prev(), one.next()] {
        let leads_there = (k.twin(side).triangle() == goal) & allowed(side);
        found = if leads_there { side } else { found };
    }
    found.some()
}

fn add(k: &impl Connectivity, marks: &mut EdgeMarks, side: HalfEdgeId) {
    for side in [side, k.twin(side)] {
        marks.add(side, EdgeMark::Matched);
    }
}
