//! Small surfaces for tests that look at every step.

use proptest::collection::vec;
use proptest::prelude::*;
use triquad_generators::Surface;
use triquad_generators::classic::{seven_vertex_torus, tetrahedron};
use triquad_generators::random::{Mix, random_surface};
use triquad_generators::sculptor::{Operation, Sculptor};

use crate::mesh::Mesh;
use crate::random::Random;
use crate::triangulation::Triangulation;

/// Connected sums of tori, `each` of every genus and mix, edited at random fewer than `operations`
/// times.
pub(crate) fn surfaces(each: u64, operations: u64) -> impl Iterator<Item = Surface> {
    let kinds = [0, 1, 2, 3, 5].into_iter().flat_map(|genus| Mix::ALL.map(|mix| (genus, mix)));
    kinds.flat_map(move |(genus, mix)| {
        (0..each).map(move |seed| {
            let mut random = Random::stream(seed, &["samples"]);
            let operations = (seed * 7 % operations) as usize;
            random_surface(genus, operations, mix, &mut |bound| random.below(bound))
        })
    })
}

/// Surfaces that shrink: one operation less at a time.
pub(crate) fn sculpted() -> impl Strategy<Value = Surface> {
    let operation = (0..3u8, any::<u32>()).prop_map(|(kind, place)| match kind {
        0 => Operation::SplitFace(place),
        1 => Operation::SplitEdge(place),
        _ => Operation::Flip(place),
    });
    (0..4usize, vec(operation, 0..30)).prop_map(|(genus, operations)| {
        let torus = seven_vertex_torus();
        let mut sculptor = Sculptor::from(&if genus == 0 { tetrahedron() } else { torus.clone() });
        (1..genus).for_each(|_| sculptor.join(&torus, 0));
        operations.into_iter().for_each(|operation| sculptor.apply(operation));
        sculptor.into_surface()
    })
}

/// The triangulation that a surface is.
pub(crate) fn triangulation(surface: &Surface) -> Triangulation {
    let list = Mesh::from_triangles(surface.positions.clone(), surface.triangles.clone());
    Triangulation::build(&list).expect("generated surfaces are triangulations")
}
