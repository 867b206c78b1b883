//! Where time is read, so that it can be scripted in tests.

use std::sync::atomic::{AtomicU32, Ordering};
use std::time::Instant;

/// Something that tells seconds since some fixed moment.
pub trait Clock {
    /// Seconds, never going back.
    fn seconds(&self) -> f64;

    /// Runs `work` and tells how many seconds passed.
    fn time<T>(&self, work: impl FnOnce() -> T) -> (T, f64)
    where
        Self: Sized,
    {
        let start = self.seconds();
        let result = work();
        (result, self.seconds() - start)
    }
}

/// The monotonic clock of the system.
#[derive(Debug)]
pub struct SystemClock(Instant);

impl Default for SystemClock {
    fn default() -> Self {
        Self(Instant::now())
    }
}

impl Clock for SystemClock {
    fn seconds(&self) -> f64 {
        self.0.elapsed().as_secs_f64()
    }
}

/// A clock that moves on by the same step each time it is read.
#[derive(Debug)]
pub struct SteppingClock {
    readings: AtomicU32,
    step: f64,
}

impl SteppingClock {
    /// A clock that first tells 0, then `step`, `2 step` …
    pub fn new(step: f64) -> Self {
        Self { readings: AtomicU32::new(0), step }
    }
}

impl Clock for SteppingClock {
    fn seconds(&self) -> f64 {
        f64::from(self.readings.fetch_add(1, Ordering::Relaxed)) * self.step
    }
}
