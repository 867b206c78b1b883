//! Work of minimum-cost matching.

use std::ops::ControlFlow;

use triquad::matching::weighted::{DualProblem, solve_cubic, verify};
use triquad::quadrangulation::{DefaultCost, edge_costs};
use triquad::{DualGraph, Triangulation};
use triquad_generators::worst_cases;

#[test]
fn paths_that_share_a_bottleneck_are_found_in_linear_work() {
    for side in [12, 24] {
        let mesh = crate::common::face_list(&worst_cases::prism_with_lobes(side, 30 * side));
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
