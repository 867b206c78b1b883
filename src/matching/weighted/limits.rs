//! Limits at which growing trees are cut, and parts of the nodes.

use std::ops::Range;

/// Limits at which growing trees are cut. Any choice gives an optimum; only time depends on it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    /// Displacements in a chain that a free node may begin.
    pub(super) displacements: u32,
    /// Nodes that a tree of the first round may visit.
    pub(super) first: usize,
    /// Factor from one round to the next; at least 2.
    pub(super) factor: usize,
    /// Rounds of single trees before the forest, if there must be one.
    pub(super) single_rounds: u32,
    /// The remaining roots grow together as soon as their number times the limit exceeds this many
    /// times the number of nodes.
    pub(super) patience: u32,
    /// Nodes that are divided into parts, at least.
    pub(super) divided: usize,
    /// Nodes in a part, about, if there are more than two. The smaller the parts, the more searches
    /// meet their borders and have to be made again by one thread.
    pub(super) part: usize,
    /// Parts that the nodes are divided into, at most.
    pub(super) parts: usize,
    /// Trees in a part may visit one node in so many of it; larger ones mostly meet its border.
    pub(super) share: usize,
    /// Nodes in a patch, of which parts are made. Their rows fit in the cache of a core.
    pub(super) patch: usize,
    /// Parts are worth it if at most one node in so many is on a border.
    pub(super) border: usize,
}

impl Limits {
    /// The fastest limits on surfaces.
    pub(super) const DEFAULT: Self = Self {
        displacements: 16,
        first: 64,
        factor: 8,
        single_rounds: 2,
        patience: 3,
        divided: 1 << 15,
        part: 1 << 20,
        parts: 16,
        share: 16,
        patch: 1 << 10,
        border: 10,
    };

    /// Returns the limit of the round after one with this limit.
    pub(super) fn next(self, limit: usize) -> usize {
        limit.saturating_mul(self.factor)
    }

    /// Returns how many parts to divide so many nodes into: 1, 2, 4, and so on. It does not depend
    /// on the machine.
    pub(super) fn parts(self, nodes: usize) -> usize {
        match nodes / self.part {
            0 if nodes < self.divided => 1,
            many => many.next_power_of_two().max(2).min(self.parts),
        }
    }

    /// Returns the nodes of each part, about equally many, in order.
    pub(super) fn ranges(self, nodes: usize) -> impl ExactSizeIterator<Item = Range<u32>> {
        let parts = self.parts(nodes);
        let end = move |part: usize| (nodes as u64 * part as u64 / parts as u64) as u32;
        (0..parts).map(move |part| end(part)..end(part + 1))
    }

    /// Returns whether parts are worth it with so many nodes on their borders.
    pub(super) fn allow(self, border: usize, nodes: usize) -> bool {
        border <= nodes / self.border
    }

    /// Returns the greatest limit for trees in one of so many parts.
    pub(super) fn most_in_part(self, nodes: usize, parts: usize) -> usize {
        nodes / parts / self.share
    }
}
