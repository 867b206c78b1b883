//! Single cases: what is too much, what is impossible, what a run reports.

use std::ops::ControlFlow;

use super::super::barrier::Barrier;
use super::super::edge_list::EdgeList;
use super::super::observer::News;
use super::super::prices::Prices;
use super::super::problem::{GREATEST_COST, NONE, Problem};
use super::super::solve::{SolveError, solve_cubic, solve_sparse};
use super::super::verify::verify;
use super::graphs::Rows;

fn go_on(_: News) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

/// A cycle of the given costs; node i and its successor are joined by edge i.
fn cycle(costs: &[i128]) -> Rows {
    let count = costs.len() as u32;
    let edges = (0..).zip(costs).map(|(i, &cost)| (i, (i + 1) % count, cost));
    Rows::from_edges(vec![None; costs.len()], edges)
}

#[test]
fn the_graph_without_nodes_has_an_empty_matching() {
    let solution = solve_cubic(&cycle(&[]), &mut go_on).unwrap();
    assert_eq!((solution.mates.len(), solution.cost), (0, 0));
}

#[test]
fn numbers_are_as_wide_as_costs_need() {
    for (cost, bits) in [(1, 32), (1 << 26, 32), (1 << 28, 64), (1 << 58, 64), (1 << 61, 128)] {
        let graph = cycle(&[cost, 0, cost, -1]);
        let solution = solve_cubic(&graph, &mut go_on).unwrap();
        assert_eq!((solution.cost, solution.work.bits), (-1, bits), "{cost}");
    }
    let solution = solve_cubic(&cycle(&[GREATEST_COST; 4]), &mut go_on).unwrap();
    assert_eq!(solution.cost, 2 * GREATEST_COST);
}

#[test]
fn costs_beyond_the_greatest_are_refused() {
    for cost in [i128::MAX, i128::MIN] {
        let graph = cycle(&[cost, 0, 0, 0]);
        assert_eq!(solve_cubic(&graph, &mut go_on), Err(SolveError::TooCostly));
        assert_eq!(solve_sparse(&graph, &mut go_on), Err(SolveError::TooCostly));
    }
}

#[test]
fn three_nodes_cannot_be_paired_and_no_barrier_is_needed_to_show_it() {
    let Err(SolveError::Infeasible(barrier)) = solve_cubic(&cycle(&[1, 2, 3]), &mut go_on) else {
        panic!("an odd number of nodes");
    };
    assert_eq!(barrier, Barrier { nodes: vec![] });
    assert!(barrier.proves_infeasible(&cycle(&[1, 2, 3])));
    assert!(!barrier.proves_infeasible(&cycle(&[1, 2, 3, 4])));
}

#[test]
fn sides_that_disagree_are_named() {
    let mut graph = cycle(&[1, 2, 3, 4]);
    graph.costs[2][0] += 1;
    assert!(matches!(solve_cubic(&graph, &mut go_on), Err(SolveError::Asymmetric(..))));
    graph.neighbours[2] = [7, NONE, NONE];
    assert!(matches!(solve_cubic(&graph, &mut go_on), Err(SolveError::Asymmetric(..))));
    graph.neighbours[0] = [7, NONE, NONE];
    assert_eq!(solve_cubic(&graph, &mut go_on), Err(SolveError::NoSuchNode(7)));
}

#[test]
fn an_edge_to_a_node_that_does_not_exist_is_named() {
    let graph = EdgeList::new(2, &[(0, 1), (1, 2)], &[0, 0]);
    assert_eq!(solve_sparse(&graph, &mut go_on), Err(SolveError::NoSuchNode(2)));
}

#[test]
fn the_cheapest_of_parallel_edges_counts_and_loops_do_not() {
    let graph = EdgeList::new(2, &[(0, 0), (0, 1), (1, 0), (0, 1)], &[-9, 7, 4, 5]);
    let solution = solve_sparse(&graph, &mut go_on).unwrap();
    assert_eq!(solution.cost, 4);
    assert_eq!(verify(&graph, &solution, &solution.certificate), Ok(()));
}

#[test]
fn a_run_can_be_stopped_and_leaves_a_bound() {
    let graph = cycle(&[5; 40]);
    let mut stop = |_| ControlFlow::Break(());
    // The greedy start pairs this cycle: the hook is not called.
    assert_eq!(solve_cubic(&graph, &mut stop).unwrap().cost, 100);
    // Two triangles of free edges, joined by edges of cost 5: one of those is needed.
    let free = [(0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3)].map(|(u, v)| (u, v, 0));
    let rungs = [(0, 3, 5), (1, 4, 5), (2, 5, 5)];
    let prism = Rows::from_edges(vec![None; 6], free.into_iter().chain(rungs));
    match solve_cubic(&prism, &mut stop) {
        Err(SolveError::Stopped { bound }) => assert!((0..=5).contains(&bound), "{bound}"),
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_fewest_unpaired_nodes_are_proven_by_the_potentials() {
    // A star of five leaves with an edge between two of them: two nodes more than can be paired.
    let edges = [(0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (1, 2)];
    let price = 1000;
    let costs = [1, 2, 3, 4, 5, -6];
    let graph = EdgeList::new(6, &edges, &costs).with_prices(Prices::Equal(price));
    let solution = solve_sparse(&graph, &mut go_on).unwrap();
    let unpaired = solution.mates.iter().filter(|&&mate| mate == NONE).count();
    let barrier = Barrier { nodes: solution.certificate.below(-i128::from(price)) };
    assert_eq!((unpaired, solution.cost), (2, 2 * 1000 + 3 - 6));
    assert_eq!(barrier.least_unpaired(&graph), unpaired);
    assert_eq!(graph.node_count(), 6);
}
