//! A short search for an alternating path between two unpaired triangles of 𝒦.
//!
//! Two trees grow in turns, breadth first and without blossoms, until an outer triangle of one meets
//! one of the other: with as much searched, a path may be twice as long as with one tree.

use super::marks::{Mark, Marks};
use crate::triangulation::{HalfEdgeId, Links};

/// What a search remembers; kept from one to the next to be allocated once.
#[derive(Default)]
pub(super) struct Search {
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
    /// The place of that in [`Search::outer`].
    before: u32,
    tree: Mark,
}

impl Search {
    /// Pairs two unpaired triangles, each given by a side, by an alternating path that takes in no edge
    /// but those that `allowed` lets in, if it finds one when it looks round `limit` triangles.
    pub(super) fn pair(
        &mut self,
        ends: [HalfEdgeId; 2],
        limit: usize,
        k: &impl Links,
        marks: &mut Marks,
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
                marks.remove(matched, Mark::Matched);
                marks.remove(back, Mark::Matched);
                add(k, marks, side);
                at = before as usize;
            }
        }
        true
    }

    /// A side between outer triangles of both trees, and which they are.
    fn find(
        &mut self,
        ends: [HalfEdgeId; 2],
        limit: usize,
        k: &impl Links,
        marks: &mut Marks,
        allowed: impl Fn(HalfEdgeId) -> bool,
    ) -> Option<(HalfEdgeId, [usize; 2])> {
        self.outer.clear();
        for (back, tree) in ends.into_iter().zip([Mark::FirstOuter, Mark::SecondOuter]) {
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

    /// Grows a tree by what lies beyond the outer triangle `at`, unless something of the other tree
    /// does: then gives the side to it, and what it is.
    #[inline]
    fn look_round(
        &mut self,
        at: usize,
        ends: [HalfEdgeId; 2],
        k: &impl Links,
        marks: &mut Marks,
        allowed: &impl Fn(HalfEdgeId) -> bool,
    ) -> Option<(HalfEdgeId, [usize; 2])> {
        let Outer { back, tree, .. } = self.outer[at];
        let goal = usize::from(tree == Mark::FirstOuter);
        let sides = [back.next(), back.prev(), back];
        for &side in &sides[..if at < 2 { 3 } else { 2 }] {
            let across = k.twin(side);
            let allowed = allowed(side);
            let met = match marks.matched_beyond(across) {
                // One branch: each of the three conditions is as good as random.
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

    /// Grows `tree` by the triangle beyond side `matched` of a neighbour that it has not seen, unless that
    /// is an outer triangle of the other tree; says whether it is.
    #[inline]
    fn reach(
        &mut self,
        before: usize,
        tree: Mark,
        [side, matched]: [HalfEdgeId; 2],
        k: &impl Links,
        marks: &mut Marks,
    ) -> bool {
        if marks.is_visited(matched) {
            return true;
        }
        let back = k.twin(matched);
        marks.add(matched, Mark::Inner);
        marks.add(back, tree);
        self.outer.push(Outer { back, matched, side, before: before as u32, tree });
        false
    }
}

/// The side of the triangle of `one` that leads to that of `other`, if one does that is `allowed`:
/// two searches of three are over with it.
#[inline]
fn side_between(
    [one, other]: [HalfEdgeId; 2],
    k: &impl Links,
    allowed: &impl Fn(HalfEdgeId) -> bool,
) -> Option<HalfEdgeId> {
    let goal = other.triangle();
    let mut found = HalfEdgeId::NONE;
    // Without branches, as nobody can tell which side it is.
    for side in [one, one.prev(), one.next()] {
        let leads_there = (k.twin(side).triangle() == goal) & allowed(side);
        found = if leads_there { side } else { found };
    }
    found.some()
}

fn add(k: &impl Links, marks: &mut Marks, side: HalfEdgeId) {
    for side in [side, k.twin(side)] {
        marks.add(side, Mark::Matched);
    }
}
