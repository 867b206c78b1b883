//! Augmentation as published (Lemos et al., section 3.1, after Tarjan).
//!
//! For each path one breadth-first alternating tree grows from one unpaired triangle, with all
//! state set up anew.

use std::ops::ControlFlow;

use super::stats::AugmentationStats;
use crate::dual::{DualGraph, Matching};
use crate::matching::{Augmented, Forest, augment_from};
use crate::triangulation::TriangleId;

/// Augments from each unpaired triangle in turn. Θ(n) a path, O(k n) in all.
pub(super) fn augment(
    graph: &DualGraph,
    matching: &mut Matching,
    on_path: &mut dyn FnMut() -> ControlFlow<()>,
) -> AugmentationStats {
    let mut forest = Forest::new(graph.len());
    let mut stats = augment_each(matching, on_path, |root, matching| {
        forest.clear();
        augment_from(root, graph, &mut forest, matching, usize::MAX)
    });
    stats.triangles_visited = forest.visited();
    stats
}

/// Calls `augment_from` for each triangle that is unpaired when its turn comes, and counts paths.
///
/// A root from which no augmenting path starts needs no second try: none will start there later.
pub(super) fn augment_each(
    matching: &mut Matching,
    on_path: &mut dyn FnMut() -> ControlFlow<()>,
    mut augment_from: impl FnMut(TriangleId, &mut Matching) -> Option<Augmented>,
) -> AugmentationStats {
    let mut stats = AugmentationStats::default();
    let roots: Vec<TriangleId> = matching.unpaired().collect();
    for root in roots {
        if matching.is_paired(root) {
            continue;
        }
        if let Some(path) = augment_from(root, matching) {
            stats.add_path(path.length);
            if on_path().is_break() {
                break;
            }
        }
    }
    stats
}
