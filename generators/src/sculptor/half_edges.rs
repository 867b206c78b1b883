//! The half-edges of a surface that is edited.
//!
//! Face `f` owns half-edges `3f`, `3f + 1`, `3f + 2`, counter-clockwise. Each stores the vertex it
//! leaves and its twin on the other side of the edge.

/// A simple closed oriented triangulation that can be edited.
///
/// Coordinates are carried along but promise nothing: after flips and joins the surface may pass
/// through itself, and vertices may coincide.
#[derive(Clone, Debug)]
pub struct Sculptor {
    pub(super) positions: Vec<[f64; 3]>,
    /// Three for each face.
    pub(super) half_edges: Vec<HalfEdge>,
}

/// One side of an edge.
#[derive(Clone, Copy, Debug)]
pub(super) struct HalfEdge {
    /// The vertex it leaves.
    pub(super) origin: u32,
    /// The half-edge on the other side.
    pub(super) twin: u32,
}

/// The next half-edge of the same face.
pub(super) fn next(h: usize) -> usize {
    if h % 3 == 2 { h - 2 } else { h + 1 }
}

/// The previous half-edge of the same face.
pub(super) fn previous(h: usize) -> usize {
    if h.is_multiple_of(3) { h + 2 } else { h - 1 }
}
