//! Results of programs that flip edges, as LRS does: pairs of triangles of another triangulation of
//! the same surface.

use std::collections::HashSet;

use triquad::Mesh;
use triquad::mesh::Faces;

/// Cuts every face of four corners into two triangles: along an edge of `input` where there is one,
/// and along no edge that is there already, if that can be. O(n) on average.
pub fn cut(quads: &Mesh, input: &Mesh) -> Mesh {
    let (given, mut taken) = (edges(input), edges(quads));
    let mut triangles = Vec::with_capacity(input.faces().len());
    for face in quads.faces() {
        let &[a, b, c, d] = face else { continue };
        let is_worse = |end: [u32; 2]| (taken.contains(&end), !given.contains(&end));
        let (one, other) = (sorted(a, c), sorted(b, d));
        if is_worse(one) <= is_worse(other) {
            taken.insert(one);
            triangles.extend([[a, b, c], [c, d, a]]);
        } else {
            taken.insert(other);
            triangles.extend([[b, c, d], [d, a, b]]);
        }
    }
    input.clone().with_faces(Faces::uniform(3, triangles.into_flattened()))
}

/// Returns all edges of the faces of a mesh. O(n) on average.
pub fn edges(mesh: &Mesh) -> HashSet<[u32; 2]> {
    let mut edges = HashSet::with_capacity(mesh.faces().corners().len() / 2);
    for face in mesh.faces() {
        let next = face.iter().cycle().skip(1);
        edges.extend(face.iter().zip(next).map(|(&u, &v)| sorted(u, v)));
    }
    edges
}

/// Returns the ends of an edge, the lower first.
pub fn sorted(u: u32, v: u32) -> [u32; 2] {
    [u.min(v), u.max(v)]
}
