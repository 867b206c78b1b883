//! Sharp edges of a triangulation, and how many of them the quads keep.

use super::edge_quad::EdgeQuad;
use crate::triangulation::{HalfEdgeId, TriangleId, Triangulation};

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
    /// Counts the sharp edges of a triangulation and, among those `removed`, the lost ones. O(n).
    ///
    /// An edge of a triangle without area is not sharp.
    ///
    /// # Panics
    /// If a vertex of the triangulation has no position.
    pub fn new(
        triangulation: &Triangulation,
        positions: &[[f64; 3]],
        removed: &[HalfEdgeId],
    ) -> Self {
        let is_sharp = |&side: &HalfEdgeId| {
            EdgeQuad::across(triangulation, positions, side).is_bent_beyond(SHARP_COSINE)
        };
        let sides = triangulation.triangles().flat_map(TriangleId::half_edges);
        let edges = sides.filter(|&side| side < triangulation.twin(side));
        let all = edges.filter(is_sharp).count();
        let lost = removed.iter().filter(|side| is_sharp(side)).count();
        Self { all, kept: all - lost }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Mesh;

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
