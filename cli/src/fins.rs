//! Faces that hang on a surface by one edge: a fin, which only has to go.

use std::collections::BTreeMap;

use triquad::Mesh;

/// The fins of a mesh.
///
/// A face hangs by an edge if each of its other edges belongs to it alone, or to faces that hang by
/// that edge. If more faces hang by an edge than it has too many, none is a fin: any of them may be
/// the surface.
pub struct Fins {
    /// The number of the fin of each face, if it is in one.
    of_face: Vec<Option<usize>>,
    /// The faces of each fin.
    faces: Vec<Vec<usize>>,
}

/// The faces at each edge, by its ends.
type FacesAt = BTreeMap<[u32; 2], Vec<usize>>;

impl Fins {
    /// Finds all fins. O(n log n).
    pub fn of(mesh: &Mesh) -> Self {
        let mut at = FacesAt::new();
        for (face, corners) in mesh.faces().iter().enumerate() {
            edges(corners).for_each(|edge| at.entry(edge).or_default().push(face));
        }
        let behind = faces_behind(mesh, &at);
        let mut fins = Self { of_face: vec![None; mesh.faces().len()], faces: Vec::new() };
        for (edge, faces) in at.iter().filter(|(_, faces)| faces.len() > 2) {
            let hanging: Vec<usize> = faces
                .iter()
                .copied()
                .filter(|&face| behind[face].hangs_by == Some(*edge))
                .collect();
            if hanging.len() + 2 <= faces.len() {
                hanging.into_iter().for_each(|root| fins.add(root, &behind));
            }
        }
        fins
    }

    fn add(&mut self, root: usize, behind: &[Behind]) {
        let mut faces = vec![root];
        let mut at = 0;
        while at < faces.len() {
            faces.extend(&behind[faces[at]].faces);
            at += 1;
        }
        faces.sort_unstable();
        faces.iter().for_each(|&face| self.of_face[face] = Some(self.faces.len()));
        self.faces.push(faces);
    }

    /// Returns the faces of the fins that any of `faces` belong to, in order.
    pub fn at(&self, faces: impl Iterator<Item = usize>) -> Vec<usize> {
        let mut fins: Vec<usize> = faces.filter_map(|face| self.of_face[face]).collect();
        fins.sort_unstable();
        fins.dedup();
        let mut faces: Vec<usize> =
            fins.into_iter().flat_map(|fin| self.faces[fin].iter().copied()).collect();
        faces.sort_unstable();
        faces
    }
}

/// The part of a surface behind the edge by which a face hangs.
#[derive(Clone, Default)]
struct Behind {
    /// The edge by which the face hangs.
    hangs_by: Option<[u32; 2]>,
    /// Faces that hang on this one.
    faces: Vec<usize>,
}

/// Takes away faces that hang by one edge, the outermost first, as long as there are any.
fn faces_behind(mesh: &Mesh, at: &FacesAt) -> Vec<Behind> {
    let mut behind = vec![Behind::default(); mesh.faces().len()];
    let mut left: Vec<usize> = (0..behind.len()).collect();
    while let Some(face) = left.pop() {
        if behind[face].hangs_by.is_some() {
            continue;
        }
        let is_held = |edge: &[u32; 2]| {
            let mut others = at[edge].iter().filter(|&&other| other != face);
            others.any(|&other| behind[other].hangs_by != Some(*edge))
        };
        let mut held = edges(&mesh.faces()[face]).filter(is_held);
        let (Some(edge), None) = (held.next(), held.next()) else { continue };
        behind[face].hangs_by = Some(edge);
        if let [one, other] = at[&edge][..] {
            let outer = if one == face { other } else { one };
            behind[outer].faces.push(face);
            left.push(outer);
        }
    }
    behind
}

/// Returns the edges of a face, the lower end of each first.
fn edges(corners: &[u32]) -> impl Iterator<Item = [u32; 2]> {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(&a, &b)| [a.min(b), a.max(b)])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A tetrahedron, and faces at its edge 0-1 or elsewhere.
    fn fins(more: &[[u32; 3]]) -> Vec<usize> {
        let mut triangles = vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
        triangles.extend(more);
        let count = triangles.len();
        let mesh = Mesh::from_triangles(vec![[0.0; 3]; 12], triangles);
        Fins::of(&mesh).at(0..count)
    }

    #[test]
    fn what_hangs_by_one_edge_is_a_fin_with_all_that_hangs_on_it() {
        assert!(fins(&[]).is_empty());
        assert_eq!(fins(&[[0, 1, 4]]), [4]);
        assert_eq!(fins(&[[0, 1, 4], [1, 0, 5]]), [4, 5]);
        assert_eq!(fins(&[[5, 4, 1], [0, 1, 4], [1, 6, 5]]), [4, 5, 6]);
        // At two edges, and between them.
        assert_eq!(fins(&[[0, 1, 4], [2, 3, 5]]), [4, 5]);
        assert!(fins(&[[0, 1, 4], [4, 1, 2]]).is_empty());
    }

    #[test]
    fn of_loose_faces_at_an_edge_none_is_a_fin() {
        let three = Mesh::from_triangles(vec![[0.0; 3]; 5], vec![[0, 1, 2], [1, 0, 3], [0, 1, 4]]);
        assert!(Fins::of(&three).at(0..3).is_empty());
        let twice = Mesh::from_triangles(vec![[0.0; 3]; 4], vec![[0, 1, 2]; 3]);
        assert!(Fins::of(&twice).at(0..3).is_empty());
    }
}
