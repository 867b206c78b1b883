//! What is shown of results: pictures of meshes, and the papers' tables to lay beside our own.
//!
//! Nothing here knows how a mesh was made; pictures are drawn from plain
//! [`FaceList`](crate::mesh::FaceList)s.

pub mod paper;
pub mod picture;
