//! Reading a mesh file, whatever its format, plain or gzipped.

use std::fs::File;
use std::io::{self, BufReader, Read};
use std::path::Path;

use flate2::read::MultiGzDecoder;

use super::error::{MeshError, Place};
use super::{FaceList, obj, off, ply, stl};

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

pub(super) fn is_gzip(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("gz"))
}

/// Reads a mesh file; `-` is standard input (OBJ). Gzipped content is recognised by its first bytes.
///
/// # Errors
/// What is wrong, and where in the file.
pub fn read(path: &Path) -> Result<FaceList, MeshError> {
    let format = Format::of(path)?;
    if path.as_os_str() == "-" {
        return read_from(&mut io::stdin().lock(), format);
    }
    if path.is_dir() {
        return Err(io::Error::new(io::ErrorKind::IsADirectory, "is a folder").into());
    }
    read_from(&mut File::open(path)?, format)
}

/// Reads a mesh from what `input` gives, plain or gzipped.
///
/// # Errors
/// What is wrong, and where in the text.
pub fn read_from(input: &mut dyn Read, format: Format) -> Result<FaceList, MeshError> {
    let mut start = Vec::new();
    input.take(GZIP.len() as u64).read_to_end(&mut start)?;
    let mut whole = start.as_slice().chain(input);
    if start == GZIP {
        // Room for the decoder to work on, or it would read byte by byte.
        let mut decoder = MultiGzDecoder::new(BufReader::with_capacity(1 << 16, whole));
        parse_from(&mut decoder, format).map_err(gzip_error)
    } else {
        parse_from(&mut whole, format)
    }
}

/// The bytes that every gzip file starts with.
const GZIP: [u8; 2] = [0x1f, 0x8b];

fn gzip_error(error: MeshError) -> MeshError {
    match error {
        MeshError::Io(error) if error.kind() == io::ErrorKind::UnexpectedEof => {
            MeshError::Truncated {
                place: Place::End,
                missing: "the rest of the gzip stream".into(),
            }
        }
        MeshError::Io(error) => {
            MeshError::malformed(Place::End, format!("damaged gzip stream: {error}"))
        }
        error => error,
    }
}

fn parse_from(input: &mut dyn Read, format: Format) -> Result<FaceList, MeshError> {
    if format == Format::Obj {
        return obj::read(input);
    }
    let mut bytes = Vec::new();
    input.read_to_end(&mut bytes)?;
    match format {
        Format::Ply => ply::read(&bytes),
        Format::Off => off::read(&bytes),
        _ => stl::read(&bytes),
    }
}

/// Reads a mesh from the content of a file, plain or gzipped.
///
/// # Errors
/// What is wrong, and where in `bytes`.
pub fn parse(bytes: &[u8], format: Format) -> Result<FaceList, MeshError> {
    read_from(&mut &bytes[..], format)
}
