//! Edges of one face only, and vertices that lie on them.

use std::collections::BTreeSet;

use triquad::Mesh;

/// A T-junction: a vertex that lies on a boundary edge and does not end it.
#[derive(Debug, PartialEq, Eq)]
pub struct Junction {
    /// The vertex, from 0.
    pub vertex: u32,
    /// The edge.
    pub edge: [u32; 2],
}

/// Distance from the edge, as a share of its length, up to which a vertex lies on it.
const NEAR: f64 = 1e-6;

impl Junction {
    /// Finds a T-junction of a boundary edge, or of one that has an end in common with it.
    /// O(n log n), and the boundary's length for each of these edges.
    pub fn near(mesh: &Mesh, edge: [u32; 2]) -> Option<Self> {
        let edges = rim_edges(mesh);
        let vertices: BTreeSet<u32> = edges.iter().copied().flatten().collect();
        let mut around =
            edges.iter().copied().filter(|other| edge.iter().any(|end| other.contains(end)));
        around.find_map(|edge| {
            let mut vertices = vertices.iter().copied();
            let vertex = vertices.find(|&vertex| lies_between(mesh, edge, vertex))?;
            Some(Self { vertex, edge })
        })
    }
}

/// Returns the edges that belong to one face only, the lower end of each first. O(n log n).
pub fn rim_edges(mesh: &Mesh) -> Vec<[u32; 2]> {
    let mut edges = Vec::with_capacity(mesh.faces().corners().len());
    for face in mesh.faces() {
        let next = face.iter().cycle().skip(1);
        edges.extend(face.iter().zip(next).map(|(&a, &b)| [a.min(b), a.max(b)]));
    }
    edges.sort_unstable();
    let single = edges.chunk_by(|one, other| one == other).filter(|group| group.len() == 1);
    single.map(|group| group[0]).collect()
}

/// Returns whether a vertex lies on an edge, apart from both ends.
fn lies_between(mesh: &Mesh, [from, to]: [u32; 2], vertex: u32) -> bool {
    let at = |v: u32| mesh.positions().get(v as usize).copied();
    let (Some(from), Some(to), Some(at)) = (at(from), at(to), at(vertex)) else { return false };
    let minus = |one: [f64; 3], other: [f64; 3]| [0, 1, 2].map(|axis| one[axis] - other[axis]);
    let dot =
        |one: [f64; 3], other: [f64; 3]| -> f64 { one.iter().zip(other).map(|(x, y)| x * y).sum() };
    let (along, offset) = (minus(to, from), minus(at, from));
    let square = dot(along, along);
    let share = dot(offset, along) / square;
    let apart = minus(offset, along.map(|x| share * x));
    share > NEAR && share < 1.0 - NEAR && dot(apart, apart) <= NEAR * NEAR * square
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_vertex_on_an_edge_is_found_from_each_edge_of_the_gap() {
        let corners = [[0.0, 0.0], [3.0, 0.0], [0.0, 1.0], [1.0, 0.0], [2.0, -1.0]];
        let positions = corners.map(|[x, y]| [x, y, 0.0]).to_vec();
        let triangles = vec![[0, 1, 2], [3, 0, 4], [1, 3, 4]];
        let mesh = Mesh::from_triangles(positions.clone(), triangles);
        let junction = Some(Junction { vertex: 3, edge: [0, 1] });
        for edge in [[0, 1], [0, 3], [1, 3]] {
            assert_eq!(Junction::near(&mesh, edge), junction);
        }
        // A hole is none.
        let mut apart = positions;
        apart[3][1] = -0.01;
        let mesh = Mesh::from_triangles(apart, vec![[0, 1, 2], [3, 0, 4], [1, 3, 4]]);
        assert_eq!(Junction::near(&mesh, [0, 1]), None);
    }
}
