//! Meshes, and the files that hold them (feature `files`).
//!
//! OBJ, PLY, OFF and STL are read, OBJ, PLY and OFF are written, each also gzipped. Readers keep
//! the order of vertices and faces, unreferenced vertices and every f64 value. Writers print values
//! that read back to the same f64. Nothing about the mesh is judged here.
//! Uses [`atomic_file`](crate::atomic_file) and threads, nothing else of the library.

mod attributes;
mod corner_indices;
mod faces;
mod polygon_cut;
mod polygon_mesh;
mod text_list;
mod triangulate;

#[cfg(feature = "files")]
mod content;
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

pub use attributes::{Attributes, AttributesError, FaceSection};
pub use corner_indices::CornerIndices;
pub use faces::{Faces, FacesIter, MAX_CORNERS};
pub use polygon_mesh::Mesh;
pub use text_list::{TextList, TextListIter};
pub use triangulate::CutError;

#[cfg(feature = "files")]
pub use error::{MeshError, Place, io_remedy};
#[cfg(feature = "files")]
pub use files::Reader;
#[cfg(feature = "files")]
pub use format::Format;
#[cfg(feature = "files")]
pub use output::Output;
#[cfg(feature = "files")]
pub use weld::Welded;
