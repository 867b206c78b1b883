//! Many augmenting paths at once, by way of another matching found from nothing.
//!
//! The triangles on which two matchings differ form alternating paths and cycles. Some of these are
//! augmenting paths of the first: at least as many as it has fewer pairs. No two of them touch.
//! They are read off in linear time, however far they reach together.

use std::ops::ControlFlow;

use super::stats::AugmentationStats;
use crate::dual::{DualGraph, Matching};
use crate::matching::weighted::{DualProblem, Prices, SolveError, solve_cubic};
use crate::pairing::{eager_rescue, gawrychowski_wasylkiewicz};
use crate::triangulation::TriangleId;

/// A matching found from nothing.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Goal {
    /// That of TQ: nearly always perfect where there is a perfect one. O(n).
    Good,
    /// A maximum one: GW's on closed surfaces, else the one that leaves the fewest triangles.
    /// O(n log n) on closed surfaces; ten times the time of the other, and 90 bytes a triangle.
    Maximum,
}

impl Goal {
    fn find(self, graph: &DualGraph) -> Matching {
        match self {
            Self::Good => eager_rescue(graph),
            Self::Maximum => gawrychowski_wasylkiewicz(graph)
                .unwrap_or_else(|_| leaving_fewest(graph).expect(SOLVABLE)),
        }
    }
}

/// Augments along all paths of `matching` whose new pairs are pairs of `goal`, or until `on_path`
/// breaks.
///
/// Counts every triangle as visited once more.
pub(super) fn augment(
    goal: Goal,
    graph: &DualGraph,
    matching: &mut Matching,
    stats: &mut AugmentationStats,
    on_path: &mut dyn FnMut() -> ControlFlow<()>,
) -> ControlFlow<()> {
    stats.triangles_visited += graph.len();
    augment_towards(&goal.find(graph), matching, stats, on_path)
}

const SOLVABLE: &str = "all costs are 0, and any triangle may be left over";

fn leaving_fewest(graph: &DualGraph) -> Result<Matching, SolveError> {
    let costs = vec![[0; 3]; graph.len()];
    let problem = DualProblem::new(graph, &costs).with_prices(Prices::Equal(1));
    Ok(solve_cubic(&problem, &mut |_| ControlFlow::Continue(()))?.matching())
}

/// Augments along all paths of `matching` whose new pairs are pairs of `goal`.
fn augment_towards(
    goal: &Matching,
    matching: &mut Matching,
    stats: &mut AugmentationStats,
    on_path: &mut dyn FnMut() -> ControlFlow<()>,
) -> ControlFlow<()> {
    let roots: Vec<TriangleId> = matching.unpaired().collect();
    let mut new_pairs = Vec::new();
    for root in roots {
        if matching.is_paired(root) || !leads_to_another(root, goal, matching, &mut new_pairs) {
            continue;
        }
        matching.replace_along(&new_pairs);
        stats.add_path(2 * new_pairs.len() - 1);
        on_path()?;
    }
    ControlFlow::Continue(())
}

/// Collects the pairs of `goal` on the path from the unpaired triangle `root`, on which pairs of
/// both matchings take turns. Returns whether an unpaired triangle is at its other end.
fn leads_to_another(
    root: TriangleId,
    goal: &Matching,
    matching: &Matching,
    new_pairs: &mut Vec<(TriangleId, TriangleId)>,
) -> bool {
    new_pairs.clear();
    let mut here = root;
    while let Some(there) = goal.mate(here) {
        new_pairs.push((here, there));
        match matching.mate(there) {
            Some(next) => here = next,
            None => return true,
        }
    }
    false
}
