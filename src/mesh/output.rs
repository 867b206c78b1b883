//! Writing mesh files, whole or not at all.

use std::io::{self, BufWriter, Write};
use std::path::Path;

use flate2::{Compression, GzBuilder};

use super::files::is_gzip;
use super::{FaceList, Format, MeshError, obj, off, ply};
use crate::atomic_file::AtomicFile;

/// A mesh file to be written; made before the work starts, so that the work is not in vain.
#[derive(Debug)]
pub struct Output {
    format: Format,
    gzip: bool,
    /// None is standard output.
    file: Option<AtomicFile>,
}

impl Output {
    /// Prepares to write a mesh to `path` in the format of its extension; `-` is standard output (OBJ).
    ///
    /// # Errors
    /// The format is unknown or is not written, or no file can be made in the folder.
    pub fn create(path: &Path) -> Result<Self, MeshError> {
        let format = Format::of(path)?;
        if format == Format::Stl {
            return Err(MeshError::ReadOnly("STL"));
        }
        let file = if path.as_os_str() == "-" { None } else { Some(AtomicFile::create(path)?) };
        Ok(Self { format, gzip: is_gzip(path), file })
    }

    /// Writes `mesh`; the file appears under its name when it is complete.
    ///
    /// # Errors
    /// Those of the file system; nothing is left behind then.
    pub fn write(self, mesh: &FaceList) -> Result<(), MeshError> {
        let Some(mut file) = self.file else {
            let mut out = BufWriter::new(io::stdout().lock());
            let written = write_as(self.format, &mut out, mesh).and_then(|()| Ok(out.flush()?));
            return match written {
                // The reader has seen enough.
                Err(MeshError::Io(error)) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
                written => written,
            };
        };
        if self.gzip {
            // The header carries no time: equal meshes make equal files.
            let mut encoder = GzBuilder::new().write(&mut file, Compression::fast());
            write_as(self.format, &mut encoder, mesh)?;
            encoder.finish()?;
        } else {
            write_as(self.format, &mut file, mesh)?;
        }
        Ok(file.commit()?)
    }
}

/// Writes `mesh` in `format` to `out`, which should be buffered.
///
/// # Errors
/// Those of `out`, and [`MeshError::ReadOnly`] for STL.
pub fn write_as(format: Format, out: &mut dyn Write, mesh: &FaceList) -> Result<(), MeshError> {
    match format {
        Format::Obj => obj::write(out, mesh)?,
        Format::Ply => ply::write(out, &mesh.positions, &mesh.faces)?,
        Format::Off => off::write(out, &mesh.positions, &mesh.faces)?,
        Format::Stl => return Err(MeshError::ReadOnly("STL")),
    }
    Ok(())
}
