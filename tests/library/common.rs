//! What several test files need: surfaces, and surfaces as face lists.

use triquad::Mesh;
use triquad::random::Random;
use triquad_generators::random::{Mix, random_surface};
use triquad_generators::{Surface, testing};

pub use triquad_generators::testing::{beside, hub, sculpted_surface, special_surfaces};

/// The face list of a generated surface.
pub fn face_list(surface: &Surface) -> Mesh {
    Mesh::from_triangles(surface.positions.clone(), surface.triangles.clone())
}

/// Small random surfaces with their genus, `each` of a kind, of fewer than 61 edits.
pub fn many_surfaces(each: u64) -> impl Iterator<Item = (usize, Surface)> {
    testing::many_surfaces(each, 61)
}

/// A random surface of `genus`, drawn from the library's own stream: counts that tests remember
/// depend on it.
pub fn random_of(genus: usize, operations: usize, mix: Mix, seed: u64) -> Surface {
    let mut random = Random::stream(seed, &["surface"]);
    random_surface(genus, operations, mix, &mut |bound| random.below(bound))
}
