//! DS: fully dynamic connectivity and a link-cut tree decide. O(n log² n).
//!
//! In the spirit of K. Diks and P. Stanczyk, *Perfect matching for biconnected cubic graphs in O(n
//! log² n) time*, SOFSEM 2010. Their full text was not at hand; the reconstruction, with the two
//! structures that they name, is proved in the [module's text](super), and tested.
//!
//! The graph is kept by [`DynamicConnectivity`], with a spanning forest, and that forest once more
//! in a [`LinkCutForest`], which answers questions about paths. A reduction deletes the five edges
//! at u and v. If that leaves the rest in two components, both new edges must go from one to the
//! other; if in one, the rule for trees (`super`) chooses.

use super::graph::{Candidate, DoubleEdge, EdgeId, Multigraph, NodeId, Reduction};
use super::solve::Decide;
use super::tree_rule::tree_rule;
use crate::dynamic::{Deletion, DynamicConnectivity, LinkCutForest};

/// The graph of the moment and its spanning tree. O(n) memory, O(n log n) at worst.
#[derive(Clone)]
pub(super) struct DynamicGraph {
    pub(super) graph: DynamicConnectivity,
    /// The spanning forest of `graph`.
    pub(super) forest: LinkCutForest,
}

impl DynamicGraph {
    /// Makes the structure for a graph as built, with its breadth-first tree. O(n log n).
    pub(super) fn new(graph: &Multigraph) -> Self {
        let nodes = graph.around.len();
        let parent = |v| graph.parent(NodeId(v)).map(|(parent, _)| parent.0);
        let forest = LinkCutForest::from_parents(nodes, parent);
        let mut connectivity = DynamicConnectivity::new(nodes, graph.ends.len());
        let in_tree = |&edge: &EdgeId| graph.around[graph.ends[edge][1]][0] == edge;
        let (tree, rest): (Vec<_>, Vec<_>) = graph.ends.ids().partition(in_tree);
        for edge in tree.into_iter().chain(rest) {
            let [a, b] = graph.ends[edge];
            connectivity.insert(edge.0, a.0, b.0);
        }
        Self { graph: connectivity, forest }
    }

    /// Deletes edges, those outside the spanning forest first, so that they replace none of the
    /// others. Returns the number of components that fell in two.
    fn delete<const N: usize>(&mut self, edges: [EdgeId; N]) -> u32 {
        let mut splits = 0;
        for in_tree in [false, true] {
            for edge in edges {
                if self.graph.contains(edge.0) && (in_tree || !self.graph.is_tree_edge(edge.0)) {
                    splits += u32::from(self.delete_one(edge));
                }
            }
        }
        splits
    }

    /// Deletes one edge. Returns whether a component fell in two.
    fn delete_one(&mut self, edge: EdgeId) -> bool {
        let [a, b] = self.graph.ends(edge.0);
        let deletion = self.graph.delete(edge.0);
        if deletion != Deletion::NonTree {
            self.forest.cut(a, b);
        }
        if let Deletion::Replaced(other) = deletion {
            let [a, b] = self.graph.ends(other);
            self.forest.link(a, b);
        }
        deletion == Deletion::Split
    }

    fn insert(&mut self, edge: EdgeId, a: NodeId, b: NodeId) {
        if self.graph.insert(edge.0, a.0, b.0) {
            self.forest.link(a.0, b.0);
        }
    }
}

impl Decide for DynamicGraph {
    fn decide(&mut self, _: &Multigraph, cut: &Reduction) -> Candidate {
        // In this order, u and v are leaves when the last of their tree edges go: nothing is
        // searched.
        let splits = self.delete([cut.f, cut.c, cut.e, cut.r, cut.s]);
        debug_assert!(splits == 2 || splits == 3, "u, v and the rest in one or two components");
        let candidate = if splits == 2 {
            tree_rule(&mut self.forest, cut, 0)
        } else if self.graph.connected(cut.w.0, cut.y_s.0) {
            Candidate::H1
        } else {
            Candidate::H2
        };
        let [(_, near_w), (_, near_x)] = cut.joined(candidate);
        self.insert(cut.f, cut.w, near_w);
        self.insert(cut.c, cut.x, near_x);
        candidate
    }

    fn contract(&mut self, _: &Multigraph, double: &DoubleEdge) {
        let DoubleEdge { f, p, q, t, w, x, .. } = *double;
        self.delete([f, p, q, t]);
        self.insert(f, w, x);
    }

    /// Returns the number of tree edges to be deleted.
    fn cost(&self, e: EdgeId, beside: [EdgeId; 4]) -> u32 {
        let tree_edge = |edge: EdgeId| u32::from(self.graph.is_tree_edge(edge.0));
        tree_edge(e) + beside.map(tree_edge).into_iter().sum::<u32>()
    }
}
