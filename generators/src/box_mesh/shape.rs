//! Sizes of a box, and reasons why there may be none.

use std::fmt;

/// Sizes of a box. All its shafts together form an `m` × `m` array, `m` the least number whose
/// square suffices; with 3,844 shafts that is the array of the papers, 62 × 62.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BoxShape {
    /// Shafts that end inside the box.
    pub cavities: u32,
    /// Shafts that go through: the genus.
    pub holes: u32,
    /// Vertices of the surface, exactly.
    pub vertices: u32,
}

/// Reason why there is no such box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ImpossibleBoxError {
    /// Fewer vertices than the corners of the faces and of the grid through them.
    TooFewVertices {
        /// The requested number.
        vertices: u32,
        /// The least number possible with these cavities and holes, as
        /// [`BoxShape::minimum_vertices`].
        minimum: u64,
    },
    /// A surface like this, or the smallest with these cavities and holes, has more than 2³¹
    /// half-edges.
    TooManyHalfEdges {
        /// Number it would have.
        half_edges: u64,
    },
}

impl fmt::Display for ImpossibleBoxError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFewVertices { vertices, minimum } => {
                write!(f, "a box with these cavities and holes has at least {minimum} vertices, ")?;
                write!(f, "not {vertices}")
            }
            Self::TooManyHalfEdges { half_edges } => {
                write!(f, "the box would have {half_edges} half-edges, more than 2^31")
            }
        }
    }
}

impl std::error::Error for ImpossibleBoxError {}
