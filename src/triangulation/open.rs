//! Triangulations of surfaces that have a boundary or only one side.
//!
//! Nothing that needs a closed, oriented surface takes them: that takes a
//! [`Triangulation`](super::Triangulation).

use super::half_edges::Side;
use super::ids::{HalfEdgeId, IdVec, VertexId};
use super::survey::Survey;
use crate::mesh::Mesh;

/// A triangulation of surfaces that may have a boundary and may be one-sided.
///
/// All other laws hold: see [`Law`](super::Law). Two-sided components are oriented alike. 24 bytes
/// a triangle.
#[derive(Clone, Debug, PartialEq)]
pub struct OpenTriangulation {
    /// A side on the boundary has no twin. Twins run in one direction where a one-sided component
    /// closes its strip.
    pub(super) sides: IdVec<HalfEdgeId, Side>,
    pub(super) vertices: usize,
    pub(super) boundary_edges: usize,
}

impl OpenTriangulation {
    /// Checks all laws but those of a closed and two-sided surface, and joins the triangles.
    ///
    /// # Errors
    /// The survey of the mesh, which lists every broken law with a place.
    ///
    /// # Cost
    /// O(n log n) time, about 100 bytes a triangle while it runs.
    pub fn build(list: &Mesh) -> Result<Self, Box<Survey>> {
        let survey = Survey::new(list);
        if survey.is_open_surface(false) { Ok(Self::join(list)) } else { Err(Box::new(survey)) }
    }

    /// Joins the triangles of a mesh that is an open surface by its survey. O(n log n).
    pub(crate) fn join(list: &Mesh) -> Self {
        let corners = list.faces().corners();
        let side = |&vertex: &u32| Side { origin: VertexId(vertex), twin: HalfEdgeId::NONE };
        let mut sides: IdVec<HalfEdgeId, Side> =
            corners.iter().map(side).collect::<Vec<_>>().into();
        let by_ends = |h: HalfEdgeId| {
            let [a, b] = [h, h.next()].map(|h| corners[h.index()]);
            (a.min(b), a.max(b), h)
        };
        let mut sorted: Vec<_> = sides.ids().map(by_ends).collect();
        sorted.sort_unstable();
        let mut boundary_edges = 0;
        for edge in sorted.chunk_by(|one, other| (one.0, one.1) == (other.0, other.1)) {
            match edge {
                &[(.., h), (.., twin)] => (sides[h].twin, sides[twin].twin) = (twin, h),
                _ => boundary_edges += 1,
            }
        }
        Self { sides, vertices: list.positions().len(), boundary_edges }
    }

    /// Returns the number of edges.
    pub fn edge_count(&self) -> usize {
        (self.sides.len() + self.boundary_edges) / 2
    }

    /// Returns the number of edges that belong to one triangle only.
    pub fn boundary_edge_count(&self) -> usize {
        self.boundary_edges
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::half_edges::Triangulation;
    use super::super::ids::TriangleId;
    use super::super::surface::Surface;
    use super::*;
    use crate::samples::sculpted;
    use crate::triangulation::Law;
    use triquad_generators::classic;

    fn mesh(surface: &triquad_generators::Surface) -> Mesh {
        Mesh::from_triangles(surface.positions.clone(), surface.triangles.clone())
    }

    /// Twins join equal ends and are mutual; sides without twin have no other side.
    fn assert_joined(open: &OpenTriangulation) {
        let sorted = |h: HalfEdgeId| {
            let mut ends = open.ends(h);
            ends.sort();
            ends
        };
        for h in open.triangles().flat_map(TriangleId::half_edges) {
            match open.across(h) {
                Some(twin) => {
                    assert_eq!((open.across(twin), sorted(twin)), (Some(h), sorted(h)));
                    assert_ne!(twin, h);
                }
                None => {
                    let all = open.triangles().flat_map(TriangleId::half_edges);
                    assert_eq!(all.filter(|&other| sorted(other) == sorted(h)).count(), 1);
                }
            }
        }
        assert_eq!(open.edges().count(), open.edge_count());
    }

    #[test]
    fn one_sided_surfaces_with_and_without_boundary_are_joined() {
        for (surface, boundary) in
            [(classic::projective_plane(), 0), (classic::moebius_strip(7), 14)]
        {
            let open = OpenTriangulation::build(&mesh(&surface)).unwrap();
            assert_joined(&open);
            assert_eq!(open.is_closed(), boundary == 0);
            assert_eq!(open.boundary_edge_count(), boundary);
        }
    }

    #[test]
    fn other_laws_still_hold() {
        let positions = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0; 3]];
        let fan = Mesh::from_triangles(positions, vec![[0, 1, 2], [0, 1, 3], [0, 1, 4]]);
        let survey = OpenTriangulation::build(&fan).unwrap_err();
        assert_eq!(survey.violations[0].law, Law::AtMostTwoFaces);
    }

    proptest! {
        #[test]
        fn a_closed_surface_has_the_same_twins_either_way(surface in sculpted()) {
            let mesh = mesh(&surface);
            let closed = Triangulation::build(&mesh).unwrap();
            let open = OpenTriangulation::build(&mesh).unwrap();
            prop_assert!(open.is_closed());
            prop_assert_eq!(open.sides.as_slice(), closed.sides());
        }
    }
}
