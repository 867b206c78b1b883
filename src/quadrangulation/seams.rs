//! Seams: edges at which the texture, the object, the group or the material changes.

use std::collections::HashMap;

use super::edge_ends::corners_at_ends;
use crate::mesh::{Attributes, Mesh, TextList};
use crate::triangulation::{HalfEdgeId, Surface};

/// Labels of the faces and corners of a mesh.
pub(super) struct Seams<'m> {
    attributes: &'m Attributes,
    /// For each texture coordinate the first one of equal text.
    texture: Vec<u32>,
    /// For each face a number for its object, group and material.
    section: Vec<u32>,
}

impl<'m> Seams<'m> {
    /// Reads the labels of a mesh, if it has any. O(n).
    pub(super) fn new(mesh: &'m Mesh) -> Option<Self> {
        let attributes = mesh.attributes()?;
        Some(Self {
            attributes,
            texture: first_equal(&attributes.texture_coordinates),
            section: face_sections(attributes, mesh.faces().len()),
        })
    }

    /// Returns whether the two sides of an edge have other labels.
    pub(super) fn part(&self, surface: &impl Surface, side: HalfEdgeId, twin: HalfEdgeId) -> bool {
        let section = |h: HalfEdgeId| self.section[h.triangle().index()];
        let texture = |h: HalfEdgeId| {
            let index = self.attributes.corner_texture.get(h.index());
            index.map(|index| self.texture[index as usize])
        };
        let has_seam = |[one, other]: [HalfEdgeId; 2]| texture(one) != texture(other);
        section(side) != section(twin)
            || corners_at_ends(surface, [side, twin]).into_iter().any(has_seam)
    }
}

/// Returns for each text the number of the first equal one.
fn first_equal(texts: &TextList) -> Vec<u32> {
    let mut first = HashMap::new();
    (0..).zip(texts).map(|(number, text)| *first.entry(text).or_insert(number)).collect()
}

/// Returns for each face a number for its object, group and material, equal for equal ones.
fn face_sections(attributes: &Attributes, faces: usize) -> Vec<u32> {
    const KEYWORDS: [&str; 3] = ["o", "g", "usemtl"];
    let mut numbers = HashMap::from([([""; 3], 0)]);
    let mut state = [""; 3];
    let mut number = 0;
    let mut sections = Vec::with_capacity(faces);
    for section in attributes.sections.iter() {
        sections.resize(section.first_face.min(faces), number);
        let (keyword, name) = section.line.trim().split_once(' ').unwrap_or((section.line, ""));
        if let Some(slot) = KEYWORDS.iter().position(|&known| known == keyword) {
            state[slot] = name.trim();
            let next = numbers.len() as u32;
            number = *numbers.entry(state).or_insert(next);
        }
    }
    sections.resize(faces, number);
    sections
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::FaceSection;
    use crate::quadrangulation::Keep;
    use crate::triangulation::Triangulation;

    /// A tetrahedron, its faces 012 (turned), 013, 123, 203.
    fn seams_of(attributes: Attributes) -> Vec<[u32; 2]> {
        let positions = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let triangles = vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
        let mesh = Mesh::from_triangles(positions, triangles).with_attributes(attributes).unwrap();
        let surface = Triangulation::build(&mesh).unwrap();
        let keep = Keep { seams: true, ..Keep::default() };
        let set = keep.find(&surface, &mesh).unwrap();
        let edges = Surface::edges(&surface).filter(|&side| set.contains(side));
        edges.map(|side| surface.ends(side).map(u32::from)).collect()
    }

    fn sections(lines: &[(usize, &'static str)]) -> Attributes {
        let section =
            |&(first_face, line): &(usize, &'static str)| FaceSection { first_face, line };
        Attributes { sections: lines.iter().map(section).collect(), ..Attributes::default() }
    }

    #[test]
    fn groups_and_materials_meet_at_seams() {
        let around_the_first = [[0, 2], [2, 1], [1, 0]];
        assert_eq!(seams_of(sections(&[(1, "g lid")])), around_the_first);
        assert_eq!(seams_of(sections(&[(0, "usemtl a"), (1, "usemtl b")])), around_the_first);
        // A group that returns is the same group; smoothing groups are none.
        let back = sections(&[(0, "g a"), (1, "g b"), (2, "g a"), (3, "g b"), (3, "s off")]);
        assert_eq!(seams_of(back), [[0, 2], [1, 0], [1, 3], [2, 3]]);
    }

    #[test]
    fn texture_is_compared_by_what_it_says() {
        // Texture coordinate v of the vertex v at all corners, but a second one at vertex 3.
        let textured = |fourth: &[u8], other: u32| {
            let mut attributes = Attributes::default();
            attributes.texture_coordinates.extend([&b"0 0"[..], b"1 0", b"0 1", b"1 1", fourth]);
            let corners = [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, other];
            attributes.corner_texture = corners.into_iter().map(Some).collect();
            attributes
        };
        assert!(seams_of(textured(b"1 1", 4)).is_empty());
        // The last triangle, 2 0 3, has another coordinate at 3: seams 0-3 and 3-2.
        assert_eq!(seams_of(textured(b"7 7", 4)), [[3, 0], [2, 3]]);
    }
}
