//! What an OBJ file attaches to corners and faces.

/// Marks a corner that has no texture or normal index.
pub const NO_INDEX: u32 = u32::MAX;

/// Attributes of an OBJ file, in its own words.
///
/// [`Mesh::with_attributes`](super::Mesh::with_attributes) attaches them to a mesh they fit.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Attributes {
    /// Texture coordinates: the text after each `vt`.
    pub texture_coordinates: TextList,
    /// Normals: the text after each `vn`.
    pub normals: TextList,
    /// For every corner its texture coordinate (from 0) or [`NO_INDEX`]; empty if no corner has one.
    pub corner_texture: Vec<u32>,
    /// For every corner its normal (from 0) or [`NO_INDEX`]; empty if no corner has one.
    pub corner_normal: Vec<u32>,
    /// TextList that hold from a face on: objects, groups, smoothing groups, materials.
    pub sections: Vec<FaceSection>,
    /// Whole `mtllib` lines.
    pub libraries: Vec<String>,
}

impl Attributes {
    /// Returns whether there is nothing to carry.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    /// Follows a change of faces. `sources` has the old corner of each new one, `first_new` the
    /// first new face of each old one and, at its end, the number of new faces.
    pub(super) fn rearrange(&mut self, sources: &[usize], first_new: &[usize]) {
        for indices in [&mut self.corner_texture, &mut self.corner_normal] {
            if !indices.is_empty() {
                *indices = sources.iter().map(|&corner| indices[corner]).collect();
            }
        }
        for section in &mut self.sections {
            section.first_face = first_new[section.first_face];
        }
    }
}

/// An `o`, `g`, `s` or `usemtl` line and the first face after it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FaceSection {
    /// Index (from 0) of the first face that the line holds for.
    pub first_face: usize,
    /// The whole line.
    pub line: String,
}

/// Many short texts in one block of memory.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TextList {
    bytes: Vec<u8>,
    ends: Vec<usize>,
}

impl TextList {
    /// Returns the number of texts.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Returns whether there is none.
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// Appends a text.
    pub fn push(&mut self, text: &[u8]) {
        self.bytes.extend_from_slice(text);
        self.ends.push(self.bytes.len());
    }

    /// Iterates over all texts in order.
    pub fn iter(&self) -> impl Iterator<Item = &[u8]> {
        let starts = std::iter::once(0).chain(self.ends.iter().copied());
        starts.zip(&self.ends).map(|(start, &end)| &self.bytes[start..end])
    }
}

/// Why attributes do not fit a mesh.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum AttributesError {
    /// There is not one index for each corner.
    #[error("{given} {kind} indices are given for {corners} corners")]
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

impl Attributes {
    /// Checks that the attributes fit a mesh of so many faces and corners. O(corners).
    pub(super) fn check(&self, faces: usize, corners: usize) -> Result<(), AttributesError> {
        let texture = ("texture", &self.corner_texture, self.texture_coordinates.len());
        let normal = ("normal", &self.corner_normal, self.normals.len());
        for (kind, indices, count) in [texture, normal] {
            let given = indices.len();
            if given != 0 && given != corners {
                return Err(AttributesError::CornerCount { kind, given, corners });
            }
            let missing = |index: u32| index != NO_INDEX && index as usize >= count;
            if let Some(corner) = indices.iter().position(|&index| missing(index)) {
                let index = indices[corner];
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
