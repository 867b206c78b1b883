//! The mesh: positions, faces and attributes that belong together.

use std::borrow::Cow;

use super::attributes::{Attributes, AttributesError};
use super::faces::Faces;

/// A polygon mesh: positions, faces over them, and what an OBJ file attaches to both.
///
/// Faces and attributes change together, so that an index never names the corner of another face.
/// Nothing else is promised: indices may be out of range, faces degenerate, coordinates NaN.
/// [`Triangulation::build`](crate::triangulation::Triangulation::build) checks that.
///
/// ```
/// use triquad::Mesh;
///
/// let positions = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let mesh = Mesh::from_triangles(positions, vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
/// assert_eq!((mesh.positions().len(), mesh.faces().len()), (4, 4));
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    pub(super) positions: Vec<[f64; 3]>,
    pub(super) faces: Faces,
    pub(super) attributes: Option<Box<Attributes>>,
    pub(super) left_out: Vec<String>,
    /// What repairs have changed.
    repairs: Vec<String>,
    /// The note on lines of an OBJ file that begin with no keyword.
    pub(super) unknown_lines: Option<String>,
    /// For each face the face of the file (from 0) that it was cut from; empty if none was cut.
    cut_from: Vec<u32>,
}

impl Mesh {
    /// Makes a mesh without attributes.
    pub fn new(positions: Vec<[f64; 3]>, faces: Faces) -> Self {
        Self { positions, faces, ..Self::default() }
    }

    /// Makes a mesh of triangles without attributes.
    pub fn from_triangles(positions: Vec<[f64; 3]>, triangles: Vec<[u32; 3]>) -> Self {
        Self::new(positions, Faces::uniform(3, triangles.into_flattened()))
    }

    /// Returns the coordinates of all vertices in file order, unreferenced ones included.
    pub fn positions(&self) -> &[[f64; 3]] {
        &self.positions
    }

    /// Returns the coordinates of all vertices for change; their number stays.
    pub fn positions_mut(&mut self) -> &mut [[f64; 3]] {
        &mut self.positions
    }

    /// Returns the faces in file order.
    pub fn faces(&self) -> &Faces {
        &self.faces
    }

    /// Returns the texture coordinates, normals, groups and materials, where the file has any.
    pub fn attributes(&self) -> Option<&Attributes> {
        self.attributes.as_deref()
    }

    /// Returns the names of what the file holds and the mesh does not, in words for the user.
    pub fn left_out(&self) -> &[String] {
        &self.left_out
    }

    /// Returns what [`Mesh::weld`], [`Mesh::clean`], [`Mesh::triangulate`] and
    /// [`Survey::orient`](crate::Survey::orient) have changed, in words for the user that begin
    /// with the name of the function.
    pub fn repairs(&self) -> &[String] {
        &self.repairs
    }

    /// Returns the number and the first of lines that begin with no keyword, in words for the user.
    ///
    /// They are in [`Mesh::left_out`] too. If the mesh is refused, they may be why.
    pub fn unknown_lines(&self) -> Option<&str> {
        self.unknown_lines.as_deref()
    }

    /// Notes what a repair has done: to so many, and the words for one and for several.
    pub(crate) fn note_repairs<const N: usize>(&mut self, done: [(&str, usize, [&str; 2]); N]) {
        let some = done.into_iter().filter(|(_, count, _)| *count > 0);
        let words = |(deed, count, [one, several]): (&str, usize, [&str; 2])| match count {
            1 => format!("{deed} 1 {one}"),
            _ => format!("{deed} {count} {several}"),
        };
        self.repairs.extend(some.map(words));
    }

    /// Takes the mesh apart into positions and faces. Attributes are dropped.
    pub fn into_parts(self) -> (Vec<[f64; 3]>, Faces) {
        (self.positions, self.faces)
    }

    /// Replaces the faces. The attributes of the old faces are dropped with them.
    #[must_use]
    pub fn with_faces(mut self, faces: Faces) -> Self {
        self.replace_faces(faces);
        self
    }

    /// Replaces the faces as [`Mesh::with_faces`] does and returns the old ones.
    pub(crate) fn replace_faces(&mut self, faces: Faces) -> Faces {
        self.attributes = None;
        self.cut_from = Vec::new();
        std::mem::replace(&mut self.faces, faces)
    }

    /// Attaches attributes in place of those there are. O(corners).
    ///
    /// # Errors
    /// The attributes are not those of a mesh with these faces.
    pub fn with_attributes(self, attributes: Attributes) -> Result<Self, AttributesError> {
        attributes.check(self.faces.len(), self.faces.corners().len())?;
        Ok(self.attach(Some(attributes)))
    }

    /// Attaches attributes made for these faces.
    pub(crate) fn attach(self, attributes: Option<Attributes>) -> Self {
        let fits =
            |given: &Attributes| given.check(self.faces.len(), self.faces.corners().len()).is_ok();
        debug_assert!(attributes.as_ref().is_none_or(fits));
        Self { attributes: attributes.map(Box::new), ..self }
    }

    /// Returns the position in the file (from 0) of the face that `face` is or was cut from.
    pub fn face_in_file(&self, face: usize) -> usize {
        self.cut_from.get(face).map_or(face, |&original| original as usize)
    }

    /// Reverses one face and keeps its first corner first.
    ///
    /// # Panics
    /// If there is no such face.
    pub fn reverse_face(&mut self, face: usize) {
        let range = self.faces.range(face);
        self.faces.corners[range.clone()][1..].reverse();
        if let Some(attributes) = &mut self.attributes {
            for indices in [&mut attributes.corner_texture, &mut attributes.corner_normal] {
                indices.reverse_after_first(range.clone());
            }
        }
    }

    /// Replaces the faces by some made from them, and makes the attributes follow.
    ///
    /// `sources` has the old corner of each new one, `first_new` the first new face of each old one
    /// and the number of new ones, `origins` the face of the file of each new one.
    pub(super) fn set_derived_faces(
        &mut self,
        faces: Faces,
        sources: &[usize],
        first_new: &[usize],
        origins: Vec<u32>,
    ) {
        self.faces = faces;
        self.cut_from = origins;
        if let Some(attributes) = &mut self.attributes {
            attributes.rearrange(sources, first_new);
        }
    }
}

impl From<Mesh> for Cow<'_, Mesh> {
    fn from(mesh: Mesh) -> Self {
        Cow::Owned(mesh)
    }
}

impl<'a> From<&'a Mesh> for Cow<'a, Mesh> {
    fn from(mesh: &'a Mesh) -> Self {
        Cow::Borrowed(mesh)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::face_sections::{FaceSection, FaceSections};

    #[test]
    fn fans_carry_what_is_attached() {
        let given: [&[u32]; 3] = [&[0, 1, 2, 3, 4], &[5, 6], &[7, 8, 9]];
        let mut list = Mesh::new(Vec::new(), Faces::from_iter(given));
        list.attributes = Some(Box::new(Attributes {
            corner_texture: (10..20).map(Some).collect(),
            sections: FaceSections::from_iter([
                FaceSection { first_face: 1, line: "g a" },
                FaceSection { first_face: 3, line: "g b" },
            ]),
            ..Attributes::default()
        }));
        list.triangulate().unwrap();
        let expected: [&[u32]; 5] = [&[0, 1, 2], &[0, 2, 3], &[0, 3, 4], &[5, 6], &[7, 8, 9]];
        assert!(list.faces.iter().eq(expected));
        list.reverse_face(4);
        let attributes = list.attributes.unwrap();
        let expected = [10, 11, 12, 10, 12, 13, 10, 13, 14, 15, 16, 17, 19, 18].map(Some);
        assert!(attributes.corner_texture.iter().eq(expected));
        assert_eq!(list.faces[4], [7, 9, 8]);
        assert_eq!(attributes.sections.iter().map(|s| s.first_face).collect::<Vec<_>>(), [3, 5]);
    }

    #[test]
    fn attributes_of_other_faces_are_refused() {
        let triangle = || Mesh::from_triangles(vec![[0.0; 3]; 3], vec![[0, 1, 2]]);
        let mut given = Attributes::default();
        given.texture_coordinates.push(b"0 0");
        for (corner_texture, fits) in
            [([0, 0, 0].as_slice(), true), (&[0; 4], false), (&[0, 0, 1], false)]
        {
            let corner_texture = corner_texture.iter().copied().map(Some).collect();
            let given = Attributes { corner_texture, ..given.clone() };
            assert_eq!(triangle().with_attributes(given).is_ok(), fits);
        }
        let sections = FaceSections::from_iter([FaceSection { first_face: 2, line: "g a" }]);
        let late = Attributes { sections, ..Attributes::default() };
        assert_eq!(triangle().with_attributes(late), Err(AttributesError::SectionOrder(0)));
    }

    #[test]
    fn new_faces_leave_the_attributes_behind() {
        let corner_texture = [Some(0); 3].into_iter().collect();
        let mut given = Attributes { corner_texture, ..Attributes::default() };
        given.texture_coordinates.push(b"0 0");
        let mesh = Mesh::from_triangles(vec![[0.0; 3]; 4], vec![[0, 1, 2]]);
        let mesh = mesh.with_attributes(given).unwrap();
        let quad = mesh.with_faces(Faces::uniform(4, vec![0, 1, 2, 3]));
        assert_eq!(quad.attributes(), None);
    }
}
