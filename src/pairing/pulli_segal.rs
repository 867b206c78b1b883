//! PS, the greedy algorithm of Pulli and Segal (Lemos et al., section 3.1): the triangle that is
//! most at risk of being left alone is paired first.
//!
//! An edge is free while neither of its triangles is paired; every unpaired triangle has one of
//! four priorities by its free edges. The paper leaves open which triangle of a priority set goes
//! first, and which of several neighbours of the highest priority is taken. It matters:
//!
//! * The sets are queues: first in, first out; so the oldest goes first. The pairing then spreads
//!   from its start in rings, what is unpaired stays in one piece, and few triangles are cut off.
//!   With stacks it runs off in tendrils that cut the surface into islands, most with a leftover:
//!   on a scan of genus 55, 0.19 % unpaired instead of 0.06 %. Rings also visit triangles near each
//!   other soon after each other, which the cache rewards.
//! * Of neighbours of equal priority too the oldest is taken: 0.06 % instead of 0.09 % with the
//!   first.
//! * On a perfectly regular mesh the rings, six-sided there, leave a row of triangles where their
//!   sides meet, while strips wound one beside the other leave none. So set 1 is a stack until a
//!   triangle has been left alone for the first time, which on irregular meshes is soon.

use std::collections::VecDeque;

use super::ranked_graph::{Priority, Rank, RankedGraph};
use super::shuffler::Shuffler;
use crate::dual::{DualGraph, Matching};
use crate::random::Random;
use crate::triangulation::TriangleId;

/// Pairs triangles by priority: one of the highest non-empty set with its highest-priority
/// neighbour across a free edge; ties as explained above.
///
/// From set 0, which is drawn on once for each component, triangles are taken at random if `random`
/// is given, else in their order; `random` also chooses which side of a triangle counts as its
/// first.
///
/// Θ(n) time: a triangle changes its set at most three times. 20 bytes a triangle, and queues as
/// long as the edge of the paired region.
pub fn pulli_segal(graph: &DualGraph, random: Option<&mut Random>) -> Matching {
    let random = random.map(|random| Shuffler::new(random, None));
    pair_by_priority(RankedGraph::copy_of(graph), random).1
}

/// Pairs as [`pulli_segal`] does, in rows that it is given. Returns these without the ranks, the
/// pairing, and the seconds that shuffles have taken.
pub(super) fn pair_by_priority(
    ranked: RankedGraph,
    random: Option<Shuffler>,
) -> (DualGraph, Matching, f64) {
    let mut greedy = Greedy::new(ranked, random);
    while let Some(f) = greedy.next() {
        match greedy.best_neighbour(f) {
            Some(g) => greedy.pair(f, g),
            None => greedy.leave_alone(f),
        }
    }
    let seconds = greedy.random.map_or(0.0, |random| random.seconds());
    (greedy.ranked.into_dual(), greedy.matching, seconds)
}

/// Counts entries into sets, at most three for each triangle; on meshes of more than 180 million
/// triangles several in one step, so that the count stays below 2^29.
struct Time {
    entries: u32,
    step_bits: u32,
}

impl Time {
    fn new(triangles: usize) -> Self {
        let bits = (3 * triangles as u64).checked_ilog2().map_or(0, |log| log + 1);
        Self { entries: 0, step_bits: bits.saturating_sub(Rank::AGE_BITS) }
    }

    fn tick(&mut self) -> u32 {
        self.entries += 1;
        self.entries >> self.step_bits
    }
}

/// The pairing so far, and the sets 3, 2 and 1 as queues.
pub(super) struct Greedy<'g> {
    /// The graph, with the ranks.
    pub(super) ranked: RankedGraph,
    pub(super) matching: Matching,
    /// Triangles that are not done.
    left: usize,
    time: Time,
    /// By priority; those of sets 1, 2 and 3 are used.
    queues: [VecDeque<TriangleId>; 5],
    /// True once a triangle has been left alone.
    irregular: bool,
    lowest: LowestSet,
    /// The side of every triangle that is taken for its first.
    first_side: usize,
    random: Option<Shuffler<'g>>,
}

impl<'g> Greedy<'g> {
    pub(super) fn new(ranked: RankedGraph, mut random: Option<Shuffler<'g>>) -> Self {
        let triangles = ranked.len();
        let mut greedy = Self {
            ranked,
            matching: Matching::empty(triangles),
            left: triangles,
            time: Time::new(triangles),
            queues: Default::default(),
            irregular: false,
            lowest: LowestSet::default(),
            first_side: random.as_mut().map_or(0, |random| random.below(3) as usize),
            random,
        };
        if greedy.ranked.has_boundary() {
            greedy.ranked.triangles().for_each(|f| greedy.relocate(f));
        }
        greedy
    }

    /// Takes a triangle of the highest non-empty set.
    pub(super) fn next(&mut self) -> Option<TriangleId> {
        if self.left == 0 {
            return None;
        }
        let next = self.pop().or_else(|| self.lowest.pop(&self.ranked, self.random.as_mut()));
        debug_assert!(next.is_some(), "a triangle that is not done is in a set");
        next
    }

    /// Takes a triangle of the highest non-empty set above set 0.
    fn pop(&mut self) -> Option<TriangleId> {
        for set in [Priority::AtMostOneFree, Priority::TwoFree, Priority::TwoFreeToLowest] {
            while let Some(f) = self.take(set) {
                if self.priority(f) == set {
                    return Some(f);
                }
            }
        }
        None
    }

    fn take(&mut self, set: Priority) -> Option<TriangleId> {
        let queue = &mut self.queues[set as usize];
        let newest = set == Priority::TwoFreeToLowest && !self.irregular;
        if newest { queue.pop_back() } else { queue.pop_front() }
    }

    /// Returns the neighbour of highest priority, the oldest of several, across a free edge; of
    /// equally old ones the one across the earliest side.
    pub(super) fn best_neighbour(&self, f: TriangleId) -> Option<TriangleId> {
        let sides = self.ranked.sides(f);
        let mut best = sides[self.first_side];
        for side in [self.first_side + 1, self.first_side + 2] {
            let g = sides[side % 3];
            if self.rank(g) > self.rank(best) {
                best = g;
            }
        }
        (self.priority(best) != Priority::Done).then_some(best)
    }

    pub(super) fn pair(&mut self, f: TriangleId, g: TriangleId) {
        self.matching.pair_unpaired(f, g);
        self.finish(f);
        self.finish(g);
        self.lock_edges(f);
        self.lock_edges(g);
    }

    /// Takes `f`, which has no free edge, out of its set without a mate.
    pub(super) fn leave_alone(&mut self, f: TriangleId) {
        self.irregular = true;
        self.finish(f);
    }

    /// Takes `f` out of its set for good.
    pub(super) fn finish(&mut self, f: TriangleId) {
        self.set_rank(f, Rank::new(Priority::Done, 0));
        self.left -= 1;
    }

    /// Relocates the neighbours of `f`, which has been finished: each has lost a free edge.
    pub(super) fn lock_edges(&mut self, f: TriangleId) {
        for locked in self.ranked.sides(f) {
            match self.priority(locked) {
                Priority::ThreeFree => self.relocate(locked),
                Priority::TwoFreeToLowest | Priority::TwoFree => {
                    self.enter(locked, Priority::AtMostOneFree);
                }
                Priority::AtMostOneFree | Priority::Done => {}
            }
        }
    }

    /// Returns whether `f` has been taken out of its set for good.
    pub(super) fn is_done(&self, f: TriangleId) -> bool {
        self.priority(f) == Priority::Done
    }

    /// Moves `f`, which may have lost a free edge, to the set where it belongs now, and with it the
    /// neighbours that were in set 1 because `f` was in set 0.
    fn relocate(&mut self, f: TriangleId) {
        let sides = self.ranked.sides(f);
        let around = sides.map(|g| self.priority(g));
        let (old, new) = (self.priority(f), Priority::among(around));
        if new == old {
            return;
        }
        debug_assert!(new > old, "priorities never fall");
        self.enter(f, new);
        if old == Priority::ThreeFree {
            for (g, priority) in sides.into_iter().zip(around) {
                match priority {
                    Priority::TwoFreeToLowest => self.enter(g, Priority::TwoFree),
                    // The ring after the next: when `g` leaves set 0, its neighbours are looked at.
                    Priority::ThreeFree => self.ranked.prefetch_around(g),
                    _ => {}
                }
            }
        }
    }

    #[inline]
    fn rank(&self, f: TriangleId) -> Rank {
        self.ranked.rank(f)
    }

    #[inline]
    fn priority(&self, f: TriangleId) -> Priority {
        self.rank(f).priority()
    }

    #[inline]
    fn set_rank(&mut self, f: TriangleId, rank: Rank) {
        self.ranked.set_rank(f, rank);
    }

    fn enter(&mut self, f: TriangleId, set: Priority) {
        let now = self.time.tick();
        self.set_rank(f, Rank::new(set, now));
        self.queues[set as usize].push_back(f);
    }
}

/// Set 0: all triangles at first. Triangles that have left it are passed over.
#[derive(Default)]
struct LowestSet {
    /// Every triangle of set 0 in random order, once there have been enough unlucky draws.
    listed: Option<Vec<TriangleId>>,
    /// Number of triangles taken or passed over, in that order or that of the triangles.
    taken: usize,
}

impl LowestSet {
    /// Takes a triangle of the set: a random one, or else the first.
    fn pop(&mut self, ranked: &RankedGraph, random: Option<&mut Shuffler>) -> Option<TriangleId> {
        let is_in = |f: &TriangleId| ranked.priority(*f) == Priority::ThreeFree;
        let Some(random) = random else {
            let found = (self.taken..ranked.len()).map(TriangleId::new).find(is_in)?;
            self.taken = found.index() + 1;
            return Some(found);
        };
        if self.listed.is_none() {
            if let Some(f) = draw(ranked, random) {
                return Some(f);
            }
            let mut left: Vec<TriangleId> =
                (0..ranked.len()).map(TriangleId::new).filter(is_in).collect();
            random.shuffle(&mut left);
            self.listed = Some(left);
        }
        let waiting = &self.listed.as_deref().unwrap_or_default()[self.taken..];
        let found = waiting.iter().position(is_in)?;
        self.taken += found + 1;
        Some(waiting[found])
    }
}

/// A triangle of set 0 drawn at random from all triangles, if luck will have it.
fn draw(ranked: &RankedGraph, random: &mut Shuffler) -> Option<TriangleId> {
    const DRAWS: usize = 16;
    let mut draws = (0..DRAWS).map(|_| TriangleId(random.below(ranked.len() as u32)));
    draws.find(|&f| ranked.priority(f) == Priority::ThreeFree)
}

#[cfg(test)]
mod tests {
    use triquad_generators::random::{Mix, random_surface};
    use triquad_generators::{classic, grids};

    use super::*;
    use crate::mesh::Mesh;
    use crate::triangulation::Triangulation;

    /// Returns the priority of `f` by the letter of section 3.1, from the triangles that are paired
    /// or left alone.
    fn by_definition(graph: &DualGraph, done: &[bool], f: TriangleId) -> Priority {
        let free =
            |f: TriangleId| graph.neighbours(f).filter(|g| !done[g.index()]).collect::<Vec<_>>();
        match free(f).as_slice() {
            [_, _, _] => Priority::ThreeFree,
            [a, b] if free(*a).len() == 3 && free(*b).len() == 3 => Priority::TwoFreeToLowest,
            [_, _] => Priority::TwoFree,
            _ => Priority::AtMostOneFree,
        }
    }

    /// Runs the algorithm and compares every priority and every choice with the definition.
    fn follow(graph: &DualGraph) {
        let mut greedy = Greedy::new(RankedGraph::copy_of(graph), None);
        while greedy.left > 0 {
            let done: Vec<bool> =
                graph.triangles().map(|f| greedy.priority(f) == Priority::Done).collect();
            let expected = |f: TriangleId| by_definition(graph, &done, f);
            let waiting = || graph.triangles().filter(|f| !done[f.index()]);
            assert!(waiting().all(|f| greedy.priority(f) == expected(f)));
            assert_eq!(waiting().count(), greedy.left);

            let f = greedy.next().unwrap();
            assert_eq!(Some(expected(f)), waiting().map(expected).max());
            let free = || graph.neighbours(f).filter(|g| !done[g.index()]);
            let g = greedy.best_neighbour(f);
            assert_eq!(g.map(expected), free().map(expected).max());
            assert!(g.is_none_or(|g| free().any(|neighbour| neighbour == g)));
            match g {
                Some(g) => greedy.pair(f, g),
                None => greedy.leave_alone(f),
            }
        }
    }

    fn dual(surface: triquad_generators::Surface) -> DualGraph {
        let list = Mesh::from_triangles(surface.positions, surface.triangles);
        DualGraph::new(&Triangulation::build(&list).unwrap())
    }

    #[test]
    fn every_choice_is_the_papers() {
        let mut random = Random::stream(1, &["pulli-segal"]);
        for (genus, mix) in
            [0, 1, 2, 5].into_iter().flat_map(|genus| Mix::ALL.map(|mix| (genus, mix)))
        {
            for operations in [0, 1, 2, 5, 20, 60] {
                follow(&dual(random_surface(genus, operations, mix, &mut |bound| {
                    random.below(bound)
                })));
            }
        }
        follow(&dual(classic::tetrahedron()));
        follow(&dual(grids::torus(9, 14)));
    }

    #[test]
    fn boundaries_lock_edges_from_the_start() {
        // A strip of five triangles: its ends have one free edge each.
        follow(&DualGraph::from_edges(5, &[(0, 1), (1, 2), (2, 3), (3, 4)]).unwrap());
        follow(
            &DualGraph::from_edges(7, &[(0, 1), (1, 2), (2, 0), (0, 3), (1, 4), (2, 5)]).unwrap(),
        );
    }

    #[test]
    fn set_zero_is_drawn_on_for_every_component() {
        let mut random = Random::stream(2, &["pulli-segal"]);
        let tetrahedron = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)];
        let edges: Vec<_> =
            (0..300).flat_map(|c| tetrahedron.map(|(a, b)| (4 * c + a, 4 * c + b))).collect();
        let graph = DualGraph::from_edges(1200, &edges).unwrap();
        assert_eq!(pulli_segal(&graph, Some(&mut random)).unpaired_count(), 0);
        assert_eq!(pulli_segal(&graph, None).unpaired_count(), 0);
    }
}
