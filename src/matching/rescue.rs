//! Short augmenting paths for single triangles, while a pairing is still being made.

use super::forest::Forest;
use super::single_tree::augment_from;
use crate::dual::{Matching, Sides};
use crate::triangulation::TriangleId;

/// The search state of all rescues of one pairing.
pub(crate) struct Rescue {
    forest: Forest,
}

impl Rescue {
    /// Prepares rescues among `triangles` triangles. Memory is taken only where a search passes.
    pub(crate) fn new(triangles: usize) -> Self {
        Self { forest: Forest::new(triangles) }
    }

    /// Pairs the unpaired triangle `f` by an augmenting path to the nearest unpaired one.
    ///
    /// Returns that triangle, or none if the search would visit more than `limit` triangles.
    pub(crate) fn pair(
        &mut self,
        graph: &impl Sides,
        matching: &mut Matching,
        f: TriangleId,
        limit: usize,
    ) -> Option<TriangleId> {
        augment_from(f, graph, &mut self.forest, matching, limit).map(|path| path.end)
    }
}
