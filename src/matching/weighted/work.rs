//! Counts of what a run did.

/// Counts of what a run did; they depend on the input alone.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Nodes left free by the greedy start and the displacements after it.
    pub free_after_start: u64,
    /// Nodes labelled outer in the half-integral phase.
    pub visits: u64,
    /// Searches of the half-integral phase.
    pub half_searches: u64,
    /// Roots that were grown together in forests.
    pub forest_roots: u64,
    /// Odd cycles left by the half-integral phase; the roots of the blossom phase.
    pub blossom_roots: u64,
    /// Searches of the blossom phase.
    pub blossom_searches: u64,
    /// Nodes scanned in the blossom phase.
    pub scans: u64,
    /// Changes of the clock in all phases.
    pub clock_ticks: u64,
    /// Bits of the numbers that sufficed.
    pub bits: u32,
}

impl Work {
    /// Makes the counts of a run with these numbers that has not begun.
    pub(super) fn of<N>() -> Self {
        Self { bits: 8 * size_of::<N>() as u32, ..Self::default() }
    }

    /// Adds the counts of a part of the run.
    pub(super) fn add(&mut self, part: Self) {
        self.free_after_start += part.free_after_start;
        self.visits += part.visits;
        self.half_searches += part.half_searches;
        self.forest_roots += part.forest_roots;
        self.blossom_roots += part.blossom_roots;
        self.blossom_searches += part.blossom_searches;
        self.scans += part.scans;
        self.clock_ticks += part.clock_ticks;
    }
}
