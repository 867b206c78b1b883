//! Triangulations of closed, oriented surfaces (Lemos et al., Definition 2.2), as half-edges.
//!
//! Triangle `f` owns half-edges `3f`, `3f + 1`, `3f + 2`, counter-clockwise; `next` and `prev` are
//! arithmetic, and a flat array holds the rest: the origin and the twin of every half-edge.
//! Several components are allowed, each a closed surface; so are vertices that no triangle uses.
//!
//! [`OpenTriangulation`] holds surfaces with a boundary and one-sided ones, [`Surface`] is what
//! both have in common.

mod build;
mod contraction;
mod counts;
mod edge_set;
mod expansion;
mod face_sides;
mod flip;
mod genera;
mod half_edges;
mod ids;
mod laws;
mod link_condition;
mod open;
mod orientation;
mod receipt;
mod split_prefetch;
mod spokes;
mod surface;
mod surroundings;
mod survey;
mod violations;

pub(crate) use contraction::Contraction;
pub use contraction::ShrinkingTriangulation;
pub use edge_set::EdgeSet;
pub(crate) use expansion::{Connectivity, ExpandingTriangulation};
pub(crate) use flip::{Displacements, Moves};
pub use half_edges::Triangulation;
pub use ids::{HalfEdgeId, Id, IdVec, ParseIdError, TriangleId, VertexId};
pub use laws::{Element, Law, Violation};
pub use link_condition::LinkMarks;
pub use open::OpenTriangulation;
pub use receipt::VertexSplit;
pub use spokes::Spokes;
pub use surface::Surface;
pub(crate) use surroundings::Surroundings;
pub use survey::Survey;
