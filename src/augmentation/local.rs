//! Augmentation that touches only what it visits.
//!
//! The trees of all unpaired triangles grow together, breadth first, in rounds: in each round every
//! tree may double. Where two trees meet they make an augmenting path, and only these two are
//! felled: their triangles are free again for the trees around. Growing together keeps trees small,
//! as paths are found half-way. With one tree at a time the last few paths would each search much
//! of the mesh. Growing by doubling rather than by single triangles keeps one tree after the other
//! in the cache.
//!
//! Paths can be long and many, and all pass one bottleneck, as from one end of a regular tube to
//! the other. The same triangles are then taken and freed again for every path. So once more has
//! been visited than a few times the mesh, and each path takes much of it, a
//! [`detour`](super::detour) finds nearly all other paths at once. Where these few lead through a
//! bottleneck again, another detour finds the rest.

use std::ops::ControlFlow;

use super::detour::{self, Goal};
use super::stats::AugmentationStats;
use crate::dual::{DualGraph, Matching};
use crate::matching::{Forest, Place, TreeId};
use crate::triangulation::TriangleId;

/// Number of triangles that a tree may take in during the first round.
const FIRST_SHARE: usize = 32;

/// Factor by which the share of a tree grows from round to round.
const GROWTH: usize = 2;

/// Number of visits, in sizes of the mesh, after which the search may be given up.
///
/// As long as a search is local, 3.2 visits a triangle have sufficed, after random pairings of up
/// to four million triangles of any kind. Beyond, it is not, and nothing but k n bounds what is
/// still to come.
const PATIENCE: usize = 4;

/// Paths found in as many visits as there are triangles, at least: else there is a bottleneck.
const FEWEST_PATHS: usize = 8;

/// Number of visits, in sizes of the mesh, that the paths left may take, judged by the last ones.
/// The second detour costs as much as thirty visits of each triangle or so, and far more memory.
const HOPE: usize = 25;

/// Augments until no path is left.
///
/// Where a bottleneck is met from the first path on, at most 7 n visits to the end of each detour:
/// one tree may pass the limit by n, and its path and a detour add n each. In general O(n log k),
/// as n more visits are made only if the n before have found a share of the paths.
pub(super) fn augment(
    graph: &DualGraph,
    matching: &mut Matching,
    on_path: &mut dyn FnMut() -> ControlFlow<()>,
) -> AugmentationStats {
    augment_in_stretches(graph.len(), graph, matching, on_path)
}

/// Augments like [`augment`], with this number of visits in place of the number of triangles.
fn augment_in_stretches(
    stretch: usize,
    graph: &DualGraph,
    matching: &mut Matching,
    on_path: &mut dyn FnMut() -> ControlFlow<()>,
) -> AugmentationStats {
    let mut stats = AugmentationStats::default();
    for goal in [Goal::Good, Goal::Maximum] {
        if search(stretch, graph, matching, &mut stats, on_path) != End::Impatient
            || detour::augment(goal, graph, matching, &mut stats, on_path).is_break()
        {
            break;
        }
    }
    stats
}

/// Searches until there is a reason to end, and adds to `stats`.
fn search(
    stretch: usize,
    graph: &DualGraph,
    matching: &mut Matching,
    stats: &mut AugmentationStats,
    on_path: &mut dyn FnMut() -> ControlFlow<()>,
) -> End {
    let counted = stats.paths;
    let forest = Forest::new(graph.len());
    let mut search = Search { graph, forest, stats, stretch, counted_at: 0, counted };
    let end = search.run(matching, on_path);
    let visited = search.forest.visited();
    stats.triangles_visited += visited;
    end
}

/// The reason why a search has ended.
#[derive(Clone, Copy, PartialEq, Eq)]
enum End {
    /// No augmenting path is left.
    Maximum,
    /// `on_path` broke.
    Stopped,
    /// Too many triangles have been visited.
    Impatient,
}

struct Search<'g> {
    graph: &'g DualGraph,
    forest: Forest,
    stats: &'g mut AugmentationStats,
    /// Visits after each of which paths are counted.
    stretch: usize,
    /// Visits when paths were last counted.
    counted_at: usize,
    /// Paths then.
    counted: usize,
}

impl Search<'_> {
    /// Grows trees from all unpaired triangles until none can grow any more.
    ///
    /// Invariant: take an outer triangle that its tree does not list as to be scanned. All its
    /// neighbours are in the same tree, and the outer ones in the same blossom. Let a round neither
    /// grow a tree nor find a path. Then the forest proves that the matching is maximum (Edmonds).
    fn run(
        &mut self,
        matching: &mut Matching,
        on_path: &mut dyn FnMut() -> ControlFlow<()>,
    ) -> End {
        let mut trees: Vec<TreeId> =
            matching.unpaired().map(|root| self.forest.plant(root)).collect();
        let mut share = FIRST_SHARE;
        loop {
            let before = (self.stats.paths, self.forest.visited());
            for &tree in &trees {
                if !self.forest.stands(tree) {
                    continue;
                }
                if self.is_stretch_over() && self.is_hopeless(&trees) {
                    return End::Impatient;
                }
                if self.grow(matching, tree, share, on_path).is_break() {
                    return End::Stopped;
                }
            }
            // A tree that was cut short by its share has grown by as much.
            if before == (self.stats.paths, self.forest.visited()) {
                return End::Maximum;
            }
            trees.retain(|&tree| self.forest.stands(tree));
            share = share.saturating_mul(GROWTH);
        }
    }

    fn is_stretch_over(&self) -> bool {
        self.forest.visited() - self.counted_at > self.stretch
    }

    /// Begins another stretch; returns whether a detour is better.
    fn is_hopeless(&mut self, trees: &[TreeId]) -> bool {
        let found = self.stats.paths - self.counted;
        (self.counted_at, self.counted) = (self.forest.visited(), self.stats.paths);
        if self.counted_at <= PATIENCE * self.stretch {
            return false;
        }
        let left = trees.iter().filter(|&&tree| self.forest.stands(tree)).count() / 2;
        found < FEWEST_PATHS || left > HOPE * found
    }

    /// Grows `tree` by up to `share` triangles.
    fn grow(
        &mut self,
        matching: &mut Matching,
        tree: TreeId,
        share: usize,
        on_path: &mut dyn FnMut() -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let enough = self.forest.visited() + share;
        self.forest.retry_barred(tree);
        while let Some(v) = self.forest.next_to_scan(tree) {
            if let Some((w, other)) = self.scan(matching, tree, v) {
                self.stats.add_path(self.forest.augment(self.graph, matching, v, w));
                [tree, other].into_iter().for_each(|tree| self.forest.fell(tree));
                return on_path();
            }
            if self.forest.visited() >= enough {
                break;
            }
        }
        ControlFlow::Continue(())
    }

    /// Grows `tree` by the neighbours of its outer triangle `v`.
    ///
    /// Returns the first outer neighbour in another tree, with that tree. Where another tree bars
    /// the way, `v` is put aside to be scanned again.
    fn scan(
        &mut self,
        matching: &Matching,
        tree: TreeId,
        v: TriangleId,
    ) -> Option<(TriangleId, TreeId)> {
        let forest = &mut self.forest;
        forest.prefetch_next(self.graph, matching, tree);
        let mut barred = false;
        for (side, w) in self.graph.sides_or_none(v).into_iter().enumerate() {
            if w == TriangleId::NONE || w == matching.mate_or_none(v) {
                continue;
            }
            match forest.place(w) {
                Place::Inner(other) => barred |= other != tree,
                Place::Free => {
                    let mate = matching.mate_or_none(w);
                    debug_assert_ne!(mate, TriangleId::NONE, "every unpaired triangle is a root");
                    self.graph.prefetch(mate);
                    forest.grow(tree, v, w, mate);
                }
                Place::Outer(other) if other != tree => return Some((w, other)),
                Place::Outer(_) => forest.shrink(self.graph, matching, tree, v, side, w),
            }
        }
        if barred {
            forest.bar(tree, v);
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use triquad_generators::worst_cases;

    use super::super::tarjan;
    use super::*;
    use crate::random::Random;
    use crate::samples::triangulation;

    /// Makes a random graph of maximum degree 3.
    fn random_graph(nodes: u32, wishes: u32, random: &mut Random) -> DualGraph {
        let mut degree = vec![0; nodes as usize];
        let mut edges = Vec::new();
        for _ in 0..wishes {
            let (a, b) = (random.below(nodes), random.below(nodes));
            if a != b && degree[a as usize] < 3 && degree[b as usize] < 3 {
                degree[a as usize] += 1;
                degree[b as usize] += 1;
                edges.push((a, b));
            }
        }
        DualGraph::from_edges(nodes as usize, &edges).unwrap()
    }

    #[test]
    fn detours_change_the_paths_but_not_their_number() {
        let mut random = Random::stream(1, &["detours"]);
        let mut paths_differed = false;
        for nodes in (2..400).chain([3000, 5000]) {
            let graph = random_graph(nodes, 3 * nodes, &mut random);
            let mut published = Matching::empty(graph.len());
            tarjan::augment(&graph, &mut published, &mut || ControlFlow::Continue(()));
            let free = augment(&graph, &mut Matching::empty(graph.len()), &mut || {
                ControlFlow::Continue(())
            });
            for stretch in [0, 3, graph.len() / 8, graph.len() / 4] {
                let mut matching = Matching::empty(graph.len());
                let stats = augment_in_stretches(stretch, &graph, &mut matching, &mut || {
                    ControlFlow::Continue(())
                });
                assert!(matching.is_matching_of(&graph));
                assert_eq!(matching.unpaired_count(), published.unpaired_count());
                paths_differed |= stats != free;
            }
        }
        assert!(paths_differed);
    }

    #[test]
    fn a_search_goes_on_while_it_finds_paths() {
        let mut random = Random::stream(2, &["stretches"]);
        let graph = random_graph(5000, 15_000, &mut random);
        let augment_in = |stretch| {
            let mut matching = Matching::empty(graph.len());
            let go_on = &mut || ControlFlow::Continue(());
            augment_in_stretches(stretch, &graph, &mut matching, go_on)
        };
        let whole = augment_in(usize::MAX);
        assert!(whole.triangles_visited > (PATIENCE + 4) * 1500, "{whole:?}");
        assert_eq!(augment_in(1500), whole);
        assert_ne!(augment_in(4), whole);
    }

    /// The dual graph of a prism, and a matching that crosses none of the rings round it.
    fn prism(side: u32) -> (DualGraph, Matching) {
        let prism = triangulation(&worst_cases::prism(side, 30 * side));
        let graph = DualGraph::new(&prism);
        let mut matching = Matching::empty(graph.len());
        for f in graph.triangles().skip(1) {
            let before = TriangleId::new(f.index() - 1);
            if !matching.is_paired(before) && graph.neighbours(f).any(|g| g == before) {
                matching.pair(before, f);
            }
        }
        assert_eq!(matching.unpaired_count(), 2 * side as usize);
        (graph, matching)
    }

    #[test]
    fn paths_that_share_a_bottleneck_are_found_in_linear_work() {
        let go_on = &mut || ControlFlow::Continue(());
        for side in [12, 24] {
            let (graph, start) = prism(side);
            let mut matching = start.clone();
            let stats = augment(&graph, &mut matching, go_on);
            assert_rings_are_crossed(side as usize, &graph, matching);
            assert_eq!(stats.paths, side as usize);
            assert!(stats.triangles_visited <= 7 * graph.len(), "{side}: {stats:?}");
            // Without the limit every path visits much of the mesh.
            let patient = augment_in_stretches(usize::MAX, &graph, &mut start.clone(), go_on);
            let least = graph.len() * side as usize / 2;
            assert!(patient.triangles_visited > least, "{side}: {patient:?}");
        }
    }

    /// Asserts that `matching` is perfect, and that at least `side` pairs cross each ring of edges
    /// round a prism of length `30 · side`.
    fn assert_rings_are_crossed(side: usize, graph: &DualGraph, matching: Matching) {
        let matching = matching.certify(graph).expect("it is perfect");
        let layers = 30 * side;
        let ends = graph.len() - 6 * side * layers;
        let layer = |f: TriangleId| match f.index().checked_sub(6 * side * layers) {
            None => 1 + f.index() / (6 * side),
            Some(at) if at < ends / 2 => 0,
            Some(_) => layers + 1,
        };
        let mut crossings = vec![0; layers + 1];
        for (f, g) in matching.pairs() {
            let [below, above] = [layer(f).min(layer(g)), layer(f).max(layer(g))];
            crossings[below..above].iter_mut().for_each(|pairs| *pairs += 1);
        }
        assert!(crossings.iter().all(|&pairs| pairs >= side), "{side}: {crossings:?}");
    }

    #[test]
    fn lobes_widen_no_bottleneck_and_do_not_matter_to_the_limit() {
        let go_on = &mut || ControlFlow::Continue(());
        for (side, length) in [(12, 360), (24, 720)] {
            let surface = worst_cases::prism_with_lobes(side, length);
            let graph = DualGraph::new(&triangulation(&surface));
            let side = side as usize;
            let mut start = Matching::empty(graph.len());
            for f in (0..6 * side * length as usize).step_by(2) {
                start.pair(TriangleId::new(f), TriangleId::new(f + 1));
            }
            let mut matching = start.clone();
            let stats = augment(&graph, &mut matching, go_on);
            assert_rings_are_crossed(side, &graph, matching);
            assert!(stats.triangles_visited <= 7 * graph.len(), "{side}: {stats:?}");
            let patient = augment_in_stretches(usize::MAX, &graph, &mut start, go_on);
            let least = graph.len() * side / 2;
            assert!(patient.triangles_visited > least, "{side}: {patient:?}");
        }
    }

    #[test]
    fn a_detour_can_be_stopped_after_any_path() {
        let (graph, start) = prism(12);
        for most in 1..=12 {
            let mut matching = start.clone();
            let mut left = most;
            let stats = augment_in_stretches(0, &graph, &mut matching, &mut || {
                left -= 1;
                if left == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            });
            assert!(matching.is_matching_of(&graph));
            assert_eq!(stats.paths, most);
            assert_eq!(matching.unpaired_count() + 2 * most, start.unpaired_count());
        }
    }
}
