//! Faces as lists of vertex indices.

use std::iter::FusedIterator;
use std::ops::{Index, Range};

/// The most corners that a mesh may have: half-edges are numbered with 32 bits, and room to spare.
pub const MAX_CORNERS: usize = 1 << 31;

/// Faces of any number of corners, stored one after the other.
///
/// 4 bytes a corner; 4 bytes a face more if the faces differ in size.
///
/// ```
/// use triquad::mesh::Faces;
///
/// let mut faces = Faces::uniform(3, vec![0, 1, 2]);
/// faces.push(&[2, 1, 3, 4]);
/// assert_eq!((faces.len(), &faces[1]), (2, &[2, 1, 3, 4][..]));
/// ```
#[derive(Clone, Debug)]
pub struct Faces {
    pub(super) corners: Vec<u32>,
    shape: Shape,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Shape {
    Uniform(usize),
    /// End of each face in `corners`.
    Mixed(Vec<u32>),
}

impl Default for Faces {
    fn default() -> Self {
        Self::uniform(3, Vec::new())
    }
}

impl Faces {
    /// Makes faces of `arity` corners each.
    ///
    /// # Panics
    /// If `arity` is 0 or does not divide the number of corners.
    pub fn uniform(arity: usize, corners: Vec<u32>) -> Self {
        assert!(arity > 0 && corners.len().is_multiple_of(arity));
        Self { corners, shape: Shape::Uniform(arity) }
    }

    /// Makes an empty list with room for `corners` corners.
    pub fn with_capacity(corners: usize) -> Self {
        Self::uniform(3, Vec::with_capacity(corners))
    }

    /// Returns the number of faces.
    pub fn len(&self) -> usize {
        match &self.shape {
            Shape::Uniform(arity) => self.corners.len() / arity,
            Shape::Mixed(ends) => ends.len(),
        }
    }

    /// Returns whether there is no face.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Returns the vertex indices of all corners, face after face.
    pub fn corners(&self) -> &[u32] {
        &self.corners
    }

    /// Returns the vertex indices of all corners, face after face, and drops the rest.
    pub fn into_corners(self) -> Vec<u32> {
        self.corners
    }

    /// Returns the number of corners that all faces have in common, if they do.
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

    /// Returns the place of face `face` in [`Faces::corners`].
    ///
    /// # Panics
    /// If there is no such face.
    pub fn range(&self, face: usize) -> Range<usize> {
        match &self.shape {
            Shape::Uniform(arity) => face * arity..(face + 1) * arity,
            Shape::Mixed(ends) => {
                let start = if face == 0 { 0 } else { ends[face - 1] as usize };
                start..ends[face] as usize
            }
        }
    }

    /// Returns the vertex indices of one face, or `None` if there is no such face.
    pub fn get(&self, face: usize) -> Option<&[u32]> {
        (face < self.len()).then(|| &self[face])
    }

    /// Iterates over all faces in order.
    pub fn iter(&self) -> FacesIter<'_> {
        FacesIter { faces: self, range: 0..self.len() }
    }

    /// Makes room for so many more corners.
    #[cfg(feature = "files")]
    pub(super) fn reserve(&mut self, corners: usize) {
        self.corners.reserve_exact(corners);
    }

    /// Appends a face.
    pub fn push(&mut self, corners: &[u32]) {
        self.corners.extend_from_slice(corners);
        self.close_face(corners.len());
    }

    /// Appends all faces of another list.
    #[cfg(feature = "files")]
    pub(super) fn append(&mut self, other: &Self) {
        match (&mut self.shape, &other.shape) {
            (Shape::Uniform(arity), Shape::Uniform(others))
                if arity == others || self.corners.is_empty() =>
            {
                *arity = *others;
                self.corners.extend_from_slice(&other.corners);
            }
            _ => other.iter().for_each(|face| self.push(face)),
        }
    }

    /// Appends one corner to the face that the next [`Faces::close_face`] will end.
    #[cfg(feature = "files")]
    #[inline]
    pub(super) fn push_corner(&mut self, vertex: u32) {
        self.corners.push(vertex);
    }

    /// Makes a face of the last `arity` corners pushed.
    #[inline]
    pub(super) fn close_face(&mut self, arity: usize) {
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

impl PartialEq for Faces {
    /// Compares the faces; no faces are equal to no faces, whatever their arity was to be.
    fn eq(&self, other: &Self) -> bool {
        self.corners == other.corners
            && (self.shape == other.shape || self.is_empty() && other.is_empty())
    }
}

impl Eq for Faces {}

impl Index<usize> for Faces {
    type Output = [u32];

    #[inline]
    fn index(&self, face: usize) -> &[u32] {
        &self.corners[self.range(face)]
    }
}

impl<F: AsRef<[u32]>> Extend<F> for Faces {
    fn extend<T: IntoIterator<Item = F>>(&mut self, faces: T) {
        faces.into_iter().for_each(|face| self.push(face.as_ref()));
    }
}

impl<F: AsRef<[u32]>> FromIterator<F> for Faces {
    fn from_iter<T: IntoIterator<Item = F>>(faces: T) -> Self {
        let mut collected = Self::default();
        collected.extend(faces);
        collected
    }
}

impl<'a> IntoIterator for &'a Faces {
    type Item = &'a [u32];
    type IntoIter = FacesIter<'a>;

    fn into_iter(self) -> FacesIter<'a> {
        self.iter()
    }
}

/// Iterator over faces in order.
#[derive(Clone, Debug)]
pub struct FacesIter<'a> {
    faces: &'a Faces,
    range: Range<usize>,
}

impl<'a> Iterator for FacesIter<'a> {
    type Item = &'a [u32];

    fn next(&mut self) -> Option<&'a [u32]> {
        self.range.next().map(|face| &self.faces[face])
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.range.size_hint()
    }
}

impl DoubleEndedIterator for FacesIter<'_> {
    fn next_back(&mut self) -> Option<Self::Item> {
        self.range.next_back().map(|face| &self.faces[face])
    }
}

impl ExactSizeIterator for FacesIter<'_> {}

impl FusedIterator for FacesIter<'_> {}

#[cfg(feature = "serde")]
impl serde::Serialize for Faces {
    /// Writes a list of lists of vertex indices.
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self)
    }
}

#[cfg(feature = "serde")]
impl<'de> serde::Deserialize<'de> for Faces {
    fn deserialize<D: serde::Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        Ok(Vec::<Vec<u32>>::deserialize(from)?.into_iter().collect())
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
            assert!(faces.iter().rev().eq(given[..=count].iter().rev().copied()));
            assert_eq!((faces.get(count), faces.get(count + 1)), (Some(*face), None));
        }
        assert_eq!(faces.arity(), None);
    }

    #[test]
    fn equal_faces_stay_uniform() {
        let mut faces = Faces::default();
        faces.push(&[0, 1, 2, 3]);
        faces.push(&[0, 1, 2, 3]);
        assert_eq!((faces.arity(), faces.len()), (Some(4), 2));
    }

    #[test]
    fn faces_are_equal_if_their_corners_are() {
        assert_eq!(Faces::uniform(4, Vec::new()), Faces::default());
        assert_ne!(Faces::from_iter([&[][..]]), Faces::default());
        assert_ne!(Faces::uniform(4, vec![0; 12]), Faces::uniform(3, vec![0; 12]));
    }

    #[cfg(feature = "serde")]
    #[test]
    fn faces_are_lists_in_json() {
        let faces = Faces::from_iter([&[0, 1, 2][..], &[], &[2, 1, 3, 4]]);
        let json = serde_json::to_string(&faces).unwrap();
        assert_eq!(json, "[[0,1,2],[],[2,1,3,4]]");
        assert_eq!(serde_json::from_str::<Faces>(&json).unwrap(), faces);
    }
}
