//! News from a run, and the answer whether to go on.

use std::ops::ControlFlow;

/// Part of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Alternating trees without blossoms.
    HalfIntegral,
    /// Alternating trees with blossoms.
    Blossoms,
}

/// State of a run between two searches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct News {
    /// Part that is running.
    pub stage: Stage,
    /// Roots that are still to be paired in this part; it never rises within one.
    pub roots: usize,
}

/// Passes news on, now and then.
pub(super) struct Observer<'a> {
    hook: &'a mut dyn FnMut(News) -> ControlFlow<()>,
    searches: u32,
}

/// Searches between two calls of the hook; in tests few, so that small graphs are stopped anywhere.
const RARELY: u32 = if cfg!(test) { 2 } else { 256 };

impl<'a> Observer<'a> {
    pub(super) fn new(hook: &'a mut dyn FnMut(News) -> ControlFlow<()>) -> Self {
        Self { hook, searches: 0 }
    }

    /// Passes news on once in a while; returns whether the run is to stop.
    #[inline]
    pub(super) fn stops(&mut self, stage: Stage, roots: usize) -> bool {
        self.searches += 1;
        self.searches % RARELY == 1 && (self.hook)(News { stage, roots }).is_break()
    }

    /// Passes news on; returns whether the run is to stop.
    pub(super) fn stops_now(&mut self, stage: Stage, roots: usize) -> bool {
        (self.hook)(News { stage, roots }).is_break()
    }
}
