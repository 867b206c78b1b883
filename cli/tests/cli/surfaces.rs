//! What several test files need: surfaces as face lists, and randomness for the generators.

use triquad::Mesh;
use triquad::random::Random;
use triquad_generators::Surface;
use triquad_generators::random::{Mix, random_surface};

/// The face list of a generated surface.
pub fn face_list(surface: &Surface) -> Mesh {
    Mesh::from_triangles(surface.positions.clone(), surface.triangles.clone())
}

/// One surface that holds both, as two components.
pub fn beside(one: &Surface, other: &Surface) -> Surface {
    let mut both = one.clone();
    let first = both.positions.len() as u32;
    both.positions.extend(other.positions.iter().map(|p| [p[0] + 10.0, p[1], p[2]]));
    both.triangles.extend(other.triangles.iter().map(|t| t.map(|v| v + first)));
    both
}

/// A random surface of `genus`; the same for the same arguments.
pub fn random_of(genus: usize, operations: usize, mix: Mix, seed: u64) -> Surface {
    let mut random = Random::stream(seed, &["surface"]);
    random_surface(genus, operations, mix, &mut |bound| random.below(bound))
}
