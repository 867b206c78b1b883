//! Every answer is optimal or a proof that there is none, whatever the limits are.

use std::ops::ControlFlow;

use proptest::prelude::*;

use super::super::limits::Limits;
use super::super::observer::Observer;
use super::super::problem::{NONE, Problem};
use super::super::solve::{Solution, SolveError, cubic_solution};
use super::super::verify::verify;
use super::brute_force::least_cost;
use super::graphs::{Rows, any_graph, cubic_graph, local_graph, surface};

/// First limits, factors, patience and parts; patience 0 forces the forest.
pub(super) fn limits() -> impl Strategy<Value = Limits> {
    let first = prop_oneof![Just(1), Just(2), Just(4), Just(16), Just(64), Just(usize::MAX)];
    let patience = prop_oneof![Just(0), Just(1), Just(3), Just(u32::MAX)];
    // Divided as they are; renumbered and divided; renumbered and not divided.
    let border = prop_oneof![Just(1), Just(3), Just(usize::MAX)];
    let displacements = prop_oneof![Just(0), 1..4_u32, Just(16)];
    let parts = (1..40_usize, 1..6_usize, 1..3_usize, 1..8_usize, border);
    (first, 2..5_usize, 0..3_u32, patience, displacements, parts).prop_map(
        |(
            first,
            factor,
            single_rounds,
            patience,
            displacements,
            (part, parts, share, patch, border),
        )| Limits {
            displacements,
            first,
            factor,
            single_rounds,
            patience,
            divided: part,
            part,
            parts,
            share,
            patch,
            border,
        },
    )
}

pub(super) fn solve(graph: &Rows, limits: Limits) -> Result<Solution, SolveError> {
    let hook = &mut |_| ControlFlow::Continue(());
    cubic_solution(graph, limits, &mut Observer::new(hook))
}

/// Checks the proof that comes with an answer; returns the cost.
pub(super) fn proven<P: Problem>(
    graph: &P,
    answer: Result<Solution, SolveError>,
) -> Result<Option<i128>, TestCaseError> {
    match answer {
        Ok(solution) => {
            prop_assert_eq!(verify(graph, &solution, &solution.certificate), Ok(()));
            Ok(Some(solution.cost))
        }
        Err(SolveError::Infeasible(barrier)) => {
            prop_assert!(barrier.nodes.is_sorted_by(|a, b| a < b), "{barrier:?} is no set");
            prop_assert!(barrier.proves_infeasible(graph), "{barrier:?} proves nothing");
            Ok(None)
        }
        Err(other) => Err(TestCaseError::fail(other.to_string())),
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    #[test]
    fn small_graphs_cost_what_brute_force_finds(graph in any_graph(0..13), limits in limits()) {
        prop_assert_eq!(proven(&graph, solve(&graph, limits))?, least_cost(&graph));
    }

    #[test]
    fn small_cubic_graphs_cost_what_brute_force_finds(
        graph in cubic_graph(1..7), limits in limits(),
    ) {
        prop_assert_eq!(proven(&graph, solve(&graph, limits))?, least_cost(&graph));
    }

    #[test]
    fn sides_that_disagree_are_refused_in_any_parts(
        graph in cubic_graph(2..30), limits in limits(), at in any::<prop::sample::Index>(),
        is_absent: bool,
    ) {
        let mut graph = graph;
        let ends: Vec<(usize, usize)> = (0..graph.neighbours.len())
            .flat_map(|node| [0, 1, 2].map(|side| (node, side)))
            .filter(|&(node, side)| graph.neighbours[node][side] != NONE)
            .collect();
        prop_assume!(!ends.is_empty());
        let (node, side) = ends[at.index(ends.len())];
        let count = graph.neighbours.len() as u32;
        if is_absent {
            graph.neighbours[node][side] = count;
        } else {
            graph.costs[node][side] += 1;
        }
        let refusal = solve(&graph, limits).unwrap_err();
        let is_named = match refusal {
            SolveError::NoSuchNode(named) => is_absent && named == count,
            SolveError::Asymmetric(one, other) => one.max(other) < count,
            SolveError::TooCostly => !is_absent,
            _ => false,
        };
        prop_assert!(is_named, "{refusal:?}");
    }

    #[test]
    fn runs_can_be_stopped_anywhere_and_leave_a_bound(
        graph in surface(), limits in limits(), calls in 0..12_u32,
    ) {
        let mut left = calls;
        let hook = &mut |_| {
            left = left.saturating_sub(1);
            if left == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let stopped = cubic_solution(&graph, limits, &mut Observer::new(hook));
        if let Err(SolveError::Stopped { bound }) = stopped {
            let cost = proven(&graph, solve(&graph, limits))?;
            prop_assert!(cost.is_none_or(|cost| bound <= cost), "{bound} is above {cost:?}");
        }
    }

    /// Surfaces have one edge between two triangles at most: there is no choice of twins.
    #[test]
    fn twins_at_hand_change_nothing(graph in surface(), limits in limits()) {
        let found = |has_backs| solve(&Rows { has_backs, ..graph.clone() }, limits);
        prop_assert_eq!(found(true), found(false));
    }

    #[test]
    fn surfaces_are_solved_with_proof(graph in surface(), limits in limits()) {
        proven(&graph, solve(&graph, limits))?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn graphs_are_solved_with_proof(graph in any_graph(0..300), limits in limits()) {
        proven(&graph, solve(&graph, limits))?;
    }

    #[test]
    fn graphs_of_near_neighbours_are_solved_with_proof(
        graph in local_graph(0..300), limits in limits(),
    ) {
        proven(&graph, solve(&graph, limits))?;
    }

    #[test]
    fn cubic_graphs_are_solved_with_proof(graph in cubic_graph(1..150), limits in limits()) {
        proven(&graph, solve(&graph, limits))?;
    }
}
