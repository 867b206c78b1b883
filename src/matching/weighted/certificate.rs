//! The proof of optimality: a feasible solution of the dual linear program, of the same value.

use super::problem::NONE;

/// Integers of the narrowest width that holds them all.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Integers {
    /// 4 bytes each.
    Narrow(Vec<i32>),
    /// 8 bytes each.
    Wide(Vec<i64>),
    /// 16 bytes each.
    Widest(Vec<i128>),
}

impl Integers {
    /// Returns the number of integers.
    pub fn len(&self) -> usize {
        match self {
            Self::Narrow(values) => values.len(),
            Self::Wide(values) => values.len(),
            Self::Widest(values) => values.len(),
        }
    }

    /// Returns whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Returns the integer at a position.
    ///
    /// # Panics
    /// If there is no such position.
    #[inline]
    pub fn at(&self, index: usize) -> i128 {
        match self {
            Self::Narrow(values) => values[index].into(),
            Self::Wide(values) => values[index].into(),
            Self::Widest(values) => values[index],
        }
    }
}

/// Dual values that prove a matching to be of least cost.
///
/// A family of odd sets of nodes is *laminar* if any two are nested or disjoint. With a value y for
/// every node and z ≥ 0 for every odd set, the potential π of a node is its y plus the z of all
/// sets that hold it. All values are in halves: an edge of cost c appears with 2c.
///
/// 8 bytes a node if the potentials fit 32 bits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Certificate {
    /// Potential π of each node, in halves.
    pub potentials: Integers,
    /// Number of the innermost odd set that holds each node, or [`NONE`].
    pub innermost: Vec<u32>,
    /// Number of the smallest odd set that holds each odd set, or [`NONE`]; greater than its own.
    pub parents: Vec<u32>,
    /// Dual value z of each odd set, in halves.
    pub values: Integers,
}

impl Certificate {
    /// Returns the nodes with a potential below a number of halves, in order. O(n).
    ///
    /// If all nodes have one price that outweighs all costs, the nodes below minus the price are a
    /// [`Barrier`](super::Barrier) that shows how many nodes stay unpaired at least.
    pub fn below(&self, potential: i128) -> Vec<u32> {
        let is_low = |&node: &u32| self.potentials.at(node as usize) < potential;
        (0..self.potentials.len() as u32).filter(is_low).collect()
    }

    /// Returns the number of odd sets.
    pub fn set_count(&self) -> usize {
        self.parents.len()
    }

    /// Returns the number of the odd set that holds `set`, if one does.
    pub fn parent(&self, set: u32) -> Option<u32> {
        Some(self.parents[set as usize]).filter(|&parent| parent != NONE)
    }
}
