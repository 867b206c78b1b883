//! BEST, ours: the best pairing by an [`Objective`], exact, with a proof that none is better.
//!
//! The costs are plain numbers here. What a good quad is stands in
//! [`quadrangulation`](crate::quadrangulation).

use std::borrow::Cow;
use std::ops::ControlFlow;

use super::initial::InitialPairing;
use super::objective::{Keeping, Leftover, Objective};
use super::proof::{Proof, ProofError};
use crate::dual::{DualGraph, Matching};
use crate::matching::weighted::{News, SolveError, solve_cubic};
use crate::triangulation::{EdgeSet, Triangulation};

/// Pairs the triangles of a closed surface, all of them, by `objective`.
///
/// `hook` is called between searches and can end the run. Nearly linear time on most surfaces,
/// see [`solve_cubic`]; about 85 bytes a triangle, 130 with edges to keep. No randomness.
///
/// # Errors
/// The costs are not symmetric or too large, or the hook ended the run.
///
/// # Panics
/// If there are not as many rows of costs as triangles.
pub fn best<'t>(
    triangulation: &'t Triangulation,
    objective: Objective,
    hook: &mut dyn FnMut(News) -> ControlFlow<()>,
) -> Result<InitialPairing<'t>, SolveError> {
    let dual = DualGraph::new(triangulation);
    let (matching, proof) = best_matching(&dual, objective, hook)?;
    let triangulation = Cow::Borrowed(triangulation);
    Ok(InitialPairing { triangulation, dual, matching, edge_flips: 0, proof: Some(proof) })
}

/// Finds the best matching by `objective`, on surfaces closed or open.
///
/// Like [`best`]. With edges to keep or the fewest triangles left, numbers are wider: about 130
/// bytes a triangle.
///
/// # Errors
/// As for [`best`]; or nothing may be left and not all triangles can be paired, with a proof.
///
/// # Panics
/// If there are not as many rows of costs as triangles. In debug builds, if two triangles have
/// several edges in common, as in no triangulation.
pub fn best_matching(
    dual: &DualGraph,
    objective: Objective,
    hook: &mut dyn FnMut(News) -> ControlFlow<()>,
) -> Result<(Matching, Proof), SolveError> {
    let solution = solve_cubic(&objective.problem(dual), hook)?;
    let matching = solution.matching();
    let proof = Proof::of_solution(objective, solution, dual, &matching);
    Ok((matching, proof))
}

/// Returns the number of triangles left over at least, whatever the pairing, proved by a barrier.
///
/// O(n) beyond the search for a pairing that leaves so few.
///
/// # Errors
/// The barrier does not prove it: a mistake of this library.
pub fn fewest_left_over(dual: &DualGraph) -> Result<usize, ProofError> {
    let costs = vec![[0; 3]; dual.len()];
    let fewest = Objective::new(costs, EdgeSet::default(), Keeping::AsManyAsCan, Leftover::Fewest);
    let found = best_matching(dual, fewest, &mut |_| ControlFlow::Continue(()));
    let (matching, proof) = found.expect("costs of 0 can be added, and no triangle must be paired");
    proof.verify(dual, &matching).map(|()| matching.unpaired_count())
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::pulli_segal::pulli_segal;
    use super::*;
    use crate::augmentation::{Augmentation, make_maximum};
    use crate::random::Random;
    use crate::samples::{sculpted, triangulation};
    use crate::triangulation::TriangleId;

    /// A cost from 0 to 9 for every edge.
    fn random_costs(triangulation: &Triangulation, seed: u64) -> Vec<[i32; 3]> {
        let mut random = Random::stream(seed, &["costs"]);
        let mut costs = vec![[0; 3]; triangulation.triangle_count()];
        for h in triangulation.triangles().flat_map(|f| f.half_edges()) {
            let twin = triangulation.twin(h);
            if h < twin {
                let cost = random.below(10) as i32;
                for side in [h, twin] {
                    costs[side.triangle().index()][side.index() % 3] = cost;
                }
            }
        }
        costs
    }

    proptest! {
        #[test]
        fn no_other_algorithm_finds_a_cheaper_pairing(surface in sculpted(), seed: u64) {
            let triangulation = triangulation(&surface);
            let costs = random_costs(&triangulation, seed);
            let objective = Objective::perfect(costs.clone());
            let pairing = best(&triangulation, objective, &mut |_| ControlFlow::Continue(()));
            let pairing = pairing.unwrap();
            let proof = pairing.proof.as_ref().unwrap();
            prop_assert!(proof.verify(&pairing.dual, &pairing.matching).is_ok());
            let greedy = pulli_segal(&pairing.dual, None);
            let on_path = &mut || ControlFlow::Continue(());
            let (other, _) = make_maximum(&pairing.dual, greedy, Augmentation::Local, on_path);
            let cost = |f: TriangleId| {
                let sides = pairing.dual.sides(f);
                let side = sides.iter().position(|&g| g == other.mate(f)).unwrap();
                i128::from(costs[f.index()][side])
            };
            prop_assert!(2 * proof.cost <= pairing.dual.triangles().map(cost).sum::<i128>());
        }
    }
}
