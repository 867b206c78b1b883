//! Open and one-sided surfaces, edges to keep and triangles left at a price, against oracles.

use std::collections::HashMap;

use petgraph::algo::maximum_matching;
use petgraph::graph::UnGraph;
use triquad::matching::weighted::{Barrier, NONE};
use triquad::mesh::Faces;
use triquad::pairing::{Proof, ProofError};
use triquad::quadrangulation::{FaceFault, Keep, check_mixed};
use triquad::random::Random;
use triquad::triangulation::{OpenTriangulation, Surface as _, TriangleId};
use triquad::{
    Algorithm, CheckError, ConvertError, Converted, Converter, DualGraph, Matching, Mesh, Survey,
    Triangulation,
};
use triquad_generators::random::Mix;
use triquad_generators::testing::random_of;
use triquad_generators::{Surface, classic, grids};

// Surfaces with holes.

/// Removes some triangles and gives each fan left a vertex of its own, so that all laws hold but
/// those that open surfaces may break.
fn torn(surface: &Surface, seed: u64) -> Mesh {
    let mut random = Random::stream(seed, &["tear"]);
    let share = 1 + random.below(9);
    let mut triangles = surface.triangles.clone();
    triangles.retain(|_| random.below(10) >= share.min(5));
    if triangles.is_empty() {
        triangles.push(surface.triangles[0]);
    }
    let fans = fans(&triangles);
    let mut positions = Vec::new();
    let mut vertex_of_fan = HashMap::new();
    for (corner, vertex) in triangles.as_flattened_mut().iter_mut().enumerate() {
        let position = surface.positions[*vertex as usize];
        *vertex = *vertex_of_fan.entry(fans[corner]).or_insert_with(|| {
            positions.push(position);
            positions.len() as u32 - 1
        });
    }
    let mut mesh = Mesh::from_triangles(positions, triangles);
    // Of a one-sided surface two-sided pieces may be left, and these must be oriented alike.
    let survey = Survey::new(&mesh);
    if !survey.is_open_surface(false) {
        survey.orient(&mut mesh);
    }
    mesh
}

/// A number for each corner, the same for corners of one fan.
fn fans(triangles: &[[u32; 3]]) -> Vec<usize> {
    let mut fan: Vec<usize> = (0..3 * triangles.len()).collect();
    let sides = |t: usize| (0..3).map(move |i| (3 * t + i, 3 * t + (i + 1) % 3));
    let corners = triangles.as_flattened();
    let mut changed = true;
    while changed {
        changed = false;
        for (a, b) in (0..triangles.len()).flat_map(sides) {
            for (c, d) in (0..triangles.len()).flat_map(sides) {
                for (p, q, r, s) in [(a, b, c, d), (a, b, d, c)] {
                    if corners[p] == corners[r] && corners[q] == corners[s] {
                        for (one, other) in [(p, r), (q, s)] {
                            let lower = fan[one].min(fan[other]);
                            changed |= fan[one] != lower || fan[other] != lower;
                            (fan[one], fan[other]) = (lower, lower);
                        }
                    }
                }
            }
        }
    }
    fan
}

/// A small surface, closed or torn, of one side or two.
fn small_surface(seed: u64) -> Mesh {
    let surface = match seed % 8 {
        0 => classic::moebius_strip(5 + (seed / 8 % 5) as u32),
        1 => classic::projective_plane(),
        2 => classic::klein_bottle(3 + (seed / 8 % 2) as u32, 3),
        3 => random_of(1, 3, Mix::Balanced, seed),
        _ => random_of(0, 3 + seed as usize / 8 % 7, Mix::Balanced, seed),
    };
    torn(&surface, seed)
}

/// The pairs of neighbours of a mesh with the vertices of their edge.
fn neighbours(mesh: &Mesh) -> Vec<([usize; 2], [u32; 2])> {
    let open = OpenTriangulation::build(mesh).unwrap();
    let pair = |side| {
        let twin = open.across(side)?;
        let triangles = [side, twin].map(|h| h.triangle().index());
        Some((triangles, open.ends(side).map(u32::from)))
    };
    open.edges().filter_map(pair).collect()
}

fn fewest_left(mesh: &Mesh) -> usize {
    let mut graph = UnGraph::<(), ()>::default();
    let nodes: Vec<_> = mesh.faces().iter().map(|_| graph.add_node(())).collect();
    for ([f, g], _) in neighbours(mesh) {
        graph.add_edge(nodes[f], nodes[g], ());
    }
    mesh.faces().len() - 2 * maximum_matching(&graph).len()
}

#[test]
fn no_pairing_leaves_fewer_triangles() {
    let mut algorithms = Algorithm::ALL.to_vec();
    algorithms.retain(|algorithm| algorithm.works_on_open());
    let mut left_some = 0;
    for seed in 0..20_000 {
        let mesh = small_surface(seed);
        let algorithm = algorithms[seed as usize / 8 % algorithms.len()];
        let converted = Converter::new().open(true).algorithm(algorithm).seed(seed).run(&mesh);
        let converted = converted.unwrap_or_else(|error| panic!("{algorithm}, {seed}: {error}"));
        let report = converted.report();
        // A surface that stayed whole is converted as before.
        let left = report.leftover_triangles.unwrap_or(0);
        assert_eq!(left, fewest_left(&mesh), "{algorithm}, {seed}");
        assert_eq!(2 * report.quads + left, report.triangles);
        assert!(report.is_proved_fewest || report.leftover_triangles.is_none());
        left_some += usize::from(left > 0);
    }
    assert!(left_some > 5_000, "{left_some}");
}

// Costs, edges to keep and prices against all pairings.

/// What is asked of a pairing.
#[derive(Clone, Debug)]
struct Question {
    costs: HashMap<[u32; 2], i32>,
    kept: Vec<[u32; 2]>,
    strict: bool,
    price: Option<i32>,
}

fn sorted([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

impl Question {
    fn random(mesh: &Mesh, seed: u64) -> (Self, Vec<i32>) {
        let mut random = Random::stream(seed, &["question"]);
        let open = OpenTriangulation::build(mesh).unwrap();
        let range = [1, 3, 20, 100_000][random.below(4) as usize];
        let list: Vec<i32> =
            open.edges().map(|_| random.below(2 * range) as i32 - range as i32).collect();
        let ends = open.edges().map(|side| sorted(open.ends(side).map(u32::from)));
        let costs = ends.zip(list.iter().copied()).collect();
        let share = random.below(4);
        let mut kept: Vec<_> = neighbours(mesh).into_iter().map(|(_, ends)| ends).collect();
        kept.retain(|_| random.below(4) < share);
        let strict = random.below(3) == 0;
        let price = (random.below(4) == 0).then(|| random.below(2 * range) as i32 - range as i32);
        (Self { costs, kept, strict, price }, list)
    }

    /// Triangles left, edges given up and cost: what is least for the best pairing.
    fn least(&self, mesh: &Mesh) -> [i64; 3] {
        let mut around = vec![Vec::new(); mesh.faces().len()];
        for ([f, g], ends) in neighbours(mesh) {
            let is_kept = self.kept.iter().any(|&kept| sorted(kept) == sorted(ends));
            if is_kept && (self.strict || self.price.is_some()) {
                continue;
            }
            let cost = self.costs[&sorted(ends)].into();
            around[f.max(g)].push((f.min(g), [0, i64::from(is_kept), cost]));
        }
        self.search(&around, &mut vec![false; around.len()], around.len())
    }

    /// Decides about the triangles below `open` that are not paired, the highest first.
    fn search(
        &self,
        around: &[Vec<(usize, [i64; 3])>],
        is_paired: &mut Vec<bool>,
        open: usize,
    ) -> [i64; 3] {
        let Some(f) = (0..open).rev().find(|&f| !is_paired[f]) else { return [0; 3] };
        let add = |one: [i64; 3], other: [i64; 3]| [0, 1, 2].map(|k| one[k] + other[k]);
        let alone = self.price.map_or([1, 0, 0], |price| [0, 0, price.into()]);
        let mut least = add(alone, self.search(around, is_paired, f));
        for &(g, score) in around[f].iter().filter(|(g, _)| !is_paired[*g]).collect::<Vec<_>>() {
            is_paired[g] = true;
            least = least.min(add(score, self.search(around, is_paired, f)));
            is_paired[g] = false;
        }
        least
    }

    fn converter(&self, list: Vec<i32>) -> Converter<'static> {
        let mut keep = Keep::default();
        keep.edges.clone_from(&self.kept);
        let converter = Converter::new().open(true).edge_costs(list).keep(keep).strict(self.strict);
        match self.price {
            Some(price) => converter.quad_dominant(price),
            None => converter,
        }
    }
}

fn score(converted: &Converted, question: &Question) -> [i64; 3] {
    let report = converted.report();
    let left = match question.price {
        Some(_) => 0,
        None => report.leftover_triangles.unwrap_or(0),
    };
    let given_up = report.given_up_edges.unwrap_or(0);
    assert_eq!(given_up, converted.given_up().len());
    [left as i64, given_up as i64, report.total_cost.unwrap() as i64]
}

#[test]
fn no_pairing_is_better_by_the_order_of_the_criteria() {
    let (mut given_up, mut strict) = (0, 0);
    for seed in 0..6_000 {
        let mesh = match seed % 6 {
            0 => crate::common::face_list(&random_of(0, 5, Mix::Balanced, seed)),
            _ => small_surface(seed),
        };
        if mesh.faces().len() > 24 {
            continue;
        }
        let (question, list) = Question::random(&mesh, seed);
        let converted = question.converter(list).run(&mesh);
        let converted = converted.unwrap_or_else(|error| panic!("{seed}: {error}"));
        let score = score(&converted, &question);
        assert_eq!(score, question.least(&mesh), "{seed}: {question:?}");
        given_up += usize::from(score[1] > 0);
        strict += usize::from(question.strict && score[0] > 0);
    }
    assert!(given_up > 300 && strict > 300, "{given_up}, {strict}");
}

#[test]
fn edges_given_up_are_kept_ones_inside_quads() {
    let surface = random_of(1, 60, Mix::Balanced, 4);
    let mesh = crate::common::face_list(&surface);
    let mut keep = Keep::default();
    keep.edges = neighbours(&mesh).into_iter().map(|(_, ends)| ends).step_by(2).collect();
    let converted = Converter::new().keep(keep.clone()).run(&mesh).unwrap();
    let report = converted.report();
    assert_eq!(report.kept_edges, Some(keep.edges.len()));
    assert_eq!(report.leftover_triangles, None);
    let sides: Vec<_> = sides(converted.mesh().faces());
    for &ends in converted.given_up() {
        assert!(keep.edges.contains(&ends) && !sides.contains(&sorted(ends)));
    }
    let lost = keep.edges.iter().filter(|&&ends| !sides.contains(&sorted(ends)));
    assert_eq!(lost.count(), converted.given_up().len());
    assert!(!converted.given_up().is_empty());
}

/// The sides of all faces.
fn sides(faces: &Faces) -> Vec<[u32; 2]> {
    let around = |face: &[u32]| {
        (0..face.len()).map(|k| sorted([face[k], face[(k + 1) % face.len()]])).collect::<Vec<_>>()
    };
    faces.iter().flat_map(around).collect()
}

#[test]
fn no_quad_costs_more_than_twice_the_price() {
    let mesh = crate::common::face_list(&grids::sphere(12));
    let length = |quad: &triquad::quadrangulation::EdgeQuad| {
        let [a, _, b, _] = quad.corners;
        (1e3 * (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>()) as i32
    };
    let mut left = usize::MAX;
    for price in [0, 20, 50, 1_000_000] {
        let converted = Converter::new().cost(&length).quad_dominant(price).run(&mesh).unwrap();
        let now = converted.report().leftover_triangles.unwrap();
        assert!(now <= left, "a higher price leaves no more triangles");
        left = now;
    }
    assert_eq!(left, 0);
}

// Refusals.

#[test]
fn open_surfaces_are_refused_unless_they_are_allowed() {
    let mesh = torn(&grids::sphere(6), 1);
    assert!(matches!(Converter::new().run(&mesh), Err(ConvertError::Refused(_))));
    for algorithm in Algorithm::ALL {
        let result = Converter::new().open(true).algorithm(algorithm).run(&mesh);
        match algorithm.id() {
            "ds" | "gw" | "lrs" => {
                assert!(matches!(result, Err(ConvertError::NeedsClosed(_))), "{algorithm}");
            }
            _ => assert!(result.is_ok(), "{algorithm}"),
        }
    }
    // More than open: an edge of three triangles.
    let mut triangles: Vec<_> = mesh.faces().corners().as_chunks::<3>().0.to_vec();
    let [a, b, _] = triangles[0];
    for c in [0, 1, 2, 3] {
        if ![a, b].contains(&c) {
            triangles.push([a, b, c]);
        }
    }
    let overfull = Mesh::from_triangles(mesh.positions().to_vec(), triangles);
    assert!(matches!(Converter::new().open(true).run(&overfull), Err(ConvertError::Refused(_))));
}

#[test]
fn what_only_best_can_aim_at_is_refused_by_the_others() {
    let mesh = crate::common::face_list(&classic::octahedron());
    let tq = || Converter::new().algorithm(Algorithm::EagerRescue);
    let mut keep = Keep::default();
    keep.sharp = Some(30.0);
    let wrong =
        [tq().keep(keep), tq().strict(true), tq().quad_dominant(1), tq().edge_costs(vec![])];
    for mut converter in wrong {
        assert!(matches!(converter.run(&mesh), Err(ConvertError::NeedsBest { .. })));
    }
    let short = Converter::new().edge_costs(vec![1; 11]).run(&mesh).unwrap_err();
    assert_eq!(short.to_string(), "11 costs are given for 12 edges");
}

// The check.

fn with_faces(mesh: &Mesh, faces: &[Vec<u32>]) -> Mesh {
    mesh.clone().with_faces(faces.iter().collect())
}

#[test]
fn the_check_of_mixed_meshes_names_what_is_wrong() {
    let mesh = torn(&grids::torus(7, 6), 3);
    let converted = Converter::new().open(true).run(&mesh).unwrap();
    let faces: Vec<Vec<u32>> = converted.mesh().faces().iter().map(<[u32]>::to_vec).collect();
    let first_of = |corners: usize| faces.iter().position(|face| face.len() == corners).unwrap();
    let (quad, triangle) = (first_of(4), first_of(3));
    let verdict = |change: &dyn Fn(&mut Vec<Vec<u32>>)| {
        let mut faces = faces.clone();
        change(&mut faces);
        check_mixed(&with_faces(&mesh, &faces), &mesh)
    };
    let good = verdict(&|_| ()).unwrap();
    assert_eq!(Some(good.report.triangles), converted.report().leftover_triangles);
    assert_eq!(good.report.quads, converted.report().quads);
    assert!(verdict(&|faces| faces[quad].rotate_left(1)).is_ok());
    assert!(verdict(&|faces| faces.reverse()).is_ok());

    let wrong = |change: &dyn Fn(&mut Vec<Vec<u32>>)| verdict(change).unwrap_err();
    assert!(matches!(wrong(&|f| drop(f.remove(triangle))), CheckError::TriangleUnused(_)));
    assert!(matches!(wrong(&|f| drop(f.remove(quad))), CheckError::TriangleUnused(_)));
    assert!(matches!(wrong(&|f| f.push(f[triangle].clone())), CheckError::TriangleTwice(_)));
    assert!(matches!(wrong(&|f| f.push(f[quad].clone())), CheckError::TriangleTwice(_)));
    assert_eq!(wrong(&|f| f[triangle].reverse()), CheckError::Turned(triangle));
    assert_eq!(wrong(&|f| f[quad].reverse()), CheckError::Turned(quad));
    assert_eq!(wrong(&|f| f[quad].swap(0, 1)), CheckError::NotAPair(quad));
    assert_eq!(wrong(&|f| f[quad][0] = f[quad][2]), CheckError::RepeatedCorner(quad));
    let absent = FaceFault::AbsentVertex { vertex: 999, all: mesh.positions().len() };
    assert_eq!(wrong(&|f| f[quad][0] = 999), CheckError::NotATriangleOrQuad(quad, absent));
    let fault = FaceFault::Corners(2);
    assert_eq!(wrong(&|f| f[quad].truncate(2)), CheckError::NotATriangleOrQuad(quad, fault));
    // Half of a quad in place of the quad.
    assert!(matches!(
        wrong(&|f| f[quad].truncate(3)),
        CheckError::TriangleUnused(_) | CheckError::NotATriangle(_)
    ));
    let mut moved = converted.mesh().clone();
    moved.positions_mut()[3][1] += 1.0;
    assert_eq!(check_mixed(&moved, &mesh).unwrap_err(), CheckError::Moved(3));
}

#[test]
fn both_checks_count_alike_on_closed_surfaces() {
    for seed in 0..300 {
        let mesh = crate::common::face_list(&random_of(seed as usize % 3, 30, Mix::Balanced, seed));
        let quads = Converter::new().run(&mesh).unwrap().into_mesh();
        let closed = triquad::check(&quads, &mesh).unwrap();
        assert_eq!(check_mixed(&quads, &mesh).unwrap().report, closed, "{seed}");
    }
}

// Proofs.

/// A torn mesh with its dual graph, the best matching and the proof.
fn proved(seed: u64) -> (DualGraph, Matching, Proof) {
    let mesh = torn(&random_of(1, 40, Mix::Balanced, seed), seed);
    let mut keep = Keep::default();
    keep.edges = neighbours(&mesh).into_iter().map(|(_, ends)| ends).step_by(3).collect();
    let converter = Converter::new().open(true).keep(keep).strict(seed.is_multiple_of(2));
    let converted = converter.keep_proof(true).run(&mesh).unwrap();
    let matching = check_mixed(converted.mesh(), &mesh).unwrap().matching;
    let proof = converted.proof().unwrap().clone();
    (DualGraph::new(&OpenTriangulation::build(&mesh).unwrap()), matching, proof)
}

#[test]
fn proofs_of_other_matchings_and_barriers_are_refused() {
    for seed in 0..40 {
        let (dual, matching, proof) = proved(seed);
        assert_eq!(proof.verify(&dual, &matching), Ok(()));
        // Any pair less is a worse matching.
        let pair = dual.triangles().find(|&f| matching.is_paired(f)).unwrap();
        let mut fewer = Matching::empty(dual.len());
        for f in dual.triangles().filter(|&f| f != pair) {
            if let Some(g) = matching.mate(f).filter(|&g| f < g && g != pair) {
                fewer.pair(f, g);
            }
        }
        assert!(matches!(proof.verify(&dual, &fewer), Err(ProofError::Certificate(_))));

        let barrier = |nodes| {
            let mut changed = proof.clone();
            changed.barrier = Some(Barrier { nodes });
            changed
        };
        let none = barrier(Vec::new()).verify(&dual, &matching);
        let all = barrier((0..dual.len() as u32).collect()).verify(&dual, &matching);
        let missing = barrier(vec![dual.len() as u32, NONE]).verify(&dual, &matching);
        assert_eq!(all.is_ok(), matching.unpaired_count() == 0, "{seed}");
        assert_eq!(missing, Err(ProofError::Barrier));
        if !proof.barrier.as_ref().unwrap().nodes.is_empty() && none.is_ok() {
            assert_eq!(matching.unpaired_count() % 2, dual.len() % 2);
        }
    }
}

#[test]
fn a_proof_put_together_again_is_the_same() {
    let (dual, matching, proof) = proved(3);
    let again = Proof::new(
        proof.objective.clone(),
        proof.certificate.clone(),
        proof.barrier.clone(),
        &dual,
        &matching,
    );
    assert_eq!(again, proof);
    assert!(!proof.given_up.is_empty());
    assert!(proof.given_up.iter().all(|h| h.triangle() < TriangleId::new(dual.len())));
}

#[test]
fn a_closed_surface_is_converted_alike_whether_open_ones_are_allowed_or_not() {
    let mesh = crate::common::face_list(&random_of(2, 50, Mix::Balanced, 7));
    assert!(Triangulation::build(&mesh).is_ok());
    for algorithm in Algorithm::ALL {
        let run = |open| Converter::new().algorithm(algorithm).open(open).run(&mesh).unwrap();
        assert_eq!(run(true).mesh(), run(false).mesh());
    }
}
