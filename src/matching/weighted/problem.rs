//! The problem: a graph, an integer cost on every edge, a price for nodes that may stay unpaired.

use crate::parallel::range_of;

/// Stands for "no node": the neighbour across a boundary, the mate of an unpaired node.
pub const NONE: u32 = u32::MAX;

/// Greatest absolute value of a cost or price, 2⁹⁰.
///
/// With it, no sum that the algorithm or the check forms can overflow an `i128`.
pub const GREATEST_COST: i128 = 1 << 90;

/// One edge of a graph and its cost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Edge {
    /// The two nodes that the edge joins.
    pub ends: [u32; 2],
    /// The cost of pairing them.
    pub cost: i128,
}

/// A graph with costs, as the check reads it, on several threads at once.
///
/// Parallel edges are allowed, even at different costs. Loops have no part in any matching: they
/// are ignored everywhere.
pub trait Problem: Sync {
    /// Returns the number of nodes; they are numbered from 0.
    fn node_count(&self) -> usize;

    /// Returns every edge once, in any order.
    fn edges(&self) -> impl Iterator<Item = Edge>;

    /// Returns the edges in one of several parts: each is in one of them, in the order of
    /// [`Problem::edges`].
    ///
    /// Each thread of the check reads a part. Unless this is implemented, the first part has all.
    fn edges_in(&self, part: usize, _parts: usize) -> impl Iterator<Item = Edge> {
        self.edges().take(if part == 0 { usize::MAX } else { 0 })
    }

    /// Returns the price of leaving a node unpaired, or `None` if it must be paired.
    fn price(&self, node: u32) -> Option<i128>;
}

/// A graph in which each node has at most three sides, each with an edge or without.
///
/// Side `i` of a node and the same edge's side of the neighbour must have equal costs.
pub trait CubicProblem: Problem {
    /// Returns the neighbours across the three sides, [`NONE`] where there is no edge.
    fn neighbours(&self, node: u32) -> [u32; 3];

    /// Returns the costs of the edges across the three sides; any number where there is no edge.
    fn costs(&self, node: u32) -> [i128; 3];

    /// Returns for each side the neighbour's side of the same edge, from 0 to 2, if these are at
    /// hand for all nodes; the solver need not find them then, and relies on them. Where there is
    /// no edge, any of them.
    fn backs(&self, _node: u32) -> Option<[u8; 3]> {
        None
    }
}

/// Returns the edges in one of several parts, each edge at the lower of its nodes.
pub(crate) fn cubic_edges(
    problem: &impl CubicProblem,
    part: usize,
    parts: usize,
) -> impl Iterator<Item = Edge> {
    range_of(part, parts, problem.node_count()).flat_map(move |node| {
        let node = node as u32;
        let (neighbours, costs) = (problem.neighbours(node), problem.costs(node));
        let from_here = move |&side: &usize| neighbours[side] != NONE && node < neighbours[side];
        let edge = move |side| Edge { ends: [node, neighbours[side]], cost: costs[side] };
        (0..3).filter(from_here).map(edge)
    })
}

/// A matching, read node by node.
pub trait Mates: Sync {
    /// Returns the number of nodes, paired or not.
    fn node_count(&self) -> usize;

    /// Returns the node that this one is paired with, or [`NONE`].
    fn mate(&self, node: u32) -> u32;
}

impl Mates for [u32] {
    fn node_count(&self) -> usize {
        self.len()
    }

    fn mate(&self, node: u32) -> u32 {
        self[node as usize]
    }
}

impl Mates for Vec<u32> {
    fn node_count(&self) -> usize {
        self.len()
    }

    fn mate(&self, node: u32) -> u32 {
        self[node as usize]
    }
}
