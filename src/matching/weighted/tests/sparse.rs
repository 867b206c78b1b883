//! General graphs, solved in compressed rows.

use std::ops::ControlFlow;

use proptest::collection::vec;
use proptest::prelude::*;

use super::super::edge_list::EdgeList;
use super::super::limits::Limits;
use super::super::observer::Observer;
use super::super::prices::Prices;
use super::super::solve::{Solution, SolveError, sparse_solution};
use super::brute_force::least_cost;
use super::cubic::{limits, proven, solve as solve_cubic};
use super::graphs::{cost_range, cubic_graph};

/// A graph with any degrees, parallel edges and loops.
#[derive(Clone, Debug)]
struct Lists {
    edges: Vec<(u32, u32)>,
    costs: Vec<i64>,
    prices: Vec<Option<i64>>,
}

impl Lists {
    fn problem(&self) -> EdgeList<'_, i64> {
        let list = EdgeList::new(self.prices.len(), &self.edges, &self.costs);
        list.with_prices(Prices::Each(&self.prices))
    }
}

fn lists(nodes: std::ops::Range<usize>) -> impl Strategy<Value = Lists> {
    (nodes, cost_range(), 1..8_usize, 0..3_u32).prop_flat_map(
        |(count, (low, high), density, kind)| {
            let number = move || narrow(low)..=narrow(high);
            let edge = (0..count as u32, 0..count as u32);
            let price = (0..3_u32, number());
            (vec((edge, number()), 0..density * count), vec(price, count)).prop_map(
                move |(edges, prices)| {
                    let (edges, costs) = edges.into_iter().unzip();
                    let price = |(chance, price)| (chance < kind).then_some(price);
                    Lists { edges, costs, prices: prices.into_iter().map(price).collect() }
                },
            )
        },
    )
}

/// The nearest number of 64 bits.
fn narrow(cost: i128) -> i64 {
    cost.clamp(i64::MIN.into(), i64::MAX.into()) as i64
}

fn solve(problem: &EdgeList<i64>, limits: Limits) -> Result<Solution, SolveError> {
    let hook = &mut |_| ControlFlow::Continue(());
    sparse_solution(problem, limits, &mut Observer::new(hook))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(5000))]

    #[test]
    fn small_general_graphs_cost_what_brute_force_finds(
        lists in lists(1..13), limits in limits(),
    ) {
        let problem = lists.problem();
        prop_assert_eq!(proven(&problem, solve(&problem, limits))?, least_cost(&problem));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn general_graphs_are_solved_with_proof(lists in lists(1..200), limits in limits()) {
        let problem = lists.problem();
        proven(&problem, solve(&problem, limits))?;
    }

    #[test]
    fn both_layouts_find_the_same_cost(graph in cubic_graph(1..60)) {
        let hook = &mut |_| ControlFlow::Continue(());
        let sparse = sparse_solution(&graph, Limits::DEFAULT, &mut Observer::new(hook));
        match (solve_cubic(&graph, Limits::DEFAULT), sparse) {
            (Ok(cubic), Ok(sparse)) => prop_assert_eq!(cubic.cost, sparse.cost),
            (Err(SolveError::Infeasible(_)), Err(SolveError::Infeasible(_))) => {}
            other => return Err(TestCaseError::fail(format!("{other:?}"))),
        }
    }
}
