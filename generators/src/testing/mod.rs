//! Shared parts of the tests of several crates: randomness, surfaces by the hundred, and damaged
//! files.
//!
//! Behind the feature `testing`, for development dependencies only. Uses the generators, and
//! `proptest` for surfaces that shrink.

mod damage;
mod draws;
#[cfg(feature = "testing")]
mod strategy;
mod surfaces;

pub use damage::damaged;
pub use draws::draws;
#[cfg(feature = "testing")]
pub use strategy::sculpted_surface;
pub use surfaces::{beside, hub, many_surfaces, random_of, special_surfaces};
