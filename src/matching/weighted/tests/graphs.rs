//! Random graphs of degree at most three, which shrink.

use proptest::collection::vec;
use proptest::prelude::*;

use super::super::problem::{CubicProblem, Edge, GREATEST_COST, NONE, Problem};
use crate::dual::DualGraph;
use crate::samples::{sculpted, triangulation};
use crate::triangulation::TriangleId;

/// A graph of degree at most three, given row by row.
#[derive(Clone, Debug)]
pub(super) struct Rows {
    pub(super) neighbours: Vec<[u32; 3]>,
    pub(super) costs: Vec<[i128; 3]>,
    pub(super) prices: Vec<Option<i128>>,
    /// The neighbours' sides, for those that have them at hand.
    pub(super) backs: Vec<[u8; 3]>,
    pub(super) has_backs: bool,
}

impl Rows {
    /// Adds edges in order; leaves out loops and those that find a node full. Has twins at hand if
    /// there are an even number of edges.
    pub(super) fn from_edges(
        prices: Vec<Option<i128>>,
        edges: impl Iterator<Item = (u32, u32, i128)>,
    ) -> Self {
        let count = prices.len();
        let mut rows = Self {
            neighbours: vec![[NONE; 3]; count],
            costs: vec![[0; 3]; count],
            prices,
            backs: vec![[0; 3]; count],
            has_backs: true,
        };
        for (u, v, cost) in edges.filter(|(u, v, _)| u != v) {
            let vacant = |node: u32| {
                rows.neighbours[node as usize].iter().position(|&neighbour| neighbour == NONE)
            };
            let (Some(i), Some(j)) = (vacant(u), vacant(v)) else { continue };
            for (from, side, to, back) in [(u, i, v, j), (v, j, u, i)] {
                rows.neighbours[from as usize][side] = to;
                rows.costs[from as usize][side] = cost;
                rows.backs[from as usize][side] = back as u8;
            }
            rows.has_backs = !rows.has_backs;
        }
        rows
    }
}

impl Problem for Rows {
    fn node_count(&self) -> usize {
        self.neighbours.len()
    }

    fn edges(&self) -> impl Iterator<Item = Edge> {
        (0..self.node_count() as u32).flat_map(move |node| {
            let side = move |side: usize| {
                let neighbour = self.neighbours[node as usize][side];
                let cost = self.costs[node as usize][side];
                let from_here = neighbour != NONE && node < neighbour;
                from_here.then_some(Edge { ends: [node, neighbour], cost })
            };
            (0..3).filter_map(side)
        })
    }

    fn price(&self, node: u32) -> Option<i128> {
        self.prices[node as usize]
    }
}

impl CubicProblem for Rows {
    fn neighbours(&self, node: u32) -> [u32; 3] {
        self.neighbours[node as usize]
    }

    fn costs(&self, node: u32) -> [i128; 3] {
        self.costs[node as usize]
    }

    fn backs(&self, node: u32) -> Option<[u8; 3]> {
        self.has_backs.then(|| self.backs[node as usize])
    }
}

/// Costs of one kind: all equal, two values, few, many; negative ones as well. Then those at the
/// limits of 32 bits, of 64 and of all.
pub(super) fn cost_range() -> impl Strategy<Value = (i128, i128)> {
    let within = |limit: i128| Just((-limit, limit));
    prop_oneof![
        3 => Just((0, 0)),
        3 => Just((0, 1)),
        3 => within(1),
        3 => Just((-5, 20)),
        3 => within(1_000_000),
        1 => within((1 << 27) - 1),
        1 => within((1 << 59) - 1),
        1 => within(GREATEST_COST),
    ]
}

/// Maps draws to costs in a range.
fn cost(draw: u32, (low, high): (i128, i128)) -> i128 {
    let count = high - low + 1;
    let draw = i128::from(draw);
    low + if count >> 32 == 0 { draw % count } else { draw * (count >> 32) }
}

/// Returns whether all, none or about a third of the nodes have prices.
fn prices(count: usize, range: (i128, i128)) -> impl Strategy<Value = Vec<Option<i128>>> {
    (0..3_u32, vec((0..3_u32, any::<u32>()), count)).prop_map(move |(kind, draws)| {
        let price = |(chance, draw)| (chance < kind).then(|| cost(draw, range));
        draws.into_iter().map(price).collect()
    })
}

/// Any graphs: `density` times as many edges are drawn as there are nodes.
pub(super) fn any_graph(nodes: std::ops::Range<usize>) -> impl Strategy<Value = Rows> {
    (nodes, cost_range(), 1..6_usize).prop_flat_map(|(count, range, density)| {
        let draws = vec((0..count as u32, 0..count as u32, any::<u32>()), 0..density * count + 1);
        (prices(count, range), draws).prop_map(move |(prices, draws)| {
            let edges = draws.into_iter().map(|(u, v, draw)| (u, v, cost(draw, range)));
            Rows::from_edges(prices, edges)
        })
    })
}

/// Graphs whose edges join nodes of numbers at most six apart, as good numberings of meshes do.
pub(super) fn local_graph(nodes: std::ops::Range<usize>) -> impl Strategy<Value = Rows> {
    (nodes, cost_range(), 1..6_usize).prop_flat_map(|(count, range, density)| {
        let draws = vec((0..count as u32, 1..7_u32, any::<u32>()), 0..density * count + 1);
        (prices(count, range), draws).prop_map(move |(prices, draws)| {
            let end = |u: u32, step: u32| (u + step) % count as u32;
            let edges = draws.into_iter();
            let edges = edges.map(|(u, step, draw)| (u, end(u, step), cost(draw, range)));
            Rows::from_edges(prices, edges)
        })
    })
}

/// Cubic graphs: random pairs of three half-edges a node.
pub(super) fn cubic_graph(half: std::ops::Range<usize>) -> impl Strategy<Value = Rows> {
    (half, cost_range()).prop_flat_map(|(half, range)| {
        let halves: Vec<u32> = (0..6 * half as u32).map(|stub| stub / 3).collect();
        (Just(halves).prop_shuffle(), vec(any::<u32>(), 3 * half), prices(2 * half, range))
            .prop_map(move |(stubs, draws, prices)| {
                let pairs = stubs.chunks_exact(2).zip(draws);
                let edges = pairs.map(|(ends, draw)| (ends[0], ends[1], cost(draw, range)));
                Rows::from_edges(prices, edges)
            })
    })
}

/// Dual graphs of closed surfaces, some edges missing in every third.
pub(super) fn surface() -> impl Strategy<Value = Rows> {
    (sculpted(), cost_range(), 0..3_u32).prop_flat_map(|(surface, range, missing)| {
        let graph = DualGraph::new(&triangulation(&surface));
        let count = graph.len();
        let draws = vec((any::<u32>(), 0..10_u32), 3 * count);
        (prices(count, range), draws).prop_map(move |(prices, draws)| {
            let neighbours = graph.triangles().flat_map(|f| {
                graph.sides_or_none(f).map(|g: TriangleId| (f.index() as u32, g.index() as u32))
            });
            let edges = neighbours.zip(&draws);
            let present = edges.filter(|((u, v), (_, chance))| u < v && *chance >= missing / 2);
            let edges = present.map(|((u, v), (draw, _))| (u, v, cost(*draw, range)));
            Rows::from_edges(prices, edges)
        })
    })
}
