//! The dual graph of a triangulation and matchings in it (Lemos et al., section 2).
//!
//! # Examples
//!
//! ```
//! use triquad::dual::{DualGraph, DualGraphError, Matching};
//! use triquad::triangulation::TriangleId;
//!
//! let graph = DualGraph::from_edges(4, &[(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)])?;
//! let [a, b, c, d] = [0, 1, 2, 3].map(TriangleId::new);
//! assert!(graph.neighbours(a).eq([b, c, d]));
//!
//! let mut matching = Matching::empty(graph.len());
//! matching.pair(a, c);
//! assert_eq!((matching.mate(c), matching.unpaired_count()), (Some(a), 2));
//! matching.pair(b, d);
//! let perfect = matching.certify(&graph).expect("no triangle is unpaired");
//! assert!(perfect.pairs().eq([(a, c), (b, d)]));
//! # Ok::<(), DualGraphError>(())
//! ```
//!
//! [`DualGraph::new`] makes the graph of a triangulation: `examples/own_pairing.rs`. Functions that
//! read one number have no examples of their own.

mod graph;
mod matching;
mod row;

pub(crate) use graph::Sides;
pub use graph::{DualGraph, DualGraphError};
pub use matching::{Matching, PerfectMatching};
pub(crate) use row::Row;
