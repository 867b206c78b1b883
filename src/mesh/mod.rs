//! Mesh files: OBJ, PLY, OFF and STL in, OBJ, PLY and OFF out, each also gzipped (feature `files`).
//!
//! Readers keep the order of vertices and faces, unreferenced vertices and every f64 value; writers
//! print values that read back to the same f64. Nothing about the mesh is judged here.

mod face_list;

#[cfg(feature = "files")]
mod error;
#[cfg(feature = "files")]
mod files;
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
mod tokens;

pub use face_list::{Attributes, FaceList, Faces, Lines, MAX_CORNERS, NO_INDEX, Section};

#[cfg(feature = "files")]
pub use error::{MeshError, Place};
#[cfg(feature = "files")]
pub use files::{Format, parse, read, read_from};
#[cfg(feature = "files")]
pub use output::{Output, write_as};
