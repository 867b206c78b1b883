//! Why a file could not be read or written.

use std::fmt;

/// Where in a file something is wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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

/// Why a mesh file could not be read or written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum MeshError {
    /// The operating system refused.
    #[error("{0}")]
    Io(#[from] std::io::Error),
    /// The name tells no known format.
    #[error("unknown mesh format '{0}'")]
    UnknownFormat(String),
    /// The format is known but is not written.
    #[error("{0} files are read, not written")]
    ReadOnly(&'static str),
    /// The text or bytes are not what the format asks for.
    #[error("{place}: {problem}")]
    Malformed {
        /// Where.
        place: Place,
        /// What was found, and what was expected.
        problem: String,
    },
    /// The file ends before everything that it announces.
    #[error("{place}: truncated file: {missing}")]
    Truncated {
        /// Where the file ends.
        place: Place,
        /// What is missing.
        missing: String,
    },
    /// More corners than 32-bit half-edge indices can name.
    #[error("more than 2^31 half-edges")]
    TooLarge,
}

impl MeshError {
    /// What the user can do about it.
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
}

impl MeshError {
    pub(crate) fn malformed(place: Place, problem: impl Into<String>) -> Self {
        Self::Malformed { place, problem: problem.into() }
    }
}
