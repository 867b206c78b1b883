//! Faces that hang on a surface by one edge: a fin, which only has to go.

use std::collections::{BTreeMap, BTreeSet};

use triquad::Mesh;

/// The fins of a mesh that certainly are some.
///
/// A face hangs by an edge if each of its other edges belongs to it alone, or to faces that hang by
/// that edge. Faces that hang are fins if they are exactly as many as the edge has too many, and
/// what is left there without them is closed and has more faces than they. Otherwise any of them
/// may be the surface: on an open mesh, and where a face is there twice.
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
        for (face, corners) in mesh.faces().iter().enumerate().filter(|(_, face)| is_sound(face)) {
            edges(corners).for_each(|edge| at.entry(edge).or_default().push(face));
        }
        let behind = faces_behind(mesh, &at);
        let bodies = Bodies::new(&at, &behind);
        let mut fins = Self { of_face: vec![None; mesh.faces().len()], faces: Vec::new() };
        for (edge, faces) in at.iter().filter(|(_, faces)| faces.len() > 2) {
            let (hanging, held): (Vec<usize>, Vec<usize>) =
                faces.iter().partition(|&&face| behind[face].hangs_by == Some(*edge));
            if held.len() == 2 && !has_equal(mesh, faces) && bodies.outweighs_fins(held[0]) {
                hanging.into_iter().for_each(|root| fins.add(root, &behind));
            }
        }
        fins
    }

    fn add(&mut self, root: usize, behind: &[Behind]) {
        let mut faces = all_behind(root, behind);
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
    let mut left: Vec<usize> =
        (0..behind.len()).filter(|&face| is_sound(&mesh.faces()[face])).collect();
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

/// What is left of a mesh without the faces that hang, in parts joined across edges.
struct Bodies {
    /// A part for each face, by one of its faces.
    parts: Vec<usize>,
    /// For each part its faces, less those that hang on it; none if it is not closed.
    weight: Vec<Option<isize>>,
}

impl Bodies {
    fn new(at: &FacesAt, behind: &[Behind]) -> Self {
        let is_held = |face: &usize| behind[*face].hangs_by.is_none();
        let mut neighbours = vec![Vec::new(); behind.len()];
        let mut is_closed = vec![true; behind.len()];
        for faces in at.values() {
            let held: Vec<usize> = faces.iter().copied().filter(is_held).collect();
            held.iter().for_each(|&face| is_closed[face] &= held.len() == 2);
            for pair in held.windows(2) {
                neighbours[pair[0]].push(pair[1]);
                neighbours[pair[1]].push(pair[0]);
            }
        }
        let parts = parts(&neighbours);
        let mut weight = vec![Some(0_isize); behind.len()];
        let mut change = |face: usize, by: Option<isize>| {
            let sum = |weight: isize| by.map(|by| weight + by);
            weight[parts[face]] = weight[parts[face]].and_then(sum);
        };
        for face in (0..behind.len()).filter(is_held) {
            change(face, is_closed[face].then_some(1));
        }
        for faces in at.values().filter(|faces| faces.len() > 2) {
            let Some(&body) = faces.iter().find(|face| is_held(face)) else { continue };
            for &root in faces.iter().filter(|face| !is_held(face)) {
                change(body, Some(-(all_behind(root, behind).len() as isize)));
            }
        }
        Self { parts, weight }
    }

    /// Returns true if the part of `face` is closed and has more faces than hang on it.
    fn outweighs_fins(&self, face: usize) -> bool {
        self.weight[self.parts[face]].is_some_and(|weight| weight > 0)
    }
}

/// Returns for each face the first of those that are reached from it.
fn parts(neighbours: &[Vec<usize>]) -> Vec<usize> {
    let mut parts: Vec<Option<usize>> = vec![None; neighbours.len()];
    for first in 0..neighbours.len() {
        let mut left = vec![first];
        while let Some(face) = left.pop() {
            if parts[face].is_none() {
                parts[face] = Some(first);
                left.extend(&neighbours[face]);
            }
        }
    }
    parts.into_iter().enumerate().map(|(face, part)| part.unwrap_or(face)).collect()
}

/// Returns a face that hangs and all that hang on it.
fn all_behind(root: usize, behind: &[Behind]) -> Vec<usize> {
    let mut faces = vec![root];
    let mut at = 0;
    while at < faces.len() {
        faces.extend(&behind[faces[at]].faces);
        at += 1;
    }
    faces
}

/// Returns true if two of `faces` have the same corners.
fn has_equal(mesh: &Mesh, faces: &[usize]) -> bool {
    let sorted = |&face: &usize| {
        let mut corners = mesh.faces()[face].to_vec();
        corners.sort_unstable();
        corners
    };
    let distinct: BTreeSet<Vec<u32>> = faces.iter().map(sorted).collect();
    distinct.len() < faces.len()
}

/// Returns true if the face has three corners at least and none twice.
fn is_sound(corners: &[u32]) -> bool {
    let distinct: BTreeSet<u32> = corners.iter().copied().collect();
    corners.len() > 2 && distinct.len() == corners.len()
}

/// Returns the edges of a face, the lower end of each first.
fn edges(corners: &[u32]) -> impl Iterator<Item = [u32; 2]> {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(&a, &b)| [a.min(b), a.max(b)])
}

#[cfg(test)]
mod tests {
    use triquad::mesh::Faces;

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

    /// The walls of a column without lids, one of them there twice or as two triangles more.
    #[test]
    fn walls_of_an_open_mesh_are_no_fins() {
        let walls = |more: &[&[u32]]| {
            let mut faces: Vec<Vec<u32>> =
                (0..16).map(|at| vec![at, at + 1, at + 18, at + 17]).collect();
            faces.extend(more.iter().map(|face| face.to_vec()));
            let faces = Faces::from_iter(faces.iter().map(Vec::as_slice));
            let count = faces.len();
            Fins::of(&Mesh::new(vec![[0.0; 3]; 40], faces)).at(0..count)
        };
        assert!(walls(&[&[3, 20, 21, 4]]).is_empty(), "reversed");
        assert!(walls(&[&[3, 4, 21, 20]]).is_empty(), "equal");
        assert!(walls(&[&[3, 4, 21], &[3, 21, 20]]).is_empty(), "cut");
        assert!(walls(&[&[3, 20, 36]]).is_empty(), "a fin, or the wall");
        assert!(walls(&[&[3, 3, 20], &[3, 20]]).is_empty(), "degenerate");
    }

    #[test]
    fn degenerate_faces_hold_no_fin() {
        let more = [[0, 1, 4], [0, 1, 1], [0, 0, 4]];
        assert_eq!(fins(&more), [4]);
    }

    #[test]
    fn of_loose_faces_at_an_edge_none_is_a_fin() {
        let three = Mesh::from_triangles(vec![[0.0; 3]; 5], vec![[0, 1, 2], [1, 0, 3], [0, 1, 4]]);
        assert!(Fins::of(&three).at(0..3).is_empty());
        let twice = Mesh::from_triangles(vec![[0.0; 3]; 4], vec![[0, 1, 2]; 3]);
        assert!(Fins::of(&twice).at(0..3).is_empty());
    }
}
