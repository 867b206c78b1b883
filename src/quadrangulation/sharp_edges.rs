//! Sharp edges of a triangulation, and how many of them the quads keep.

use std::ops::Range;

use super::edge_quad::{EdgeQuad, prefetch_ahead};
use crate::parallel::{map, ranges};
use crate::triangulation::{HalfEdgeId, Surface, TriangleId};

/// Cosine of 30 degrees: an edge is sharp if the normals of its triangles differ by more.
const SHARP_COSINE: f64 = 0.866_025_403_784_438_6;

/// Numbers of edges at which the surface bends by more than 30 degrees.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct SharpEdges {
    /// Sharp edges of the triangulation.
    pub all: usize,
    /// Those that no quad lies across.
    pub kept: usize,
}

impl SharpEdges {
    /// Counts the sharp edges of a surface and, among those `removed`, the lost ones. O(n).
    ///
    /// An edge of a triangle without area is not sharp, and none on the boundary is.
    ///
    /// # Panics
    /// If a vertex of the surface has no position.
    pub fn new(surface: &impl Surface, positions: &[[f64; 3]], removed: &[HalfEdgeId]) -> Self {
        let mut is_removed = vec![0_u64; (3 * surface.triangle_count()).div_ceil(64)];
        removed.iter().for_each(|side| is_removed[side.index() / 64] |= 1 << (side.index() % 64));
        let is_removed =
            |side: HalfEdgeId| is_removed[side.index() / 64] >> (side.index() % 64) & 1 != 0;
        let count = |triangles: Range<usize>| {
            let (mut all, mut lost) = (0, 0);
            for f in triangles.map(TriangleId::new) {
                prefetch_ahead(surface, positions, f, |_| {});
                for side in f.half_edges() {
                    let Some(twin) = surface.across(side).filter(|&twin| side < twin) else {
                        continue;
                    };
                    let quad = EdgeQuad::between(surface, positions, [side, twin]);
                    if quad.is_bent_beyond(SHARP_COSINE) {
                        all += 1;
                        lost += usize::from(is_removed(side) || is_removed(twin));
                    }
                }
            }
            [all, lost]
        };
        let counts = map(ranges(surface.triangle_count()), count);
        let [all, lost] = counts.into_iter().fold([0, 0], |[a, b], [c, d]| [a + c, b + d]);
        Self { all, kept: all - lost }
    }
}

/// Returns the cosine of an angle from 0 to 180 degrees, with the same bits on every machine.
pub(super) fn cosine_of_degrees(degrees: f64) -> f64 {
    if degrees > 90.0 {
        return -cosine_of_degrees(180.0 - degrees);
    }
    // The angle in radians is at most 1 in either series: the terms left out are below 10⁻¹⁷.
    let series = |first: f64, factor: f64, step: f64| {
        let term = |(term, k): (f64, f64)| (-term * factor / (k * (k + 1.0)), k + 2.0);
        let terms = std::iter::successors(Some((first, step)), |&at| Some(term(at)));
        terms.take(10).map(|(term, _)| term).fold(0.0, |sum, term| sum + term)
    };
    let radians = |degrees: f64| degrees * (std::f64::consts::PI / 180.0);
    if degrees <= 45.0 {
        let x = radians(degrees);
        series(1.0, x * x, 1.0)
    } else {
        let x = radians(90.0 - degrees);
        series(x, x * x, 2.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Mesh;
    use crate::triangulation::{TriangleId, Triangulation};

    #[test]
    fn cosines_are_those_of_the_standard_library_but_for_a_few_last_bits() {
        assert_eq!([0.0, 30.0, 90.0, 180.0].map(cosine_of_degrees), [1.0, SHARP_COSINE, 0.0, -1.0]);
        for degrees in (0..=720).map(|quarter| f64::from(quarter) / 4.0) {
            let difference = cosine_of_degrees(degrees) - degrees.to_radians().cos();
            assert!(difference.abs() < 5e-16, "{degrees}: {difference}");
        }
    }

    #[test]
    fn a_cube_has_twelve_sharp_edges_and_six_flat_ones() {
        let positions: Vec<[f64; 3]> =
            (0..8).map(|i| [i & 1, i >> 1 & 1, i >> 2].map(f64::from)).collect();
        let quads =
            [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6]];
        let triangles = quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
        let mesh = Mesh::from_triangles(positions, triangles);
        let triangulation = Triangulation::build(&mesh).unwrap();
        let sides: Vec<HalfEdgeId> =
            triangulation.triangles().flat_map(TriangleId::half_edges).collect();
        let count = |removed: &[HalfEdgeId]| {
            let SharpEdges { all, kept } =
                SharpEdges::new(&triangulation, mesh.positions(), removed);
            [all, kept]
        };
        assert_eq!(count(&[]), [12, 12]);
        // Side 2 of the first triangle is the diagonal of a face, side 0 an edge of the cube.
        assert_eq!(count(&sides[2..3]), [12, 12]);
        assert_eq!(count(&sides[..1]), [12, 11]);
    }
}
