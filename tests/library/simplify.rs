//! Simplification against brute force: exact counts, the same surface, and giving up only when no
//! edge can be contracted at all.

use std::collections::HashMap;

use crate::common::{beside, face_list, special_surfaces};
use proptest::prelude::*;
use triquad::Triangulation;
use triquad::mesh::{Format, Mesh};
use triquad::simplify::{Rule, Shape, Simplifier, SimplifyError};
use triquad_generators::box_mesh::BoxShape;
use triquad_generators::{Surface, classic, grids};

fn simplifier(surface: &Surface) -> Simplifier {
    simplifier_by(Rule::Guarded, surface)
}

fn simplifier_by(rule: Rule, surface: &Surface) -> Simplifier {
    let list = face_list(surface);
    Simplifier::with_rule(Triangulation::build(&list).unwrap(), list.positions(), rule)
}

fn reduced(surface: &Surface, vertices: usize) -> Mesh {
    let mut simplifier = simplifier(surface);
    simplifier.reduce_to(vertices).unwrap();
    simplifier.result().0
}

fn bytes(list: &Mesh) -> Vec<u8> {
    let mut bytes = Vec::new();
    list.write_to(&mut bytes, Format::Obj).unwrap();
    bytes
}

/// The result as it is rebuilt from its faces alone; it must be what the simplifier says it is.
fn rebuilt(simplifier: &Simplifier) -> (Mesh, Triangulation) {
    let (list, told) = simplifier.result();
    let built = Triangulation::build(&list).expect("the result is a triangulation");
    assert_eq!(built.vertex_count(), simplifier.vertex_count());
    assert_eq!(built.vertex_count(), list.positions().len());
    assert_eq!(built, told);
    (list, built)
}

/// Whether some edge can be contracted: tried on the list of faces.
fn some_edge_is_contractible(list: &Mesh) -> bool {
    let triangles: Vec<[u32; 3]> = list.faces().iter().map(|f| f.try_into().unwrap()).collect();
    let sides = triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    sides.filter(|[u, v]| u < v).any(|[u, v]| {
        let moved = triangles.iter().map(|t| t.map(|w| if w == v { u } else { w }));
        let left = moved.filter(|[a, b, c]| a != b && b != c && c != a).collect();
        Triangulation::build(&Mesh::from_triangles(list.positions().to_vec(), left)).is_ok()
    })
}

/// Reduces by `step` vertices at a time until topology forbids more; returns what is then left.
fn exhaust(surface: &Surface, step: usize, what: &str) -> usize {
    exhaust_by(Rule::Guarded, surface, step, what)
}

fn exhaust_by(rule: Rule, surface: &Surface, step: usize, what: &str) -> usize {
    let mut simplifier = simplifier_by(rule, surface);
    let (_, input) = rebuilt(&simplifier);
    for wanted in (1..=input.vertex_count()).rev().step_by(step).chain([0]) {
        let outcome = simplifier.reduce_to(wanted);
        let reached = simplifier.vertex_count();
        let (list, left) = rebuilt(&simplifier);
        assert_eq!(left.genus(), input.genus(), "{what}");
        assert_eq!(left.component_count(), input.component_count(), "{what}");
        if outcome == Ok(()) {
            assert_eq!(reached, wanted, "{what}");
            continue;
        }
        assert_eq!(outcome, Err(SimplifyError::Irreducible { wanted, reached }), "{what}");
        assert!(reached > wanted && !some_edge_is_contractible(&list), "{what}: {reached} left");
        if input.genus() == 0 {
            assert_eq!(reached, 4 * input.component_count(), "{what}");
        }
        return reached;
    }
    unreachable!("no surface has 0 vertices")
}

#[test]
fn every_target_is_met_or_forbidden_by_topology() {
    for (i, (genus, surface)) in crate::common::many_surfaces(12).enumerate() {
        exhaust(&surface, 1, &format!("surface {i} of genus {genus}"));
        exhaust_by(Rule::Plain, &surface, 1, &format!("surface {i} of genus {genus}, plainly"));
    }
}

#[test]
fn special_surfaces_are_reduced_as_far_as_they_go() {
    for (name, surface) in special_surfaces() {
        let step = 1 + surface.positions.len() / 100;
        let reached = exhaust(&surface, step, name);
        let expected = match name {
            "seven-vertex torus" => Some(7),
            "two components" => None,
            "tetrahedra" => Some(8),
            "long thin tube" | "tori round a pole" => None,
            _ if name.ends_with("torus") => None,
            _ => Some(4),
        };
        assert!(expected.is_none_or(|expected| reached == expected), "{name}: {reached} left");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn sculpted_surfaces_are_reduced_as_far_as_they_go(surface in crate::common::sculpted_surface()) {
        exhaust(&surface, 1, "sculpted surface");
    }
}

/// Ends of edges only, and flat faces without any error: a cube keeps its corners to the last.
#[test]
fn plain_simplification_moves_no_vertex_and_keeps_corners_longest() {
    let cube = BoxShape { cavities: 0, holes: 0, vertices: 1000 }.surface().unwrap();
    let mut simplifier = simplifier_by(Rule::Plain, &cube);
    for vertices in [500, 200] {
        simplifier.reduce_to(vertices).unwrap();
        let (left, _) = rebuilt(&simplifier);
        assert!(left.positions().iter().all(|place| cube.positions.contains(place)));
        let corners = left.positions().iter().filter(|place| {
            [0, 1, 2].iter().all(|&axis| place[axis] == 0.0 || place[axis] == [2.0, 2.0, 1.0][axis])
        });
        assert_eq!(corners.count(), 8, "{vertices}");
    }
}

#[test]
fn more_vertices_than_there_are_is_an_error() {
    let mut simplifier = simplifier(&grids::sphere(3));
    let error = Err(SimplifyError::TooMany { wanted: 39, present: 38 });
    assert_eq!(simplifier.reduce_to(39), error);
    assert_eq!(simplifier.reduce_to(38), Ok(()));
    assert_eq!(rebuilt(&simplifier).0, face_list(&grids::sphere(3)));
    assert_eq!(simplifier.reduce_to(20), Ok(()));
    assert!(simplifier.reduce_to(21).is_err());
}

#[test]
fn vertices_in_no_triangle_are_left_out_and_not_counted() {
    let mut surface = grids::sphere(3);
    surface.positions.insert(0, [100.0; 3]);
    surface.triangles.iter_mut().flatten().for_each(|v| *v += 1);
    surface.positions.push([-7.0; 3]);
    let mut simplifier = simplifier(&surface);
    assert_eq!(simplifier.vertex_count(), 38);
    assert_eq!(rebuilt(&simplifier).0, face_list(&grids::sphere(3)));
    simplifier.reduce_to(11).unwrap();
    assert!(rebuilt(&simplifier).0.positions().iter().flatten().all(|x| x.abs() < 1.1));
}

// The same every time.

#[test]
fn stops_on_the_way_change_nothing() {
    let surface = grids::torus(40, 30);
    let mut in_steps = simplifier(&surface);
    for vertices in [1000, 999, 500, 130, 60] {
        in_steps.reduce_to(vertices).unwrap();
        assert_eq!(bytes(&in_steps.result().0), bytes(&reduced(&surface, vertices)));
    }
}

/// Fowler, Noll and Vo's hash (FNV-1a).
fn hash(bytes: &[u8]) -> u64 {
    let step = |hash: u64, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, step)
}

/// Not to be changed lightly: meshes of published results are made by this.
#[test]
fn the_bytes_are_the_same_on_every_machine() {
    let hashes = [grids::sphere(20), grids::torus(40, 30), cube(12)]
        .map(|surface| hash(&bytes(&reduced(&surface, surface.positions.len() / 5))));
    let expected = [0x469a_7fba_8de5_905b, 0x2156_e99f_0590_b325, 0x9e11_e54f_e321_7997];
    assert_eq!(hashes, expected, "{hashes:x?}");
}

#[test]
fn scaling_by_a_power_of_two_scales_the_result() {
    let surface = grids::torus(20, 15);
    let expected = reduced(&surface, 70);
    for factor in [2f64.powi(-300), 0.25, 2f64.powi(400)] {
        let mut scaled = surface.clone();
        scaled.positions.as_flattened_mut().iter_mut().for_each(|x| *x *= factor);
        let mut result = reduced(&scaled, 70);
        result.positions_mut().as_flattened_mut().iter_mut().for_each(|x| *x /= factor);
        assert_eq!(result, expected);
    }
}

// Geometry.

/// The surface of the cube [0, n]³ with unit squares cut into triangles.
fn cube(n: i32) -> Surface {
    let (mut names, mut positions, mut triangles) = (HashMap::new(), Vec::new(), Vec::new());
    let mut name = |p: [i32; 3]| {
        *names.entry(p).or_insert_with(|| {
            positions.push(p.map(f64::from));
            positions.len() as u32 - 1
        })
    };
    for axis in 0..3 {
        for side in [0, n] {
            for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
                let mut corner = |di, dj| {
                    let mut p = [side; 3];
                    p[(axis + 1) % 3] = i + di;
                    p[(axis + 2) % 3] = j + dj;
                    name(p)
                };
                let [a, b, c, d] = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
                let outward = [[a, b, c], [a, c, d]];
                triangles.extend(if side == n {
                    outward
                } else {
                    outward.map(|[p, q, r]| [p, r, q])
                });
            }
        }
    }
    Surface { positions, triangles }
}

fn volume(list: &Mesh) -> f64 {
    let of = |face: &[u32]| {
        let [p, q, r] = [0, 1, 2].map(|k| list.positions()[face[k] as usize]);
        p[0] * (q[1] * r[2] - q[2] * r[1])
            + p[1] * (q[2] * r[0] - q[0] * r[2])
            + p[2] * (q[0] * r[1] - q[1] * r[0])
    };
    list.faces().iter().map(of).sum::<f64>() / 6.0
}

fn turned(mut surface: Surface) -> Surface {
    // An orthogonal matrix of rational numbers, and a shift.
    let rows = [[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]];
    for p in &mut surface.positions {
        *p = rows.map(|row: [f64; 3]| row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + 3.0);
    }
    surface
}

#[test]
fn a_cube_stays_a_cube_down_to_its_corners() {
    for (surface, tolerance) in [(cube(16), 0.0), (turned(cube(16)), 1e-9)] {
        let mut simplifier = simplifier(&surface);
        for vertices in [1000, 300, 100, 50, 20, 12, 9, 8] {
            simplifier.reduce_to(vertices).unwrap();
            let error = (volume(&rebuilt(&simplifier).0) - 4096.0).abs();
            assert!(error <= tolerance, "{vertices} vertices: the volume is off by {error:e}");
        }
        simplifier.reduce_to(4).unwrap();
        assert!((volume(&rebuilt(&simplifier).0) - 4096.0).abs() > 1.0);
    }
}

#[test]
fn large_grids_keep_small_degrees_and_decent_triangles() {
    let kinds =
        [("torus", grids::torus(300, 200)), ("sphere", grids::sphere(120)), ("cube", cube(80))];
    for (name, surface) in kinds {
        let n = surface.positions.len();
        let mut simplifier = simplifier(&surface);
        for vertices in [n / 2, n / 10, n / 50] {
            simplifier.reduce_to(vertices).unwrap();
            let (list, _) = rebuilt(&simplifier);
            let shape = Shape::new(&list);
            let what = format!("{name} of {vertices} vertices: {shape:?}");
            assert!(shape.largest_degree <= 9, "{what}");
            assert!(shape.smallest_angle() > 8.0 && shape.largest_angle() < 155.0, "{what}");
        }
    }
}

/// What Lemos et al. (section 4) say of A2 to A5: regular connectivity is not preserved.
#[test]
fn a_simplified_grid_is_not_regular() {
    let surface = grids::torus(100, 80);
    let irregular_percent = |vertices| {
        let list = reduced(&surface, vertices);
        let mut degrees = vec![0; vertices];
        list.faces().corners().iter().for_each(|&v| degrees[v as usize] += 1);
        100 * degrees.iter().filter(|&&degree| degree != 6).count() / vertices
    };
    let percents = [8000, 6000, 4000].map(irregular_percent);
    assert!(percents[0] == 0 && percents[1] >= 20 && percents[2] >= 40, "{percents:?}");
}

#[test]
fn a_sphere_stays_round() {
    let mut simplifier = simplifier(&grids::sphere(60));
    for (vertices, tolerance) in [(7200, 3e-4), (1440, 2e-3), (288, 1.2e-2)] {
        simplifier.reduce_to(vertices).unwrap();
        let (list, triangulation) = rebuilt(&simplifier);
        let length = |p: [f64; 3]| p.iter().map(|x| x * x).sum::<f64>().sqrt();
        let centroid = |f| {
            let corners = triangulation
                .corners(f)
                .map(|v| list.positions()[triquad::triangulation::Id::index(v)]);
            std::array::from_fn(|k| corners.iter().map(|p| p[k]).sum::<f64>() / 3.0)
        };
        let off = |p| (length(p) - 1.0).abs();
        let at_vertices = list.positions().iter().map(|&p| off(p)).fold(0.0, f64::max);
        let at_centroids = triangulation.triangles().map(|f| off(centroid(f))).fold(0.0, f64::max);
        let what = format!("{vertices} vertices: off by {at_vertices}, {at_centroids}");
        assert!(at_vertices < tolerance && at_centroids < 4.0 * tolerance, "{what}");
    }
}

#[test]
fn places_without_extent_or_beyond_measure_are_no_obstacle() {
    let flat = |p: [f64; 3]| [p[0], 0.0, 0.0];
    let point = |_| [1.0, 2.0, 3.0];
    let huge = |p: [f64; 3]| p.map(|x| if x > 0.0 { f64::MAX } else { f64::MIN });
    for place in [flat as fn([f64; 3]) -> [f64; 3], point, huge] {
        let mut surface = beside(&grids::sphere(6), &classic::octahedron());
        surface.positions.iter_mut().for_each(|p| *p = place(*p));
        let mut simplifier = simplifier(&surface);
        for vertices in [100, 30, 8] {
            simplifier.reduce_to(vertices).unwrap();
            rebuilt(&simplifier);
        }
    }
}

#[test]
fn shapes_are_measured() {
    let measure = |surface: &Surface| {
        let list = face_list(surface);
        Shape::new(&list)
    };
    let cube = measure(&cube(1));
    assert!(
        (cube.smallest_angle() - 45.0).abs() < 1e-9 && (cube.largest_angle() - 90.0).abs() < 1e-9
    );
    let octahedron = measure(&classic::octahedron());
    assert_eq!(octahedron.largest_degree, 4);
    assert!((octahedron.smallest_angle() - 60.0).abs() < 1e-9);
    let mut point = classic::tetrahedron();
    point.positions.fill([1.0; 3]);
    assert_eq!((measure(&point).smallest_angle(), measure(&point).largest_angle()), (0.0, 180.0));
    assert_eq!(measure(&crate::common::hub(50)).largest_degree, 50);
}
