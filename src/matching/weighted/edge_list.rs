//! Any graph, given by a list of its edges.

use super::prices::Prices;
use super::problem::{Edge, Problem};
use crate::parallel::range_of;

/// A graph given by a list of edges and their costs.
///
/// Parallel edges are allowed and loops are ignored.
#[derive(Clone, Copy, Debug)]
pub struct EdgeList<'a, C> {
    node_count: usize,
    edges: &'a [(u32, u32)],
    costs: &'a [C],
    prices: Prices<'a, C>,
}

impl<'a, C: Copy + Into<i128>> EdgeList<'a, C> {
    /// Takes the number of nodes, the edges and the cost of each edge.
    ///
    /// # Panics
    /// If there are not as many costs as edges.
    pub fn new(node_count: usize, edges: &'a [(u32, u32)], costs: &'a [C]) -> Self {
        assert_eq!(edges.len(), costs.len(), "one cost an edge");
        Self { node_count, edges, costs, prices: Prices::None }
    }

    /// Allows nodes to stay unpaired, each at a price.
    ///
    /// # Panics
    /// If prices are given one by one and are not as many as nodes.
    pub fn with_prices(self, prices: Prices<'a, C>) -> Self {
        prices.check_count(self.node_count);
        Self { prices, ..self }
    }
}

impl<C: Copy + Into<i128> + Sync> Problem for EdgeList<'_, C> {
    fn node_count(&self) -> usize {
        self.node_count
    }

    fn edges(&self) -> impl Iterator<Item = Edge> {
        self.edges_in(0, 1)
    }

    fn edges_in(&self, part: usize, parts: usize) -> impl Iterator<Item = Edge> {
        let edge = |(&(u, v), &cost): (&(u32, u32), &C)| Edge { ends: [u, v], cost: cost.into() };
        let range = range_of(part, parts, self.edges.len());
        self.edges[range.clone()].iter().zip(&self.costs[range]).map(edge)
    }

    fn price(&self, node: u32) -> Option<i128> {
        self.prices.of(node)
    }
}
