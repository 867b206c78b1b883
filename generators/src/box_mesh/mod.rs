//! The brick-shaped surfaces on which the papers stress their algorithms: a flat box with a square
//! array of shafts, each a cavity or a hole (Ramaswami and Siqueira, *irreducible triangulations*,
//! section 5, Figure 14 and Tables 3 to 5; Lemos, Ramaswami and Siqueira, section 4, Table 4.2).
//!
//! The papers print the numbers of vertices and of shafts. [`PaperBox`] is the box that these
//! determine. [`BoxShape`] has any number of vertices, and proportions of ours: a shaft is 1 wide
//! and 1/2 away from the next one and from the sides, a cavity is 3/4 deep, the box is 1 high:
//!
//! ```text
//!   +-----+       +-----+             +-----+
//!   |     |       |     |             |     |
//!   |     |cavity |     |    hole     |     |
//!   |     +-------+     |             |     |
//!   +-------------------+             +-----+
//! ```
//!
//! Every face is a grid of nearly square cells, each cut in two; neighbouring faces share the
//! vertices of their common edge. Those on the walls of cavities are half again as high as wide.
//! Diagonals turn every two cells along a shaft, in such a way that nearly all degrees are 6, on
//! the rims of shafts too. Other degrees occur in the corners, eight a shaft and eight of the box,
//! along two sides of each floor, of its counterpart on the bottom and of the place of a missing
//! shaft, along the edges of the box, and around the centres described at [`BoxShape::surface`].

pub(crate) mod array;
mod build;
mod cell_surface;
mod diagonals;
pub(crate) mod lattice;
mod paper_box;
mod shape;

#[cfg(test)]
mod tests;

use crate::surface::Surface;
use lattice::Lattice;

pub use paper_box::{ImpossiblePaperBoxError, PaperBox, Walls};
pub use shape::{BoxShape, ImpossibleBoxError};

impl BoxShape {
    /// The fewest vertices of a box with these cavities and holes: 8 without any, otherwise
    /// `8(m + 1)² + 4 · cavities` with an `m` × `m` array, whichever of its places stay empty.
    /// O(1).
    pub fn minimum_vertices(cavities: u32, holes: u32) -> u64 {
        Lattice::coarsest(cavities, holes).vertices()
    }

    /// The box: connected, closed, simple, of genus [`BoxShape::holes`], with exactly
    /// [`BoxShape::vertices`] vertices; axis-parallel faces, outward, without self-intersections.
    ///
    /// The grid is refined where its cells are longest, those of cavities counting 2/3, as long as
    /// the vertices suffice. What is left over goes first into whole grid lines between the shafts,
    /// then into whole rings of single shafts, which both leave nearly all degrees at 6. The last
    /// few, fewer than a ring or, in a box without shafts, than a line, become centres of single
    /// cells spread over the surface: a vertex of degree 4 and two of degree 7 each.
    ///
    /// Holes are spread over the array, and so are the empty places. Numbers of vertices and
    /// triangles run along the rows of the faces, each shaft after the row of the array it is in.
    ///
    /// Coordinates are from 0 up, the first shafts at (1/2, 1/2) in x and y, the top at z = 1; the
    /// box is `(3m + 1) / 2` wide in x and y, or 2 if there are no shafts.
    ///
    /// O(vertices) time; in addition to the surface, 4 bytes for each vertex of a plate.
    ///
    /// # Errors
    /// If the vertices do not suffice, or are too many to number the half-edges.
    ///
    /// ```
    /// use triquad_generators::box_mesh::{BoxShape, ImpossibleBoxError};
    ///
    /// let torus = BoxShape { cavities: 0, holes: 1, vertices: 1000 };
    /// assert_eq!(torus.surface()?.triangles.len(), 2000);
    ///
    /// let too_small = BoxShape { vertices: 31, ..torus };
    /// let why = ImpossibleBoxError::TooFewVertices { vertices: 31, minimum: 32 };
    /// assert_eq!(too_small.surface(), Err(why));
    /// # Ok::<(), ImpossibleBoxError>(())
    /// ```
    pub fn surface(&self) -> Result<Surface, ImpossibleBoxError> {
        let minimum = Self::minimum_vertices(self.cavities, self.holes);
        // E = 3 (V - 2 + 2g) by Euler's formula.
        let half_edges = 6 * (minimum.max(self.vertices.into()) - 2 + 2 * u64::from(self.holes));
        if half_edges > 1 << 31 {
            return Err(ImpossibleBoxError::TooManyHalfEdges { half_edges });
        }
        if u64::from(self.vertices) < minimum {
            return Err(ImpossibleBoxError::TooFewVertices { vertices: self.vertices, minimum });
        }
        Ok(build::surface(self))
    }
}
