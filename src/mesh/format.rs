//! Which format a file has, by its name.

use std::fmt;
use std::path::Path;
use std::str::FromStr;

use super::error::MeshError;

/// A mesh file format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
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
    /// Returns the format by the extension of `path`, before `.gz` if it has that; `-` means OBJ.
    ///
    /// # Errors
    /// [`MeshError::UnknownFormat`] names the extension.
    pub fn from_path(path: impl AsRef<Path>) -> Result<Self, MeshError> {
        let path = path.as_ref();
        if path.as_os_str() == "-" {
            return Ok(Self::Obj);
        }
        let name = if is_gzip(path) { path.file_stem().map(Path::new) } else { Some(path) };
        let extension = name.and_then(Path::extension).unwrap_or_default().to_string_lossy();
        let unknown = |_| MeshError::UnknownFormat(path.display().to_string());
        extension.parse().map_err(unknown)
    }
}

/// Returns whether the extension of `path` is `.gz`.
pub(super) fn is_gzip(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("gz"))
}

impl FromStr for Format {
    type Err = MeshError;

    /// Returns the format with this extension, in letters of either case.
    fn from_str(extension: &str) -> Result<Self, MeshError> {
        match extension.to_ascii_lowercase().as_str() {
            "obj" => Ok(Self::Obj),
            "ply" => Ok(Self::Ply),
            "off" => Ok(Self::Off),
            "stl" => Ok(Self::Stl),
            _ => Err(MeshError::UnknownFormat(extension.to_owned())),
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Obj => "obj",
            Self::Ply => "ply",
            Self::Off => "off",
            Self::Stl => "stl",
        })
    }
}
