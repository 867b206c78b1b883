//! The faces that an imperfect pairing makes: quads, and the triangles left over.

use super::edge_quad::quad_corners;
use super::losses::{self, AttributeLosses};
use crate::dual::Matching;
use crate::mesh::{Attributes, Faces, Mesh};
use crate::triangulation::{HalfEdgeId, Surface};

/// A quad for each pair of triangles of a surface, and each triangle without a mate as it is.
///
/// Faces come in the order of their lowest triangles. A quad starts where the removed edge starts
/// and is oriented as its lower triangle.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MixedFaces {
    faces: Faces,
    /// For each corner the half-edge that leaves it in the surface.
    sources: Vec<HalfEdgeId>,
    /// For each quad the side of its lower triangle that was removed.
    removed: Vec<HalfEdgeId>,
}

impl MixedFaces {
    /// Removes the common edge of every pair of `matching`. O(n).
    ///
    /// # Panics
    /// If two mates have no common edge: the matching is that of another surface.
    pub fn new(surface: &impl Surface, matching: &Matching) -> Self {
        let corners = 3 * surface.triangle_count() - matching.len() + matching.unpaired_count();
        let mut faces = Faces::with_capacity(corners);
        let (mut sources, mut removed) = (Vec::with_capacity(corners), Vec::new());
        let mut push = |corners: &[HalfEdgeId]| {
            let mut vertices = [0; 4];
            (0..corners.len()).for_each(|k| vertices[k] = surface.origin(corners[k]).into());
            faces.push(&vertices[..corners.len()]);
            sources.extend_from_slice(corners);
        };
        for f in surface.triangles() {
            match matching.mate(f) {
                None => push(&f.half_edges()),
                Some(g) if f < g => {
                    let twin = |side| surface.across(side).filter(|twin| twin.triangle() == g);
                    let sides = f.half_edges().into_iter().find_map(|h| Some([h, twin(h)?]));
                    let sides = sides.expect("mates share an edge");
                    removed.push(sides[0]);
                    push(&quad_corners(sides));
                }
                Some(_) => {}
            }
        }
        Self { faces, sources, removed }
    }

    /// Returns the faces over the vertices of the surface.
    pub fn faces(&self) -> &Faces {
        &self.faces
    }

    /// Returns for each quad the side of its lower triangle that was removed.
    pub fn removed(&self) -> &[HalfEdgeId] {
        &self.removed
    }

    /// Carries the attributes of `list`, the mesh of the surface, over; `None` if it has none.
    /// O(n).
    ///
    /// A corner where both triangles of a quad meet takes the indices of the lower one. A quad
    /// belongs to the sections of its lower triangle.
    pub fn carry_attributes(&self, list: &Mesh) -> Option<Attributes> {
        let given = list.attributes()?;
        let sources = self.sources.iter().map(|h| h.index());
        let lowest: Vec<usize> = (0..self.faces.len())
            .map(|face| self.sources[self.faces.range(face).start].triangle().index())
            .collect();
        let face_at = |face: usize| lowest.partition_point(|&triangle| triangle < face);
        Some(super::carry(given, sources, face_at))
    }

    /// Counts what the quads cannot keep of the attributes of `list`, the mesh of `surface`.
    /// O(n log s) for s sections.
    pub fn attribute_losses(&self, surface: &impl Surface, list: &Mesh) -> AttributeLosses {
        let Some(attributes) = list.attributes() else { return AttributeLosses::default() };
        losses::count(attributes, surface, surface, &self.removed, HalfEdgeId::index)
    }

    /// Takes the faces and drops the rest.
    pub fn into_faces(self) -> Faces {
        self.faces
    }
}
