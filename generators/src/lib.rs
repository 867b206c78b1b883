//! Triangulated surfaces as plain arrays, for tests, benchmarks and demonstrations.
//!
//! * [`classic`]: the smallest closed surfaces, orientable and not, and an open one;
//! * [`box_mesh`]: boxes with cavities and holes, as large as the papers';
//! * [`grids`]: regular spheres and tori of any size;
//! * [`organic`]: smooth, irregular shapes of any genus;
//! * [`sculptor`]: small edits that keep a closed surface valid, fit for property tests;
//! * [`random`]: random surfaces of any genus, tori, and irregular versions of regular surfaces;
//! * [`worst_cases`]: surfaces on which some algorithms take longer than elsewhere;
//! * `testing` (feature `testing`): what the tests of several crates share.
//!
//! The closed orientable surfaces are consistently oriented, counter-clockwise seen from outside
//! where they are embedded. Without the feature the crate has no dependencies. The generators have
//! no random numbers of their own: callers pass a function `below` such that `below(n)` is a
//! uniform draw from `0..n`. Nothing here calls a mathematical function whose last bit differs
//! between platforms, so equal arguments give equal bits everywhere.
//!
//! ```
//! use triquad_generators::{grids, random};
//!
//! let mut state = 1u64;
//! let mut below = |n: u32| {
//!     state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
//!     ((state >> 32) * u64::from(n) >> 32) as u32
//! };
//! let irregular = random::irregular(&grids::sphere(10), 3, &mut below);
//! assert_eq!(irregular.triangles.len(), 800);
//! ```

pub mod box_mesh;
pub mod classic;
pub mod grids;
pub mod organic;
pub mod random;
pub mod sculptor;
#[cfg(any(test, feature = "testing"))]
pub mod testing;
pub mod worst_cases;

#[cfg(test)]
mod check;
mod circle;
mod surface;

pub use surface::Surface;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
