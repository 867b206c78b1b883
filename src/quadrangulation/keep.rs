//! Edges to keep: those that no quad shall lie across.

use std::collections::HashMap;

use super::edge_quad::EdgeQuad;
use super::seams::Seams;
use super::sharp_edges::cosine_of_degrees;
use crate::mesh::Mesh;
use crate::triangulation::{EdgeSet, Element, Surface};

/// A description of the edges that no quad shall lie across. The default is none.
///
/// ```
/// use triquad::quadrangulation::Keep;
/// use triquad::{Converter, Mesh};
///
/// let positions = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let mesh = Mesh::from_triangles(positions, vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
/// let mut keep = Keep::default();
/// keep.edges = vec![[0, 1], [0, 2], [0, 3]];
/// let quads = Converter::new().keep(keep).run(&mesh)?;
/// // Every perfect pairing removes two opposite edges, and one of them is at vertex 0.
/// assert_eq!(quads.given_up().len(), 1);
/// # Ok::<(), triquad::ConvertError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Keep {
    /// All edges at which the surface bends by more than so many degrees, from 0 to 180.
    pub sharp: Option<f64>,
    /// Edges by their two vertices, from 0.
    pub edges: Vec<[u32; 2]>,
    /// Edges between faces of other texture coordinates, objects, groups or materials.
    pub seams: bool,
}

/// An edge to keep that the mesh does not have. Displayed numbers count from 1, stored ones from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{} is no edge of the mesh", Element::Edge(ends[0], ends[1]))]
pub struct NoSuchEdgeError {
    /// Its position in [`Keep::edges`].
    pub position: usize,
    /// Its two vertices, from 0.
    pub ends: [u32; 2],
}

impl Keep {
    /// Returns whether no edge is described.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    /// Finds the edges in `surface`, the triangulation of `mesh`. O(n), in expectation.
    ///
    /// Takes no memory if no edge is described.
    ///
    /// # Errors
    /// An edge listed is none of the mesh.
    pub fn find(&self, surface: &impl Surface, mesh: &Mesh) -> Result<EdgeSet, NoSuchEdgeError> {
        if self.is_empty() {
            return Ok(EdgeSet::default());
        }
        let mut set = EdgeSet::empty(surface);
        if let Some(degrees) = self.sharp {
            let cosine = cosine_of_degrees(degrees);
            let is_sharp = |quad: EdgeQuad| quad.is_bent_beyond(cosine);
            let positions = mesh.positions();
            for side in surface.edges() {
                if EdgeQuad::beyond(surface, positions, side).is_some_and(is_sharp) {
                    set.insert(surface, side);
                }
            }
        }
        if let Some(seams) = Seams::new(mesh).filter(|_| self.seams) {
            for side in surface.edges() {
                if surface.across(side).is_some_and(|twin| seams.part(surface, side, twin)) {
                    set.insert(surface, side);
                }
            }
        }
        self.insert_listed(surface, &mut set)?;
        Ok(set)
    }

    fn insert_listed(
        &self,
        surface: &impl Surface,
        set: &mut EdgeSet,
    ) -> Result<(), NoSuchEdgeError> {
        if self.edges.is_empty() {
            return Ok(());
        }
        let sorted = |[a, b]: [u32; 2]| [a.min(b), a.max(b)];
        let mut is_found: HashMap<_, _> =
            self.edges.iter().map(|&ends| (sorted(ends), false)).collect();
        for side in surface.edges() {
            let ends = sorted(surface.ends(side).map(u32::from));
            if let Some(is_found) = is_found.get_mut(&ends) {
                *is_found = true;
                set.insert(surface, side);
            }
        }
        match self.edges.iter().position(|&ends| !is_found[&sorted(ends)]) {
            Some(position) => Err(NoSuchEdgeError { position, ends: self.edges[position] }),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::triangulation::{HalfEdgeId, Triangulation};

    /// A cube of which each face is cut in two.
    fn cube() -> Mesh {
        let positions = (0..8).map(|i| [i & 1, i >> 1 & 1, i >> 2].map(f64::from)).collect();
        let quads =
            [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6]];
        let triangles = quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
        Mesh::from_triangles(positions, triangles)
    }

    fn found(keep: &Keep) -> Vec<[u32; 2]> {
        let mesh = cube();
        let surface = Triangulation::build(&mesh).unwrap();
        let set = keep.find(&surface, &mesh).unwrap();
        let edges = Surface::edges(&surface).filter(|&side| set.contains(side));
        let edges: Vec<_> = edges.map(|side| surface.ends(side).map(u32::from)).collect();
        assert_eq!(set.len(), edges.len());
        edges
    }

    #[test]
    fn the_edges_of_a_cube_bend_by_more_than_89_degrees_and_not_by_more_than_90() {
        let bend = |degrees| found(&Keep { sharp: Some(degrees), ..Keep::default() }).len();
        assert_eq!([0.0, 30.0, 89.0, 90.0, 180.0].map(bend), [12, 12, 12, 0, 0]);
    }

    #[test]
    fn listed_edges_are_found_in_either_direction_and_once() {
        let edges = vec![[2, 0], [7, 5], [5, 7]];
        assert_eq!(found(&Keep { edges, ..Keep::default() }), [[0, 2], [5, 7]]);
    }

    #[test]
    fn an_edge_that_does_not_exist_is_named() {
        let mesh = cube();
        let surface = Triangulation::build(&mesh).unwrap();
        let keep = Keep { edges: vec![[0, 2], [0, 7]], ..Keep::default() };
        let error = keep.find(&surface, &mesh).unwrap_err();
        assert_eq!(error, NoSuchEdgeError { position: 1, ends: [0, 7] });
        assert_eq!(error.to_string(), "edge 1-8 is no edge of the mesh");
    }

    #[test]
    fn both_sides_of_an_edge_are_in_the_set_or_neither() {
        let mesh = cube();
        let surface = Triangulation::build(&mesh).unwrap();
        let set = Keep { sharp: Some(30.0), ..Keep::default() }.find(&surface, &mesh).unwrap();
        for side in (0..3 * surface.triangle_count()).map(HalfEdgeId::new) {
            assert_eq!(set.contains(side), set.contains(surface.twin(side)));
        }
    }
}
