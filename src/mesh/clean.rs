//! Cleaning: faces that no surface can have are dropped.

use std::collections::HashSet;

use super::derived::Derived;
use super::polygon_mesh::Mesh;

/// Outcome of cleaning a mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Cleaned {
    /// Faces dropped that have fewer than three corners or one corner twice.
    pub degenerate_faces: usize,
    /// Faces dropped that have the corners of an earlier one in the same order, or reversed.
    pub duplicate_faces: usize,
}

impl Mesh {
    /// Drops degenerate faces, and faces that have the corners of an earlier one in the same
    /// cyclic order, or reversed.
    ///
    /// The other faces keep their order, and every vertex stays. A dropped face may leave a hole.
    ///
    /// ```
    /// use triquad::mesh::Mesh;
    ///
    /// let triangles = vec![[0, 1, 2], [1, 1, 2], [2, 1, 0], [0, 1, 3]];
    /// let mut mesh = Mesh::from_triangles(vec![[0.0; 3]; 4], triangles);
    /// let cleaned = mesh.clean();
    /// assert_eq!((cleaned.degenerate_faces, cleaned.duplicate_faces), (1, 1));
    /// assert_eq!(mesh.faces().corners(), [0, 1, 2, 0, 1, 3]);
    /// ```
    ///
    /// # Cost
    /// O(n) expected.
    pub fn clean(&mut self) -> Cleaned {
        let mut cleaned = Cleaned::default();
        let mut seen = Seen::with_capacity(self.faces().len());
        let mut derived = Derived::default();
        let mut corners = Vec::new();
        for (index, face) in self.faces().iter().enumerate() {
            corners.clear();
            corners.extend_from_slice(face);
            corners.sort_unstable();
            let is_degenerate = face.len() < 3 || corners.windows(2).any(|pair| pair[0] == pair[1]);
            let is_duplicate = !is_degenerate && !seen.insert(face);
            cleaned.degenerate_faces += usize::from(is_degenerate);
            cleaned.duplicate_faces += usize::from(is_duplicate);
            derived.begin_face();
            if !is_degenerate && !is_duplicate {
                derived.keep(self, index, 0..face.len(), |v| v);
            }
        }
        if cleaned != Cleaned::default() {
            derived.replace_faces_of(self);
        }
        let duplicate = ["face that was there twice", "faces that were there twice"];
        self.note_repairs([
            ("clean dropped", cleaned.degenerate_faces, ["degenerate face", "degenerate faces"]),
            ("clean dropped", cleaned.duplicate_faces, duplicate),
        ]);
        cleaned
    }
}

/// Faces of distinct corners, each whatever its first corner and its direction.
struct Seen {
    triangles: HashSet<[u32; 3]>,
    larger: HashSet<Vec<u32>>,
}

impl Seen {
    /// Begins without faces, with room for so many triangles.
    fn with_capacity(triangles: usize) -> Self {
        Self { triangles: HashSet::with_capacity(triangles), larger: HashSet::new() }
    }

    /// Adds a face; returns false if it is there.
    fn insert(&mut self, face: &[u32]) -> bool {
        if let Ok(mut triangle) = <[u32; 3]>::try_from(face) {
            triangle.sort_unstable();
            return self.triangles.insert(triangle);
        }
        let lowest = (0..face.len()).min_by_key(|&corner| face[corner]).unwrap_or_default();
        let mut corners = face.to_vec();
        corners.rotate_left(lowest);
        if corners[1] > corners[corners.len() - 1] {
            corners[1..].reverse();
        }
        self.larger.insert(corners)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::attributes::Attributes;
    use crate::mesh::{FaceSection, FaceSections, Faces};

    #[test]
    fn what_is_attached_and_the_number_in_the_file_stay_with_each_face() {
        let given: [&[u32]; 6] =
            [&[5, 6], &[0, 1, 2], &[3, 4, 3], &[1, 2, 0], &[0, 1, 2, 3], &[3, 2, 0, 1]];
        let mut mesh = Mesh::new(vec![[0.0; 3]; 7], Faces::from_iter(given));
        let mut sections = FaceSections::default();
        sections.push(FaceSection { first_face: 3, line: "g a" });
        mesh.attributes = Some(Box::new(Attributes {
            corner_texture: (10..29).map(Some).take(19).collect(),
            sections,
            ..Attributes::default()
        }));
        let cleaned = mesh.clean();
        assert_eq!((cleaned.degenerate_faces, cleaned.duplicate_faces), (2, 1));
        let expected: [&[u32]; 3] = [&[0, 1, 2], &[0, 1, 2, 3], &[3, 2, 0, 1]];
        assert!(mesh.faces().iter().eq(expected));
        assert_eq!([0, 1, 2].map(|face| mesh.face_in_file(face)), [1, 4, 5]);
        let notes =
            ["clean dropped 2 degenerate faces", "clean dropped 1 face that was there twice"];
        assert_eq!(mesh.repairs(), notes);
        let attributes = mesh.attributes().unwrap();
        let texture = [12, 13, 14, 21, 22, 23, 24, 25, 26, 27, 28].map(Some);
        assert!(attributes.corner_texture.iter().eq(texture));
        assert!(attributes.sections.iter().map(|section| section.first_face).eq([1]));
        let clean = mesh.clone();
        assert_eq!(mesh.clean(), Cleaned::default());
        assert_eq!(mesh, clean);
    }

    #[test]
    fn larger_faces_are_the_same_from_any_corner_in_either_direction() {
        let given: [&[u32]; 7] = [
            &[0, 1, 2, 3],
            &[2, 3, 0, 1],
            &[1, 0, 3, 2],
            &[0, 2, 1, 3],
            &[4, 0, 1, 2, 3],
            &[1, 0, 4, 3, 2],
            &[0, 1, 3, 2, 4],
        ];
        let mut mesh = Mesh::new(vec![[0.0; 3]; 5], Faces::from_iter(given));
        assert_eq!(mesh.clean().duplicate_faces, 3);
        assert_eq!([0, 1, 2, 3].map(|face| mesh.face_in_file(face)), [0, 3, 4, 6]);
    }
}
