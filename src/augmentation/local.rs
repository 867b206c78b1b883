//! Augmentation that touches only what it visits.
//!
//! The trees of all unpaired triangles grow together, breadth first, in rounds: in each round every
//! tree may double. Where two trees meet they make an augmenting path, and only these two are
//! felled: their triangles are free again for the trees around. Growing together keeps trees small,
//! as paths are found half-way. With one tree at a time the last few paths would each search much
//! of the mesh. Growing by doubling rather than by single triangles keeps one tree after the other
//! in the cache.
//!
//! Paths can be long and many, as between two far regions of a regular mesh. There the dual graph
//! is bipartite, and trees of like roots never meet. The same triangles would be taken and freed
//! again and again. So once more has been visited than a few times the mesh, trees that met are
//! fenced instead. No other tree enters them until none can grow any more; then all start anew.
//! Such a phase visits a triangle once at most and finds many paths.

use std::ops::ControlFlow;

use super::stats::AugmentationStats;
use crate::dual::{DualGraph, Matching};
use crate::matching::{Forest, Place, TreeId};
use crate::triangulation::TriangleId;

/// Number of triangles that a tree may take in during the first round.
const FIRST_SHARE: usize = 32;

/// Factor by which the share of a tree grows from round to round.
const GROWTH: usize = 2;

/// Number of visits, in sizes of the mesh, after which trees that met are fenced, not felled.
const PATIENCE: usize = 4;

/// Augments until no path is left.
pub(super) fn augment(
    graph: &DualGraph,
    matching: &mut Matching,
    on_path: &mut dyn FnMut() -> ControlFlow<()>,
) -> AugmentationStats {
    augment_with_patience(PATIENCE * graph.len(), graph, matching, on_path)
}

/// Augments like [`augment`], fencing trees after `patience` visits of triangles.
fn augment_with_patience(
    patience: usize,
    graph: &DualGraph,
    matching: &mut Matching,
    on_path: &mut dyn FnMut() -> ControlFlow<()>,
) -> AugmentationStats {
    let mut search = Search {
        graph,
        forest: Forest::new(graph.len()),
        stats: AugmentationStats::default(),
        patience,
        fencing: false,
    };
    loop {
        let before = search.stats.paths;
        let stopped = search.run(matching, on_path).is_break();
        if stopped || !search.fencing || search.stats.paths == before {
            break;
        }
        search.forest.fell_all();
    }
    search.stats.triangles_visited = search.forest.visited();
    search.stats
}

struct Search<'g> {
    graph: &'g DualGraph,
    forest: Forest,
    stats: AugmentationStats,
    /// Number of visits after which trees are fenced.
    patience: usize,
    /// True if a tree has been fenced.
    fencing: bool,
}

impl Search<'_> {
    /// Grows trees from all unpaired triangles until none can grow any more or `on_path` breaks.
    ///
    /// Invariant: take an outer triangle that its tree does not list as to be scanned. All its
    /// neighbours are in the same tree, and the outer ones in the same blossom. Let a round neither
    /// grow a tree nor find a path while no tree is fenced. Then the forest proves that the
    /// matching is maximum (Edmonds).
    fn run(
        &mut self,
        matching: &mut Matching,
        on_path: &mut dyn FnMut() -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let mut trees: Vec<TreeId> =
            matching.unpaired().map(|root| self.forest.plant(root)).collect();
        let mut share = FIRST_SHARE;
        loop {
            let before = (self.stats.paths, self.forest.visited());
            for &tree in &trees {
                if self.forest.stands(tree) {
                    self.grow(matching, tree, share, on_path)?;
                }
            }
            // A tree that was cut short by its share has grown by as much.
            if before == (self.stats.paths, self.forest.visited()) {
                return ControlFlow::Continue(());
            }
            trees.retain(|&tree| self.forest.stands(tree));
            share = share.saturating_mul(GROWTH);
        }
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
                [tree, other].into_iter().for_each(|tree| self.retire(tree));
                return on_path();
            }
            if self.forest.visited() >= enough {
                break;
            }
        }
        ControlFlow::Continue(())
    }

    /// Fells a tree whose root is paired now, or fences it once patience has run out.
    fn retire(&mut self, tree: TreeId) {
        if self.forest.visited() > self.patience {
            self.fencing = true;
            self.forest.fence(tree);
        } else {
            self.forest.fell(tree);
        }
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
    use super::super::tarjan;
    use super::*;
    use crate::random::Random;

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
    fn fences_change_the_paths_but_not_their_number() {
        let mut random = Random::stream(1, &["fences"]);
        let mut phases_differed = false;
        for nodes in (2..400).chain([3000, 5000]) {
            let graph = random_graph(nodes, 3 * nodes, &mut random);
            let mut published = Matching::empty(graph.len());
            tarjan::augment(&graph, &mut published, &mut || ControlFlow::Continue(()));
            let free = augment(&graph, &mut Matching::empty(graph.len()), &mut || {
                ControlFlow::Continue(())
            });
            for patience in [0, 10, graph.len() / 2, graph.len()] {
                let mut matching = Matching::empty(graph.len());
                let stats = augment_with_patience(patience, &graph, &mut matching, &mut || {
                    ControlFlow::Continue(())
                });
                assert!(matching.is_matching_of(&graph));
                assert_eq!(matching.unpaired_count(), published.unpaired_count());
                phases_differed |= stats != free;
            }
        }
        assert!(phases_differed);
    }
}
