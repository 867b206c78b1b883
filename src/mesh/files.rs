//! Reading a mesh file, whatever its format, plain or gzipped.

use std::fs::File;
use std::io::{self, BufReader, Read};
use std::path::Path;

use flate2::read::MultiGzDecoder;

use super::error::{MeshError, Place};
use super::format::Format;
use super::polygon_mesh::Mesh;
use super::{obj, off, ply, stl};

impl Mesh {
    /// Reads a mesh file; `-` is standard input (OBJ). Gzip is recognised by its first bytes.
    ///
    /// # Errors
    /// The first defect with its place in the file, or an error of the file system.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, MeshError> {
        let path = path.as_ref();
        let format = Format::from_path(path)?;
        if path.as_os_str() == "-" {
            return read_any(&mut io::stdin().lock(), format);
        }
        if path.is_dir() {
            return Err(io::Error::new(io::ErrorKind::IsADirectory, "is a folder").into());
        }
        read_any(&mut File::open(path)?, format)
    }

    /// Reads a mesh from `input`, plain or gzipped.
    ///
    /// # Errors
    /// The first defect with its place, or an error of `input`.
    pub fn read_from(mut input: impl Read, format: Format) -> Result<Self, MeshError> {
        read_any(&mut input, format)
    }

    /// Reads a mesh from the content of a file, plain or gzipped.
    ///
    /// # Errors
    /// The first defect with its place.
    pub fn parse(bytes: &[u8], format: Format) -> Result<Self, MeshError> {
        read_any(&mut &bytes[..], format)
    }
}

/// The bytes that every gzip file starts with.
const GZIP: [u8; 2] = [0x1f, 0x8b];

fn read_any(input: &mut dyn Read, format: Format) -> Result<Mesh, MeshError> {
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

fn parse_from(input: &mut dyn Read, format: Format) -> Result<Mesh, MeshError> {
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
