//! BEST, ours: the perfect pairing of least total cost, exact, with a proof that none costs less.
//!
//! The costs are plain numbers here. What a good quad is stands in
//! [`quadrangulation`](crate::quadrangulation).

use std::borrow::Cow;
use std::ops::ControlFlow;

use super::initial::{InitialPairing, Proof};
use crate::dual::DualGraph;
use crate::matching::weighted::{DualProblem, News, SolveError, solve_cubic};
use crate::triangulation::Triangulation;

/// Pairs the triangles at the least sum of `costs`, those of the removed edges.
///
/// Row `f`, column `i` of `costs` belongs to side `i` of triangle `f`; both sides of an edge cost
/// the same. `hook` is called between searches and can end the run. Nearly linear time on surfaces,
/// see [`solve_cubic`]; about 85 bytes a triangle. No randomness.
///
/// # Errors
/// The costs are not symmetric or too large, or the hook ended the run.
///
/// # Panics
/// If there are not as many rows as triangles.
pub fn best<'t>(
    triangulation: &'t Triangulation,
    costs: Vec<[i32; 3]>,
    hook: &mut dyn FnMut(News) -> ControlFlow<()>,
) -> Result<InitialPairing<'t>, SolveError> {
    let dual = DualGraph::new(triangulation);
    let solution = solve_cubic(&DualProblem::new(&dual, &costs), hook)?;
    let matching = solution.matching();
    let proof = Proof { costs, certificate: solution.certificate, cost: solution.cost };
    let triangulation = Cow::Borrowed(triangulation);
    Ok(InitialPairing { triangulation, dual, matching, edge_flips: 0, proof: Some(proof) })
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
            let pairing = best(&triangulation, costs.clone(), &mut |_| ControlFlow::Continue(()));
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
