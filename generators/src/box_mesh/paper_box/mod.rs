//! The box of the papers' tables, as far as their printed counts determine it.
//!
//! The papers print numbers of vertices, edges and triangles, and no proportions. A lattice box
//! with a square array of shafts, each one cell wide, has all these counts if it is
//! 125 × 127 × 130 cells large, its 62 × 62 shafts are 128 cells deep, and horizontal cells are cut
//! in four by a centre, walls in two. Module `derivation` searches for it.
//!
//! ```text
//!   +-+   +-+   +-+
//!   | |   | |   | |    62 shafts a row, one cell wide, one cell apart
//!   | |   | |   | |
//!   | +---+ |   | |    cavities, and a hole;
//!   +-------+---+ +    two cells from the floor of a cavity to the bottom
//! ```
//!
//! A cavity that becomes a hole adds 2 vertices and 8 triangles: its tube grows by 4 vertices, and
//! the centres of its floor and of one cell of the bottom go.

mod build;
#[cfg(test)]
mod derivation;
mod shape;
#[cfg(test)]
mod tests;

pub use shape::{ImpossiblePaperBoxError, PaperBox, Walls};
