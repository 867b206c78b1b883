//! Irreducible triangulations against brute force, and against what is known of them.

use std::collections::BTreeSet;

use proptest::prelude::*;
use triquad::irreducible::{Contractor, Discipline, Irreducible, Order, ramaswami_siqueira};
use triquad::pairing::LRS_ORDER;
use triquad::random::Random;
use triquad::simplify::Simplifier;
use triquad::triangulation::{HalfEdgeId, LinkMarks, ShrinkingTriangulation, TriangleId, VertexId};
use triquad::{Algorithm, Converter, Expansion, Mesh, Triangulation};
use triquad_generators::box_mesh::{BoxShape, PaperBox, Walls};
use triquad_generators::random::{Mix, random_surface};
use triquad_generators::{Surface, classic, grids, organic, worst_cases};

fn build(surface: &Surface) -> Triangulation {
    Triangulation::build(&crate::common::face_list(surface)).unwrap()
}

/// The corners of all triangles.
fn corners(t: &Triangulation) -> Vec<[u32; 3]> {
    t.triangles().map(|f| t.corners(f).map(|v| v.index() as u32)).collect()
}

fn neighbours(t: &Triangulation) -> Vec<BTreeSet<u32>> {
    let mut neighbours = vec![BTreeSet::new(); t.vertex_id_count()];
    for [a, b, c] in corners(t) {
        for (from, to) in [(a, b), (b, c), (c, a)] {
            neighbours[from as usize].insert(to);
        }
    }
    neighbours
}

/// An edge that could be contracted: its ends have no common neighbours but the two apexes, and it
/// does not belong to a tetrahedron.
fn contractible_edge(t: &Triangulation) -> Option<[u32; 2]> {
    let neighbours = neighbours(t);
    let edges = corners(t).into_iter().flat_map(|[a, b, c]| [[a, b], [b, c], [c, a]]);
    edges.into_iter().find(|ends| {
        let [u, v] = ends.map(|end| &neighbours[end as usize]);
        u.intersection(v).count() == 2 && u.len().max(v.len()) > 3
    })
}

/// Everything that holds for the result of any algorithm on `t`.
fn assert_irreducible(t: &Triangulation, result: &Irreducible, what: &str) {
    let left = &result.triangulation;
    let list = Mesh::from_triangles(vec![[0.0; 3]; result.vertices.len()], corners(left));
    let rebuilt = Triangulation::build(&list).unwrap_or_else(|survey| panic!("{what}: {survey}"));
    assert_eq!(&rebuilt, left, "{what}");
    assert_eq!(left.genus(), t.genus(), "{what}");
    assert_eq!(left.component_count(), t.component_count(), "{what}");
    assert_eq!(contractible_edge(left), None, "{what}");
    assert!(result.vertices.is_sorted() && result.vertices.len() == left.vertex_count(), "{what}");
    assert_eq!(t.vertex_count() - left.vertex_count(), result.contractions, "{what}");
    if t.component_count() == 1 {
        let allowed = match t.genus() {
            0 => 4..=4,
            1 => 7..=10,
            g => 7..=26 * g - 4,
        };
        assert!(allowed.contains(&left.vertex_count()), "{what}: {}", left.vertex_count());
    }
}

/// Makes `surface` irreducible by all methods and orders, and checks what they did.
fn reduce_all(surface: &Surface, seed: u64, what: &str) {
    let t = build(surface);
    for contractor in Contractor::ALL {
        for order in [Order::File, Order::Random] {
            let result = contractor.reduce(t.clone(), order, seed);
            let what = format!("{what}, {contractor}, {order:?}");
            assert_irreducible(&t, &result, &what);
            assert_counts(&t, contractor, &result, &what);
        }
    }
}

fn assert_counts(t: &Triangulation, contractor: Contractor, result: &Irreducible, what: &str) {
    let (tests, repeated) =
        (result.counts.link_condition_tests, result.counts.edges_tested_more_than_once);
    if contractor == Contractor::RamaswamiSiqueira {
        assert_eq!(repeated, 0, "{what}");
        assert!(tests <= t.edge_count(), "{what}: {tests}");
    } else {
        // All edges left were tested, and all that were contracted.
        let left = result.triangulation.edge_count();
        assert!(tests >= result.contractions + left && repeated <= tests / 2, "{what}: {tests}");
    }
    if contractor == Contractor::Schipper && t.genus() == 0 && t.component_count() == 1 {
        // Each edge of the tetrahedron from both ends, and hardly any other.
        assert!((6..=9).contains(&repeated), "{what}: {repeated}");
        assert!((t.vertex_count() + 8..=t.vertex_count() + 40).contains(&tests), "{what}: {tests}");
    }
}

/// Figure 6: sides of the polygon and edges to the apexes, as long as nothing is contracted.
#[test]
fn only_the_edges_of_the_bipyramid_cannot_be_contracted() {
    for m in 4..10 {
        let list = crate::common::face_list(&classic::starred_bipyramid(m));
        let built = Triangulation::build(&list).unwrap();
        assert_eq!((built.vertex_count(), built.genus()), (3 * m as usize + 2, 0));
        let k = ShrinkingTriangulation::from(built.clone());
        let mut marks = LinkMarks::new(built.vertex_count());
        for h in (0..2 * built.edge_count()).map(HalfEdgeId::new) {
            let has_centre =
                [h, h.next()].iter().any(|&h| built.origin(h).index() >= 2 + m as usize);
            assert_eq!(k.is_contractible(h, &mut marks), has_centre, "{m}: {h:?}");
        }
    }
}

#[test]
fn random_surfaces_become_irreducible() {
    for genus in 0..=10 {
        for (mix, seed) in Mix::ALL.into_iter().flat_map(|mix| (0..50).map(move |seed| (mix, seed)))
        {
            let operations = (seed * seed % 91) as usize;
            let surface = crate::common::random_of(genus, operations, mix, seed);
            reduce_all(&surface, seed, &format!("genus {genus}, {mix:?}, seed {seed}"));
        }
    }
}

#[test]
fn special_surfaces_become_irreducible() {
    for (name, surface) in crate::common::special_surfaces() {
        reduce_all(&surface, 1, name);
    }
}

#[test]
fn boxes_become_irreducible() {
    for (cavities, holes, vertices) in [(1, 0, 300), (9, 0, 2000), (0, 9, 2000), (4, 5, 3000)] {
        let surface = BoxShape { cavities, holes, vertices }.surface().unwrap();
        reduce_all(&surface, 2, &format!("{cavities} cavities, {holes} holes"));
    }
    for (shafts, depth, holes) in [(3, 20, 0), (3, 20, 4), (4, 30, 16)] {
        let shape = PaperBox { shafts, depth, holes };
        let surface = shape.surface(Walls::Alternating, &mut |_| 0).unwrap();
        reduce_all(&surface, 2, &format!("{shape:?}"));
    }
}

#[test]
fn every_component_becomes_irreducible() {
    let mut all = classic::tetrahedron();
    for genus in [1, 0, 3, 0, 2] {
        all = crate::common::beside(
            &all,
            &crate::common::random_of(genus, 30, Mix::Balanced, genus as u64),
        );
    }
    let t = build(&all);
    for contractor in Contractor::ALL {
        let result = contractor.reduce(t.clone(), Order::File, 0);
        assert_irreducible(&t, &result, contractor.id());
        let tetrahedra = neighbours(&result.triangulation).iter().filter(|n| n.len() == 3).count();
        assert_eq!(tetrahedra, 4 * 3, "{contractor}");
    }
}

#[test]
fn unreferenced_vertices_do_not_count() {
    let mut surface = grids::torus(5, 6);
    let used = surface.positions.len() as u32;
    surface.positions.extend([[9.0; 3]; 3]);
    // The numbers of used vertices are shifted so that unreferenced ones come first.
    for v in surface.triangles.as_flattened_mut() {
        *v += 2;
    }
    for contractor in Contractor::ALL {
        let t = build(&surface);
        let result = contractor.reduce(t.clone(), Order::Random, 3);
        assert_irreducible(&t, &result, contractor.id());
        let is_used = |v: &VertexId| (2..used as usize + 2).contains(&v.index());
        assert!(result.vertices.iter().all(is_used));
    }
}

// Canonical forms.

/// The least of the codes of the triangulation, which is connected: it is the same exactly for
/// isomorphic ones, mirrored or not.
fn canonical_form(t: &Triangulation) -> Vec<u32> {
    let sides = (0..3 * t.triangle_count()).map(HalfEdgeId::new);
    sides.flat_map(|h| [false, true].map(|mirrored| code(t, h, mirrored))).min().unwrap()
}

/// The vertices of all triangles as a walk across edges, begun at `start`, meets and numbers them.
fn code(t: &Triangulation, start: HalfEdgeId, mirrored: bool) -> Vec<u32> {
    let ends = |h: HalfEdgeId| {
        let ends = [t.origin(h), t.origin(h.next())];
        if mirrored { [ends[1], ends[0]] } else { ends }
    };
    let mut number = vec![None; t.vertex_id_count()];
    let mut count = 0;
    let mut seen = vec![false; t.triangle_count()];
    let mut queue = vec![start];
    let mut code = Vec::new();
    let mut at = 0;
    while let Some(&h) = queue.get(at) {
        at += 1;
        if std::mem::replace(&mut seen[h.triangle().index()], true) {
            continue;
        }
        let [from, to] = ends(h);
        for v in [from, to, t.origin(h.prev())] {
            code.push(*number[v.index()].get_or_insert_with(|| {
                count += 1;
                count
            }));
        }
        let [second, third] = if mirrored { [h.prev(), h.next()] } else { [h.next(), h.prev()] };
        queue.extend([h, second, third].map(|side| t.twin(side)));
    }
    code
}

#[test]
fn tori_end_as_one_of_the_21_of_lavrenchenko() {
    let mut random = Random::stream(5, &["tori"]);
    let mut forms = vec![BTreeSet::new(); 11];
    let mut counts = [0; 11];
    for round in 0..1500 {
        let mix = Mix::ALL[round % 4];
        let operations = random.below(60) as usize;
        let surface = random_surface(1, operations, mix, &mut |bound| random.below(bound));
        let t = build(&surface);
        for contractor in Contractor::ALL {
            let left = contractor.reduce(t.clone(), Order::File, round as u64).triangulation;
            assert!((7..=10).contains(&left.vertex_count()));
            counts[left.vertex_count()] += 1;
            forms[left.vertex_count()].insert(canonical_form(&left));
        }
    }
    let seen: Vec<usize> = (7..=10).map(|n| forms[n].len()).collect();
    println!("irreducible tori of 7 to 10 vertices: {seen:?} distinct, {:?} in all", &counts[7..]);
    assert!(seen.iter().zip([1, 4, 15, 1]).all(|(&seen, all)| seen <= all), "{seen:?}");
    assert!(seen[0] == 1 && seen[1] == 4 && seen[2] > 7, "{seen:?}");
}

#[test]
fn canonical_forms_do_not_depend_on_the_numbering() {
    let mut random = Random::stream(6, &["forms"]);
    let torus = grids::torus(4, 6);
    let mut relabelled = triquad_generators::sculptor::Sculptor::from(&torus);
    relabelled.relabel(&mut |bound| random.below(bound));
    let relabelled = relabelled.into_surface();
    assert_ne!(torus.triangles, relabelled.triangles);
    let mut mirrored = torus.clone();
    mirrored.triangles.iter_mut().for_each(|t| t.swap(0, 1));
    let form = canonical_form(&build(&torus));
    assert_eq!(form, canonical_form(&build(&relabelled)));
    assert_eq!(form, canonical_form(&build(&mirrored)));
    assert_ne!(form, canonical_form(&build(&grids::torus(3, 8))));
}

// Counts.

#[test]
fn schipper_tests_an_edge_again_where_there_are_handles() {
    let repeated = |genus| {
        let t = build(&crate::common::random_of(genus, 2000, Mix::Balanced, 4));
        let result = Contractor::Schipper.reduce(t, Order::File, 0);
        result.counts.edges_tested_more_than_once
    };
    let [few, many] = [10, 40].map(repeated);
    assert!(few >= 10 * 4, "{few}");
    let ratio = many as f64 / few as f64;
    assert!((2.0..8.0).contains(&ratio), "{many} and {few} for four times the genus");
}

#[test]
fn schipper_tests_a_regular_sphere_once() {
    let t = build(&grids::sphere(20));
    let vertices = t.vertex_count();
    let counts = Contractor::Schipper.reduce(t, Order::File, 0).counts;
    assert_eq!(counts.link_condition_tests, vertices + 8);
    assert_eq!(counts.edges_tested_more_than_once, 6);
}

/// The triangulation of Figure 6: two vertices of degree 2m, a ring of m between them, and a vertex
/// in every triangle. Edges of the ring and to the two cannot be contracted at first.
fn figure_6(m: u32) -> Surface {
    let hub = crate::common::hub(m);
    let mut positions = hub.positions;
    let mut triangles = Vec::new();
    for [a, b, c] in hub.triangles {
        let inside = positions.len() as u32;
        positions.push([f64::from(inside), 0.0, f64::from(a)]);
        triangles.extend([[a, b, inside], [b, c, inside], [c, a, inside]]);
    }
    Surface { positions, triangles }
}

/// A walk round a vertex of high degree for each edge at it would take minutes for these.
#[test]
fn high_degrees_and_long_tubes_take_linear_time() {
    let surfaces = [
        ("Figure 6", figure_6(60_000)),
        ("hub", crate::common::hub(150_000)),
        ("tube", grids::torus(50_000, 3)),
        ("ring", grids::torus(3, 50_000)),
    ];
    for (name, surface) in surfaces {
        let t = build(&surface);
        for order in [Order::File, Order::Random] {
            let result = Contractor::RamaswamiSiqueira.reduce(t.clone(), order, 0);
            assert_irreducible(&t, &result, name);
        }
        let result = Contractor::Schipper.reduce(t.clone(), Order::File, 0);
        assert_irreducible(&t, &result, name);
    }
}

/// Link vertices visited by the contraction of `rs`, and by that of `lrs`.
fn link_vertices(mesh: &Mesh) -> [u64; 2] {
    let k = Triangulation::build(mesh).unwrap();
    let all = (0..k.vertex_id_count()).map(VertexId::new);
    let of_rs = Contractor::RamaswamiSiqueira.reduce(k.clone(), Order::File, 0).counts;
    let of_lrs = ramaswami_siqueira(ShrinkingTriangulation::from(k), all, LRS_ORDER).counts;
    [of_rs, of_lrs].map(|counts| counts.link_vertices_visited)
}

/// Meshes of genus n / 16 whose degrees stay low, and a sphere, with their genus.
fn stand_ins() -> impl Iterator<Item = (usize, Mesh)> {
    let mut random = Random::stream(1, &["handles"]);
    [0, 100, 400].into_iter().map(move |genus| {
        let vertices = 6 * genus.max(100);
        let surface = organic::surface(genus, 3 * vertices, &mut |bound| random.below(bound));
        let mut simplifier = Simplifier::new(build(&surface), &surface.positions);
        simplifier.reduce_to(vertices as usize).unwrap();
        let (mesh, triangulation) = simplifier.result();
        let degrees = neighbours(&triangulation).into_iter().map(|around| around.len());
        assert!(degrees.max() < Some(11), "the degrees of {genus} are high");
        (genus as usize, mesh)
    })
}

#[test]
fn high_genus_costs_no_more_than_low_where_degrees_are_low() {
    for (genus, mesh) in stand_ins() {
        let triangles = mesh.faces().len();
        let visited = link_vertices(&mesh);
        assert!(
            visited.iter().all(|&count| count <= 6 * triangles as u64),
            "genus {genus}: {visited:?} for {triangles} triangles"
        );
    }
}

/// The bound O(g² + g n) is reached: each of the 5 g edges at the pole is tested once, from its
/// other end.
#[test]
fn a_vertex_of_degree_5_g_costs_its_degree_for_every_edge_there() {
    for genus in [10, 40, 160] {
        let square = u64::from(5 * genus).pow(2);
        let mesh = crate::common::face_list(&worst_cases::tori_round_a_pole(genus));
        for visited in link_vertices(&mesh) {
            assert!((square / 2..=2 * square).contains(&visited), "genus {genus}: {visited}");
        }
    }
}

/// Of the tori `lrs` leaves all but two triangles. Still, the augmenting paths stay short.
#[test]
fn what_lrs_leaves_at_high_genus_is_paired_in_linear_work() {
    let tori = [30, 120, 480].map(|genus| {
        let surface = worst_cases::tori_round_a_pole(genus);
        (genus as usize, crate::common::face_list(&surface))
    });
    for (genus, mesh) in stand_ins().chain(tori) {
        for expansion in Expansion::ALL {
            let mut converter = Converter::new().algorithm(Algorithm::Lrs(expansion));
            let report = converter.run(&mesh).unwrap().report().clone();
            let triangles = mesh.faces().len();
            assert_eq!((report.triangles, report.genus), (triangles, genus));
            let visited = report.paths.triangles_visited;
            assert!(visited <= 3 * triangles, "genus {genus}: {visited} of {triangles}");
        }
    }
}

// Reproducibility.

#[test]
fn the_seed_decides_what_is_left() {
    let t = build(&crate::common::random_of(3, 200, Mix::Balanced, 8));
    let run = |contractor: Contractor, order, seed| {
        let result = contractor.reduce(t.clone(), order, seed);
        (result.vertices, corners(&result.triangulation), result.counts)
    };
    for contractor in Contractor::ALL {
        for order in [Order::File, Order::Random] {
            assert_eq!(run(contractor, order, 5), run(contractor, order, 5));
            let is_random = contractor != Contractor::RamaswamiSiqueira || order == Order::Random;
            assert_eq!(
                run(contractor, order, 5) != run(contractor, order, 6),
                is_random,
                "{contractor}"
            );
        }
    }
}

/// A fixed example: a change here is a change of the published numbers.
#[test]
fn counts_are_what_they_were() {
    let t = build(&crate::common::random_of(2, 300, Mix::Balanced, 1));
    let counts = Contractor::ALL.map(|contractor| {
        let result = contractor.reduce(t.clone(), Order::File, 0);
        let counts = result.counts;
        (counts.link_condition_tests, counts.edges_tested_more_than_once, result.vertices.len())
    });
    assert_eq!(counts, [(127, 0, 13), (239, 39, 11), (365, 46, 13)]);
}

// What expansion needs of RS.

fn state(k: &ShrinkingTriangulation) -> Vec<(VertexId, HalfEdgeId)> {
    (0..k.half_edge_id_count()).map(HalfEdgeId::new).map(|h| (k.origin(h), k.twin(h))).collect()
}

/// Runs RS, and splits all the way back.
fn contract_and_expand(surface: &Surface, discipline: Discipline) -> usize {
    let t = build(surface);
    let all = (0..t.vertex_id_count()).map(VertexId::new);
    let k = ShrinkingTriangulation::from(t.clone());
    let before = state(&k);
    let reduction = ramaswami_siqueira(k, all, discipline);
    let mut k = reduction.triangulation;
    let alive = |k: &ShrinkingTriangulation| {
        (0..t.triangle_count()).filter(|&f| k.is_alive(TriangleId::new(f))).count()
    };
    assert_eq!(alive(&k) + 2 * reduction.splits.len(), t.triangle_count());
    for receipt in reduction.splits.into_iter().rev() {
        k.split(receipt);
    }
    assert_eq!(alive(&k), t.triangle_count());
    assert_eq!(state(&k), before);
    reduction.counts.link_condition_tests
}

#[test]
fn receipts_lead_all_the_way_back() {
    let mut tests = [0; 2];
    for (_, surface) in crate::common::many_surfaces(20) {
        let disciplines = [Discipline::FirstInFirstOut, Discipline::LastInFirstOut];
        for (sum, discipline) in tests.iter_mut().zip(disciplines) {
            *sum += contract_and_expand(&surface, discipline);
        }
    }
    assert!(tests[0] < tests[1], "degree 3 first saves tests: {tests:?}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn sculpted_surfaces_become_irreducible(surface in crate::common::sculpted_surface(), seed: u64) {
        reduce_all(&surface, seed, "sculpted");
    }
}
