//! Augmentation with all data set up anew for each path, the graph included.
//!
//! The printed times suggest that such a thing was run: 33 ms for each path on 394 thousand
//! triangles (Lemos et al., Table 4.3, Eros). The graph is made of nodes with lists of their
//! neighbours, each a piece of memory of its own. Paths are those of [`tarjan`](super::tarjan).

use std::ops::ControlFlow;

use super::stats::AugmentationStats;
use super::tarjan;
use crate::dual::{DualGraph, Matching, Sides};
use crate::matching::{Forest, augment_from};
use crate::triangulation::TriangleId;

/// Augments from each unpaired triangle in turn. Θ(n) a path, and n pieces of memory.
pub(super) fn augment(
    graph: &DualGraph,
    matching: &mut Matching,
    on_path: &mut dyn FnMut() -> ControlFlow<()>,
) -> AugmentationStats {
    let mut visited = 0;
    let mut stats = tarjan::augment_each(matching, on_path, |root, matching| {
        let lists = NeighbourLists::new(graph);
        let mut forest = Forest::new(graph.len());
        let path = augment_from(root, &lists, &mut forest, matching, usize::MAX);
        visited += forest.visited();
        path
    });
    stats.triangles_visited = visited;
    stats
}

/// For each triangle a list of its neighbours, in the order of its sides.
struct NeighbourLists(Vec<Vec<TriangleId>>);

impl NeighbourLists {
    fn new(graph: &DualGraph) -> Self {
        Self(graph.triangles().map(|f| graph.neighbours(f).collect()).collect())
    }
}

impl Sides for NeighbourLists {
    fn sides_or_none(&self, f: TriangleId) -> [TriangleId; 3] {
        let list = &self.0[f.index()];
        [0, 1, 2].map(|side| list.get(side).copied().unwrap_or(TriangleId::NONE))
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Augmentation, make_maximum};
    use super::*;
    use crate::samples::{surfaces, triangulation};

    #[test]
    fn paths_are_those_of_tarjan() {
        for surface in surfaces(4, 60) {
            let graph = DualGraph::new(&triangulation(&surface));
            let augmented = |augmentation| {
                let none = Matching::empty(graph.len());
                make_maximum(&graph, none, augmentation, || ControlFlow::Continue(()))
            };
            assert_eq!(augmented(Augmentation::Rebuild), augmented(Augmentation::Tarjan));
        }
    }
}
