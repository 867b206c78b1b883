//! Triangulations of closed, oriented surfaces (Lemos et al., Definition 2.2), as half-edges.
//!
//! Triangle `f` owns half-edges `3f`, `3f + 1`, `3f + 2`, counter-clockwise; `next` and `prev` are
//! arithmetic, and a flat array holds the rest: the origin and the twin of every half-edge.
//! Several components are allowed, each a closed surface; so are vertices that no triangle uses.

mod build;
mod contraction;
mod counts;
mod expansion;
mod flip;
mod half_edges;
mod ids;
mod laws;
mod link_condition;
mod receipt;
mod split_prefetch;
mod spokes;

mod surroundings;
mod survey;

pub(crate) use contraction::Contraction;
pub use contraction::ShrinkingTriangulation;
pub(crate) use expansion::{Connectivity, ExpandingTriangulation};
pub(crate) use flip::{Displacements, Moves};
pub(crate) use half_edges::Side;
pub use half_edges::Triangulation;
pub use ids::{HalfEdgeId, Id, IdVec, ParseIdError, TriangleId, VertexId};
pub use laws::{Element, Law, Violation};
pub use link_condition::LinkMarks;
pub use receipt::VertexSplit;
pub use spokes::Spokes;
pub(crate) use surroundings::Surroundings;
pub use survey::Survey;
