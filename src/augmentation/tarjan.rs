//! Augmentation as published (Lemos et al., section 3.1, after Tarjan): for each path one
//! breadth-first alternating tree from one unpaired triangle, all state set up anew.

use super::AugmentationStats;
use super::forest::{Forest, Place};
use crate::dual::{DualGraph, Matching};
use crate::triangulation::TriangleId;

/// Augments from each unpaired triangle in turn. Θ(n) a path, O(k n) in all.
///
/// A root from which no augmenting path starts needs no second try: none will start there later.
pub(super) fn augment(
    graph: &DualGraph,
    matching: &mut Matching,
    on_path: &mut dyn FnMut(),
) -> AugmentationStats {
    let mut stats = AugmentationStats::default();
    let mut forest = Forest::new(graph);
    let roots: Vec<TriangleId> = matching.unpaired().collect();
    for root in roots {
        if matching.is_paired(root) {
            continue;
        }
        forest.clear();
        if let Some(length) = augment_from(graph, &mut forest, matching, root) {
            stats.add_path(length);
            on_path();
        }
    }
    stats.triangles_visited = forest.visited();
    stats
}

/// Grows the tree of `root` until it reaches another unpaired triangle. The length of the path.
fn augment_from(
    graph: &DualGraph,
    forest: &mut Forest<'_>,
    matching: &mut Matching,
    root: TriangleId,
) -> Option<usize> {
    let tree = forest.plant(root);
    while let Some(v) = forest.next_to_scan(tree) {
        for (side, w) in graph.sides(v).into_iter().enumerate() {
            if w == TriangleId::NONE || w == matching.mate_or_none(v) {
                continue;
            }
            match forest.place(w) {
                Place::Inner(_) => {}
                Place::Free => match matching.mate(w) {
                    Some(mate) => forest.grow(tree, v, w, mate),
                    None => return Some(forest.augment(matching, v, w)),
                },
                Place::Outer(_) => forest.shrink(matching, tree, v, side, w),
            }
        }
    }
    None
}
