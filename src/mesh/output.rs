//! Writing mesh files, whole or not at all.

use std::io::{self, BufWriter, Write};
use std::path::Path;

use flate2::{Compression, GzBuilder};

use super::error::MeshError;
use super::format::{Format, is_gzip};
use super::polygon_mesh::Mesh;
use super::{obj, off, ply};
use crate::atomic_file::AtomicFile;

/// A mesh file to be written.
///
/// To be made before the work starts, so that a wrong name is found before and not after it.
#[derive(Debug)]
pub struct Output {
    format: Format,
    gzip: bool,
    /// None is standard output.
    file: Option<AtomicFile>,
}

impl Output {
    /// Prepares to write a mesh to `path` in the format of its extension.
    ///
    /// `-` is standard output (OBJ).
    ///
    /// # Errors
    /// The format is unknown or is not written, or no file can be made in the folder.
    pub fn create(path: impl AsRef<Path>) -> Result<Self, MeshError> {
        let path = path.as_ref();
        let format = Format::from_path(path).map_err(|error| match error {
            MeshError::UnknownFormat(name) => MeshError::UnknownOutput(name),
            error => error,
        })?;
        if format == Format::Stl {
            return Err(MeshError::ReadOnly("STL"));
        }
        let file = if path.as_os_str() == "-" { None } else { Some(AtomicFile::create(path)?) };
        Ok(Self { format, gzip: is_gzip(path), file })
    }

    /// Writes `mesh`. The file appears under its name when it is complete.
    ///
    /// # Errors
    /// Those of the file system. Nothing is left behind then.
    pub fn write(self, mesh: &Mesh) -> Result<(), MeshError> {
        let Some(mut file) = self.file else {
            let mut out = BufWriter::new(io::stdout().lock());
            let written = mesh.write_to(&mut out, self.format).and_then(|()| Ok(out.flush()?));
            return match written {
                // A closed pipe is how `head` ends its input.
                Err(MeshError::Io(error)) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
                written => written,
            };
        };
        if self.gzip {
            // The header carries no time: equal meshes make equal files.
            let mut encoder = GzBuilder::new().write(&mut file, Compression::fast());
            mesh.write_to(&mut encoder, self.format)?;
            encoder.finish()?;
        } else {
            mesh.write_to(&mut file, self.format)?;
        }
        Ok(file.commit()?)
    }
}

impl Mesh {
    /// Writes the mesh to `path` in the format of its extension.
    ///
    /// `-` is standard output (OBJ). The file appears under its name when it is complete.
    ///
    /// # Errors
    /// [`MeshError::File`]: the format is unknown or is not written, or those of the file system.
    pub fn write(&self, path: impl AsRef<Path>) -> Result<(), MeshError> {
        let path = path.as_ref();
        let written = Output::create(path).and_then(|output| output.write(self));
        written.map_err(|error| error.at(path))
    }

    /// Writes the mesh in `format` to `out`, which should be buffered.
    ///
    /// # Errors
    /// Those of `out`, and [`MeshError::ReadOnly`] for STL.
    pub fn write_to(&self, mut out: impl Write, format: Format) -> Result<(), MeshError> {
        match format {
            Format::Obj => obj::write(&mut out, self)?,
            Format::Ply => ply::write(&mut out, &self.positions, &self.faces)?,
            Format::Off => off::write(&mut out, &self.positions, &self.faces)?,
            Format::Stl => return Err(MeshError::ReadOnly("STL")),
        }
        Ok(())
    }
}
