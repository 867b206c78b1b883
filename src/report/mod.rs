//! What is shown of results: pictures of meshes.
//!
//! Nothing here knows how a mesh was made; everything is drawn from plain
//! [`FaceList`](crate::mesh::FaceList)s.

pub mod picture;
