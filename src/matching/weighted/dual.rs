//! Dual graphs of triangulations with costs on the sides of triangles.

use super::prices::Prices;
use super::problem::{CubicProblem, Edge, Mates, NONE, Problem, cubic_edges};
use super::solve::Solution;
use crate::dual::{DualGraph, Matching, PerfectMatching};
use crate::triangulation::TriangleId;

/// A dual graph with a cost on each side of each triangle; both sides of an edge cost the same.
#[derive(Clone, Copy, Debug)]
pub struct DualProblem<'a, C> {
    graph: &'a DualGraph,
    costs: &'a [[C; 3]],
    prices: Prices<'a, C>,
    locks: &'a [u8],
}

impl<'a, C: Copy + Into<i128>> DualProblem<'a, C> {
    /// Takes a graph and the costs of the three sides of each triangle.
    ///
    /// # Panics
    /// If there are not as many costs as triangles.
    pub fn new(graph: &'a DualGraph, costs: &'a [[C; 3]]) -> Self {
        assert_eq!(graph.len(), costs.len(), "one cost a side");
        Self { graph, costs, prices: Prices::None, locks: &[] }
    }

    /// Allows triangles to be left over, each at a price.
    ///
    /// # Panics
    /// If prices are given one by one and are not as many as triangles.
    pub fn with_prices(self, prices: Prices<'a, C>) -> Self {
        prices.check_count(self.graph.len());
        Self { prices, ..self }
    }

    /// Locks edges: no pair may lie across them. Bit `i` of a triangle's entry locks its side `i`;
    /// one of an edge's two sides suffices.
    ///
    /// # Panics
    /// If there are not as many entries as triangles.
    pub fn with_locks(self, locks: &'a [u8]) -> Self {
        assert_eq!(locks.len(), self.graph.len(), "one entry a triangle");
        Self { locks, ..self }
    }

    /// Returns the neighbours across all sides, locked or not.
    #[inline]
    fn across(&self, node: u32) -> [u32; 3] {
        let number = |f: TriangleId| f.some().map_or(NONE, |f| f.index() as u32);
        self.graph.sides_or_none(TriangleId::new(node as usize)).map(number)
    }

    /// Returns whether the edge across a side is locked on either side.
    ///
    /// Triangles that share several edges of equal cost are locked apart in the order of sides.
    fn is_locked(&self, node: u32, side: usize, across: &[u32; 3]) -> bool {
        if self.locks[node as usize] >> side & 1 != 0 {
            return true;
        }
        let neighbour = across[side];
        if neighbour == NONE {
            return false;
        }
        let cost = |node: u32, side: usize| -> i128 { self.costs[node as usize][side].into() };
        let here = cost(node, side);
        let rank = (0..side).filter(|&i| across[i] == neighbour && cost(node, i) == here).count();
        let theirs = self.across(neighbour);
        let back = |i: &usize| theirs[*i] == node && cost(neighbour, *i) == here;
        let back = (0..3).filter(back).nth(rank);
        back.is_some_and(|back| self.locks[neighbour as usize] >> back & 1 != 0)
    }
}

impl<C: Copy + Into<i128> + Sync> Problem for DualProblem<'_, C> {
    fn node_count(&self) -> usize {
        self.graph.len()
    }

    fn edges(&self) -> impl Iterator<Item = Edge> {
        cubic_edges(self, 0, 1)
    }

    fn edges_in(&self, part: usize, parts: usize) -> impl Iterator<Item = Edge> {
        cubic_edges(self, part, parts)
    }

    fn price(&self, node: u32) -> Option<i128> {
        self.prices.of(node)
    }
}

impl<C: Copy + Into<i128> + Sync> CubicProblem for DualProblem<'_, C> {
    #[inline]
    fn neighbours(&self, node: u32) -> [u32; 3] {
        let across = self.across(node);
        if self.locks.is_empty() {
            return across;
        }
        let open = |side| if self.is_locked(node, side, &across) { NONE } else { across[side] };
        [0, 1, 2].map(open)
    }

    #[inline]
    fn costs(&self, node: u32) -> [i128; 3] {
        self.costs[node as usize].map(Into::into)
    }

    #[inline]
    fn backs(&self, node: u32) -> Option<[u8; 3]> {
        self.graph.backs(TriangleId::new(node as usize))
    }
}

impl Mates for Matching {
    fn node_count(&self) -> usize {
        self.len()
    }

    fn mate(&self, node: u32) -> u32 {
        let mate = Matching::mate(self, TriangleId::new(node as usize));
        mate.map_or(NONE, |mate| mate.index() as u32)
    }
}

impl Mates for PerfectMatching {
    fn node_count(&self) -> usize {
        2 * self.pair_count()
    }

    fn mate(&self, node: u32) -> u32 {
        PerfectMatching::mate(self, TriangleId::new(node as usize)).index() as u32
    }
}

impl Solution {
    /// Returns the pairs as a matching of triangles. O(n).
    pub fn matching(&self) -> Matching {
        let mut matching = Matching::empty(self.mates.len());
        for (f, &g) in self.mates.iter().enumerate().filter(|&(f, &g)| g != NONE && f < g as usize)
        {
            matching.pair(TriangleId::new(f), TriangleId::new(g as usize));
        }
        matching
    }
}
