//! All-quadrilateral meshes from triangulations of closed surfaces.
//!
//! Any triangulation of a closed surface can be turned into a quadrangulation with the same vertices
//! by pairing up edge-adjacent triangles perfectly: the dual graph is 3-regular and bridgeless, and
//! such a graph has a perfect matching (Petersen's theorem). The call is [`convert()`]; the parts
//! follow Lemos, Ramaswami and Siqueira, *An Experimental Comparison of Algorithms for Converting
//! Triangulations of Closed Surfaces into Quadrangulations*:
//!
//! | module | what | source |
//! |---|---|---|
//! | [`mesh`] | files: OBJ, PLY, OFF, STL → [`Mesh`](mesh::Mesh), unchecked (feature `files`) | |
//! | [`triangulation`] | half-edges, and the laws that make a face list a triangulation | section 2 |
//! | [`irreducible`] | contraction until nothing can be contracted: RS, Schipper's, brute force | |
//! | [`dual`] | the dual graph and matchings in it | section 2 |
//! | [`augmentation`] | augmenting paths, as published and ours | section 3.1 |
//! | [`dynamic`] | link-cut trees, Euler-tour trees, dynamic connectivity | for section 3.2 |
//! | [`pairing`] | initial pairings: SG, PS, DS, GW, LRS, ours | section 3 |
//! | [`quadrangulation`] | the quads, and a check that trusts nothing | section 2 |
//! | [`simplify`] | fewer vertices, exactly as many as asked for, same topology | section 4 |
//! | [`convert`](mod@convert) | the chain, timed | section 4 |
//!
//! A module uses only what stands above it. One type per stage is the proof that the stage before
//! was done: `Mesh → Triangulation → InitialPairing → PerfectMatching → Quadrangulation`.

#[cfg(feature = "files")]
pub mod atomic_file;
pub mod augmentation;
pub mod clock;
pub mod convert;
mod disjoint_sets;
pub mod dual;
pub mod dynamic;
pub mod irreducible;
pub mod matching;
pub mod mesh;
mod names;
pub mod pairing;
mod prefetch;
pub mod quadrangulation;
pub mod random;
#[cfg(test)]
mod samples;
pub mod simplify;
pub mod triangulation;
mod vector;

pub use augmentation::{Augmentation, AugmentationStats, make_maximum};
pub use convert::{ConvertError, Converted, Converter, Progress, Quadrangulated, Report, Stage};
pub use dual::{DualGraph, Matching, PerfectMatching};
pub use mesh::Mesh;
#[cfg(feature = "files")]
pub use mesh::MeshError;
pub use names::UnknownNameError;
pub use pairing::{Algorithm, Expansion};
pub use quadrangulation::{CheckReport, Mismatch, Quadrangulation, check, check_retriangulation};
pub use triangulation::{Element, Law, Survey, Triangulation, Violation};
