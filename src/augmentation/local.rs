//! Augmentation that touches only what it visits.
//!
//! The trees of all unpaired triangles grow together, breadth first, in rounds: in each round every
//! tree may double. Where two trees meet they make an augmenting path, and only these two are
//! felled: their triangles are free again for the trees around. Growing together keeps trees small,
//! as paths are found half-way; with one tree at a time the last few paths would each search much
//! of the mesh. Growing by doubling rather than by single triangles keeps one tree after the other
//! in the cache.
//!
//! Where paths are long and many, as between two far regions of a regular mesh, whose dual graph is
//! bipartite, so that trees of like roots never meet, the same ground would be taken and freed again
//! and again. Once more has been visited than a few times the mesh, trees that met are therefore
//! fenced instead: nobody else enters them until no tree can grow any more, and then all start anew.
//! Such a phase visits a triangle once at most and finds many paths.

use std::ops::ControlFlow;

use super::stats::AugmentationStats;
use crate::dual::{DualGraph, Matching};
use crate::matching::{Forest, Place, TreeId};
use crate::triangulation::TriangleId;

/// Number of triangles that a tree may take in during the first round.
const FIRST_SHARE: usize = 32;

/// How many times more triangles a tree may take in during each round than in the one before.
const GROWTH: usize = 2;

/// How many times the mesh is visited before trees that met are fenced instead of felled.
const PATIENCE: usize = 4;

/// Augments until no path is left.
pub(super) fn augment(
    graph: &DualGraph,
    matching: &mut Matching,
    on_path: &mut dyn FnMut() -> ControlFlow<()>,
) -> AugmentationStats {
    augment_with_patience(PATIENCE * graph.len(), graph, matching, on_path)
}

/// Like [`augment`], fencing trees after `patience` visits of triangles.
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
    /// Whether a tree has been fenced.
    fencing: bool,
}

impl Search<'_> {
    /// Grows trees from all unpaired triangles until none can grow any more or `on_path` says stop.
    ///
    /// Invariant: every neighbour of an outer triangle that is not listed in its tree, to be scanned,
    /// is in the same tree, and if outer in the same blossom. So when a round neither grows a tree nor
    /// finds a path, and no tree is fenced, the forest proves that the matching is maximum (Edmonds).
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

    /// Lets `tree` take in `share` more triangles.
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

    fn retire(&mut self, tree: TreeId) {
        if self.forest.visited() > self.patience {
            self.fencing = true;
            self.forest.fence(tree);
        } else {
            self.forest.fell(tree);
        }
    }

    /// Grows `tree` by the neighbours of its outer triangle `v`; an outer neighbour in another tree is
    /// returned with that.
    ///
    /// Where another tree bars the way, `v` has to be scanned again later.
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

    /// A random graph of maximum degree 3.
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
