//! The search for an augmenting path from one unpaired triangle, breadth first.

use super::forest::{Forest, Place};
use crate::dual::{Matching, Sides};
use crate::triangulation::TriangleId;

/// An augmenting path that has been augmented along.
pub(crate) struct Augmented {
    /// Number of its edges.
    pub(crate) length: usize,
    /// The triangle at its other end.
    pub(crate) end: TriangleId,
}

/// Grows a tree from the unpaired triangle `root` to another one and augments along the path.
///
/// Returns none if no such triangle can be reached or `limit` triangles have been visited. The tree
/// is felled afterwards. O(α) a triangle visited.
pub(crate) fn augment_from(
    root: TriangleId,
    graph: &impl Sides,
    forest: &mut Forest,
    matching: &mut Matching,
    limit: usize,
) -> Option<Augmented> {
    let enough = forest.visited().saturating_add(limit);
    let tree = forest.plant(root);
    let mut found = None;
    while let Some(v) = forest.next_to_scan(tree)
        && found.is_none()
        && forest.visited() < enough
    {
        for (side, w) in graph.sides_or_none(v).into_iter().enumerate() {
            if w == TriangleId::NONE || w == matching.mate_or_none(v) {
                continue;
            }
            match (forest.place(w), matching.mate(w)) {
                (Place::Inner(_), _) => {}
                (Place::Outer(_), _) => forest.shrink(graph, matching, tree, v, side, w),
                (Place::Free, Some(mate)) => forest.grow(tree, v, w, mate),
                (Place::Free, None) => {
                    let length = forest.augment(graph, matching, v, w);
                    found = Some(Augmented { length, end: w });
                    break;
                }
            }
        }
    }
    forest.fell(tree);
    found
}
