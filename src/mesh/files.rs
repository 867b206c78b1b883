//! Reading a mesh file, whatever its format, plain or gzipped.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use super::content;
use super::error::MeshError;
use super::format::Format;
use super::gzip::{Expanded, GZIP};
use super::polygon_mesh::Mesh;
use super::text::{from_utf16, utf16_order};
use super::{obj, off, ply, stl};

/// Reads mesh files, with limits of the user.
///
/// ```no_run
/// use triquad::mesh::Reader;
///
/// let mesh = Reader::new().max_expanded(1 << 36).read("huge.ply.gz")?;
/// # Ok::<(), triquad::MeshError>(())
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct Reader {
    max_expanded: Option<u64>,
}

impl Reader {
    /// Makes a reader with the usual limits.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets how many bytes a gzip file may expand to, in place of 256 MiB and 100 times its size.
    #[must_use]
    pub fn max_expanded(self, bytes: u64) -> Self {
        Self { max_expanded: Some(bytes) }
    }

    /// Reads a mesh file; `-` is standard input, in the format that its first bytes show.
    ///
    /// Gzip, UTF-16 and byte-order marks are recognised by the first bytes.
    ///
    /// # Errors
    /// [`MeshError::File`] with the first defect and its place, or an error of the file system.
    pub fn read(&self, path: impl AsRef<Path>) -> Result<Mesh, MeshError> {
        let path = path.as_ref();
        if path.as_os_str() == "-" {
            return self.read_any(&mut io::stdin().lock(), None);
        }
        self.read_file(path).map_err(|error| error.at(path))
    }

    fn read_file(&self, path: &Path) -> Result<Mesh, MeshError> {
        let format = Format::from_path(path)?;
        refuse_endless(path)?;
        self.read_any(&mut File::open(path)?, Some(format))
    }

    /// Reads a mesh from `input`, plain or gzipped; without `format` its first bytes show it.
    ///
    /// # Errors
    /// The first defect with its place, or an error of `input`.
    pub fn read_from(
        &self,
        mut input: impl Read,
        format: Option<Format>,
    ) -> Result<Mesh, MeshError> {
        self.read_any(&mut input, format)
    }

    fn read_any(&self, input: &mut dyn Read, format: Option<Format>) -> Result<Mesh, MeshError> {
        let start = take(input, GZIP.len())?;
        let mut whole = start.as_slice().chain(input);
        if start == GZIP {
            let mut content = Expanded::new(whole, self.max_expanded);
            parse(&mut content, format).map_err(|error| content.explain(error))
        } else {
            parse(&mut whole, format)
        }
    }
}

impl Mesh {
    /// Reads a mesh file as [`Reader::read`] does, with the usual limits.
    ///
    /// # Errors
    /// The first defect with its place in the file, or an error of the file system.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, MeshError> {
        Reader::new().read(path)
    }

    /// Reads a mesh from `input`, plain or gzipped.
    ///
    /// # Errors
    /// The first defect with its place, or an error of `input`.
    pub fn read_from(input: impl Read, format: Format) -> Result<Self, MeshError> {
        Reader::new().read_from(input, Some(format))
    }

    /// Reads a mesh from the content of a file, plain or gzipped.
    ///
    /// # Errors
    /// The first defect with its place.
    pub fn parse(bytes: &[u8], format: Format) -> Result<Self, MeshError> {
        Self::read_from(bytes, format)
    }
}

/// Refuses a folder, and a device: some never end.
///
/// ```
/// assert!(triquad::mesh::refuse_endless(".".as_ref()).is_err());
/// ```
///
/// # Errors
/// Says which of them it is.
pub fn refuse_endless(path: &Path) -> io::Result<()> {
    let Ok(facts) = path.metadata() else { return Ok(()) };
    if facts.is_dir() {
        return Err(io::Error::new(io::ErrorKind::IsADirectory, "is a folder"));
    }
    #[cfg(unix)]
    {
        use std::os::unix::fs::FileTypeExt;
        let kind = facts.file_type();
        if kind.is_char_device() || kind.is_block_device() {
            return Err(io::Error::other("is a device, not a file"));
        }
    }
    Ok(())
}

/// Reads the content of a file that is not gzipped.
fn parse(input: &mut dyn Read, format: Option<Format>) -> Result<Mesh, MeshError> {
    let start = take(input, content::START)?;
    let mut whole = start.as_slice().chain(input);
    // The header of a binary STL file may hold anything.
    let is_stl_text = |order| content::is_text_stl(&from_utf16(&start, order));
    let is_text = |order: &_| format != Some(Format::Stl) || is_stl_text(*order);
    if let Some(order) = utf16_order(&start).filter(is_text) {
        let mut bytes = Vec::new();
        whole.read_to_end(&mut bytes)?;
        let text = from_utf16(&bytes, order);
        let start = &text[..text.len().min(content::START)];
        return parse_utf8(start, &mut &text[..], format);
    }
    parse_utf8(&start, &mut whole, format)
}

/// Reads content that is no UTF-16 text; `start` has its first bytes.
fn parse_utf8(
    start: &[u8],
    input: &mut dyn Read,
    format: Option<Format>,
) -> Result<Mesh, MeshError> {
    let format = format.unwrap_or_else(|| content::guess_format(start));
    // What begins like another file may still be an STL file, as their header is free.
    let foreign = content::foreign_to(format, start);
    if format == Format::Stl {
        let result = stl::read(&read_all(input)?);
        return result.map_err(|error| foreign.unwrap_or(error));
    }
    match (foreign, format) {
        (Some(foreign), _) => Err(foreign),
        (None, Format::Ply) => ply::read(&read_all(input)?),
        (None, Format::Off) => off::read(&read_all(input)?),
        (None, _) => match obj::read(input) {
            Ok(mesh) if !mesh.faces.is_empty() => Ok(mesh),
            result => content::binary(start).map_or(result, Err),
        },
    }
}

fn read_all(input: &mut dyn Read) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    input.read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Takes the first `count` bytes, or all if there are fewer.
fn take(input: &mut dyn Read, count: usize) -> io::Result<Vec<u8>> {
    let mut start = Vec::new();
    input.take(count as u64).read_to_end(&mut start)?;
    Ok(start)
}
