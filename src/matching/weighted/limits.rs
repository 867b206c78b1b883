//! How far trees grow before they are cut.

/// How far trees grow before they are cut. Any choice gives an optimum; only time depends on it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    /// Nodes that a tree of the first round may visit.
    pub(super) first: usize,
    /// Factor from one round to the next; at least 2.
    pub(super) factor: usize,
    /// Rounds of single trees before the forest, if there must be one.
    pub(super) single_rounds: u32,
    /// The remaining roots grow together as soon as their number times the limit exceeds this many
    /// times the number of nodes.
    pub(super) patience: u32,
}

impl Limits {
    /// What is fastest on surfaces.
    pub(super) const DEFAULT: Self = Self { first: 64, factor: 4, single_rounds: 2, patience: 3 };

    /// Returns the limit of the round after one with this limit.
    pub(super) fn next(self, limit: usize) -> usize {
        limit.saturating_mul(self.factor)
    }
}
