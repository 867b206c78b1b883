//! TQ, ours: the priorities of Pulli and Segal, with an augmenting path for each stranded triangle
//! at once.
//!
//! The Pulli-Segal pairing spreads in rings. A triangle that it strands lies just behind the front
//! of the paired region, and beyond that front everything is still unpaired. So an augmenting path
//! of a few steps leads there. Taken at once, while the surroundings are in the cache, it costs
//! next to nothing. Afterwards the nearest unpaired triangle would be another stranded one, far
//! away.
//!
//! Where the triangles are halves of quads in order, these quads are tried first.

use super::in_order::pair_in_order;
use super::pulli_segal::Greedy;
use super::ranked_graph::RankedGraph;
use crate::dual::{DualGraph, Matching};
use crate::matching::Rescue;

/// Search limit, in triangles, for one rescue. Longer searches are left to the augmentation.
const SEARCH_LIMIT: usize = 8000;

/// Pairs triangles as [`pulli_segal`](super::pulli_segal()) does, in the order of the triangles.
/// Each triangle that would be left alone is paired by an augmenting path to the nearest unpaired
/// one. Before, it tries whether pairing each triangle with its next unpaired neighbour leaves none
/// alone: then the quads of a mesh that was triangulated in order come back.
///
/// O(n) time. At most a few triangles stay unpaired, where the rings meet.
pub fn eager_rescue(graph: &DualGraph) -> Matching {
    pair_with_rescues(RankedGraph::copy_of(graph)).1
}

/// Pairs as [`eager_rescue`] does, in rows that it is given, and returns them without the ranks.
pub(super) fn pair_with_rescues(ranked: RankedGraph) -> (DualGraph, Matching) {
    let mut rescue = Rescue::new(ranked.len());
    let mut greedy = Greedy::new(ranked, None);
    if pair_in_order(&greedy.ranked, &mut greedy.matching) {
        return (greedy.ranked.into_dual(), greedy.matching);
    }
    while let Some(f) = greedy.next() {
        if let Some(g) = greedy.best_neighbour(f) {
            greedy.pair(f, g);
            continue;
        }
        greedy.leave_alone(f);
        if let Some(end) = rescue.pair(&greedy.ranked, &mut greedy.matching, f, SEARCH_LIMIT)
            && !greedy.is_done(end)
        {
            greedy.finish(end);
            greedy.lock_edges(end);
        }
    }
    (greedy.ranked.into_dual(), greedy.matching)
}
