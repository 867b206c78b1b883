//! Small surfaces for tests that look at every step.

use triquad_generators::Surface;
use triquad_generators::testing::many_surfaces;

use crate::mesh::Mesh;
use crate::triangulation::Triangulation;

pub(crate) use triquad_generators::testing::sculpted_surface as sculpted;

/// Surfaces of several genera in every mix, `each` of a kind.
pub(crate) fn surfaces(each: u64, operations: u64) -> impl Iterator<Item = Surface> {
    many_surfaces(each, operations).map(|(_, surface)| surface)
}

/// The triangulation that a surface is.
pub(crate) fn triangulation(surface: &Surface) -> Triangulation {
    let list = Mesh::from_triangles(surface.positions.clone(), surface.triangles.clone());
    Triangulation::build(&list).expect("generated surfaces are triangulations")
}
