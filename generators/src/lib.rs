//! Triangulated surfaces as plain arrays, for tests, benchmarks and demonstrations.
//!
//! * [`classic`]: the smallest closed surfaces, orientable and not, and an open one;
//! * [`box_mesh`]: boxes with cavities and holes, as large as the papers';
//! * [`grids`]: regular spheres and tori of any size;
//! * [`organic`]: smooth, irregular shapes of any genus;
//! * [`sculptor`]: small edits that keep a closed surface valid, fit for property tests;
//! * [`random`]: random surfaces of any genus, and irregular versions of regular ones.
//!
//! The closed orientable surfaces are consistently oriented, counter-clockwise seen from outside
//! where they are embedded. The crate has no dependencies and no random numbers of its own: who
//! wants randomness passes a function `below` such that `below(n)` is a uniform draw from `0..n`.
//! Nothing here calls a mathematical function whose last bit differs between platforms, so equal
//! arguments give equal bits everywhere.
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

#[cfg(test)]
mod check;
mod circle;

/// A triangulated surface as plain arrays.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// Coordinates of each vertex.
    pub positions: Vec<[f64; 3]>,
    /// The three vertices of each triangle, as indices into `positions`.
    pub triangles: Vec<[u32; 3]>,
}
