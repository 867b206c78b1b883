//! Building triangulations: what is valid is accepted, and a mutated mesh is refused by the right
//! law.

use std::collections::HashMap;

use proptest::prelude::*;
use triquad::mesh::{Faces, Mesh};
use triquad::{ConvertError, Converter, Element, Law, Survey, Triangulation};
use triquad_generators::{Surface, classic, grids};

fn laws(list: &Mesh) -> Vec<Law> {
    Triangulation::build(list)
        .unwrap_err()
        .violations
        .iter()
        .map(|violation| violation.law)
        .collect()
}

fn survey(list: &Mesh) -> Survey {
    *Triangulation::build(list).unwrap_err()
}

fn first(list: &Mesh) -> (Law, Element, usize) {
    let violation = survey(list).violations.swap_remove(0);
    (violation.law, violation.element, violation.count)
}

fn count(survey: &Survey, law: Law) -> usize {
    survey
        .violations
        .iter()
        .find(|violation| violation.law == law)
        .map_or(0, |violation| violation.count)
}

/// Twins, fans and counts by hash maps, to compare the triangulation with.
fn assert_right(triangulation: &Triangulation, surface: &Surface) {
    let mut leads: HashMap<(u32, u32), usize> = HashMap::new();
    for (f, &[a, b, c]) in surface.triangles.iter().enumerate() {
        for (i, edge) in [(a, b), (b, c), (c, a)].into_iter().enumerate() {
            assert_eq!(leads.insert(edge, 3 * f + i), None);
        }
    }
    for f in triangulation.triangles() {
        let corners = surface.triangles[usize_of(f)];
        for (i, h) in f.half_edges().into_iter().enumerate() {
            let (from, to) = (corners[i], corners[(i + 1) % 3]);
            let twin = triangulation.twin(h);
            assert_eq!(leads[&(to, from)], triquad::triangulation::Id::index(twin));
            assert_eq!(
                (triangulation.twin(twin), triangulation.origin(twin)),
                (h, triangulation.origin(h.next()))
            );
        }
    }
    assert_eq!(triangulation.edge_count(), leads.len() / 2);
    assert_eq!(triangulation.triangle_count(), surface.triangles.len());
}

fn usize_of(id: impl triquad::triangulation::Id) -> usize {
    id.index()
}

/// A bow-tie: the last vertex of one surface is also the first of the other.
fn bow_tie() -> Mesh {
    let (one, other) = (classic::octahedron(), classic::tetrahedron());
    let shared = one.positions.len() as u32 - 1;
    let mut both = one;
    both.positions.extend(other.positions[1..].iter().map(|p| p.map(|x| x + 5.0)));
    both.triangles.extend(other.triangles.iter().map(|t| t.map(|v| v + shared)));
    crate::common::face_list(&both)
}

#[test]
fn many_random_surfaces_are_accepted_and_right() {
    for (genus, surface) in crate::common::many_surfaces(100) {
        let list = crate::common::face_list(&surface);
        let triangulation = Triangulation::build(&list).unwrap();
        assert_right(&triangulation, &surface);
        assert_eq!((triangulation.genus(), triangulation.component_count()), (genus, 1));
        let survey = Survey::new(&list);
        assert_eq!((survey.violations.len(), survey.genus()), (0, Some(genus)));
        assert!(survey.closed && survey.orientable && survey.faces_to_flip.is_empty());
    }
}

#[test]
fn special_surfaces_are_accepted() {
    for (name, surface) in crate::common::special_surfaces() {
        let triangulation = Triangulation::build(&crate::common::face_list(&surface)).expect(name);
        assert_right(&triangulation, &surface);
        let expected = match name {
            "two components" => (2, 1),
            "tetrahedra" => (2, 0),
            "tori round a pole" => (1, 9),
            "long thin tube" => (1, 1),
            _ if name.ends_with("torus") => (1, 1),
            _ => (1, 0),
        };
        assert_eq!((triangulation.component_count(), triangulation.genus()), expected, "{name}");
    }
}

#[test]
fn unreferenced_vertices_do_not_count() {
    let octahedron = crate::common::face_list(&classic::octahedron());
    let more = [octahedron.positions(), &[[9.0; 3], [f64::MAX; 3]]].concat();
    let list = Mesh::new(more, octahedron.faces().clone());
    let triangulation = Triangulation::build(&list).unwrap();
    assert_eq!(triangulation.vertex_count(), 6);
    assert_eq!(
        (triangulation.unreferenced_vertex_count(), triangulation.vertex_id_count()),
        (2, 8)
    );
    assert_eq!((triangulation.euler_characteristic(), triangulation.genus()), (2, 0));
}

#[test]
fn nothing_is_no_mesh() {
    assert_eq!(first(&Mesh::default()), (Law::NotEmpty, Element::Mesh, 1));
    let only_points = Mesh::new(vec![[0.0; 3]; 3], Faces::default());
    assert_eq!(laws(&only_points), [Law::NotEmpty]);
}

#[test]
fn non_orientable_surfaces_are_told_from_badly_oriented_ones() {
    for surface in [classic::projective_plane(), classic::klein_bottle(5, 4)] {
        let survey = survey(&crate::common::face_list(&surface));
        assert_eq!(survey.violations[0].law, Law::Orientable);
        assert!(!survey.orientable && survey.closed && survey.genus().is_none());
        assert_eq!(count(&survey, Law::ConsistentOrientation), 0, "flipping would not help");
    }
    let strip = survey(&crate::common::face_list(&classic::moebius_strip(7)));
    assert_eq!(strip.violations[0].law, Law::NoBoundary);
    assert_eq!((strip.boundary_loops, strip.orientable, strip.closed), (1, false, false));
    assert_eq!(strip.euler_characteristic, 0);
}

#[test]
fn a_bow_tie_is_named_by_its_vertex() {
    let list = bow_tie();
    assert_eq!(first(&list), (Law::OneFan, Element::Vertex(5), 1));
    assert_eq!(survey(&list).components, 1);
}

#[test]
fn a_doubled_sheet_is_no_triangulation() {
    let positions = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let list = Mesh::from_triangles(positions, vec![[0, 1, 2], [0, 2, 1]]);
    assert_eq!(laws(&list), [Law::DistinctFaces]);
}

#[test]
fn an_edge_shared_by_two_surfaces_is_overfull() {
    // Two tetrahedra on the edge 0-1, and an edge doubled within one sheet: both have four faces.
    let tetrahedron = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
    let other = tetrahedron.map(|t: [u32; 3]| t.map(|v| if v < 2 { v } else { v + 2 }));
    let positions = (0..6).map(|i| [f64::from(i), f64::from(i * i), 0.0]).collect();
    let list = Mesh::from_triangles(positions, [tetrahedron, other].concat());
    assert_eq!(first(&list), (Law::AtMostTwoFaces, Element::Edge(0, 1), 1));
}

/// An edge or vertex alone does not say which faces to mend.
#[test]
fn faces_at_the_broken_place_are_named_as_in_the_file() {
    let tetrahedron = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
    let with = |faces: &[[u32; 3]]| {
        let positions = (0..20).map(|i| [f64::from(i), f64::from(i * i), 0.0]).collect();
        Mesh::from_triangles(positions, faces.to_vec())
    };
    let broken = |faces: &[[u32; 3]]| survey(&with(faces)).violations.swap_remove(0);
    let glued = |at: [u32; 4]| {
        [&tetrahedron[..], &tetrahedron.map(|t| t.map(|v: u32| at[v as usize]))].concat()
    };

    let overfull = broken(&glued([0, 1, 4, 5]));
    assert_eq!((overfull.law, &overfull.faces[..]), (Law::AtMostTwoFaces, &[0, 1, 4, 5][..]));
    let told = "edge 1-2 belongs to more than two faces (faces 1, 2, 5 and 6)";
    assert_eq!(overfull.to_string(), told);
    let bow_tie = broken(&glued([3, 4, 5, 6]));
    assert_eq!((bow_tie.law, &bow_tie.faces[..]), (Law::OneFan, &[1, 4][..]));
    assert!(bow_tie.to_string().ends_with("fans of faces (one face of each: 2 and 5)"));
    let mut turned = tetrahedron;
    turned[0].reverse();
    let turned = broken(&turned);
    assert_eq!((turned.law, &turned.faces[..]), (Law::ConsistentOrientation, &[0, 2][..]));
    assert!(turned.to_string().ends_with(" (faces 1 and 3; first of 3)"), "{turned}");
    let open = broken(&tetrahedron[..3]);
    assert_eq!((open.law, &open.faces[..]), (Law::NoBoundary, &[0][..]));
    let twice = broken(&[&tetrahedron[..], &[[3, 1, 2]]].concat());
    assert_eq!(
        (twice.law, twice.element, &twice.faces[..]),
        (Law::DistinctFaces, Element::Face(4), &[2][..])
    );
    let strip = [[0, 1, 2], [1, 3, 2], [2, 3, 4], [3, 5, 4], [4, 5, 1], [5, 0, 1]];
    let violations = survey(&with(&strip)).violations;
    let strip = violations.iter().find(|found| found.law == Law::Orientable).unwrap();
    assert_eq!(strip.faces.len(), 2);

    // A book of many pages: the rest is counted. What was cut before does not shift the names.
    let pages: Vec<[u32; 3]> = (2..14).map(|page| [0, 1, page]).collect();
    let many = broken(&pages);
    assert!(many.to_string().ends_with("(faces 1, 2, 3, 4, 5, 6, 7, 8 and 4 more)"), "{many}");
    let (positions, _) = with(&[]).into_parts();
    let mut faces = Faces::default();
    faces.push(&[7, 8, 9, 10]);
    faces.extend(glued([0, 1, 4, 5]));
    let mut cut = Mesh::new(positions, faces);
    cut.triangulate().unwrap();
    assert_eq!(survey(&cut).violations[0].faces, [1, 2, 5, 6]);
}

#[test]
fn polygons_are_surveyed_as_they_are() {
    let cube: [[u32; 4]; 6] =
        [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];
    let mut list = Mesh::new(vec![[0.0; 3]; 8], Faces::from_iter(cube));
    let survey = survey(&list);
    assert_eq!((survey.violations.len(), survey.violations[0].law), (1, Law::Triangle));
    assert_eq!(survey.violations[0].count, 6);
    assert_eq!((survey.edges, survey.euler_characteristic, survey.genus()), (12, 2, Some(0)));
    list.triangulate().unwrap();
    assert_eq!(Triangulation::build(&list).unwrap().genus(), 0);
}

#[test]
fn all_broken_laws_are_listed_the_most_basic_first() {
    let (mut positions, mut faces) = crate::common::face_list(&grids::sphere(3)).into_parts();
    positions[4][1] = f64::NAN;
    faces.extend([[0, 1, 999], [0, 1, 1]]);
    faces.push(&[0, 1, 2, 3]);
    let list = Mesh::new(positions, faces);
    let found = laws(&list);
    assert!(found.is_sorted(), "{found:?}");
    let basic = [Law::IndexInRange, Law::FiniteCoordinate, Law::Triangle, Law::DistinctCorners];
    assert_eq!(found[..4], basic);
}

#[test]
fn a_large_irregular_mesh_is_oriented_with_the_fewest_flips() {
    let mut list = crate::common::face_list(&grids::torus(40, 30));
    let wrong: Vec<usize> = (0..list.faces().len()).filter(|face| face % 7 == 3).collect();
    wrong.iter().for_each(|&face| list.reverse_face(face));
    let survey = survey(&list);
    assert!(survey.only_orientation_is_wrong());
    assert_eq!(survey.faces_to_flip, wrong);
    let triangulation = Triangulation::build_oriented(&mut list).unwrap();
    assert_eq!(triangulation.genus(), 1);
    let whole = crate::common::face_list(&grids::torus(40, 30));
    assert_eq!((list.positions(), list.faces()), (whole.positions(), whole.faces()));
    assert_ne!(list.repairs(), whole.repairs(), "faces that were turned are counted");
}

/// Flipping faces mends one law of several.
#[test]
fn a_refusal_after_flipping_faces_is_about_the_flipped_mesh() {
    let mut list = crate::common::face_list(&grids::torus(5, 4));
    list.reverse_face(7);
    let corners: Vec<[u32; 3]> = list.faces().iter().map(|f| [f[0], f[1], f[2]]).collect();
    let fin = [corners[20][0], corners[20][1], 20];
    let positions = [list.positions(), &[[9.0; 3]]].concat();
    let list = Mesh::from_triangles(positions, [&corners[..], &[fin]].concat());
    let given = laws(&list);
    assert!(given.contains(&Law::AtMostTwoFaces) && given.contains(&Law::ConsistentOrientation));
    let mut flipped = list.clone();
    let survey = Triangulation::build_oriented(&mut flipped).unwrap_err();
    assert_eq!(*survey, Survey::new(&flipped));
    assert_eq!(survey.violations.len(), given.len() - 1);
    for open in [false, true] {
        let error = Converter::new().orient(true).open(open).run(&list).unwrap_err();
        let ConvertError::Refused(refused) = error else { panic!("{error}") };
        assert_eq!(refused.violations.len(), survey.violations.len(), "open: {open}");
    }
}

/// A change to a valid mesh and the first law that it breaks.
#[derive(Clone, Debug)]
enum Mutation {
    DropFace(usize),
    DoubleFace(usize),
    DoubleFaceReversed(usize),
    FlipFace(usize),
    IndexOut(usize, usize),
    RepeatCorner(usize),
    SpoilCoordinate(usize, usize, bool),
    AddCorner(usize),
}

fn mutation() -> impl Strategy<Value = Mutation> {
    use Mutation::{
        AddCorner, DoubleFace, DoubleFaceReversed, DropFace, FlipFace, IndexOut, RepeatCorner,
        SpoilCoordinate,
    };
    let index = || any::<usize>();
    prop_oneof![
        index().prop_map(DropFace),
        index().prop_map(DoubleFace),
        index().prop_map(DoubleFaceReversed),
        index().prop_map(FlipFace),
        (index(), 0..5usize).prop_map(|(face, beyond)| IndexOut(face, beyond)),
        index().prop_map(RepeatCorner),
        (index(), 0..3usize, any::<bool>())
            .prop_map(|(v, axis, nan)| SpoilCoordinate(v, axis, nan)),
        index().prop_map(AddCorner),
    ]
}

/// Applies `mutation` to a mesh; the law it breaks first, where, and how often.
fn apply(
    mutation: &Mutation,
    surface: &mut Surface,
) -> (Mesh, Law, Option<Element>, Option<usize>) {
    let (faces, vertices) = (surface.triangles.len(), surface.positions.len());
    let triangles = &mut surface.triangles;
    let mut extra = None;
    let (law, element, count) = match *mutation {
        Mutation::DropFace(face) => {
            triangles.remove(face % faces);
            (Law::NoBoundary, None, Some(3))
        }
        Mutation::DoubleFace(face) => {
            triangles.push(triangles[face % faces]);
            (Law::DistinctFaces, Some(Element::Face(faces)), Some(1))
        }
        Mutation::DoubleFaceReversed(face) => {
            let [a, b, c] = triangles[face % faces];
            triangles.insert(0, [b, a, c]);
            (Law::DistinctFaces, Some(Element::Face(face % faces + 1)), Some(1))
        }
        Mutation::FlipFace(face) => {
            triangles[face % faces].swap(0, 2);
            (Law::ConsistentOrientation, None, Some(3))
        }
        Mutation::IndexOut(face, beyond) => {
            triangles[face % faces][beyond % 3] = (vertices + beyond) as u32;
            (Law::IndexInRange, Some(Element::Face(face % faces)), Some(1))
        }
        Mutation::RepeatCorner(face) => {
            triangles[face % faces][2] = triangles[face % faces][0];
            (Law::DistinctCorners, Some(Element::Face(face % faces)), Some(1))
        }
        Mutation::SpoilCoordinate(v, axis, nan) => {
            surface.positions[v % vertices][axis] = if nan { f64::NAN } else { f64::NEG_INFINITY };
            (Law::FiniteCoordinate, Some(Element::Vertex((v % vertices) as u32)), Some(1))
        }
        Mutation::AddCorner(face) => {
            let [a, b, c] = triangles[face % faces];
            extra = (0..vertices as u32).find(|v| ![a, b, c].contains(v)).map(|v| [a, b, c, v]);
            (Law::Triangle, Some(Element::Face(faces)), Some(1))
        }
    };
    let (positions, mut faces) = crate::common::face_list(surface).into_parts();
    faces.extend(extra);
    (Mesh::new(positions, faces), law, element, count)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]

    #[test]
    fn a_mutated_mesh_breaks_the_right_law(surface in crate::common::sculpted_surface(), mutation in mutation()) {
        let mut surface = surface;
        let (list, law, element, count) = apply(&mutation, &mut surface);
        let violation = survey(&list).violations.swap_remove(0);
        prop_assert_eq!(violation.law, law);
        prop_assert_eq!(Some(violation.element), element.or(Some(violation.element)));
        prop_assert_eq!(Some(violation.count), count);
    }

    #[test]
    fn gluing_two_vertices_makes_a_bow_tie_or_an_overfull_edge(
        surface in crate::common::sculpted_surface(),
        (one, other) in (any::<prop::sample::Index>(), any::<prop::sample::Index>()),
    ) {
        let vertices = surface.positions.len();
        let one = one.index(vertices) as u32;
        let around = |v: u32| {
            let touching = surface.triangles.iter().filter(move |t| t.contains(&v));
            touching.flatten().copied().filter(|&w| w != v).collect::<std::collections::HashSet<_>>()
        };
        let strangers: Vec<u32> =
            (0..vertices as u32).filter(|v| *v != one && !around(one).contains(v)).collect();
        if strangers.is_empty() {
            return Ok(());
        }
        let other = strangers[other.index(strangers.len())];
        let apart = around(one).is_disjoint(&around(other));
        let glue = |v: u32| if v == other { one } else { v };
        let glued = surface.triangles.iter().map(|t| t.map(glue)).collect();
        let list = Mesh::from_triangles(surface.positions.clone(), glued);
        let found = survey(&list).violations.swap_remove(0);
        if apart {
            prop_assert_eq!((found.law, found.element, found.count), (Law::OneFan, Element::Vertex(one), 1));
        } else {
            prop_assert!(matches!(found.law, Law::AtMostTwoFaces | Law::DistinctFaces));
        }
    }

    #[test]
    fn what_is_built_is_right(surface in crate::common::sculpted_surface()) {
        let triangulation = Triangulation::build(&crate::common::face_list(&surface)).unwrap();
        assert_right(&triangulation, &surface);
    }

    #[test]
    fn any_faces_are_judged_alike_by_both_ways(
        triangles in prop::collection::vec(prop::array::uniform3(0u32..7), 1..16),
    ) {
        // The quick builder and the exhaustive survey must agree on what is a triangulation.
        let list = Mesh::from_triangles(vec![[0.0; 3]; 7], triangles);
        let survey = Survey::new(&list);
        prop_assert_eq!(Triangulation::build(&list).is_ok(), survey.violations.is_empty());
    }
}
