//! Positions and faces exactly as a file states them: nothing is checked here.

/// The most corners that a mesh may have: half-edges are numbered with 32 bits, and room to spare.
pub const MAX_CORNERS: usize = 1 << 31;

/// Marks a corner that has no texture or normal index.
pub const NO_INDEX: u32 = u32::MAX;

/// A polygon mesh as read: positions, faces over them, and what an OBJ file attaches to both.
///
/// Nothing is promised: indices may be out of range, faces degenerate, coordinates NaN.
/// [`Triangulation::build`](crate::triangulation::Triangulation::build) turns it into something
/// that can be trusted, or says which law is broken.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FaceList {
    /// Coordinates of every vertex, in file order, unreferenced ones included.
    pub positions: Vec<[f64; 3]>,
    /// Faces in file order.
    pub faces: Faces,
    /// Texture coordinates, normals, groups and materials, where the file has any.
    pub attributes: Option<Box<Attributes>>,
    /// What the file holds and this list does not, for the user to be told.
    pub left_out: Vec<String>,
    /// For each face the face of the file (from 0) that it was cut from; empty if none has been cut.
    pub cut_from: Vec<u32>,
}

impl FaceList {
    /// A list of positions and triangles without attributes.
    pub fn from_triangles(positions: Vec<[f64; 3]>, triangles: Vec<[u32; 3]>) -> Self {
        Self { positions, faces: Faces::uniform(3, triangles.into_flattened()), ..Self::default() }
    }

    /// The position in the file (from 0) of `face`, whatever faces have been cut.
    pub fn face_in_file(&self, face: usize) -> usize {
        self.cut_from.get(face).map_or(face, |&original| original as usize)
    }

    /// Reverses one face, keeping its first corner first.
    pub fn reverse_face(&mut self, face: usize) {
        let range = self.faces.range(face);
        self.faces.corners[range.clone()][1..].reverse();
        if let Some(attributes) = &mut self.attributes {
            for indices in [&mut attributes.corner_texture, &mut attributes.corner_normal] {
                if !indices.is_empty() {
                    indices[range.clone()][1..].reverse();
                }
            }
        }
    }

    /// Cuts every face of more than three corners into a fan of triangles at its first corner.
    ///
    /// Faces of fewer corners stay what they are. O(n).
    pub fn triangulate(&mut self) {
        if self.faces.arity() == Some(3) {
            return;
        }
        let old = std::mem::take(&mut self.faces);
        let mut sources = Vec::new();
        let mut first_new = Vec::with_capacity(old.len() + 1);
        for face in 0..old.len() {
            first_new.push(self.faces.len());
            let range = old.range(face);
            if range.len() <= 3 {
                sources.extend(range);
                self.faces.push(old.get(face));
                self.cut_from.push(face as u32);
                continue;
            }
            for at in range.start + 1..range.end - 1 {
                let triangle = [range.start, at, at + 1];
                sources.extend(triangle);
                self.faces.push(&triangle.map(|corner| old.corners[corner]));
                self.cut_from.push(face as u32);
            }
        }
        first_new.push(self.faces.len());
        if let Some(attributes) = &mut self.attributes {
            attributes.rearrange(&sources, &first_new);
        }
    }
}

/// Faces of any number of corners, stored one after the other.
///
/// Meshes whose faces all have the same number of corners (nearly all) cost 4 bytes a corner;
/// others 4 bytes a face more.
#[derive(Clone, Debug, PartialEq)]
pub struct Faces {
    corners: Vec<u32>,
    shape: Shape,
}

#[derive(Clone, Debug, PartialEq)]
enum Shape {
    Uniform(usize),
    /// Where each face ends in `corners`.
    Mixed(Vec<u32>),
}

impl Default for Faces {
    fn default() -> Self {
        Self::uniform(3, Vec::new())
    }
}

impl Faces {
    /// Faces of `arity` corners each.
    ///
    /// # Panics
    /// If `arity` is 0 or does not divide the number of corners.
    pub fn uniform(arity: usize, corners: Vec<u32>) -> Self {
        assert!(arity > 0 && corners.len().is_multiple_of(arity));
        Self { corners, shape: Shape::Uniform(arity) }
    }

    /// No faces yet, and room for `corners` corners.
    pub fn with_capacity(corners: usize) -> Self {
        Self::uniform(3, Vec::with_capacity(corners))
    }

    /// Number of faces.
    pub fn len(&self) -> usize {
        match &self.shape {
            Shape::Uniform(arity) => self.corners.len() / arity,
            Shape::Mixed(ends) => ends.len(),
        }
    }

    /// Whether there is no face.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Vertex indices of all corners, face after face.
    pub fn corners(&self) -> &[u32] {
        &self.corners
    }

    /// The common number of corners of all faces, if they have one.
    pub fn arity(&self) -> Option<usize> {
        match self.shape {
            Shape::Uniform(arity) => Some(arity),
            Shape::Mixed(_) => None,
        }
    }

    /// Returns the end of each face in [`Faces::corners`]; none if all faces have the same size.
    pub fn ends(&self) -> Option<&[u32]> {
        match &self.shape {
            Shape::Uniform(_) => None,
            Shape::Mixed(ends) => Some(ends),
        }
    }

    /// Where face `face` lies in [`Faces::corners`].
    pub fn range(&self, face: usize) -> std::ops::Range<usize> {
        match &self.shape {
            Shape::Uniform(arity) => face * arity..(face + 1) * arity,
            Shape::Mixed(ends) => {
                let start = if face == 0 { 0 } else { ends[face - 1] as usize };
                start..ends[face] as usize
            }
        }
    }

    /// Vertex indices of one face.
    pub fn get(&self, face: usize) -> &[u32] {
        &self.corners[self.range(face)]
    }

    /// All faces in order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &[u32]> {
        (0..self.len()).map(|face| self.get(face))
    }

    /// Appends a face.
    pub fn push(&mut self, corners: &[u32]) {
        self.corners.extend_from_slice(corners);
        self.close_face(corners.len());
    }

    /// Appends one corner to the face that the next [`Faces::close_face`] will end.
    #[inline]
    pub fn push_corner(&mut self, vertex: u32) {
        self.corners.push(vertex);
    }

    /// Makes a face of the last `arity` corners pushed.
    #[inline]
    pub fn close_face(&mut self, arity: usize) {
        match &mut self.shape {
            Shape::Uniform(common) if *common == arity && arity > 0 => {}
            Shape::Uniform(common) if self.corners.len() == arity && arity > 0 => *common = arity,
            Shape::Uniform(common) => {
                let before = self.corners.len() - arity;
                let mut ends: Vec<u32> =
                    (1..=before / *common).map(|k| (k * *common) as u32).collect();
                ends.push(self.corners.len() as u32);
                self.shape = Shape::Mixed(ends);
            }
            Shape::Mixed(ends) => ends.push(self.corners.len() as u32),
        }
    }
}

/// What an OBJ file says beyond positions and faces, kept as it was written.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Attributes {
    /// Texture coordinates: the text after each `vt`.
    pub texture_coordinates: Lines,
    /// Normals: the text after each `vn`.
    pub normals: Lines,
    /// For every corner its texture coordinate (from 0) or [`NO_INDEX`]; empty if no corner has one.
    pub corner_texture: Vec<u32>,
    /// For every corner its normal (from 0) or [`NO_INDEX`]; empty if no corner has one.
    pub corner_normal: Vec<u32>,
    /// Lines that hold from a face on: objects, groups, smoothing groups, materials.
    pub sections: Vec<Section>,
    /// Whole `mtllib` lines.
    pub libraries: Vec<String>,
}

impl Attributes {
    /// Whether there is nothing to carry.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    /// Follows a change of faces: `sources` are the old corners of the new ones, `first_new` the first
    /// new face of each old one, with the number of new faces at the end.
    fn rearrange(&mut self, sources: &[usize], first_new: &[usize]) {
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
pub struct Section {
    /// Index (from 0) of the first face that the line holds for.
    pub first_face: usize,
    /// The whole line.
    pub line: String,
}

/// Many short texts in one block of memory.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Lines {
    bytes: Vec<u8>,
    ends: Vec<usize>,
}

impl Lines {
    /// Number of texts.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// Appends a text.
    pub fn push(&mut self, text: &[u8]) {
        self.bytes.extend_from_slice(text);
        self.ends.push(self.bytes.len());
    }

    /// All texts in order.
    pub fn iter(&self) -> impl Iterator<Item = &[u8]> {
        let starts = std::iter::once(0).chain(self.ends.iter().copied());
        starts.zip(&self.ends).map(|(start, &end)| &self.bytes[start..end])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faces_keep_their_corners_whatever_their_arity() {
        let given: [&[u32]; 5] =
            [&[0, 1, 2, 3], &[3, 2, 1, 0], &[4, 5, 6], &[], &[7, 8, 9, 10, 11]];
        let mut faces = Faces::default();
        for (count, face) in given.iter().enumerate() {
            faces.push(face);
            assert!(faces.iter().eq(given[..=count].iter().copied()));
        }
        assert_eq!(faces.arity(), None);
    }

    #[test]
    fn fans_carry_what_is_attached() {
        let mut list = FaceList::default();
        list.faces.push(&[0, 1, 2, 3, 4]);
        list.faces.push(&[5, 6]);
        list.faces.push(&[7, 8, 9]);
        list.attributes = Some(Box::new(Attributes {
            corner_texture: (10..20).collect(),
            sections: vec![
                Section { first_face: 1, line: "g a".into() },
                Section { first_face: 3, line: "g b".into() },
            ],
            ..Attributes::default()
        }));
        list.triangulate();
        let expected: [&[u32]; 5] = [&[0, 1, 2], &[0, 2, 3], &[0, 3, 4], &[5, 6], &[7, 8, 9]];
        assert!(list.faces.iter().eq(expected));
        list.reverse_face(4);
        let attributes = list.attributes.unwrap();
        assert_eq!(
            attributes.corner_texture,
            [10, 11, 12, 10, 12, 13, 10, 13, 14, 15, 16, 17, 19, 18]
        );
        assert_eq!(list.faces.get(4), [7, 9, 8]);
        assert_eq!(attributes.sections.iter().map(|s| s.first_face).collect::<Vec<_>>(), [3, 5]);
    }

    #[test]
    fn equal_faces_stay_uniform() {
        let mut faces = Faces::default();
        faces.push(&[0, 1, 2, 3]);
        faces.push(&[0, 1, 2, 3]);
        assert_eq!((faces.arity(), faces.len()), (Some(4), 2));
    }
}
