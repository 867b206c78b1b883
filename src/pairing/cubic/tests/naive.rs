//! Graphs on the way and the state of deciders, checked against the definitions.

use super::super::graph::{Candidate, DoubleEdge, EdgeId, Multigraph, NodeId, Reduction};
use super::super::solve::Decide;
use super::{DynamicGraph, SpanningTree};
use crate::triangulation::IdVec;

/// Returns a low-point search (Tarjan): whether `nodes` nodes can be reached from `root`, without
/// passing a loop or a bridge.
pub(super) fn is_legal(graph: &Multigraph, root: NodeId, nodes: usize) -> bool {
    struct LowPointSearch<'g> {
        graph: &'g Multigraph,
        reached: IdVec<NodeId, u32>,
        count: u32,
    }
    impl LowPointSearch<'_> {
        /// Returns the lowest number of a node that the subtree of `v` has an edge to, if all is
        /// well there.
        fn low_point(&mut self, v: NodeId, via: EdgeId) -> Option<u32> {
            self.count += 1;
            let number = self.count;
            self.reached[v] = number;
            let mut low = number;
            for edge in self.graph.around[v].into_iter().filter(|&edge| edge != via) {
                let [a, b] = self.graph.ends[edge];
                if a == b || (v != a && v != b) {
                    return None;
                }
                let g = self.graph.far_end(edge, v);
                let below = match self.reached[g] {
                    0 => self.low_point(g, edge).filter(|&below| below <= number)?,
                    seen => seen,
                };
                low = low.min(below);
            }
            Some(low)
        }
    }
    let reached = IdVec::filled(0, graph.around.len());
    let mut search = LowPointSearch { graph, reached, count: 0 };
    search.low_point(root, EdgeId::NONE) == Some(1) && search.count as usize == nodes
}

/// Decides by trying.
pub(super) struct Naive {
    pub(super) left: usize,
}

impl Decide for Naive {
    fn decide(&mut self, graph: &Multigraph, cut: &Reduction) -> Candidate {
        self.left -= 2;
        let is_good = |&candidate: &Candidate| {
            let mut next = graph.clone();
            let _ = next.reduce(cut, candidate);
            is_legal(&next, cut.w, self.left)
        };
        [Candidate::H1, Candidate::H2].into_iter().find(is_good).expect("Frink's theorem")
    }

    fn contract(&mut self, _: &Multigraph, _: &DoubleEdge) {
        self.left -= 2;
    }

    fn cost(&self, _: EdgeId, _: [EdgeId; 4]) -> u32 {
        0
    }
}

/// A decider whose state can be checked.
pub(super) trait Audit: Decide {
    /// Compares the state with a graph of `nodes` nodes, one of which is `root`.
    fn audit(&mut self, graph: &Multigraph, root: NodeId, nodes: usize);
}

impl Audit for Naive {
    fn audit(&mut self, _: &Multigraph, _: NodeId, _: usize) {}
}

/// Returns the nodes that can be reached from `root` by edges that `passable` lets through.
pub(super) fn reach(
    graph: &Multigraph,
    root: NodeId,
    passable: impl Fn(EdgeId) -> bool,
) -> Vec<NodeId> {
    let mut reached = vec![root];
    let mut next = 0;
    while next < reached.len() {
        for edge in graph.around[reached[next]].into_iter().filter(|&edge| passable(edge)) {
            let g = graph.far_end(edge, reached[next]);
            if !reached.contains(&g) {
                reached.push(g);
            }
        }
        next += 1;
    }
    reached
}

pub(super) fn edges_at(graph: &Multigraph, nodes: &[NodeId]) -> Vec<EdgeId> {
    let mut edges: Vec<_> = nodes.iter().flat_map(|&v| graph.around[v]).collect();
    edges.sort_unstable();
    edges.dedup();
    edges
}

impl Audit for SpanningTree {
    /// Checks that the tree spans the graph, the forest is that tree, and every cover crosses its
    /// cut.
    fn audit(&mut self, graph: &Multigraph, root: NodeId, nodes: usize) {
        let live = reach(graph, root, |_| true);
        let edges = edges_at(graph, &live);
        let tree: Vec<_> = edges.iter().copied().filter(|&edge| self.in_tree[edge]).collect();
        assert_eq!(self.in_tree.ids().filter(|&edge| self.in_tree[edge]).count(), nodes - 1);
        assert_eq!((live.len(), tree.len()), (nodes, nodes - 1));
        let below = reach(graph, root, |edge| self.in_tree[edge]);
        assert_eq!(below.len(), nodes, "the tree spans the graph");
        for &edge in &tree {
            let [a, b] = graph.ends[edge];
            let node = self.node(edge);
            self.forest.evert(a.0);
            assert_eq!((self.forest.lca(b.0, node), self.forest.lca(a.0, node)), (node, a.0));
            let cover = EdgeId(self.forest.value(node));
            assert!(edges.contains(&cover) && !self.in_tree[cover], "{cover:?} covers {edge:?}");
            let side = reach(graph, a, |other| self.in_tree[other] && other != edge);
            let ends = graph.ends[cover].map(|v| side.contains(&v));
            assert_ne!(ends[0], ends[1], "{cover:?} covers {edge:?}");
        }
    }
}

impl Audit for DynamicGraph {
    /// Checks that it has the edges of the graph and that its forest is a spanning tree, in both
    /// structures.
    fn audit(&mut self, graph: &Multigraph, root: NodeId, nodes: usize) {
        let live = reach(graph, root, |_| true);
        let edges = edges_at(graph, &live);
        for edge in graph.ends.ids() {
            assert_eq!(self.graph.contains(edge.0), edges.contains(&edge));
        }
        for &edge in &edges {
            let [mut ours, mut known] = [graph.ends[edge].map(|v| v.0), self.graph.ends(edge.0)];
            ours.sort_unstable();
            known.sort_unstable();
            assert_eq!(ours, known);
        }
        let in_tree = |edge: EdgeId| self.graph.is_tree_edge(edge.0);
        assert_eq!(edges.iter().filter(|&&edge| in_tree(edge)).count(), nodes - 1);
        assert_eq!(reach(graph, root, in_tree).len(), nodes);
        for &edge in edges.iter().filter(|&&edge| self.graph.is_tree_edge(edge.0)) {
            let [a, b] = graph.ends[edge].map(|v| v.0);
            self.forest.cut(a, b);
            self.forest.link(a, b);
        }
    }
}

/// Checks the graph after every step, and on request the state of the decider.
pub(super) struct Checked<D> {
    pub(super) decider: D,
    pub(super) left: usize,
    pub(super) audited: bool,
}

impl<D: Audit> Checked<D> {
    pub(super) fn check(&mut self, graph: &Multigraph, root: NodeId) {
        assert!(is_legal(graph, root, self.left), "after {} nodes", self.left);
        if self.audited {
            self.decider.audit(graph, root, self.left);
        }
    }
}

impl<D: Audit> Decide for Checked<D> {
    fn decide(&mut self, graph: &Multigraph, cut: &Reduction) -> Candidate {
        let candidate = self.decider.decide(graph, cut);
        self.left -= 2;
        let mut next = graph.clone();
        let _ = next.reduce(cut, candidate);
        self.check(&next, cut.w);
        candidate
    }

    fn contract(&mut self, graph: &Multigraph, double: &DoubleEdge) {
        self.decider.contract(graph, double);
        self.left -= 2;
        let mut next = graph.clone();
        let _ = next.contract(double);
        self.check(&next, double.w);
    }

    fn cost(&self, e: EdgeId, beside: [EdgeId; 4]) -> u32 {
        self.decider.cost(e, beside)
    }
}
