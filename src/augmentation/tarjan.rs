//! Augmentation as published (Lemos et al., section 3.1, after Tarjan).
//!
//! For each path one breadth-first alternating tree grows from one unpaired triangle, with all
//! state set up anew.

use std::ops::ControlFlow;

use super::stats::AugmentationStats;
use crate::dual::{DualGraph, Matching};
use crate::matching::{Forest, augment_from};
use crate::triangulation::TriangleId;

/// Augments from each unpaired triangle in turn. Θ(n) a path, O(k n) in all.
///
/// A root from which no augmenting path starts needs no second try: none will start there later.
pub(super) fn augment(
    graph: &DualGraph,
    matching: &mut Matching,
    on_path: &mut dyn FnMut() -> ControlFlow<()>,
) -> AugmentationStats {
    let mut stats = AugmentationStats::default();
    let mut forest = Forest::new(graph.len());
    let roots: Vec<TriangleId> = matching.unpaired().collect();
    for root in roots {
        if matching.is_paired(root) {
            continue;
        }
        forest.clear();
        if let Some(path) = augment_from(root, graph, &mut forest, matching, usize::MAX) {
            stats.add_path(path.length);
            if on_path().is_break() {
                break;
            }
        }
    }
    stats.triangles_visited = forest.visited();
    stats
}
