//! Dual graphs with locked edges are the same as graphs without those edges.

use std::ops::ControlFlow;

use proptest::collection::vec;
use proptest::prelude::*;

use super::super::dual::DualProblem;
use super::super::limits::Limits;
use super::super::prices::Prices;
use super::super::problem::{Mates, NONE};
use super::super::solve::solve_cubic;
use super::cubic::{proven, solve};
use super::graphs::Rows;
use crate::dual::DualGraph;
use crate::samples::{sculpted, triangulation};
use crate::triangulation::TriangleId;

/// A side, as its triangle and number, and the other side of its edge.
fn edges(graph: &DualGraph) -> Vec<[(usize, usize); 2]> {
    let sides = graph.triangles().flat_map(|f| (0..3).map(move |i| (f, i)));
    let edge = |(f, i): (TriangleId, usize)| {
        let g = graph.sides_or_none(f)[i];
        let j = graph
            .sides_or_none(g)
            .iter()
            .position(|&back| back == f)
            .expect("edges have two sides");
        [(f.index(), i), (g.index(), j)]
    };
    sides.map(edge).filter(|[a, b]| a < b).collect()
}

proptest! {
    #[test]
    fn locked_edges_are_as_good_as_missing(
        surface in sculpted(),
        draws in vec((-9..10_i32, 0..12_u32), 300),
        price in proptest::option::of(-20..50_i32),
    ) {
        let graph = DualGraph::new(&triangulation(&surface));
        let edges = edges(&graph);
        let mut costs = vec![[0_i32; 3]; graph.len()];
        let mut locks = vec![0_u8; graph.len()];
        let mut open = Vec::new();
        for (&[(f, i), (g, j)], &(cost, lock)) in edges.iter().zip(draws.iter().cycle()) {
            costs[f][i] = cost;
            costs[g][j] = cost;
            match lock {
                0 => locks[f] |= 1 << i,
                1 => locks[g] |= 1 << j,
                _ => open.push((f as u32, g as u32, i128::from(cost))),
            }
        }
        let prices = price.map_or(Prices::None, Prices::Equal);
        let problem = DualProblem::new(&graph, &costs).with_prices(prices).with_locks(&locks);
        let answer = solve_cubic(&problem, &mut |_| ControlFlow::Continue(()));
        if let Ok(solution) = &answer {
            let matching = solution.matching();
            prop_assert!(matching.is_matching_of(&graph));
            let same = |f: u32| Mates::mate(&matching, f) == solution.mates[f as usize];
            prop_assert!((0..graph.len() as u32).all(same));
            let unpaired = solution.mates.iter().filter(|&&mate| mate == NONE).count();
            prop_assert_eq!(matching.unpaired_count(), unpaired);
        }
        let rows = Rows::from_edges(vec![price.map(i128::from); graph.len()], open.into_iter());
        prop_assert_eq!(
            proven(&problem, answer)?,
            proven(&rows, solve(&rows, Limits::DEFAULT))?
        );
    }
}
