//! Every operation against its definition on plain sets of triangles.

use super::*;
use crate::check::{assert_embedded, assert_oriented, degrees, directed_edges, signed_volume};
use crate::classic::{octahedron, seven_vertex_torus, tetrahedron};
use crate::grids::{sphere, torus};
use crate::testing::draws;
use std::collections::BTreeSet;

/// The triangles, each starting with its smallest corner.
fn triangle_set(surface: &Surface) -> BTreeSet<[u32; 3]> {
    let smallest_first =
        |&[a, b, c]: &[u32; 3]| [[a, b, c], [b, c, a], [c, a, b]].into_iter().min();
    surface.triangles.iter().filter_map(smallest_first).collect()
}

fn some_operation(below: &mut dyn FnMut(u32) -> u32) -> Operation {
    let kind = [Operation::SplitFace, Operation::SplitEdge, Operation::Flip, Operation::Flip];
    kind[below(4) as usize](below(u32::MAX))
}

#[test]
fn every_operation_keeps_the_surface_valid() {
    let starts =
        [(tetrahedron(), 0), (octahedron(), 0), (seven_vertex_torus(), 1), (torus(3, 3), 1)];
    for (seed, (start, genus)) in starts.iter().enumerate() {
        let mut below = draws(seed as u64);
        let mut sculptor = Sculptor::from(start);
        for _ in 0..200 {
            sculptor.apply(some_operation(&mut below));
            assert_oriented(&sculptor.surface(), *genus);
        }
    }
}

#[test]
fn twins_stay_those_of_the_triangles() {
    let mut below = draws(7);
    let mut sculptor = Sculptor::from(&octahedron());
    for step in 0..200 {
        sculptor.apply(some_operation(&mut below));
        if step % 50 == 0 {
            sculptor.join(&seven_vertex_torus(), below(u32::MAX));
            sculptor.relabel(&mut below);
        }
        let rebuilt = Sculptor::from(&sculptor.surface());
        assert!((0..rebuilt.half_edges.len()).all(|h| sculptor.twin(h) == rebuilt.twin(h)));
    }
}

#[test]
fn a_face_split_replaces_one_triangle_by_three() {
    for face in 0..8 {
        let mut sculptor = Sculptor::from(&octahedron());
        let mut expected = triangle_set(&octahedron());
        let [a, b, c] = octahedron().triangles[face as usize];
        sculptor.split_face(face);
        let fan = Surface { positions: vec![], triangles: vec![[a, b, 6], [b, c, 6], [c, a, 6]] };
        expected.retain(|corners| ![a, b, c].iter().all(|v| corners.contains(v)));
        expected.extend(triangle_set(&fan));
        assert_eq!(triangle_set(&sculptor.surface()), expected);
    }
}

#[test]
fn an_edge_split_joins_the_middle_to_the_four_corners_around() {
    for half_edge in 0..24 {
        let mut sculptor = Sculptor::from(&octahedron());
        sculptor.split_edge(half_edge);
        let surface = sculptor.surface();
        assert_oriented(&surface, 0);
        let mut degrees = degrees(&surface);
        assert_eq!(degrees.pop(), Some(4));
        // The ends keep their degree, the corners across gain the new vertex.
        degrees.sort_unstable();
        assert_eq!(degrees, [4, 4, 4, 4, 5, 5]);
        assert_eq!(surface.positions[6].iter().filter(|x| x.abs() == 0.5).count(), 2);
    }
}

#[test]
fn subdivision_keeps_old_vertices_and_adds_vertices_of_degree_6() {
    for (start, genus) in [(tetrahedron(), 0), (seven_vertex_torus(), 1), (torus(4, 3), 1)] {
        let mut below = draws(genus);
        let mut sculptor = Sculptor::from(&start);
        (0..30).for_each(|_| sculptor.apply(some_operation(&mut below)));
        let (coarse, fine) = (sculptor.surface(), sculptor.subdivided());
        assert_oriented(&fine, genus as usize);
        assert_eq!(fine.triangles.len(), 4 * coarse.triangles.len());
        let old = coarse.positions.len();
        assert_eq!(fine.positions[..old], coarse.positions);
        assert_eq!(degrees(&fine)[..old], degrees(&coarse));
        assert!(degrees(&fine)[old..].iter().all(|&degree| degree == 6));
    }
}

#[test]
fn subdivision_of_a_flat_surface_stays_within_it() {
    let fine = Sculptor::from(&tetrahedron()).subdivided();
    assert_embedded(&fine);
    let [before, after] = [tetrahedron(), fine].map(|surface| signed_volume(&surface));
    assert!((after / before - 1.0).abs() < 1e-15);
}

#[test]
fn flips_happen_exactly_where_the_other_diagonal_is_missing() {
    let mut below = draws(3);
    let mut sculptor = Sculptor::from(&octahedron());
    let mut flipped = 0;
    for _ in 0..300 {
        sculptor.apply(some_operation(&mut below));
        let half_edge = below(sculptor.half_edge_count());
        let before = sculptor.surface();
        let (h, edges) = (half_edge as usize, directed_edges(&before));
        let t = sculptor.twin(h);
        let [a, b] = [h, t].map(|h| sculptor.origin(h));
        let [c, d] = [h, t].map(|h| sculptor.origin(previous(h)));

        let possible = !edges.contains(&(c, d));
        assert_eq!(sculptor.flip(half_edge), possible);
        flipped += u32::from(possible);
        let mut expected = before.clone();
        if possible {
            expected.triangles[h / 3] = [c, a, d];
            expected.triangles[t / 3] = [d, b, c];
        }
        assert_eq!(triangle_set(&sculptor.surface()), triangle_set(&expected));
    }
    assert!(flipped > 50);
}

#[test]
fn edges_of_complete_graphs_cannot_be_flipped() {
    for surface in [tetrahedron(), seven_vertex_torus()] {
        let mut sculptor = Sculptor::from(&surface);
        assert!((0..sculptor.half_edge_count()).all(|h| !sculptor.flip(h)));
        assert_eq!(sculptor.into_surface(), surface);
    }
}

#[test]
fn joining_adds_the_genera() {
    for face in 0..14 {
        let mut sculptor = Sculptor::from(&seven_vertex_torus());
        sculptor.join(&seven_vertex_torus(), face);
        assert_oriented(&sculptor.surface(), 2);
        sculptor.join(&sphere(2), 5 * face);
        assert_oriented(&sculptor.surface(), 2);
        sculptor.join(&torus(3, 4), 7 * face);
        assert_oriented(&sculptor.surface(), 3);
    }
}

#[test]
fn joining_a_tetrahedron_is_a_face_split() {
    for face in 0..8 {
        let mut joined = Sculptor::from(&octahedron());
        joined.join(&tetrahedron(), face);
        let mut split = Sculptor::from(&octahedron());
        split.split_face(face);
        assert_eq!(triangle_set(&joined.surface()), triangle_set(&split.surface()));
    }
}

#[test]
fn relabelling_keeps_the_surface() {
    let original = sphere(3);
    let mut sculptor = Sculptor::from(&original);
    sculptor.relabel(&mut draws(11));
    let surface = sculptor.into_surface();
    assert_oriented(&surface, 0);
    assert_ne!(surface, original);
    // Positions tell the vertices apart.
    let old_number = |v: u32| {
        let same = |p: &[f64; 3]| *p == surface.positions[v as usize];
        original.positions.iter().position(same).map(|v| v as u32)
    };
    let triangles = surface.triangles.iter().map(|t| t.map(|v| old_number(v).unwrap()));
    let named_back = Surface { positions: vec![], triangles: triangles.collect() };
    assert_eq!(triangle_set(&named_back), triangle_set(&original));
}

#[test]
#[should_panic(expected = "must have two triangles")]
fn an_open_surface_is_refused() {
    Sculptor::from(&crate::classic::moebius_strip(5));
}

#[test]
#[should_panic(expected = "oriented alike")]
fn a_surface_that_is_not_orientable_is_refused() {
    Sculptor::from(&crate::classic::projective_plane());
}

#[test]
#[should_panic(expected = "must form one fan")]
fn a_pinched_surface_is_refused() {
    let mut surface = tetrahedron();
    let other = surface.triangles.clone().into_iter();
    surface.triangles.extend(other.map(|t| t.map(|v| if v == 0 { 0 } else { v + 3 })));
    surface.positions.extend([[2.0; 3], [3.0; 3], [4.0; 3]]);
    Sculptor::from(&surface);
}
