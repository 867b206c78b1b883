//! Errors of reading and writing files, with their place.

use std::fmt;

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
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum MeshError {
    /// The operating system reported an error.
    #[error(transparent)]
    Io(#[from] std::io::Error),
    /// The name has no extension of a known format.
    #[error("unknown mesh format '{0}'")]
    UnknownFormat(String),
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
    #[error("{place}: truncated file: {missing}")]
    Truncated {
        /// The end of the file.
        place: Place,
        /// The first thing that is missing.
        missing: String,
    },
    /// More corners than 32-bit half-edge indices can name.
    #[error("more than 2^31 half-edges")]
    TooLarge,
}

impl MeshError {
    /// Returns the remedy, as an instruction to the user.
    pub fn remedy(&self) -> &'static str {
        match self {
            Self::Io(_) => "check the path and its permissions",
            Self::UnknownFormat(_) => "use .obj, .ply, .off or .stl, each also with .gz",
            Self::ReadOnly(_) => "write .obj, .ply or .off, each also with .gz",
            Self::Malformed { .. } => "correct the file there or export it again",
            Self::Truncated { .. } => "copy or export the file again",
            Self::TooLarge => "split the mesh into components and convert them one by one",
        }
    }

    /// Makes the error that something is wrong at `place`.
    pub(crate) fn malformed(place: Place, problem: impl Into<String>) -> Self {
        Self::Malformed { place, problem: problem.into() }
    }
}
