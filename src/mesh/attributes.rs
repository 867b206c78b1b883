//! Attributes of corners and faces in an OBJ file.

use super::corner_indices::CornerIndices;
use super::face_sections::FaceSections;
use super::text_list::TextList;
use crate::counted::counted;

/// Attributes of an OBJ file, in its own words.
///
/// [`Mesh::with_attributes`](super::Mesh::with_attributes) attaches them to a mesh they fit.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Attributes {
    /// Texture coordinates: the text after each `vt`.
    pub texture_coordinates: TextList,
    /// Normals: the text after each `vn`.
    pub normals: TextList,
    /// Texture coordinate of every corner, from 0.
    pub corner_texture: CornerIndices,
    /// Normal of every corner, from 0.
    pub corner_normal: CornerIndices,
    /// Lines that hold from a face on: objects, groups, smoothing groups, materials.
    pub sections: FaceSections,
    /// Whole `mtllib` lines.
    pub libraries: Vec<String>,
}

impl Attributes {
    /// Returns whether there is nothing to carry.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    /// Returns the names of what there is, for messages about formats that cannot hold it.
    pub fn names(&self) -> Vec<&'static str> {
        let has = |keywords: &[&str]| {
            self.sections.iter().any(|section| keywords.contains(&section.keyword()))
        };
        let has_texture = !(self.corner_texture.is_empty() && self.texture_coordinates.is_empty());
        let has_normals = !(self.corner_normal.is_empty() && self.normals.is_empty());
        [
            (has_texture, "texture coordinates"),
            (has_normals, "normals"),
            (has(&["usemtl"]) || !self.libraries.is_empty(), "materials"),
            (has(&["o", "g"]), "groups"),
            (has(&["s"]), "smoothing groups"),
        ]
        .into_iter()
        .filter_map(|(is_there, name)| is_there.then_some(name))
        .collect()
    }

    /// Follows a change of faces.
    ///
    /// `sources` has the old corner of each new one. `first_new` has the first new face of each old
    /// one and, at its end, the number of new faces.
    pub(super) fn rearrange(&mut self, sources: &[usize], first_new: &[usize]) {
        for indices in [&mut self.corner_texture, &mut self.corner_normal] {
            *indices = indices.gather(sources.iter().copied());
        }
        self.sections = self.sections.moved(|face| first_new[face]);
    }

    /// Checks that the attributes fit a mesh of so many faces and corners. O(corners).
    pub(super) fn check(&self, faces: usize, corners: usize) -> Result<(), AttributesError> {
        let texture = ("texture", &self.corner_texture, self.texture_coordinates.len());
        let normal = ("normal", &self.corner_normal, self.normals.len());
        for (kind, indices, count) in [texture, normal] {
            let given = indices.len();
            if given != 0 && given != corners {
                return Err(AttributesError::CornerCount { kind, given, corners });
            }
            if let Some((corner, index)) = indices.first_beyond(count) {
                return Err(AttributesError::OutOfRange { kind, corner, index, count });
            }
        }
        let mut first = 0;
        for (place, section) in self.sections.iter().enumerate() {
            if section.first_face < first || section.first_face > faces {
                return Err(AttributesError::SectionOrder(place));
            }
            first = section.first_face;
        }
        Ok(())
    }
}

/// A reason why attributes do not fit a mesh.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum AttributesError {
    /// There is not one index for each corner.
    #[error(
        "{} given for {}",
        counted(*.given, format_args!("{kind} index is"), format_args!("{kind} indices are")),
        counted(*.corners, "corner", "corners")
    )]
    CornerCount {
        /// Texture or normal.
        kind: &'static str,
        /// Number of indices.
        given: usize,
        /// Number of corners of the mesh.
        corners: usize,
    },
    /// A corner names an entry that does not exist.
    #[error("corner {corner} has {kind} index {index}, and there are {count} (all from 0)")]
    OutOfRange {
        /// Texture or normal.
        kind: &'static str,
        /// The corner.
        corner: usize,
        /// Its index.
        index: u32,
        /// Number of entries.
        count: usize,
    },
    /// The sections are not in the order of their faces, or begin after the last one.
    #[error("section {0} (from 0) begins before the one ahead of it or after the last face")]
    SectionOrder(usize),
}
