//! Triangulations of closed, oriented surfaces (Lemos et al., Definition 2.2), as half-edges.
//!
//! Triangle `f` owns half-edges `3f`, `3f + 1`, `3f + 2`, counter-clockwise; `next` and `prev` are
//! arithmetic, and a flat array holds the rest: the origin and the twin of every half-edge.
//! Several components are allowed, each a closed surface; so are vertices that no triangle uses.
//!
//! [`OpenTriangulation`] holds surfaces with a boundary and one-sided ones, [`Surface`] is what
//! both have in common.
//!
//! # Examples
//!
//! Each law that a mesh breaks is a [`Violation`] with a place and a remedy:
//!
//! ```
//! use triquad::{Law, Mesh, Survey, Triangulation};
//!
//! let one_turned = vec![[0, 1, 2], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
//! let mut mesh = Mesh::from_triangles(vec![[0.0; 3]; 4], one_turned);
//! let survey = Survey::new(&mesh);
//! assert_eq!(survey.violations[0].law, Law::ConsistentOrientation);
//! assert!(survey.only_orientation_is_wrong());
//!
//! let triangulation = Triangulation::build_oriented(&mut mesh)?;
//! assert_eq!((triangulation.edge_count(), triangulation.genus()), (6, 0));
//! # Ok::<(), Box<Survey>>(())
//! ```
//!
//! An edge is contracted, and split again:
//!
//! ```
//! use triquad::{Mesh, Triangulation};
//! use triquad::triangulation::{HalfEdgeId, LinkMarks, ShrinkingTriangulation};
//!
//! let upper = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]];
//! let lower = [[5, 2, 1], [5, 3, 2], [5, 4, 3], [5, 1, 4]];
//! let octahedron = Mesh::from_triangles(vec![[0.0; 3]; 6], [upper, lower].concat());
//! let triangulation = Triangulation::build(&octahedron)?;
//!
//! let mut shrinking = ShrinkingTriangulation::from(triangulation);
//! let side = HalfEdgeId::new(0);
//! assert_eq!(shrinking.spokes(shrinking.origin(side)).count(), 4);
//! let mut marks = LinkMarks::new(shrinking.vertex_id_count());
//! assert!(shrinking.is_contractible(side, &mut marks));
//! let receipt = shrinking.contract(side);
//! assert_eq!(shrinking.vertex_count(), 5);
//! shrinking.split(receipt);
//! assert_eq!(shrinking.into_triangulation().to_faces(), *octahedron.faces());
//! # Ok::<(), Box<triquad::Survey>>(())
//! ```
//!
//! A surface with a boundary:
//!
//! ```
//! use triquad::Mesh;
//! use triquad::triangulation::{OpenTriangulation, Surface};
//!
//! let square = Mesh::from_triangles(vec![[0.0; 3]; 4], vec![[0, 1, 2], [0, 2, 3]]);
//! let surface = OpenTriangulation::build(&square)?;
//! assert_eq!((surface.edge_count(), surface.boundary_edge_count()), (5, 4));
//! assert_eq!(surface.edges().filter(|&side| surface.across(side).is_some()).count(), 1);
//! # Ok::<(), Box<triquad::Survey>>(())
//! ```
//!
//! Counts, ids and single half-edges have names and types that say what they are, so they have no
//! examples of their own.

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
