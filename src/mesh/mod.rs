//! Meshes, and the files that hold them (feature `files`).
//!
//! OBJ, PLY, OFF and STL are read, OBJ, PLY and OFF are written, each also gzipped. Readers keep
//! the order of vertices and faces, unreferenced vertices and every f64 value. Writers print values
//! that read back to the same f64. Nothing about the mesh is judged here.
//! Uses [`atomic_file`](crate::atomic_file) and threads, nothing else of the library.
//!
//! # Examples
//!
//! Polygons are cut, and faces are replaced:
//!
//! ```
//! use triquad::mesh::{Faces, Mesh};
//!
//! let corners = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
//! let mut mesh = Mesh::new(corners, Faces::uniform(4, vec![0, 1, 2, 3]));
//! mesh.triangulate()?;
//! assert_eq!((mesh.faces().len(), mesh.faces().arity()), (2, Some(3)));
//!
//! let mut faces = Faces::default();
//! faces.push(&[0, 1, 2]);
//! let mut half = mesh.with_faces(faces);
//! half.reverse_face(0);
//! assert_eq!(half.faces()[0], [0, 2, 1]);
//! # Ok::<(), triquad::mesh::CutError>(())
//! ```
//!
//! `Mesh::read` and `Mesh::write` are on the first page of the crate. Functions that read one part
//! of a mesh have no examples of their own.

mod attributes;
mod corner_indices;
mod face_sections;
mod faces;
mod polygon_cut;
mod polygon_mesh;
mod text_list;
mod triangulate;

#[cfg(feature = "files")]
mod clean;
#[cfg(feature = "files")]
mod content;
#[cfg(feature = "files")]
mod derived;
#[cfg(feature = "files")]
mod error;
#[cfg(feature = "files")]
mod files;
#[cfg(feature = "files")]
mod format;
#[cfg(feature = "files")]
mod gzip;
#[cfg(feature = "files")]
mod line_ends;
#[cfg(feature = "files")]
mod obj;
#[cfg(feature = "files")]
mod off;
#[cfg(feature = "files")]
mod output;
#[cfg(feature = "files")]
mod ply;
#[cfg(feature = "files")]
mod stl;
#[cfg(feature = "files")]
mod text;
#[cfg(feature = "files")]
mod tokens;
#[cfg(feature = "files")]
mod weld;

pub use attributes::{Attributes, AttributesError};
pub use corner_indices::CornerIndices;
pub use face_sections::{FaceSection, FaceSections};
pub use faces::{Faces, FacesIter, MAX_CORNERS};
pub use polygon_mesh::Mesh;
pub use text_list::{TextList, TextListIter};
pub use triangulate::CutError;

#[cfg(feature = "files")]
pub use clean::Cleaned;
#[cfg(feature = "files")]
pub use error::{MeshError, Place, io_remedy};
#[cfg(feature = "files")]
pub use files::{Reader, refuse_endless};
#[cfg(feature = "files")]
pub use format::Format;
#[cfg(feature = "files")]
pub use output::Output;
#[cfg(feature = "files")]
pub use weld::Welded;
