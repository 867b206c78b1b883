//! The choice of the diagonal of each cell.
//!
//! Always the one from the first corner would do, but for one algorithm: what Pulli and Segal's
//! pairs up spreads in a front, and a front that closes round a cavity before it has filled it
//! leaves an island behind, whose number of triangles may be odd. With equal diagonals and square
//! cells, 1.1 triangles a cavity are left alone in A1 of the papers, which lost 0.035. With
//! diagonals that turn every two cells, and fewer but higher cells on the walls of cavities, it is
//! 0.03 (with either alone 0.5 and 0.3).
//!
//! A strip of cells keeps its diagonal where it runs over an edge of the box, so that the vertices
//! there have degree 6 like those inside:
//!
//! ```text
//!   +---+---+---+---+
//!   | / | / | \ | \ |     plate
//!   +---+---+---+---+     rim
//!   | / | / | \ | \ |     wall
//!   +---+---+---+---+
//! ```
//!
//! That settles the gaps between two shafts and the walls. Where gaps cross, nothing turns; on
//! floors and where there is no shaft, the strips along y go on, so that vertices of degree 5 and 7
//! lie on two of the sides.

/// Returns whether the cells at place `along` of a row along a shaft have the other diagonal.
pub(super) fn is_turned(along: usize) -> bool {
    along / 2 % 2 == 1
}

/// The same for the cells below each other that come `step`th around a wall which is `side` cells
/// long on each side: from the least x and y along y, along x, and back.
pub(super) fn is_turned_around(side: usize, step: usize) -> bool {
    let (corner, step) = (step / side, step % side);
    let along = if corner < 2 { step } else { side - 1 - step };
    // Along y the wall is seen with the plate's diagonal from the other side.
    is_turned(along) != corner.is_multiple_of(2)
}
