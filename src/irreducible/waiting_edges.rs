//! Lists of edges that wait for a vertex to become a neighbour of u, in one array.

use crate::triangulation::VertexId;

/// Linked lists of edges [u, w], each named by w. 8 bytes an edge.
#[derive(Debug, Default)]
pub(super) struct WaitingEdges(Vec<WaitingEdge>);

#[derive(Clone, Copy, Debug)]
struct WaitingEdge {
    w: VertexId,
    /// The next in its list, or [`WaitingEdges::NONE`].
    next: u32,
}

impl WaitingEdges {
    /// The empty list.
    pub(super) const NONE: u32 = u32::MAX;

    /// Removes all edges of all lists.
    pub(super) fn clear(&mut self) {
        self.0.clear();
    }

    /// Puts an edge before a list, and returns the list that this makes.
    pub(super) fn push_before(&mut self, next: u32, w: VertexId) -> u32 {
        self.0.push(WaitingEdge { w, next });
        self.0.len() as u32 - 1
    }

    /// Iterates over the edges of a list, the last one put into it first.
    pub(super) fn list(&self, first: u32) -> impl Iterator<Item = VertexId> {
        let edge = |at: u32| self.0.get(at as usize).copied();
        std::iter::successors(edge(first), move |one| edge(one.next)).map(|one| one.w)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_grow_at_the_front_and_share_no_edge() {
        let [a, b, c] = [0, 1, 2].map(VertexId::new);
        let mut edges = WaitingEdges::default();
        let one = edges.push_before(WaitingEdges::NONE, a);
        let other = edges.push_before(WaitingEdges::NONE, b);
        let one = edges.push_before(one, c);
        assert_eq!(edges.list(one).collect::<Vec<_>>(), [c, a]);
        assert_eq!(edges.list(other).collect::<Vec<_>>(), [b]);
        assert_eq!(edges.list(WaitingEdges::NONE).count(), 0);
        edges.clear();
        assert_eq!(edges.list(other).count(), 0);
    }
}
