//! One suite for every algorithm there is or will be: all-quad meshes of the same surface.

use std::collections::{HashMap, HashSet};

use proptest::prelude::*;
use triquad::clock::SteppingClock;
use triquad::dual::{DualGraph, Matching};
use triquad::mesh::{Faces, Mesh};
use triquad::pairing::{LRS_ORDER, lrs, velho};
use triquad::quadrangulation::FaceFault;
use triquad::random::Random;
use triquad::triangulation::HalfEdgeId;
use triquad::{
    Algorithm, Augmentation, CheckError, Converter, Expansion, Quadrangulated, Quadrangulation,
    Triangulation, check, check_retriangulation,
};
use triquad_generators::random::Mix;
use triquad_generators::{Surface, classic, grids};

fn all_settings(seed: u64) -> impl Iterator<Item = Settings> {
    let all = Algorithm::ALL.into_iter().chain([Algorithm::Lrs(Expansion::FewFlips)]);
    let pairs = all.flat_map(|a| Augmentation::ALL.map(|b| (a, b)));
    pairs.map(move |(algorithm, augmentation)| Settings { algorithm, augmentation, seed })
}

/// One way to convert.
#[derive(Clone, Copy, Debug)]
struct Settings {
    algorithm: Algorithm,
    augmentation: Augmentation,
    seed: u64,
}

impl Settings {
    fn converter<'a>(self) -> Converter<'a> {
        let Self { algorithm, augmentation, seed } = self;
        Converter::new().algorithm(algorithm).augmentation(augmentation).seed(seed)
    }
}

/// The quads of a triangulation by the default algorithm.
fn quads_of(triangulation: &Triangulation) -> Vec<[u32; 4]> {
    corners(&Converter::new().quadrangulate(triangulation).unwrap().quadrangulation)
}

fn with_quads(list: &Mesh, quads: Vec<[u32; 4]>) -> Mesh {
    list.clone().with_faces(Faces::uniform(4, quads.into_flattened()))
}

fn corners(quadrangulation: &Quadrangulation) -> Vec<[u32; 4]> {
    quadrangulation.quads().iter().map(|quad| quad.map(|v| v.index() as u32)).collect()
}

/// The definition, with hash maps: every quad is two triangles across an edge, each used once, and
/// the quads close up, oriented, with one fan round every vertex.
fn assert_quadrangulation(triangles: &Mesh, quads: &[[u32; 4]]) {
    let turned = |t: [u32; 3]| {
        let least = (0..3).min_by_key(|&i| t[i]).unwrap();
        [t[least], t[(least + 1) % 3], t[(least + 2) % 3]]
    };
    let mut left: HashSet<[u32; 3]> =
        triangles.faces().corners().as_chunks().0.iter().copied().map(turned).collect();
    for &[a, b, c, d] in quads {
        let cuts = [[[a, b, c], [c, d, a]], [[b, c, d], [d, a, b]]].map(|cut| cut.map(turned));
        let cut = cuts.iter().find(|cut| cut.iter().all(|t| left.contains(t)));
        let cut = cut.expect("two triangles that are left");
        assert!(cut.iter().all(|t| left.remove(t)));
    }
    assert!(left.is_empty());

    let mut after: HashMap<(u32, u32), (usize, usize)> = HashMap::new();
    for (q, quad) in quads.iter().enumerate() {
        for i in 0..4 {
            assert_eq!(
                after.insert((quad[i], quad[(i + 1) % 4]), (q, i)),
                None,
                "a directed edge twice"
            );
        }
    }
    let mut at_vertex: HashMap<u32, Vec<(usize, usize)>> = HashMap::new();
    for (q, quad) in quads.iter().enumerate() {
        (0..4).for_each(|i| at_vertex.entry(quad[i]).or_default().push((q, i)));
    }
    for (v, sides) in at_vertex {
        let (mut at, mut turned) = (sides[0], 0);
        loop {
            let (q, i) = at;
            at = after[&(v, quads[q][(i + 3) % 4])];
            turned += 1;
            if at == sides[0] {
                break;
            }
        }
        assert_eq!(turned, sides.len(), "one fan");
    }
}

/// The triangles that were paired triangulate the surface of the input and have all its edges but
/// those flipped; few of them are left for the augmentation if the algorithm promises so.
fn assert_same_surface(
    conversion: &Quadrangulated<'_>,
    input: &Triangulation,
    paired: &Mesh,
    list: &Mesh,
) {
    let rebuilt = Triangulation::build(paired).expect("a triangulation");
    assert_eq!(rebuilt, *conversion.triangulation);
    assert_eq!(check_retriangulation(paired, list), Ok(()));
    let edges = |t: &Triangulation| -> HashSet<_> {
        let sides = t.triangles().flat_map(|f| f.half_edges());
        sides.map(|h| [t.origin(h), t.origin(h.next())]).collect()
    };
    let new = edges(&rebuilt).difference(&edges(input)).count();
    assert_eq!(new, 2 * conversion.report.edge_flips);
}

fn assert_converts(surface: &Surface, settings: &Settings) {
    let list = crate::common::face_list(surface);
    let triangulation = Triangulation::build(&list).unwrap();
    let conversion = settings.converter().quadrangulate(&triangulation).unwrap();
    let quads = corners(&conversion.quadrangulation);
    let paired = list.clone().with_faces(conversion.triangulation.to_faces());
    assert_quadrangulation(&paired, &quads);
    assert_same_surface(&conversion, &triangulation, &paired, &list);
    let degree_two = {
        let mut degree = vec![0; surface.positions.len()];
        quads.iter().flatten().for_each(|&v| degree[v as usize] += 1);
        degree.iter().filter(|&&degree| degree == 2).count()
    };
    let report = check(&with_quads(&list, quads), &paired).unwrap();
    assert_eq!(report.degree_two_vertices, degree_two);
    assert_eq!(report.euler_characteristic, triangulation.euler_characteristic());
    assert_eq!(report.vertices, triangulation.vertex_count());
}

#[test]
fn every_algorithm_quadrangulates_random_surfaces() {
    for (seed, (_, surface)) in crate::common::many_surfaces(60).enumerate() {
        all_settings(seed as u64).for_each(|settings| assert_converts(&surface, &settings));
    }
}

#[test]
fn every_algorithm_quadrangulates_special_surfaces() {
    for (_, surface) in crate::common::special_surfaces() {
        all_settings(0).for_each(|settings| assert_converts(&surface, &settings));
    }
}

/// The definition: the longest edge between unpaired triangles, the first of equal ones, again and
/// again. Coordinates are on a coarse lattice, so that many lengths are equal.
#[test]
fn velho_takes_the_longest_free_edge() {
    let mut equal_lengths = 0;
    for (seed, (_, surface)) in crate::common::many_surfaces(20).enumerate() {
        let mut random = Random::stream(seed as u64, &["lattice"]);
        let mut coordinate = || f64::from(random.below(4));
        let points: Vec<[f64; 3]> =
            surface.positions.iter().map(|_| [(); 3].map(|()| coordinate())).collect();
        let list = Mesh::from_triangles(points.clone(), surface.triangles.clone());
        let triangulation = Triangulation::build(&list).unwrap();
        let dual = DualGraph::new(&triangulation);
        let length = |h: HalfEdgeId| -> f64 {
            let [a, b] = [h, h.next()].map(|h| points[triangulation.origin(h).index()]);
            (0..3).map(|i| (a[i] - b[i]).powi(2)).sum()
        };
        let mut expected = Matching::empty(dual.len());
        let sides: Vec<HalfEdgeId> =
            triangulation.triangles().flat_map(|f| f.half_edges()).collect();
        loop {
            let mut best: Option<HalfEdgeId> = None;
            for &h in &sides {
                let pair = [h.triangle(), triangulation.twin(h).triangle()];
                let is_free = pair[0] < pair[1] && pair.iter().all(|&f| !expected.is_paired(f));
                equal_lengths += usize::from(best.is_some_and(|b| length(b) == length(h)));
                if is_free && best.is_none_or(|best| length(h) > length(best)) {
                    best = Some(h);
                }
            }
            let Some(h) = best else { break };
            expected.pair(h.triangle(), triangulation.twin(h).triangle());
        }
        assert_eq!(velho(&dual, length), expected, "seed {seed}");
        let report = Converter::new().algorithm(Algorithm::Velho).run(&list).unwrap();
        assert_eq!(report.report().unpaired_triangles, expected.unpaired_count());
    }
    assert!(equal_lengths > 1_000, "{equal_lengths}");
}

#[test]
fn a_seed_fixes_the_result_and_another_changes_it() {
    let surface = crate::common::random_of(1, 600, triquad_generators::random::Mix::Balanced, 1);
    let triangulation = Triangulation::build(&crate::common::face_list(&surface)).unwrap();
    for algorithm in Algorithm::ALL {
        let quads = |seed| {
            let settings = Settings { algorithm, augmentation: Augmentation::Local, seed };
            corners(&settings.converter().quadrangulate(&triangulation).unwrap().quadrangulation)
        };
        assert_eq!(quads(1), quads(1));
        let different: HashSet<_> = (0..5).map(quads).collect();
        // An algorithm draws or ignores the seed.
        assert!([1, 5].contains(&different.len()), "{algorithm}: {}", different.len());
        let draws = matches!(algorithm, Algorithm::SimpleGreedy | Algorithm::PulliSegal);
        assert!(!draws || different.len() == 5, "{algorithm}");
    }
}

#[test]
fn contraction_and_expansion_leave_few_unpaired() {
    for (genus, surface) in crate::common::many_surfaces(60) {
        let triangulation = Triangulation::build(&crate::common::face_list(&surface)).unwrap();
        for expansion in Expansion::ALL {
            let pairing = lrs(&triangulation, expansion, LRS_ORDER);
            let unpaired = pairing.matching.unpaired_count();
            assert!(unpaired >= 4 && unpaired <= (56 * genus).saturating_sub(12).max(4));
        }
    }
    let two = crate::common::beside(&classic::seven_vertex_torus(), &grids::sphere(5));
    let triangulation = Triangulation::build(&crate::common::face_list(&two)).unwrap();
    let pairing = lrs(&triangulation, Expansion::Printed, LRS_ORDER);
    assert_eq!(pairing.matching.unpaired_count(), 14 + 4, "components add up");
}

#[test]
fn a_retriangulation_has_the_same_components_on_the_same_vertices() {
    let list = |surface: &Surface| crate::common::face_list(surface);
    let (torus, sphere) = (grids::torus(5, 4), grids::sphere(3));
    let given = list(&crate::common::beside(&torus, &sphere));
    let changed = |change: &dyn Fn(&mut Vec<[u32; 3]>)| {
        let mut triangles = given.faces().corners().as_chunks().0.to_vec();
        change(&mut triangles);
        let other = Mesh::from_triangles(given.positions().to_vec(), triangles);
        check_retriangulation(&other, &given)
    };
    assert_eq!(changed(&|_| ()), Ok(()));
    let half = torus.triangles.len();
    assert_eq!(changed(&|all| all.truncate(half)), Err(CheckError::VertexUse(20)));
    let missing = changed(&|all| all.truncate(all.len() - 1));
    assert!(matches!(missing, Err(CheckError::Component(20))));
    let bridged = changed(&|all| all[0] = [0, 1, 25]);
    assert!(matches!(bridged, Err(CheckError::Component(0))));
    assert_eq!(
        changed(&|all| all[3][1] = 999),
        Err(CheckError::BadTriangle(3, absent(999, &given)))
    );
    let mut moved = given.clone();
    moved.positions_mut()[2][0] += 1.0;
    assert_eq!(check_retriangulation(&moved, &given), Err(CheckError::Moved(2)));
    let more = [given.positions(), &[[0.0; 3]]].concat();
    let longer = Mesh::new(more, given.faces().clone());
    let counts = [longer.positions().len(), given.positions().len()];
    let expected = CheckError::TriangulationVertexCount { paired: counts[0], given: counts[1] };
    assert_eq!(check_retriangulation(&longer, &given), Err(expected));
    assert!(!expected.to_string().contains("quad"), "{expected}");
}

#[test]
fn a_large_regular_torus_is_paired_almost_fully() {
    let triangulation =
        Triangulation::build(&crate::common::face_list(&grids::torus(1450, 1450))).unwrap();
    let mut random = triquad::random::Random::stream(0, &["ps"]);
    let matching = Algorithm::PulliSegal.pair(&triangulation, &mut random).matching;
    assert!(matching.unpaired_count() * 10_000 < triangulation.triangle_count());
}

#[test]
fn unreferenced_vertices_are_kept() {
    let sphere = crate::common::face_list(&grids::sphere(4));
    let more = [sphere.positions(), &[[7.0; 3], [-0.0; 3]]].concat();
    let list = Mesh::new(more, sphere.faces().clone());
    let clock = SteppingClock::new(0.5);
    let converted = Converter::new().clock(&clock).run(&list).unwrap();
    let (quads, report) = (converted.mesh(), converted.report());
    assert_eq!(quads.positions(), list.positions());
    assert_eq!(
        (report.vertices, report.quads),
        (list.positions().len() - 2, list.faces().len() / 2)
    );
    assert!(report.to_string().contains(" vertices (2 more in no face); "), "{report}");
    assert_eq!(report.build_seconds, 0.5);
    // Costs of edges, the search, and the augmentation that finds nothing to do.
    assert_eq!((report.cost_seconds, report.total_seconds()), (0.5, 1.5));
    assert!(check(quads, &list).is_ok());
}

/// A reading of the clock takes half a second: two more where something is shuffled.
#[test]
fn shuffles_are_timed_apart_and_belong_to_the_pairing() {
    let list = crate::common::face_list(&crate::common::random_of(1, 300, Mix::Balanced, 3));
    let triangulation = Triangulation::build(&list).unwrap();
    let seconds = |algorithm| {
        let clock = SteppingClock::new(0.5);
        let mut converter = Converter::new().algorithm(algorithm).clock(&clock);
        let report = converter.quadrangulate(&triangulation).unwrap().report;
        (report.pairing_seconds, report.shuffle_seconds)
    };
    assert_eq!(seconds(Algorithm::SimpleGreedy), (1.5, 0.5));
    assert_eq!(seconds(Algorithm::EagerRescue), (0.5, 0.0));
    let (pairing, shuffles) = seconds(Algorithm::PulliSegal);
    assert!(shuffles <= pairing, "{shuffles} of {pairing}");
}

fn absent(vertex: u32, mesh: &Mesh) -> FaceFault {
    FaceFault::AbsentVertex { vertex, all: mesh.positions().len() }
}

#[test]
fn the_check_names_what_is_wrong() {
    let surface = grids::torus(6, 5);
    let list = crate::common::face_list(&surface);
    let triangulation = Triangulation::build(&list).unwrap();
    let good = quads_of(&triangulation);
    let verdict = |change: &dyn Fn(&mut Vec<[u32; 4]>)| {
        let mut quads = good.clone();
        change(&mut quads);
        check(&with_quads(&list, quads), &list).unwrap_err()
    };
    assert!(matches!(
        verdict(&|quads| quads.truncate(quads.len() - 1)),
        CheckError::EdgeOpen(..) | CheckError::VertexUse(_)
    ));
    assert!(matches!(verdict(&|quads| quads.push(quads[3])), CheckError::EdgeTwice(..)));
    assert!(matches!(verdict(&|quads| quads[2].reverse()), CheckError::EdgeTwice(..)));
    let folded = |quads: &mut Vec<[u32; 4]>| {
        let [a, b, c, _] = quads[0];
        *quads = vec![[a, b, c, b]; 1];
    };
    assert!(matches!(verdict(&folded), CheckError::RepeatedCorner(0) | CheckError::VertexUse(_)));
    assert_eq!(verdict(&|quads| quads[4][0] = 999), CheckError::NotAQuad(4, absent(999, &list)));

    let other = crate::common::face_list(&classic::octahedron());
    let quads_of_other = quads_of(&Triangulation::build(&other).unwrap());
    let turned = quads_of_other.iter().map(|&[a, b, c, d]| [b, c, d, a]).collect();
    assert!(
        check(&with_quads(&other, turned), &other).is_ok(),
        "where a quad starts does not matter"
    );
    let mut moved = with_quads(&other, quads_of_other);
    moved.positions_mut()[5][2] = 2.0;
    assert_eq!(check(&moved, &other), Err(CheckError::Moved(5)));
    let (positions, faces) = moved.into_parts();
    let shorter = Mesh::new(positions[..5].to_vec(), faces);
    assert_eq!(check(&shorter, &other), Err(CheckError::VertexCount { quads: 5, triangles: 6 }));
}

#[test]
fn a_quad_may_be_cut_along_either_diagonal_but_its_triangles_must_exist() {
    let positions: Vec<[f64; 3]> =
        (0..8).map(|i| [i & 1, i >> 1 & 1, i >> 2].map(f64::from)).collect();
    let cube = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6]];
    let cut = |other_diagonal: usize| {
        let halves = |(face, &[a, b, c, d]): (usize, &[u32; 4])| {
            if face == other_diagonal { [[a, b, d], [b, c, d]] } else { [[a, b, c], [a, c, d]] }
        };
        let triangles = cube.iter().enumerate().flat_map(halves).collect();
        Mesh::from_triangles(positions.clone(), triangles)
    };
    for other_diagonal in 0..6 {
        let triangles = cut(other_diagonal);
        assert!(check(&with_quads(&triangles, cube.to_vec()), &triangles).is_ok());
    }
    // Pair both triangles of a face with others, then cut that face along its other diagonal.
    let (even, uneven) = (cut(6), cut(0));
    let across: Vec<[u32; 4]> =
        vec![[0, 2, 3, 6], [0, 3, 1, 5], [4, 5, 7, 6], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6]];
    assert!(check(&with_quads(&even, across.clone()), &even).is_err());
    assert!(check(&with_quads(&uneven, across), &uneven).is_err());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn any_sculpted_surface_is_quadrangulated(surface in crate::common::sculpted_surface(), seed: u64) {
        all_settings(seed).for_each(|settings| assert_converts(&surface, &settings));
    }

    #[test]
    fn a_damaged_quad_mesh_never_passes(
        surface in crate::common::sculpted_surface(),
        (quad, corner, vertex) in (any::<usize>(), 0..4usize, any::<u32>()),
    ) {
        let list = crate::common::face_list(&surface);
        let mut quads = quads_of(&Triangulation::build(&list).unwrap());
        let (quad, vertex) = (quad % quads.len(), vertex % list.positions().len() as u32);
        prop_assume!(quads[quad][corner] != vertex);
        quads[quad][corner] = vertex;
        prop_assert!(check(&with_quads(&list, quads), &list).is_err());
    }
}
