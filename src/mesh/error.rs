//! Errors of reading and writing files, with their place.

use std::fmt;
use std::path::{Path, PathBuf};

/// A place in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
#[non_exhaustive]
pub enum Place {
    /// A line of a text file, counted from 1.
    Line(usize),
    /// A byte of a binary file, counted from 0.
    Byte(usize),
    /// The end of the file.
    End,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(line) => write!(f, "line {line}"),
            Self::Byte(byte) => write!(f, "byte {byte}"),
            Self::End => write!(f, "end of file"),
        }
    }
}

/// A reason why a mesh file could not be read or written.
///
/// `Debug` writes the message and the remedy: an error that `main` returns is printed by `Debug`.
#[derive(thiserror::Error)]
#[non_exhaustive]
pub enum MeshError {
    /// The operating system reported an error.
    #[error(transparent)]
    Io(#[from] std::io::Error),
    /// Something is wrong with the file of this name.
    #[error("{}: {error}", .path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What is wrong with it; never of this kind itself.
        error: Box<MeshError>,
    },
    /// The name has no extension of a known format.
    #[error("unknown mesh format '{0}'")]
    UnknownFormat(String),
    /// The name has no extension of a format that is written.
    #[error("unknown mesh format '{0}'")]
    UnknownOutput(String),
    /// The format is known but is not written.
    #[error("{0} files are read, not written")]
    ReadOnly(&'static str),
    /// The text or bytes are not as the format demands.
    #[error("{place}: {problem}")]
    Malformed {
        /// The place of the first defect.
        place: Place,
        /// The defect: what was found, and what was expected.
        problem: String,
    },
    /// The file ends before everything that it announces.
    #[error("the file ends before {missing}")]
    Truncated {
        /// The end of the file.
        place: Place,
        /// The first thing that is missing.
        missing: String,
        /// The record that is missing or incomplete, by its number from 1: `vertex 2`.
        element: Option<String>,
    },
    /// The first bytes are those of another kind of file.
    #[error("the file is {content}, by its first bytes")]
    Foreign {
        /// The content, article included.
        content: &'static str,
        /// The remedy for such content.
        remedy: &'static str,
    },
    /// A gzip file holds more than it may.
    #[error("the gzip file expands to more than {0} bytes, the limit for a file of its size")]
    Expanded(u64),
    /// More corners than 32-bit half-edge indices can name.
    #[error("more than 2^31 half-edges")]
    TooLarge,
}

impl MeshError {
    /// Returns the remedy, as an instruction to the user.
    pub fn remedy(&self) -> &'static str {
        match self {
            Self::Io(error) => io_remedy(error),
            Self::File { error, .. } => error.remedy(),
            Self::UnknownFormat(_) => "use .obj, .ply, .off or .stl, each also with .gz",
            Self::UnknownOutput(_) | Self::ReadOnly(_) => {
                "write .obj, .ply or .off, each also with .gz"
            }
            Self::Malformed { .. } => "correct the file there or export it again",
            Self::Truncated { .. } => "it was cut off: copy or export it again",
            Self::Foreign { remedy, .. } => remedy,
            Self::Expanded(_) => {
                "if it is to be that large, raise the limit (Reader::max_expanded)"
            }
            Self::TooLarge => "split the mesh into components and convert them one by one",
        }
    }

    /// Returns the element at which reading ended, as the message names it: the line or byte of a
    /// defect, the vertex or face before which the file ends.
    ///
    /// ```
    /// use triquad::mesh::{Format, Mesh};
    ///
    /// let error = Mesh::parse(b"OFF\n3 1 0\n0 0 0\n", Format::Off).unwrap_err();
    /// assert_eq!(error.element().as_deref(), Some("vertex 2"));
    /// ```
    pub fn element(&self) -> Option<String> {
        match self {
            Self::File { error, .. } => error.element(),
            Self::Malformed { place: Place::End, .. } => None,
            Self::Malformed { place, .. } => Some(place.to_string()),
            Self::Truncated { element, .. } => element.clone(),
            _ => None,
        }
    }

    /// Returns what is wrong, without the name of the file.
    ///
    /// ```
    /// let error = triquad::Mesh::read("absent.obj").unwrap_err();
    /// assert!(error.to_string().starts_with("absent.obj: "));
    /// assert!(!error.without_path().to_string().contains("absent.obj"));
    /// ```
    #[must_use]
    pub fn without_path(self) -> Self {
        match self {
            Self::File { error, .. } => *error,
            error => error,
        }
    }

    /// Adds the name of the file.
    pub(crate) fn at(self, path: &Path) -> Self {
        Self::File { path: path.to_owned(), error: Box::new(self) }
    }

    /// Makes the error that something is wrong at `place`.
    pub(crate) fn malformed(place: Place, problem: impl Into<String>) -> Self {
        Self::Malformed { place, problem: problem.into() }
    }
}

impl fmt::Debug for MeshError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self}; {}", self.remedy())
    }
}

/// Returns the remedy for an error of the operating system, as an instruction to the user.
pub fn io_remedy(error: &std::io::Error) -> &'static str {
    use std::io::ErrorKind;
    if error.get_ref().is_some_and(|inner| inner.is::<crate::atomic_file::NoFolderError>()) {
        return "make the folder first, or name another";
    }
    match error.kind() {
        ErrorKind::ReadOnlyFilesystem => "name a file on a disk that can be written to",
        ErrorKind::StorageFull => "free some space there, or write to another disk",
        ErrorKind::QuotaExceeded => "free some of your quota there, or write to another disk",
        ErrorKind::FileTooLarge => "raise the limit for the size of files (ulimit -f)",
        ErrorKind::OutOfMemory => "raise the limit for memory, or use a machine with more",
        _ => "check the path and its permissions",
    }
}
