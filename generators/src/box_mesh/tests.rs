//! The box against the solid it bounds, which is known in closed form.

use super::array::{Place, places};
use super::*;
use crate::check::{assert_distinct_positions, assert_oriented, degree_six_share, signed_volume};
use crate::testing::draws;

/// Cavities, holes, columns: full and partly filled arrays, mixed and not.
const SHAPES: [(u32, u32, u32); 11] = [
    (0, 0, 0),
    (1, 0, 1),
    (0, 1, 1),
    (1, 1, 2),
    (4, 0, 2),
    (0, 4, 2),
    (0, 5, 3),
    (2, 7, 3),
    (20, 0, 5),
    (7, 3, 4),
    (90, 31, 11),
];

fn build(cavities: u32, holes: u32, vertices: u32) -> Surface {
    BoxShape { cavities, holes, vertices }.surface().expect("the box is possible")
}

fn minimum(cavities: u32, holes: u32) -> u32 {
    BoxShape::minimum_vertices(cavities, holes) as u32
}

fn width(columns: u32) -> f64 {
    if columns == 0 { 2.0 } else { f64::from(3 * columns + 1) / 2.0 }
}

#[test]
fn every_number_of_vertices_from_the_minimum_on() {
    for (cavities, holes, _) in SHAPES {
        let minimum = minimum(cavities, holes);
        for more in 0..=500 {
            let surface = build(cavities, holes, minimum + more);
            assert_eq!(surface.positions.len() as u32, minimum + more);
            if more < 15 || more % 17 == 0 {
                assert_oriented(&surface, holes as usize);
            }
        }
    }
}

#[test]
fn any_shape_of_any_size() {
    let mut below = draws(7);
    for _ in 0..60 {
        let (cavities, holes) = (below(30), below(30));
        let vertices = minimum(cavities, holes) + below(1500);
        let surface = build(cavities, holes, vertices);
        assert_eq!(surface.positions.len() as u32, vertices);
        assert_oriented(&surface, holes as usize);
        assert_distinct_positions(&surface);
    }
}

#[test]
fn the_array_of_the_papers_is_sound() {
    assert_eq!(minimum(3844, 0), 8 * 63 * 63 + 4 * 3844);
    for (cavities, holes) in [(3844, 0), (344, 3500)] {
        let surface = build(cavities, holes, minimum(cavities, holes) + 100);
        assert_oriented(&surface, holes as usize);
        assert_distinct_positions(&surface);
    }
}

/// Table 4.2 and, with the other numbers of holes, Table 5 of the second paper.
#[test]
fn the_boxes_of_the_papers() {
    let rows = [
        (0, 2_097_150, 4_194_296),
        (3500, 2_104_150, 4_222_296),
        (1500, 2_100_150, 4_206_296),
        (10, 2_097_170, 4_194_376),
    ];
    for (holes, vertices, triangles) in rows {
        let surface = build(3844 - holes, holes, vertices);
        assert_eq!(surface.positions.len() as u32, vertices);
        assert_eq!(surface.triangles.len(), triangles);
        assert!(degree_six_share(&surface) > 0.95);
        let [shortest, longest] = edge_lengths(&surface);
        // Half of the shortest diagonal to the longest diagonal.
        assert!(longest < 3.2 * shortest && longest < 0.22, "{shortest} to {longest}");
        let volume = width(62).powi(2) - 0.75 * f64::from(3844 - holes) - f64::from(holes);
        assert!((signed_volume(&surface) / volume - 1.0).abs() < 1e-9);
    }
}

#[test]
fn degrees_are_regular_in_boxes_of_every_shape() {
    for (cavities, holes, columns) in SHAPES {
        for more in 0..20 {
            let vertices = 10_000 + 2_000 * columns.pow(2) + 7 * more;
            let share = degree_six_share(&build(cavities, holes, vertices));
            assert!(share > 0.95, "{share} with {cavities} and {holes}");
        }
    }
}

/// The surface lies in the boundary of the solid and has its area and, oriented outward, its
/// volume: it covers the boundary once.
#[test]
fn the_surface_is_the_boundary_of_the_solid() {
    for (cavities, holes, columns) in SHAPES {
        for more in [0, 17, 3000] {
            let surface = build(cavities, holes, minimum(cavities, holes) + more);
            let [c, h, w] = [f64::from(cavities), f64::from(holes), width(columns)];
            let volume = w * w - 0.75 * c - h;
            assert!((signed_volume(&surface) - volume).abs() < 1e-9 * w * w);
            let area = 2.0 * w * w + 4.0 * w + 3.0 * c + 2.0 * h;
            let found: f64 = surface.triangles.iter().map(|t| flat_area(&surface, t)).sum();
            assert!((found - area).abs() < 1e-9 * w * w, "{found} instead of {area}");
        }
    }
}

/// The area of a triangle, which has to be positive, in a plane across an axis.
fn flat_area(surface: &Surface, triangle: &[u32; 3]) -> f64 {
    let [a, b, c] = triangle.map(|v| surface.positions[v as usize]);
    let flat: Vec<_> = (0..3).filter(|&k| a[k] == b[k] && b[k] == c[k]).collect();
    assert_eq!(flat.len(), 1, "{triangle:?} lies in no axis-parallel plane, or has no area");
    let twice = cross([a, b, c], (flat[0] + 1) % 3, (flat[0] + 2) % 3).abs();
    assert!(twice > 0.0);
    twice / 2.0
}

/// Twice the signed area of a triangle projected to the axes `x` and `y`.
fn cross([a, b, c]: [[f64; 3]; 3], x: usize, y: usize) -> f64 {
    (b[x] - a[x]) * (c[y] - a[y]) - (b[y] - a[y]) * (c[x] - a[x])
}

/// Rays in each direction leave the surface as often as a point is inside the solid: once, or not
/// at all on balance, and never enter it twice in a row.
#[test]
fn crossings_of_rays_tell_inside_from_outside() {
    let mut below = draws(3);
    for (cavities, holes, columns) in SHAPES {
        let places = places(columns, cavities, holes);
        let surface = build(cavities, holes, minimum(cavities, holes) + 150);
        for _ in 0..200 {
            // Odd multiples of a fraction that no grid line is a multiple of.
            let mut draw = |length: f64| length * f64::from(2 * below(1 << 20) + 1) / 2_097_169.0;
            let w = width(columns);
            let point = [draw(w), draw(w), draw(1.0)];
            for axis in 0..3 {
                let inside = i32::from(is_inside(point, columns, &places));
                assert_eq!(crossings(&surface, point, axis), inside, "{point:?} along {axis}");
            }
        }
    }
}

/// How often the ray from `point` upward along `axis` leaves the surface, less how often it enters.
fn crossings(surface: &Surface, point: [f64; 3], axis: usize) -> i32 {
    let (x, y) = ((axis + 1) % 3, (axis + 2) % 3);
    let crossing = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|v| surface.positions[v as usize]);
        let sides = [[point, a, b], [point, b, c], [point, c, a]].map(|t| cross(t, x, y));
        let leaves = sides.iter().all(|&side| side > 0.0);
        let enters = sides.iter().all(|&side| side < 0.0);
        // A triangle that has a normal along the axis lies across it.
        if a[axis] > point[axis] { i32::from(leaves) - i32::from(enters) } else { 0 }
    };
    surface.triangles.iter().map(crossing).sum()
}

fn is_inside(point: [f64; 3], columns: u32, places: &[Place]) -> bool {
    let [column, row] = [0, 1].map(|axis| {
        let at = point[axis] / 1.5;
        // A third of each pitch is the gap before a shaft, the last third stands alone.
        (at.fract() > 1.0 / 3.0 && at < f64::from(columns)).then_some(at as usize)
    });
    let place = column.zip(row).map(|(column, row)| places[row * columns as usize + column]);
    match place {
        Some(Place::Hole) => false,
        Some(Place::Cavity) => point[2] < 0.25,
        _ => true,
    }
}

#[test]
fn cells_are_nearly_square() {
    for (cavities, holes, columns) in SHAPES {
        let surface = build(cavities, holes, 3000 + 500 * columns.pow(2));
        let [shortest, longest] = edge_lengths(&surface);
        // From half of the shortest diagonal, at a centre, to the longest diagonal.
        assert!(longest < 3.2 * shortest, "{cavities} {holes}: {shortest} to {longest}");
    }
}

fn edge_lengths(surface: &Surface) -> [f64; 2] {
    let edges = surface.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let lengths = edges.map(|edge| {
        let [p, q] = edge.map(|v| surface.positions[v as usize]);
        (0..3).map(|k| (p[k] - q[k]).powi(2)).sum::<f64>()
    });
    lengths.fold([f64::MAX, 0.0], |[low, high], x| [low.min(x), high.max(x)]).map(f64::sqrt)
}

#[test]
fn neighbouring_triangles_have_neighbouring_numbers() {
    for (cavities, holes) in [(30, 6), (0, 36), (36, 0), (0, 0)] {
        let surface = build(cavities, holes, 50_000);
        let near = |triangle: &&[u32; 3]| {
            let [low, high] = [triangle.iter().min(), triangle.iter().max()].map(Option::unwrap);
            high - low < 2500
        };
        let count = surface.triangles.iter().filter(near).count();
        assert!(count as f64 > 0.9 * surface.triangles.len() as f64, "{cavities} {holes} {count}");
        let mut before = [0; 3];
        let jumps = surface.triangles.iter().filter(|&&triangle| {
            let jumps = !triangle.iter().any(|v| before.contains(v));
            before = triangle;
            jumps
        });
        let jumps = jumps.count();
        assert!((jumps as f64) < 0.03 * surface.triangles.len() as f64, "{jumps} jumps");
    }
}

#[test]
fn less_than_the_minimum_is_refused() {
    let known = [(0, 0, 8), (0, 1, 32), (1, 0, 36), (4, 5, 144), (3844, 0, 47_128)];
    for (cavities, holes, minimum) in known {
        assert_eq!(BoxShape::minimum_vertices(cavities, holes), minimum);
        for vertices in [0, minimum as u32 - 1] {
            let shape = BoxShape { cavities, holes, vertices };
            assert_eq!(
                shape.surface(),
                Err(ImpossibleBoxError::TooFewVertices { vertices, minimum })
            );
        }
    }
    let shape = BoxShape { cavities: 4, holes: 5, vertices: 143 };
    let message = "a box with these cavities and holes has at least 144 vertices, not 143";
    assert_eq!(shape.surface().unwrap_err().to_string(), message);
}

#[test]
fn more_than_all_half_edges_are_refused() {
    let limit = (1 << 31) / 6 + 2;
    let shape = BoxShape { cavities: 5, holes: 0, vertices: limit + 1 };
    let half_edges = 6 * u64::from(limit - 1);
    assert_eq!(shape.surface(), Err(ImpossibleBoxError::TooManyHalfEdges { half_edges }));
    for (cavities, holes) in [(u32::MAX, u32::MAX), (0, u32::MAX), (u32::MAX, 0)] {
        let shape = BoxShape { cavities, holes, vertices: 1000 };
        assert!(matches!(shape.surface(), Err(ImpossibleBoxError::TooManyHalfEdges { .. })));
    }
}

#[test]
fn equal_shapes_give_equal_surfaces() {
    let shape = BoxShape { cavities: 5, holes: 6, vertices: 777 };
    assert_eq!(shape.surface(), shape.surface());
}
