//! The formats of files, by their names.

use std::fmt;
use std::path::Path;
use std::str::FromStr;

use super::error::MeshError;
use crate::names::serde_as_string;

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
    /// Returns the format by the extension of `path`, without a last `.gz`; `-` means OBJ.
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
    /// Writes the extension.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Obj => "obj",
            Self::Ply => "ply",
            Self::Off => "off",
            Self::Stl => "stl",
        })
    }
}

serde_as_string!(Format);

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [Format; 4] = [Format::Obj, Format::Ply, Format::Off, Format::Stl];

    #[test]
    fn formats_are_read_back_as_they_are_written() {
        for format in ALL {
            let path = format!("folder.gz/mesh.{}.GZ", format.to_string().to_uppercase());
            assert_eq!(Format::from_path(path).unwrap(), format);
            assert_eq!(Format::from_path(format!("mesh.{format}")).unwrap(), format);
        }
        for path in ["obj", "mesh.", "mesh.gz", ".obj", "mesh.obj.gz.gz"] {
            assert!(Format::from_path(path).is_err(), "{path}");
        }
    }

    #[cfg(feature = "serde")]
    #[test]
    fn formats_are_their_extensions_in_json() {
        for format in ALL {
            let json = serde_json::to_string(&format).unwrap();
            assert_eq!(json, format!("\"{format}\""));
            assert_eq!(serde_json::from_str::<Format>(&json).unwrap(), format);
        }
    }
}
