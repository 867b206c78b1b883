//! The box against its counts and the solid that it bounds.

use super::shape::THICKNESS;
use super::{ImpossiblePaperBoxError, PaperBox, Walls};
use crate::check::{assert_distinct_positions, assert_oriented, degree_six_share, signed_volume};
use crate::surface::Surface;
use crate::testing::draws;

fn build(shape: PaperBox, walls: Walls) -> Surface {
    shape.surface(walls, &mut draws(5)).expect("the box is possible")
}

fn shapes() -> impl Iterator<Item = PaperBox> {
    let sizes = [(0, 3), (1, 1), (2, 4), (3, 2), (5, 9)];
    let holes = |shafts: u32| [0, 1, shafts.pow(2) / 2, shafts.pow(2)];
    sizes.into_iter().flat_map(move |(shafts, depth)| {
        let possible = holes(shafts).into_iter().filter(move |&holes| holes <= shafts.pow(2));
        possible.map(move |holes| PaperBox { shafts, depth, holes })
    })
}

#[test]
fn counts_and_volume_are_those_of_the_solid() {
    for (shape, walls) in shapes().flat_map(|shape| Walls::ALL.map(|walls| (shape, walls))) {
        let surface = build(shape, walls);
        assert_eq!(surface.positions.len() as u64, shape.vertices(), "{shape:?}");
        assert_eq!(surface.triangles.len() as u64, shape.triangles(), "{shape:?}");
        assert_oriented(&surface, shape.holes as usize);
        assert_distinct_positions(&surface);
        let PaperBox { shafts, depth, holes } = shape;
        let hollow = u64::from(shafts).pow(2) * u64::from(depth) + u64::from(holes * THICKNESS);
        let volume = shape.cells().iter().product::<u64>() - hollow;
        assert!((signed_volume(&surface) - volume as f64).abs() < 1e-6, "{shape:?} {walls:?}");
    }
}

/// Tables 3 to 5.
#[test]
fn the_papers_boxes_have_the_printed_counts() {
    let rows =
        [(0, 2_097_150, 4_194_296), (10, 2_097_170, 4_194_376), (3500, 2_104_150, 4_222_296)];
    for (holes, vertices, triangles) in rows {
        let shape = PaperBox { holes, ..PaperBox::PUBLISHED };
        assert_eq!((shape.vertices(), shape.triangles()), (vertices, triangles));
    }
    let surface = build(PaperBox::PUBLISHED, Walls::Alternating);
    assert!((0.965..0.967).contains(&degree_six_share(&surface)));
}

#[test]
fn a_hole_costs_two_vertices_and_eight_triangles() {
    for depth in [1, 7, 128] {
        let counts = |holes| {
            let surface = build(PaperBox { shafts: 3, depth, holes }, Walls::Equal);
            [surface.positions.len(), surface.triangles.len()]
        };
        let [few, more] = [2, 7].map(counts);
        assert_eq!([more[0] - few[0], more[1] - few[1]], [5 * 2, 5 * 8]);
    }
}

/// On walls every vertex has one diagonal of each side, however these are turned.
#[test]
fn vertices_inside_the_walls_have_degree_six() {
    for walls in Walls::ALL {
        let surface = build(PaperBox { shafts: 4, depth: 60, holes: 5 }, walls);
        let mut degrees = vec![0; surface.positions.len()];
        surface.triangles.as_flattened().iter().for_each(|&v| degrees[v as usize] += 1);
        let inside = |z: f64| z > 2.0 && z < 62.0;
        let regular = |(at, degree): (&[f64; 3], &u32)| *degree == 6 || !inside(at[2]);
        assert!(surface.positions.iter().zip(&degrees).all(regular), "{walls:?}");
    }
}

#[test]
fn patterns_of_walls_differ_and_draws_decide_the_drawn_one() {
    let shape = PaperBox { shafts: 2, depth: 3, holes: 1 };
    let triangles = Walls::ALL.map(|walls| build(shape, walls).triangles);
    for (i, one) in triangles.iter().enumerate() {
        assert!(triangles[..i].iter().all(|other| other != one));
    }
    let drawn = |seed| shape.surface(Walls::Drawn, &mut draws(seed)).unwrap();
    assert_eq!(drawn(5), drawn(5));
    assert_ne!(drawn(5), drawn(6));
}

#[test]
fn impossible_boxes_are_refused() {
    let refusal = |shafts, depth, holes| {
        PaperBox { shafts, depth, holes }.surface(Walls::Equal, &mut |_| 0).unwrap_err()
    };
    assert_eq!(refusal(2, 0, 0), ImpossiblePaperBoxError::NoDepth);
    let too_many = ImpossiblePaperBoxError::TooManyHoles { holes: 5, shafts: 4 };
    assert_eq!(refusal(2, 1, 5), too_many);
    assert_eq!(too_many.to_string(), "more holes (5) than shafts (4)");
    for (shafts, depth) in [(62, 1 << 20), (1 << 14, 1), (u32::MAX, u32::MAX), (0, u32::MAX)] {
        assert_eq!(refusal(shafts, depth, 0), ImpossiblePaperBoxError::TooManyHalfEdges);
    }
}
