//! The nodes of a graph and the state of a search at each, behind one interface.
//!
//! An edge is two *half-edges*, one from each end; its halves are *twins*. Half-edges are numbers
//! from 0 to [`Nodes::codes`]. Each node has one more, to the *ground*: a node whose mate is its
//! ground half-edge stays unpaired at its price.

use std::ops::Range;

use super::number::Number;

/// No half-edge, no set, no blossom.
pub(super) const NONE: u32 = u32::MAX;

/// Role of a node or outermost blossom in the tree that is grown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Label {
    /// In no tree.
    Free,
    /// An even number of edges from the root; potentials rise.
    Outer,
    /// An odd number of edges from the root; potentials fall.
    Inner,
    /// In no tree, but on an odd cycle of edges of value ½ whose half-edges are the mates.
    Half,
}

impl Label {
    /// Returns whether the node is in no tree.
    pub(super) fn is_none(self) -> bool {
        matches!(self, Self::Free | Self::Half)
    }

    pub(super) fn of(bits: u64) -> Self {
        match bits & 3 {
            0 => Self::Free,
            1 => Self::Outer,
            2 => Self::Inner,
            _ => Self::Half,
        }
    }
}

/// An array of nodes. At first none has a mate, and potentials are feasible: no edge has negative
/// slack, and none is above the price of its node.
pub(super) trait Nodes: Sync {
    /// The integers of costs and potentials.
    type N: Number;
    /// Greatest number of a set that a node can store.
    const MOST_SETS: u32;

    /// Returns the number of all nodes.
    fn len(&self) -> u32;
    /// Returns the nodes that may be read and changed here.
    fn range(&self) -> Range<u32>;
    /// Returns whether a node has a neighbour out of range.
    ///
    /// Such a node may be read but must not change: the owner of its neighbour relies on it.
    fn is_on_border(&self, node: u32) -> bool;
    /// Returns the number of half-edges, those to the ground included.
    fn codes(&self) -> u32;
    /// Returns the node that a half-edge leaves.
    fn origin(&self, half_edge: u32) -> u32;
    /// Returns the half-edge of the same edge in the other direction, `NONE` if there is no edge.
    fn twin(&self, half_edge: u32) -> u32;
    /// Returns the node's half-edge to the ground.
    fn ground(&self, node: u32) -> u32;
    /// Returns the node's half-edges but the one to the ground.
    fn sides(&self, node: u32) -> Range<u32>;
    /// Returns the cost of an edge in halves.
    fn cost(&self, half_edge: u32) -> Self::N;
    /// Returns the price of a node in halves.
    fn price(&self, node: u32) -> Option<Self::N>;
    /// Starts to load a node.
    fn prefetch(&self, node: u32);

    /// Returns the stored potential: without the offset of the node's set and without the clock.
    fn potential(&self, node: u32) -> Self::N;
    /// Changes the stored potential.
    fn add_potential(&mut self, node: u32, change: Self::N);
    /// Returns the half-edge to the mate: `NONE` if free, `ground` if unpaired at its price.
    fn mate(&self, node: u32) -> u32;
    fn set_mate(&mut self, node: u32, half_edge: u32);
    /// Returns the half-edge of an inner node to its parent in the tree.
    fn parent(&self, node: u32) -> u32;
    fn set_parent(&mut self, node: u32, half_edge: u32);
    fn label(&self, node: u32) -> Label;
    fn set_label(&mut self, node: u32, label: Label);
    fn is_marked(&self, node: u32) -> bool;
    fn set_marked(&mut self, node: u32, marked: bool);
    /// Returns the set of the outermost blossom that holds the node, `NONE` if it is outermost.
    fn set(&self, node: u32) -> u32;
    fn set_set(&mut self, node: u32, set: u32);

    /// Returns Σ y in halves: without blossoms, no matching costs less. O(n).
    fn potential_sum(&self) -> i128 {
        self.range().map(|node| self.potential(node).widen()).sum()
    }

    /// Starts to load the neighbours of a node.
    #[inline]
    fn prefetch_around(&self, node: u32) {
        for half_edge in self.sides(node) {
            let twin = self.twin(half_edge);
            if twin != NONE {
                self.prefetch(self.origin(twin));
            }
        }
    }

    /// Makes a half-edge and its twin the mates of their ends, or leaves the origin to the ground.
    #[inline]
    fn pair(&mut self, half_edge: u32) {
        let node = self.origin(half_edge);
        self.set_mate(node, half_edge);
        if half_edge != self.ground(node) {
            let twin = self.twin(half_edge);
            self.set_mate(self.origin(twin), twin);
        }
    }

    /// Returns whether this half-edge marks its origin as one without mate in the graph.
    #[inline]
    fn is_no_mate(&self, mate: u32) -> bool {
        mate == NONE || mate == self.ground(self.origin(mate))
    }

    /// Returns the node at the other end of a half-edge; the half-edge must have a twin.
    #[inline]
    fn head(&self, half_edge: u32) -> u32 {
        self.origin(self.twin(half_edge))
    }
}
