//! The dual graph of a triangulation and matchings in it (Lemos et al., section 2).

mod graph;
mod matching;
mod row;

pub(crate) use graph::Sides;
pub use graph::{DualGraph, DualGraphError};
pub use matching::{Matching, PerfectMatching};
pub(crate) use row::Row;
