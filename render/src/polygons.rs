//! The mesh to draw, as borrowed arrays.

/// Positions and faces of a mesh, borrowed from the caller. Faces may have any number of corners.
#[derive(Clone, Copy, Debug)]
pub struct Polygons<'a> {
    positions: &'a [[f64; 3]],
    corners: &'a [u32],
    shape: Shape<'a>,
}

#[derive(Clone, Copy, Debug)]
enum Shape<'a> {
    Uniform(usize),
    Mixed(&'a [u32]),
}

impl<'a> Polygons<'a> {
    /// Borrows faces of `arity` corners each, stored one after the other in `corners`.
    ///
    /// # Panics
    /// If `arity` is 0 or does not divide the number of corners.
    pub fn uniform(positions: &'a [[f64; 3]], corners: &'a [u32], arity: usize) -> Self {
        assert!(arity > 0 && corners.len().is_multiple_of(arity), "faces of {arity} corners");
        Self { positions, corners, shape: Shape::Uniform(arity) }
    }

    /// Borrows faces of different sizes; `ends` has the end of each face in `corners`.
    ///
    /// # Panics
    /// If the ends decrease or the last one is not the number of corners. O(faces).
    pub fn mixed(positions: &'a [[f64; 3]], corners: &'a [u32], ends: &'a [u32]) -> Self {
        let last = ends.last().map_or(0, |&end| end as usize);
        assert!(ends.is_sorted() && last == corners.len(), "ends of {} corners", corners.len());
        Self { positions, corners, shape: Shape::Mixed(ends) }
    }

    /// Returns the coordinates of all vertices.
    pub fn positions(&self) -> &'a [[f64; 3]] {
        self.positions
    }

    /// Returns the vertex indices of all corners, face after face.
    pub fn corners(&self) -> &'a [u32] {
        self.corners
    }

    /// Returns the number of faces.
    pub fn face_count(&self) -> usize {
        match self.shape {
            Shape::Uniform(arity) => self.corners.len() / arity,
            Shape::Mixed(ends) => ends.len(),
        }
    }

    /// Returns the vertex indices of face `face`.
    ///
    /// # Panics
    /// If there is no such face.
    pub fn face(&self, face: usize) -> &'a [u32] {
        match self.shape {
            Shape::Uniform(arity) => &self.corners[face * arity..(face + 1) * arity],
            Shape::Mixed(ends) => {
                let start = if face == 0 { 0 } else { ends[face - 1] as usize };
                &self.corners[start..ends[face] as usize]
            }
        }
    }

    /// Iterates over all faces in order.
    pub fn faces(&self) -> impl ExactSizeIterator<Item = &'a [u32]> {
        let polygons = *self;
        (0..self.face_count()).map(move |face| polygons.face(face))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faces_of_one_size_and_of_many_are_cut_where_they_end() {
        let corners = [0, 1, 2, 3, 4, 5];
        let uniform = Polygons::uniform(&[], &corners, 3);
        assert!(uniform.faces().eq([&[0, 1, 2], &[3, 4, 5]]));
        let mixed = Polygons::mixed(&[], &corners, &[4, 4, 6]);
        let expected: [&[u32]; 3] = [&[0, 1, 2, 3], &[], &[4, 5]];
        assert!(mixed.faces().eq(expected));
    }

    #[test]
    #[should_panic(expected = "ends of 2 corners")]
    fn ends_beyond_the_corners_are_refused() {
        Polygons::mixed(&[], &[0, 1], &[3]);
    }
}
