//! Work of minimum-cost matching.

use std::ops::ControlFlow;

use triquad::matching::weighted::{DualProblem, solve_cubic, verify};
use triquad::quadrangulation::{DefaultCost, edge_costs};
use triquad::random::Random;
use triquad::triangulation::Surface;
use triquad::{DualGraph, Triangulation};
use triquad_generators::random::Mix;
use triquad_generators::worst_cases;

use crate::common::{face_list, random_of};

#[test]
fn paths_that_share_a_bottleneck_are_found_in_linear_work() {
    for side in [12, 24] {
        let mesh = face_list(&worst_cases::prism_with_lobes(side, 30 * side));
        let triangulation = Triangulation::build(&mesh).unwrap();
        let graph = DualGraph::new(&triangulation);
        let costs = edge_costs(&triangulation, mesh.positions(), &DefaultCost);
        let problem = DualProblem::new(&graph, &costs);
        let solution = solve_cubic(&problem, &mut |_| ControlFlow::Continue(())).unwrap();
        assert_eq!(verify(&problem, &solution, &solution.certificate), Ok(()));
        // One tree at a time would scan 18 n nodes of the larger one.
        assert!(solution.work.scans <= 8 * graph.len() as u64, "{side}: {:?}", solution.work);
        assert!(solution.work.forest_roots > 0, "{side}: {:?}", solution.work);
    }
}

#[test]
fn random_costs_on_random_surfaces_are_proved_least() {
    let mut forests = 0;
    for seed in 0..3000 {
        let surface = random_of(seed as usize % 4, 150, Mix::ALL[seed as usize / 4 % 4], seed);
        let triangulation = Triangulation::build(&face_list(&surface)).unwrap();
        let graph = DualGraph::new(&triangulation);
        let mut random = Random::stream(seed, &["costs"]);
        let mut costs = vec![[0; 3]; graph.len()];
        for side in triangulation.edges() {
            let cost = cost(seed, &mut random);
            for side in [side, triangulation.twin(side)] {
                costs[side.triangle().index()][side.index() % 3] = cost;
            }
        }
        let problem = DualProblem::new(&graph, &costs);
        let solution = solve_cubic(&problem, &mut |_| ControlFlow::Continue(())).expect("Petersen");
        assert_eq!(verify(&problem, &solution, &solution.certificate), Ok(()), "{seed}");
        forests += usize::from(solution.work.forest_roots > 0);
    }
    assert!(forests > 100, "{forests} runs ended with a forest");
}

/// Draws a cost: a power of two, or one of few or many below some that are far beyond.
fn cost(kind: u64, random: &mut Random) -> i32 {
    let below = [0, 3, 1 << 17][kind as usize % 3];
    match below {
        0 => 1 << random.below(24),
        _ if random.below(3) == 0 => 1 << 21,
        _ => random.below(below) as i32,
    }
}
