//! Adjacency of a triangle list: which half-edges belong together, and is it a surface at all.

use super::half_edges::{HalfEdge, next, previous};

/// The half-edges of faces with the given corners, twins found by sorting. O(n log n).
///
/// # Panics
/// If an edge does not have exactly one half-edge in each direction, or the half-edges do not fit
/// a `u32`.
pub(super) fn match_half_edges(origin: &[u32]) -> Vec<HalfEdge> {
    assert!(u32::try_from(origin.len()).is_ok(), "the half-edges of a surface fit a u32");
    let mut sorted: Vec<(u64, u32)> = (0..origin.len())
        .map(|h| {
            let (a, b) = (origin[h], origin[next(h)]);
            (u64::from(a.min(b)) << 32 | u64::from(a.max(b)), h as u32)
        })
        .collect();
    sorted.sort_unstable();
    let mut half_edges: Vec<_> =
        origin.iter().map(|&origin| HalfEdge { origin, twin: 0 }).collect();
    for edge in sorted.chunk_by(|g, h| g.0 == h.0) {
        match *edge {
            [(_, g), (_, h)] if origin[g as usize] != origin[h as usize] => {
                half_edges[g as usize].twin = h;
                half_edges[h as usize].twin = g;
            }
            _ => panic!(
                "edge {} {} must have two triangles, oriented alike",
                edge[0].0 >> 32,
                edge[0].0 as u32
            ),
        }
    }
    half_edges
}

/// Walks once around every vertex. O(n).
///
/// # Panics
/// If the triangles of a vertex form more than one fan, or a vertex is not below `vertices`.
pub(super) fn assert_one_fan_each(half_edges: &[HalfEdge], vertices: usize) {
    let mut has_fan = vec![false; vertices];
    let mut walked = vec![false; half_edges.len()];
    for start in 0..half_edges.len() {
        if walked[start] {
            continue;
        }
        let v = half_edges[start].origin as usize;
        assert!(v < vertices, "vertex {v} does not exist");
        assert!(!has_fan[v], "the triangles of vertex {v} must form one fan");
        has_fan[v] = true;
        let mut h = start;
        while !walked[h] {
            walked[h] = true;
            h = half_edges[previous(h)].twin as usize;
        }
    }
}
