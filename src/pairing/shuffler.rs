//! Random choices of a pairing, with the time that shuffles take.

use crate::clock::Clock;
use crate::random::Random;

/// A stream of random choices that counts the seconds of its shuffles, if it has a clock.
pub(super) struct Shuffler<'a> {
    random: &'a mut Random,
    clock: Option<&'a dyn Clock>,
    seconds: f64,
}

impl<'a> Shuffler<'a> {
    pub(super) fn new(random: &'a mut Random, clock: Option<&'a dyn Clock>) -> Self {
        Self { random, clock, seconds: 0.0 }
    }

    /// Draws uniformly from `0..bound`.
    pub(super) fn below(&mut self, bound: u32) -> u32 {
        self.random.below(bound)
    }

    /// Shuffles `items` uniformly.
    pub(super) fn shuffle<T>(&mut self, items: &mut [T]) {
        let start = self.clock.map(Clock::seconds);
        self.random.shuffle(items);
        if let Some((clock, start)) = self.clock.zip(start) {
            self.seconds += clock.seconds() - start;
        }
    }

    /// Returns the seconds that shuffles have taken; 0 without a clock.
    pub(super) fn seconds(&self) -> f64 {
        self.seconds
    }
}
