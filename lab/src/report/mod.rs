//! What is shown of results: tables, the comparison with the papers, plots, pictures of meshes, and
//! one page with all of it.
//!
//! Everything is made of records and of the papers' printed values, nothing is measured here.
//! Pictures know nothing of how a mesh was made: they are drawn from plain
//! [`Mesh`](triquad::Mesh)s.

pub mod claims;
pub mod compare;
pub mod figures;
pub mod fit;
pub mod gallery;
pub mod number;
pub mod page;
pub mod paper;
pub mod plots;
pub mod statistics;
pub mod summary;
pub mod tables;
pub mod write;

pub use compare::{Comparison, Judged, Verdict};
pub use statistics::Statistics;
pub use summary::{Cell, Summary};
pub use tables::ReportTable;
