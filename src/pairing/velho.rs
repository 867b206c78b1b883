//! SG with the longest edge first, after Velho (*Quadrilateral meshing using 4-8 clustering*, 2000;
//! Lemos et al., section 3.1).
//!
//! The text of Velho was not at hand. Lemos et al. state that his heuristic selects edges for the
//! shape of the quads, takes Θ(n log n) time and pairs no more triangles than [`simple_greedy`]. A
//! quad whose diagonal is the longest edge of both triangles is the block of 4-8 meshes.
//!
//! [`simple_greedy`]: super::simple_greedy

use super::simple_greedy::edges_of;
use crate::dual::{DualGraph, Matching};
use crate::mesh::Mesh;
use crate::triangulation::{HalfEdgeId, Surface, TriangleId, VertexId};
use crate::vector::{difference, dot};

/// Pairs the triangles on both sides of each edge, the longest first, if both are unpaired.
///
/// Edges of equal length go in the order in which the triangles first have them. `squared_length`
/// is called once for each edge. The result is a maximal matching. Θ(n log n) time; 24 bytes a
/// triangle.
pub fn velho(graph: &DualGraph, squared_length: impl Fn(HalfEdgeId) -> f64) -> Matching {
    let with_length = |edge: u32| (squared_length(HalfEdgeId(edge)), edge);
    let mut edges: Vec<(f64, u32)> = edges_of(graph).into_iter().map(with_length).collect();
    edges.sort_unstable_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    let mut matching = Matching::empty(graph.len());
    for (_, edge) in edges {
        let f = TriangleId(edge / 3);
        let g = graph.sides_or_none(f)[edge as usize % 3];
        if !matching.is_paired(f) && !matching.is_paired(g) {
            matching.pair(f, g);
        }
    }
    matching
}

/// Returns the square of the length of an edge of `surface`, whose coordinates `mesh` has.
pub(crate) fn squared_length(surface: &impl Surface, mesh: &Mesh, h: HalfEdgeId) -> f64 {
    let [a, b] = surface.ends(h).map(|v: VertexId| mesh.positions()[v.index()]);
    let along = difference(b, a);
    dot(along, along)
}
