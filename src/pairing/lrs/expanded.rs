//! The outcome of an expansion, and the test hook that both expansions call.

use super::marks::EdgeMarks;
use crate::dual::{DualGraph, Matching};
use crate::triangulation::{Triangulation, VertexSplit};

/// Test hook, called after each split; `()` in production. `E` is the state of an expansion.
pub(super) trait ExpansionObserver<E> {
    /// A vertex has been expanded and its triangles have been paired; others are `pending`.
    fn expanded(&mut self, _expansion: &E, _pending: &[VertexSplit]) {}
}

impl<E> ExpansionObserver<E> for () {}

/// 𝒦 and the matching of its triangles.
pub(super) struct Expanded {
    pub(super) triangulation: Triangulation,
    pub(super) dual: DualGraph,
    pub(super) matching: Matching,
    /// Edges of 𝒦 that are flips. None is an edge of the input: when it is made, it ends at the
    /// vertex being expanded, all whose edges in the triangulation expanded so far are in 𝒦.
    pub(super) edge_flips: usize,
}

impl Expanded {
    /// Pairs the triangles of 𝒦 = `k` on both sides of the edges that are marked as in M. O(n).
    pub(super) fn new(k: Triangulation, marks: &EdgeMarks, edge_flips: usize) -> Self {
        let dual = DualGraph::new(&k);
        let matching = Matching::from_mates(marks.mates(&dual));
        Self { dual, matching, triangulation: k, edge_flips }
    }
}
