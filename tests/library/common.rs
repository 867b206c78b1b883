//! What several test files need: surfaces as face lists, and randomness for the generators.

use proptest::prelude::*;
use triquad::Mesh;
use triquad::random::Random;
use triquad_generators::random::{Mix, random_surface};
use triquad_generators::sculptor::{Operation, Sculptor};
use triquad_generators::{Surface, classic, grids};

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

/// Many small random surfaces of genus 0, 1, 2 and 5 with their genus.
pub fn many_surfaces(each: u64) -> impl Iterator<Item = (usize, Surface)> {
    let kinds = [0, 1, 2, 5].into_iter().flat_map(|genus| Mix::ALL.map(|mix| (genus, mix)));
    kinds.flat_map(move |(genus, mix)| {
        (0..each).map(move |seed| (genus, random_of(genus, (seed * seed % 61) as usize, mix, seed)))
    })
}

/// Surfaces that are special in some way, with their names.
pub fn special_surfaces() -> Vec<(&'static str, Surface)> {
    vec![
        ("tetrahedron", classic::tetrahedron()),
        ("octahedron", classic::octahedron()),
        ("seven-vertex torus", classic::seven_vertex_torus()),
        ("regular sphere", grids::sphere(9)),
        ("regular torus", grids::torus(12, 17)),
        ("long thin tube", grids::torus(600, 3)),
        ("hub", hub(400)),
        ("two components", beside(&grids::sphere(3), &grids::torus(5, 4))),
        ("tetrahedra", beside(&classic::tetrahedron(), &classic::tetrahedron())),
    ]
}

/// A bipyramid: two vertices of degree `n` each.
pub fn hub(n: u32) -> Surface {
    let around = |i: u32| [f64::from(i), f64::from(i) * f64::from(i), 0.0];
    let positions = (0..n).map(around).chain([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]]).collect();
    let pair = |i: u32| [[i, (i + 1) % n, n], [(i + 1) % n, i, n + 1]];
    Surface { positions, triangles: (0..n).flat_map(pair).collect() }
}

/// Surfaces made by a list of operations on a small one, so that failing cases shrink.
pub fn sculpted_surface() -> impl Strategy<Value = Surface> {
    let operation = prop_oneof![
        any::<u32>().prop_map(Operation::SplitFace),
        any::<u32>().prop_map(Operation::SplitEdge),
        any::<u32>().prop_map(Operation::Flip),
    ];
    (0..3usize, prop::collection::vec(operation, 0..40)).prop_map(|(genus, operations)| {
        let mut sculptor = Sculptor::from(&match genus {
            0 => classic::tetrahedron(),
            _ => classic::seven_vertex_torus(),
        });
        (1..genus).for_each(|_| sculptor.join(&classic::seven_vertex_torus(), 0));
        operations.into_iter().for_each(|operation| sculptor.apply(operation));
        sculptor.into_surface()
    })
}
