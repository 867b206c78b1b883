//! The last stage: a quadrilateral for every pair of triangles (Lemos et al., section 2).

mod check;

use crate::dual::PerfectMatching;
use crate::mesh::{Attributes, FaceList, Faces, NO_INDEX, Section};
use crate::triangulation::{HalfEdgeId, TriangleId, Triangulation, VertexId};

pub(crate) use check::check_faces;
pub use check::{CheckReport, Mismatch, check};

/// A quadrangulation of the surface of a triangulation, on the same vertices.
///
/// Made by removing the common edge of each pair of triangles: orientation, vertices and all other
/// edges are those of the triangulation.
#[derive(Clone, Debug)]
pub struct Quadrangulation {
    /// For each quad, the side of its lower triangle that was removed.
    removed: Vec<HalfEdgeId>,
    corners: Vec<[VertexId; 4]>,
}

impl Quadrangulation {
    /// Removes the common edge of every pair of `matching` in `triangulation`. O(n).
    ///
    /// Quads come in the order of their lower triangles, each starting where the removed edge
    /// starts, counter-clockwise.
    ///
    /// # Panics
    /// If two mates have no common edge: the matching is that of another triangulation.
    pub fn new(triangulation: &Triangulation, matching: &PerfectMatching) -> Self {
        let mut removed = Vec::with_capacity(matching.pair_count());
        let mut corners = Vec::with_capacity(matching.pair_count());
        for (lower, upper) in matching.pairs() {
            let side = common_side(triangulation, lower, upper);
            removed.push(side);
            corners.push(quad_across(triangulation, side));
        }
        Self { removed, corners }
    }

    /// Number of quads, half the number of triangles.
    pub fn len(&self) -> usize {
        self.corners.len()
    }

    /// Whether there is no quad.
    pub fn is_empty(&self) -> bool {
        self.corners.is_empty()
    }

    /// The corners of all quads, counter-clockwise.
    pub fn quads(&self) -> &[[VertexId; 4]] {
        &self.corners
    }

    /// The faces over the vertices of the triangulation.
    pub fn faces(&self) -> Faces {
        Faces::uniform(4, self.corners.as_flattened().iter().map(|vertex| vertex.0).collect())
    }

    /// What `triangles` attaches to its corners and faces, carried over to the quads.
    ///
    /// A corner where both triangles meet takes the indices of the lower one; a quad belongs to the
    /// sections of its lower triangle. `triangles` must be the face list of the triangulation whose
    /// triangles were paired.
    pub fn carry_attributes(
        &self,
        triangulation: &Triangulation,
        triangles: &FaceList,
    ) -> Option<Attributes> {
        let given = triangles.attributes.as_deref()?;
        Some(Attributes {
            texture_coordinates: given.texture_coordinates.clone(),
            normals: given.normals.clone(),
            corner_texture: self.carry_corners(triangulation, &given.corner_texture),
            corner_normal: self.carry_corners(triangulation, &given.corner_normal),
            sections: self.carry_sections(&given.sections),
            libraries: given.libraries.clone(),
        })
    }

    fn carry_corners(&self, triangulation: &Triangulation, given: &[u32]) -> Vec<u32> {
        if given.is_empty() {
            return Vec::new();
        }
        let sources = self.removed.iter().flat_map(|&side| corner_sources(triangulation, side));
        sources.map(|h| given.get(h.0 as usize).copied().unwrap_or(NO_INDEX)).collect()
    }

    fn carry_sections(&self, given: &[Section]) -> Vec<Section> {
        let quad_at = |face: usize| self.removed.partition_point(|side| (side.0 / 3) < face as u32);
        let carry = |section: &Section| Section {
            first_face: quad_at(section.first_face),
            line: section.line.clone(),
        };
        given.iter().map(carry).collect()
    }
}

/// The side of `lower` beyond which `upper` lies.
fn common_side(triangulation: &Triangulation, lower: TriangleId, upper: TriangleId) -> HalfEdgeId {
    let is_common = |h: &HalfEdgeId| triangulation.twin(*h).triangle() == upper;
    lower.half_edges().into_iter().find(is_common).expect("mates share an edge")
}

/// The half-edges that leave the corners of the quad made by removing the edge of `side`.
///
/// ```text
///     c              side runs a -> b in triangle abc; its twin b -> a in triangle bad.
///    / \
///   a - b            The quad is a d b c, counter-clockwise.
///    \ /
///     d
/// ```
fn corner_sources(triangulation: &Triangulation, side: HalfEdgeId) -> [HalfEdgeId; 4] {
    let twin = triangulation.twin(side);
    [side, twin.prev(), side.next(), side.prev()]
}

fn quad_across(triangulation: &Triangulation, side: HalfEdgeId) -> [VertexId; 4] {
    corner_sources(triangulation, side).map(|h| triangulation.origin(h))
}
