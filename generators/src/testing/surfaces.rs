//! Small surfaces of many kinds.

use super::draws::draws;
use crate::random::{self, Mix, random_surface};
use crate::sculptor::Sculptor;
use crate::surface::Surface;
use crate::{classic, grids, worst_cases};

/// Returns a random surface of `genus`; the same for the same arguments.
pub fn random_of(genus: usize, operations: usize, mix: Mix, seed: u64) -> Surface {
    random_surface(genus, operations, mix, &mut draws(seed))
}

/// Returns small random surfaces with their genus: `each` of the genera 0, 1, 2, 3 and 5 in every
/// mix, made by fewer than `operations` edits.
pub fn many_surfaces(each: u64, operations: u64) -> impl Iterator<Item = (usize, Surface)> {
    let kinds = [0, 1, 2, 3, 5].into_iter().flat_map(|genus| Mix::ALL.map(|mix| (genus, mix)));
    kinds.flat_map(move |(genus, mix)| {
        let edits = move |seed| (seed * 7 % operations) as usize;
        (0..each).map(move |seed| (genus, random_of(genus, edits(seed), mix, seed)))
    })
}

/// Returns surfaces that are special in some way, with their names.
pub fn special_surfaces() -> Vec<(&'static str, Surface)> {
    vec![
        ("tetrahedron", classic::tetrahedron()),
        ("octahedron", classic::octahedron()),
        ("seven-vertex torus", classic::seven_vertex_torus()),
        ("regular sphere", grids::sphere(9)),
        ("regular torus", grids::torus(12, 17)),
        ("long thin tube", grids::torus(600, 3)),
        ("hub", hub(400)),
        ("prism", worst_cases::prism(4, 9)),
        ("prism with lobes", worst_cases::prism_with_lobes(4, 9)),
        ("tori round a pole", worst_cases::tori_round_a_pole(9)),
        ("slab", worst_cases::slab(9, &mut draws(2))),
        ("random torus", random::torus(8, 9, &mut draws(1))),
        ("subdivided torus", Sculptor::from(&classic::seven_vertex_torus()).subdivided()),
        ("two components", beside(&grids::sphere(3), &grids::torus(5, 4))),
        ("tetrahedra", beside(&classic::tetrahedron(), &classic::tetrahedron())),
    ]
}

/// Returns a bipyramid: two vertices of degree `n` each.
pub fn hub(n: u32) -> Surface {
    let around = |i: u32| [f64::from(i), f64::from(i) * f64::from(i), 0.0];
    let positions = (0..n).map(around).chain([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]]).collect();
    let pair = |i: u32| [[i, (i + 1) % n, n], [(i + 1) % n, i, n + 1]];
    Surface { positions, triangles: (0..n).flat_map(pair).collect() }
}

/// Returns one surface that holds both, `other` moved by 10 along x, as two components.
pub fn beside(one: &Surface, other: &Surface) -> Surface {
    let mut both = one.clone();
    let first = both.positions.len() as u32;
    both.positions.extend(other.positions.iter().map(|p| [p[0] + 10.0, p[1], p[2]]));
    both.triangles.extend(other.triangles.iter().map(|t| t.map(|v| v + first)));
    both
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::{assert_oriented, inspect};

    #[test]
    fn random_surfaces_are_what_they_say() {
        for (genus, surface) in many_surfaces(10, 40) {
            assert_oriented(&surface, genus);
        }
    }

    #[test]
    fn special_surfaces_are_closed() {
        for (name, surface) in special_surfaces() {
            let facts = inspect(&surface);
            assert!(facts.orientable && facts.boundary_edges == 0, "{name}: {facts:?}");
        }
    }
}
