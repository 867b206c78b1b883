//! Tests of the library through its public items, in one program.

mod auto_traits;
mod common;
mod conformance;
mod contraction;
#[cfg(feature = "files")]
mod dialects;
mod dynamic;
#[cfg(feature = "files")]
mod errors;
mod examples;
#[cfg(feature = "files")]
mod formats;
mod irreducible;
mod laws;
mod matching;
mod open;
#[cfg(feature = "files")]
mod polygons;
#[cfg(feature = "files")]
mod real_meshes;
#[cfg(feature = "files")]
mod simplify;
#[cfg(feature = "threads")]
mod threads;
mod weighted;
