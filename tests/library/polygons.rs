//! Polygons cut into triangles, and vertices welded: against brute force on small meshes.

use std::collections::{BTreeMap, BTreeSet};

use proptest::prelude::*;
use triquad::mesh::Faces;
use triquad::{Algorithm, Converter, Mesh, Triangulation};
use triquad_generators::random::Mix;

use crate::common::{face_list, random_of, special_surfaces};

// Cutting.

#[test]
fn quads_of_any_surface_are_cut_into_triangles_of_it() {
    let special = special_surfaces().into_iter().map(|(_, surface)| surface);
    let random = (0..60).map(|seed| {
        random_of(seed % 4, 30 + seed * 3, Mix::ALL[seed % Mix::ALL.len()], seed as u64)
    });
    for surface in special.chain(random) {
        for algorithm in [Algorithm::Best, Algorithm::PulliSegal] {
            let triangles = face_list(&surface);
            let mut quads =
                Converter::new().algorithm(algorithm).run(&triangles).unwrap().into_mesh();
            let genus = Triangulation::build(&triangles).unwrap().genus();
            quads.triangulate().unwrap();
            assert_eq!(Triangulation::build(&quads).unwrap().genus(), genus);
        }
    }
}

/// Returns whether no edge of these triangles has more than two of them that it had not before.
fn is_proper(triangles: &[[u32; 3]], edges: &BTreeSet<[u32; 2]>) -> bool {
    let mut uses: BTreeMap<[u32; 2], usize> = BTreeMap::new();
    for &[a, b, c] in triangles {
        for [p, q] in [[a, b], [b, c], [c, a]] {
            *uses.entry([p.min(q), p.max(q)]).or_default() += 1;
        }
    }
    uses.iter().all(|(edge, &uses)| edges.contains(edge) || uses == 2)
}

fn edges_of(faces: &[[u32; 4]]) -> BTreeSet<[u32; 2]> {
    let sides = |f: &[u32; 4]| [[f[0], f[1]], [f[1], f[2]], [f[2], f[3]], [f[3], f[0]]];
    faces.iter().flat_map(sides).map(|[a, b]| [a.min(b), a.max(b)]).collect()
}

/// Returns whether some choice of diagonals makes no edge twice.
fn can_be_cut(quads: &[[u32; 4]]) -> bool {
    let edges = edges_of(quads);
    let diagonal = |q: &[u32; 4], cut: usize| {
        let [a, b] = [q[cut], q[cut + 2]];
        [a.min(b), a.max(b)]
    };
    (0..1 << quads.len()).any(|cuts: usize| {
        let used: Vec<_> =
            quads.iter().enumerate().map(|(i, quad)| diagonal(quad, cuts >> i & 1)).collect();
        let distinct: BTreeSet<_> = used.iter().copied().collect();
        distinct.len() == used.len() && distinct.is_disjoint(&edges)
    })
}

/// A quad of different vertices among the first seven.
fn quad() -> impl Strategy<Value = [u32; 4]> {
    prop::sample::subsequence((0..7).collect::<Vec<u32>>(), 4)
        .prop_shuffle()
        .prop_map(|corners| [corners[0], corners[1], corners[2], corners[3]])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    #[test]
    fn quads_are_cut_whenever_they_can_be(
        quads in prop::collection::vec(quad(), 1..7),
        places in prop::collection::vec(prop::array::uniform3(-1.0..1.0), 7),
    ) {
        let mut mesh = Mesh::new(places, Faces::from_iter(&quads));
        let cut = mesh.triangulate();
        prop_assert_eq!(cut.is_ok(), can_be_cut(&quads));
        if cut.is_ok() {
            let triangles = mesh.faces().corners().as_chunks::<3>().0;
            prop_assert_eq!(triangles.len(), 2 * quads.len());
            prop_assert!(is_proper(triangles, &edges_of(&quads)));
        } else {
            prop_assert_eq!(mesh.faces().len(), quads.len(), "unchanged");
        }
    }

    #[test]
    fn welding_is_what_comparing_with_all_others_gives(
        places in prop::collection::vec(prop::array::uniform3(-3..4i8), 0..40),
        tolerance in prop::sample::select(vec![0.0, 0.5, 1.0, 2.0, 4.0]),
        scale in prop::sample::select(vec![1.0, 2_f64.powi(-990), 2_f64.powi(990)]),
    ) {
        let places: Vec<[f64; 3]> =
            places.iter().map(|place| place.map(|x| f64::from(x) * scale)).collect();
        let corners: Vec<u32> = (0..places.len() as u32 / 3 * 3).collect();
        let mut mesh = Mesh::new(places.clone(), Faces::uniform(3, corners.clone()));
        let (kept, targets) = weld_slowly(&places, tolerance, scale);
        let welded = mesh.weld(tolerance * scale);
        prop_assert_eq!(mesh.positions(), &kept[..]);
        prop_assert_eq!(welded.merged_vertices, places.len() - kept.len());
        let expected: Vec<Vec<u32>> = corners
            .chunks(3)
            .map(|face| face.iter().map(|&v| targets[v as usize]).collect::<Vec<u32>>())
            .filter(|face| face[0] != face[1] && face[1] != face[2] && face[2] != face[0])
            .collect();
        prop_assert!(mesh.faces().iter().eq(expected.iter().map(Vec::as_slice)));
        prop_assert_eq!(welded.dropped_faces, corners.len() / 3 - expected.len());
        prop_assert_eq!(mesh.weld(tolerance * scale).merged_vertices, 0, "a second time");
    }
}

/// Returns, without rounding as all numbers are small multiples of powers of 2, the kept positions
/// and the vertex that each becomes.
fn weld_slowly(places: &[[f64; 3]], tolerance: f64, scale: f64) -> (Vec<[f64; 3]>, Vec<u32>) {
    let square = |p: &[f64; 3], q: &[f64; 3]| {
        (0..3).map(|axis| ((p[axis] - q[axis]) / scale).powi(2)).sum::<f64>()
    };
    let (mut kept, mut targets): (Vec<[f64; 3]>, _) = (Vec::new(), Vec::new());
    for place in places {
        let near = kept.iter().enumerate().map(|(v, other)| (square(place, other), v));
        let nearest = near.reduce(|a, b| if b.0 < a.0 { b } else { a });
        match nearest.filter(|(distance, _)| *distance <= tolerance * tolerance) {
            Some((_, vertex)) => targets.push(vertex as u32),
            None => {
                targets.push(kept.len() as u32);
                kept.push(*place);
            }
        }
    }
    (kept, targets)
}
