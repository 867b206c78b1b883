//! A cover for every edge of a spanning tree: the certificate that there is no bridge.

use super::graph::{EdgeId, Multigraph, NodeId};
use crate::disjoint_sets::DisjointSets;
use crate::triangulation::IdVec;

/// Returns for each node but node 0 a cover of its edge to its parent: an edge outside the
/// breadth-first tree whose cycle with the tree passes it.
///
/// An edge outside covers the tree edges of the path between its ends; those that are covered
/// already are skipped with disjoint sets, whose roots are the uppermost nodes. O(n log n), in
/// practice O(n); 8 bytes a node.
///
/// # Errors
/// A tree edge without a cover, which is a bridge.
pub(super) fn cover_tree_edges(graph: &Multigraph) -> Result<IdVec<NodeId, EdgeId>, EdgeId> {
    let mut cover = IdVec::filled(EdgeId::NONE, graph.around.len());
    let mut covered = DisjointSets::new(graph.around.len());
    for edge in graph.ends.ids() {
        let [mut a, mut b] = graph.ends[edge];
        if graph.around[b][0] == edge {
            continue;
        }
        // A node's number exceeds its parent's: the higher one is not above the lower.
        loop {
            [a, b] = [a, b].map(|v| NodeId(covered.find(v.0)));
            let lower = a.max(b);
            if a == b {
                break;
            }
            let (parent, _) = graph.parent(lower).expect("node 0 is the root");
            cover[lower] = edge;
            covered.hang(lower.0, parent.0);
            (a, b) = (parent, a.min(b));
        }
    }
    let bare = cover.ids().skip(1).find(|&v: &NodeId| cover[v] == EdgeId::NONE);
    bare.map_or(Ok(cover), |v| Err(graph.around[v][0]))
}
