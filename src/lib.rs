//! All-quadrilateral meshes from triangulations of closed surfaces, on the same vertices.
//!
//! Two triangles that share an edge make a quad when that edge is removed. The dual graph of a
//! triangulated closed surface is 3-regular and bridgeless, so its triangles can be paired up
//! perfectly (Petersen's theorem). [`Converter`] finds such a pairing and checks the result:
//!
#![cfg_attr(feature = "files", doc = "```no_run")]
#![cfg_attr(not(feature = "files"), doc = "```ignore")]
//! let mesh = triquad::Mesh::read("in.obj")?;
//! let quads = triquad::Converter::new().seed(7).run(&mesh)?;
//! quads.mesh().write("out.obj")?;
//! println!("{}", quads.report());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # I want to …
//!
//! | task | item |
//! |---|---|
//! | read or write a mesh file | [`Mesh`], [`mesh`] |
//! | convert arrays that I have in memory | [`Mesh::from_triangles`], [`Converter`] |
//! | find every law that a mesh breaks | [`Survey::new`] |
//! | define what a good quad is | [`Converter::cost`], [`Cost`] |
//! | keep some edges | [`Converter::keep`], [`quadrangulation::Keep`] |
//! | convert surfaces with boundary | [`Converter::open`] |
//! | solve a minimum-cost perfect matching | [`matching::weighted`] |
//! | choose how triangles are paired | [`Converter::algorithm`], [`pairing`] |
//! | write a pairing algorithm | [`DualGraph`], [`Matching`], [`make_maximum`], `examples/own_pairing.rs` |
//! | check quads of any origin | [`check`] |
//! | measure the shape of quads | [`Quality`](quadrangulation::quality::Quality) |
//! | reduce a mesh to a number of vertices, with the same topology | [`simplify`] |
//! | contract edges until the triangulation is irreducible | [`irreducible`] |
//!
//! # Features
//!
//! * `files` (default): mesh files. Without it and `threads` the crate has three dependencies.
//! * `threads` (default): building, costs and checks on all threads of rayon's current pool.
//!   Results are the same on any number of threads, and without the feature.
//! * `serde`: ids, names, counts and reports as serde data.
//!
//! # Modules
//!
//! The algorithms are those of Lemos, Ramaswami and Siqueira, *An Experimental Comparison of
//! Algorithms for Converting Triangulations of Closed Surfaces into Quadrangulations* (column
//! "source"), and of Ramaswami and Siqueira, *A fast algorithm for computing irreducible
//! triangulations of closed surfaces*.
//!
//! | module | content | source |
//! |---|---|---|
//! | [`atomic_file`] | files that appear only when they are complete | |
//! | [`mesh`] | OBJ, PLY, OFF, STL to [`Mesh`] and back, unchecked | |
//! | [`random`], [`clock`] | seeded random numbers; seconds, scripted in tests | |
//! | [`triangulation`] | half-edges, and the laws that make a mesh a triangulation | section 2 |
//! | [`dual`] | the dual graph and matchings in it | section 2 |
//! | [`matching`] | alternating trees and blossoms; perfect matchings of least cost | |
//! | [`irreducible`] | contraction until no edge can be contracted: RS, Schipper's, brute force | |
//! | [`pairing`] | initial pairings, one for each [`Algorithm`] | section 3 |
//! | [`augmentation`] | augmenting paths, as published and ours | section 3.1 |
//! | [`quadrangulation`] | the quads, and a check independent of their construction | section 2 |
//! | [`simplify`] | an exact number of vertices, same topology | section 4 |
//! | [`convert`](mod@convert) | the chain, counted and timed | section 4 |
//!
//! A module uses only modules above it. One type per stage is the proof that the stage before is
//! done: `Mesh → Triangulation → InitialPairing → PerfectMatching → Quadrangulation`.

#[cfg(feature = "files")]
pub mod atomic_file;
pub mod augmentation;
pub mod clock;
pub mod convert;
pub mod counted;
mod disjoint_sets;
pub mod dual;
pub mod dynamic;
pub mod irreducible;
pub mod matching;
pub mod mesh;
mod names;
pub mod pairing;
mod parallel;
mod prefetch;
pub mod quadrangulation;
pub mod random;
#[cfg(test)]
mod samples;
pub mod simplify;
pub mod triangulation;
mod vector;

#[cfg(all(doctest, feature = "files"))]
#[doc = include_str!("../README.md")]
struct Readme;

pub use augmentation::{Augmentation, AugmentationStats, make_maximum};
pub use convert::{
    ConvertError, Converted, Converter, Progress, Quadrangulated, Report, Size, Stage,
};
pub use dual::{DualGraph, Matching, PerfectMatching};
pub use mesh::Mesh;
#[cfg(feature = "files")]
pub use mesh::MeshError;
pub use names::UnknownNameError;
pub use pairing::{Algorithm, Expansion};
pub use quadrangulation::{
    AttributeLosses, CheckError, CheckReport, Cost, DefaultCost, Quadrangulation, ShapeCost, check,
    check_retriangulation, common_edges,
};
pub use triangulation::{Element, Law, Survey, Triangulation, Violation};
