//! Mesh files: OBJ, PLY, OFF and STL in, OBJ, PLY and OFF out, each also gzipped.
//!
//! Readers keep the order of vertices and faces, unreferenced vertices and every f64 value; writers
//! print values that read back to the same f64. Nothing about the mesh is judged here.

mod error;
mod face_list;
mod obj;
mod off;
mod output;
mod ply;
mod stl;
mod tokens;

use std::io::Read;
use std::path::Path;

use flate2::read::MultiGzDecoder;

pub use error::{MeshError, Place};
pub use face_list::{Attributes, FaceList, Faces, Lines, NO_INDEX, Section};
pub use output::{Output, write_as};

/// A mesh file format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Wavefront OBJ.
    Obj,
    /// Stanford PLY.
    Ply,
    /// Object File Format.
    Off,
    /// Stereolithography; read only, welded on equal coordinates.
    Stl,
}

impl Format {
    /// The format by the extension of `path`, before `.gz` if it has that; `-` means OBJ.
    ///
    /// # Errors
    /// [`MeshError::UnknownFormat`] names the extension.
    pub fn of(path: &Path) -> Result<Self, MeshError> {
        if path.as_os_str() == "-" {
            return Ok(Self::Obj);
        }
        let name = if is_gzip(path) { path.file_stem().map(Path::new) } else { Some(path) };
        let extension = name.and_then(Path::extension).unwrap_or_default().to_string_lossy();
        match extension.to_ascii_lowercase().as_str() {
            "obj" => Ok(Self::Obj),
            "ply" => Ok(Self::Ply),
            "off" => Ok(Self::Off),
            "stl" => Ok(Self::Stl),
            _ => Err(MeshError::UnknownFormat(path.display().to_string())),
        }
    }
}

fn is_gzip(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("gz"))
}

/// Reads a mesh file; `-` is standard input (OBJ). Gzipped content is recognised by its first bytes.
///
/// # Errors
/// What is wrong, and where in the file.
pub fn read(path: &Path) -> Result<FaceList, MeshError> {
    let format = Format::of(path)?;
    let bytes = if path.as_os_str() == "-" {
        let mut bytes = Vec::new();
        std::io::stdin().lock().read_to_end(&mut bytes)?;
        bytes
    } else {
        std::fs::read(path)?
    };
    parse(&decompress(bytes)?, format)
}

fn decompress(bytes: Vec<u8>) -> Result<Vec<u8>, MeshError> {
    if !bytes.starts_with(&[0x1f, 0x8b]) {
        return Ok(bytes);
    }
    let mut text = Vec::new();
    let damaged = |error: std::io::Error| match error.kind() {
        std::io::ErrorKind::UnexpectedEof => MeshError::Truncated {
            place: Place::End,
            missing: "the rest of the gzip stream".into(),
        },
        _ => MeshError::malformed(Place::End, format!("damaged gzip stream: {error}")),
    };
    MultiGzDecoder::new(bytes.as_slice()).read_to_end(&mut text).map_err(damaged)?;
    Ok(text)
}

/// Reads a mesh from the content of a file.
///
/// # Errors
/// What is wrong, and where in `bytes`.
pub fn parse(bytes: &[u8], format: Format) -> Result<FaceList, MeshError> {
    match format {
        Format::Obj => obj::read(bytes),
        Format::Ply => ply::read(bytes),
        Format::Off => off::read(bytes),
        Format::Stl => stl::read(bytes),
    }
}
