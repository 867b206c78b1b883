//! Surfaces as face lists.

use triquad::Mesh;
use triquad_generators::Surface;

/// The face list of a generated surface.
pub fn face_list(surface: &Surface) -> Mesh {
    Mesh::from_triangles(surface.positions.clone(), surface.triangles.clone())
}
