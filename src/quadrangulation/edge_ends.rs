//! Corners that two triangles have at the ends of their common edge.

use crate::triangulation::{HalfEdgeId, Surface};

/// Returns the corners of both triangles at each end of the edge of `side` and `twin`.
pub(super) fn corners_at_ends(
    surface: &impl Surface,
    [side, twin]: [HalfEdgeId; 2],
) -> [[HalfEdgeId; 2]; 2] {
    let mut theirs = [twin.next(), twin];
    if surface.origin(side) == surface.origin(twin) {
        theirs.reverse(); // The sides of a one-sided surface may lead the same way.
    }
    [[side, theirs[0]], [side.next(), theirs[1]]]
}
