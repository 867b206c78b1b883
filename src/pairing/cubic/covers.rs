//! A cover for every edge of a spanning tree: the certificate that there is no bridge.

use super::graph::{EdgeId, Multigraph, NodeId};
use crate::triangulation::{Id, IdVec};

/// For each node but node 0 an edge outside the breadth-first tree whose cycle with the tree passes
/// the node's edge to its parent.
///
/// An edge outside covers the tree edges of the path between its ends; those that are covered already
/// are skipped with disjoint sets. O(n log n) with path halving alone, in practice O(n); 8 bytes a
/// node.
///
/// # Errors
/// A tree edge without a cover, which is a bridge.
pub(super) fn covers(graph: &Multigraph) -> Result<IdVec<NodeId, EdgeId>, EdgeId> {
    let mut cover = IdVec::filled(EdgeId::NONE, graph.around.len());
    let mut top = IdVec::from((0..graph.around.len()).map(NodeId::new).collect::<Vec<_>>());
    for edge in graph.ends.ids() {
        let [mut a, mut b] = graph.ends[edge];
        if graph.around[b][0] == edge {
            continue;
        }
        // A node's number exceeds its parent's: the higher one is not above the lower.
        loop {
            [a, b] = [highest(&mut top, a), highest(&mut top, b)];
            let lower = a.max(b);
            if a == b {
                break;
            }
            let (parent, _) = graph.parent(lower).expect("node 0 is the root");
            cover[lower] = edge;
            top[lower] = parent;
            (a, b) = (parent, a.min(b));
        }
    }
    let bare = cover.ids().skip(1).find(|&v: &NodeId| cover[v] == EdgeId::NONE);
    bare.map_or(Ok(cover), |v| Err(graph.around[v][0]))
}

/// The uppermost node that covered tree edges lead to from `v`.
fn highest(top: &mut IdVec<NodeId, NodeId>, mut v: NodeId) -> NodeId {
    while top[v] != v {
        let up = top[top[v]];
        top[v] = up;
        v = up;
    }
    v
}
