//! Clocks: the system's, and one that is scripted in tests.
//!
//! ```
//! use triquad::clock::{Clock, SteppingClock};
//!
//! let clock = SteppingClock::new(0.5);
//! assert_eq!(clock.time(|| 2 + 2), (4, 0.5));
//! ```

use std::sync::atomic::{AtomicU32, Ordering};
use std::time::Instant;

/// Rounds seconds to nanoseconds, the resolution of the system's clock. Differences and sums of
/// times are then written with the digits that were measured, and no others.
///
/// ```
/// use triquad::clock::to_nanoseconds;
///
/// assert_eq!(0.1 + 0.2, 0.30000000000000004);
/// assert_eq!(to_nanoseconds(0.1 + 0.2), 0.3);
/// ```
pub fn to_nanoseconds(seconds: f64) -> f64 {
    (1e9 * seconds).round() / 1e9
}

/// A source of seconds since some fixed moment.
pub trait Clock {
    /// Returns the seconds, which never decrease.
    fn seconds(&self) -> f64;

    /// Runs `work` and returns its result with the seconds that passed, in whole nanoseconds.
    fn time<T>(&self, work: impl FnOnce() -> T) -> (T, f64)
    where
        Self: Sized,
    {
        let start = self.seconds();
        let result = work();
        (result, to_nanoseconds(self.seconds() - start))
    }
}

/// The monotonic clock of the system, from 0 where it is made.
#[derive(Clone, Copy, Debug)]
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

/// A clock that advances by the same step at each reading.
#[derive(Debug)]
pub struct SteppingClock {
    readings: AtomicU32,
    step: f64,
}

impl SteppingClock {
    /// Makes a clock whose readings are 0, `step`, `2 step` … seconds.
    pub fn new(step: f64) -> Self {
        Self { readings: AtomicU32::new(0), step }
    }
}

impl Clock for SteppingClock {
    fn seconds(&self) -> f64 {
        f64::from(self.readings.fetch_add(1, Ordering::Relaxed)) * self.step
    }
}
