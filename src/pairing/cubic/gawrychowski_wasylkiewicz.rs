//! GW: a spanning tree with covers in one link-cut tree decides. O(n log n).
//!
//! In the spirit of P. Gawrychowski and M. Wasylkiewicz, *Finding Perfect Matchings in Bridgeless
//! Cubic Multigraphs Without Dynamic (2-)connectivity*, ESA 2024. Their full text was not at hand;
//! the reconstruction is proved here and in the [module's text](super), and tested.
//!
//! Kept for every graph on the way: a spanning tree T, and for every edge of T a *cover*, an edge
//! outside T whose cycle with T passes it. The covers certify that there is no bridge. They also
//! mend T after u and v have been removed:
//!
//! 1. T − {u, v} has K components, 1 ≤ K ≤ 4, each with a slot (w, x, y_r, y_s).
//! 2. Let K > 1. Then u or v is a *fork*, at which T fell apart: both are if e was in T, or else
//!    those with two more edges of T. Every component hangs by one edge of T, from a slot to a
//!    fork, which separated it from the rest, so that edge's cover leaves the component. If it is
//!    none of the removed edges, and its ends are not connected by now, it joins T, and K falls by
//!    one. It is none of them if the component has but one slot, as those edges end in slots. So
//!    afterwards K = 1, or K = 2 with two slots each.
//! 3. K = 1: T spans H', and the rule for trees chooses. Both new edges stay outside T and become
//!    the covers of their paths in T. K = 2: the candidate with two edges from one component to the
//!    other. One joins T, the other becomes the cover of its path in T, which runs over the first.
//!
//! ```text
//!   K = 1    w ~~~~~~ y_r                    K = 2    w ~~~~~~ x     one component
//!                ~                                    |        |
//!                ~   f' covers w ~ y_r,               f'       c'    c' joins T, and f' covers
//!                ~   c' covers x ~ y_s                |        |     w ~ x - y_s ~ y_r
//!            x ~~~~~~ y_s                            y_r ~~~~ y_s    the other one
//! ```
//!
//! In both cases these paths make up the smallest subtree S of the new tree that has all four
//! slots: for K = 1, each edge of S separates slots, but not, by the rule, one pair from the other.
//! So in S all covers are new. *No other cover needs to change.* Let k be a tree edge outside S.
//! One side X of T − k has no slot. What joined T in step 2 or 3 has components, and so slots, on
//! both sides: it is not in X, and does not leave it; X is connected by old tree edges, none but k
//! leaves it, and X is a side of the old T − k too. The cover of k left X. It is no removed edge,
//! as those end in slots, u or v, and it has not joined T, or it would leave X as a second tree
//! edge; so it is still there, and leaves X.

use super::graph::{Candidate, DoubleEdge, EdgeId, Multigraph, NodeId, Reduction};
use super::solve::Decide;
use super::tree_rule::tree_rule;
use crate::dynamic::LinkCutForest;
use crate::triangulation::IdVec;

/// The spanning tree. 16 bytes for each node and each edge, and one for each edge.
#[derive(Clone)]
pub(super) struct SpanningTree {
    /// Nodes, and behind them edges: a tree edge is a node of degree 2 whose value is its cover,
    /// other edges are alone.
    pub(super) forest: LinkCutForest,
    /// Number of nodes of the graph.
    nodes: u32,
    pub(super) in_tree: IdVec<EdgeId, bool>,
}

/// The remains of T without u and v. Slots are numbered in the order w, x, y_r, y_s.
struct Rest {
    /// Number of components, K.
    count: u32,
    /// If K = 1, a slot whose node is the root.
    root: usize,
    /// If K > 1, the covers that the edges from forks to slots had.
    cover: [EdgeId; 4],
}

impl SpanningTree {
    /// Makes the breadth-first tree of a graph as built, with the given covers.
    /// O(n).
    pub(super) fn new(graph: &Multigraph, cover: &IdVec<NodeId, EdgeId>) -> Self {
        let nodes = graph.around.len() as u32;
        let mut in_tree = IdVec::filled(false, graph.ends.len());
        cover.ids().skip(1).for_each(|v| in_tree[graph.around[v][0]] = true);
        let parent = |node: u32| match node.checked_sub(nodes) {
            None => graph.parent(NodeId(node)).map(|(_, edge)| nodes + edge.0),
            Some(edge) => in_tree[EdgeId(edge)].then(|| graph.ends[EdgeId(edge)][0].0),
        };
        let count = graph.around.len() + graph.ends.len();
        let mut forest = LinkCutForest::from_parents(count, parent);
        for v in cover.ids().skip(1) {
            forest.set_value(nodes + graph.around[v][0].0, cover[v].0);
        }
        Self { forest, nodes, in_tree }
    }

    /// Returns the node of the forest that stands for `edge`.
    pub(super) fn node(&self, edge: EdgeId) -> u32 {
        self.nodes + edge.0
    }

    fn connected(&mut self, a: NodeId, b: NodeId) -> bool {
        self.forest.connected(a.0, b.0)
    }

    /// Makes `edge` a tree edge between `a` and `b`.
    fn link(&mut self, edge: EdgeId, [a, b]: [NodeId; 2]) {
        self.in_tree[edge] = true;
        self.forest.link_through(a.0, self.node(edge), b.0);
    }

    /// Cuts a node of the forest from the one above it.
    fn cut_above(&mut self, node: u32) {
        let above = self.forest.cut_above(node);
        debug_assert!(above.is_some(), "{node} is a root");
    }

    /// Returns the cover of a tree edge.
    fn cover(&mut self, edge: EdgeId) -> EdgeId {
        debug_assert!(self.in_tree[edge]);
        EdgeId(self.forest.value(self.node(edge)))
    }

    /// Removes `u`, `v` and the edges at them, whose other ends have been cut off.
    fn dissolve(&mut self, u: NodeId, v: NodeId, edges: &[EdgeId]) {
        let mut nodes = [u.0; 7];
        nodes[1] = v.0;
        for (node, &edge) in nodes[2..].iter_mut().zip(edges) {
            *node = self.node(edge);
            self.in_tree[edge] = false;
        }
        self.forest.dissolve(&nodes[..2 + edges.len()]);
    }

    /// Returns the number K of components of T − {u, v} for an edge `e` between u and v, and the
    /// edges beside it.
    fn component_count(&self, e: EdgeId, beside: [EdgeId; 4]) -> u32 {
        let hanging = beside.map(|edge| u32::from(self.in_tree[edge]));
        hanging.into_iter().sum::<u32>() - u32::from(!self.in_tree[e])
    }

    /// Removes u and v (step 1).
    fn isolate(&mut self, cut: &Reduction) -> Rest {
        let slots = cut.slots();
        let hangs = slots.map(|(edge, _)| self.in_tree[edge]);
        let count = self.component_count(cut.e, slots.map(|(edge, _)| edge));
        let root = hangs.iter().position(|&hangs| hangs).expect("T spans the graph");
        let mut cover = [EdgeId::NONE; 4];
        if count == 1 {
            // The removed part hangs on the rest of T as two leaves, u and v, or as one twig of
            // both.
            self.forest.evert(slots[root].1.0);
            for i in (0..4).filter(|&i| hangs[i]) {
                self.cut_above(self.node(slots[i].0));
            }
        } else {
            cover = self.isolate_forks(cut, hangs);
        }
        self.dissolve(cut.u, cut.v, &[cut.e, cut.f, cut.c, cut.r, cut.s]);
        Rest { count, root, cover }
    }

    /// Cuts u and v off where T falls apart without them. Returns the covers of edges that `hang`
    /// slots on a fork; those of edges to leaves are of no use.
    fn isolate_forks(&mut self, cut: &Reduction, hangs: [bool; 4]) -> [EdgeId; 4] {
        let slots = cut.slots();
        let joined = self.in_tree[cut.e];
        let forks = [0, 2].map(|i| joined || (hangs[i] && hangs[i + 1]));
        let mut cover = [EdgeId::NONE; 4];
        for i in (0..4).filter(|&i| forks[i / 2]) {
            match i {
                0 => self.forest.evert(cut.u.0),
                2 if !joined => self.forest.evert(cut.v.0),
                _ => {}
            }
            if hangs[i] {
                self.cut_above(slots[i].1.0);
                cover[i] = self.cover(slots[i].0);
            }
        }
        let is_leaf_edge = |&i: &usize| hangs[i] && !forks[i / 2];
        for i in (0..4).filter(is_leaf_edge) {
            self.cut_above(self.node(slots[i].0));
        }
        cover
    }

    /// Joins components by covers (step 2).
    fn mend(&mut self, graph: &Multigraph, cut: &Reduction, rest: &mut Rest) {
        let removed = [EdgeId::NONE, cut.f, cut.c, cut.r, cut.s, cut.e];
        let mut is_whole = true;
        for edge in rest.cover.into_iter().filter(|edge| !removed.contains(edge)) {
            if rest.count == 1 {
                return;
            }
            let [a, b] = graph.ends[edge];
            if is_whole || !self.connected(a, b) {
                self.link(edge, [a, b]);
                rest.count -= 1;
                is_whole = false;
            }
        }
    }

    /// Chooses by the rule for trees (step 3 for K = 1).
    fn choose_by_tree(&mut self, cut: &Reduction, root: usize) -> Candidate {
        let candidate = tree_rule(&mut self.forest, cut, root);
        let slots = cut.slots().map(|(_, node)| node.0);
        let step = candidate.step();
        // The root may be at either end of either new edge; f' is the one at w, slot 0.
        let at_w = root == 0 || root == step;
        let [near, far] = if at_w { [cut.f, cut.c] } else { [cut.c, cut.f] };
        self.forest.assign_above(slots[root ^ step], near.0);
        self.forest.assign_path(slots[root ^ 1], slots[root ^ 1 ^ step], far.0);
        candidate
    }

    /// Chooses the candidate between the components (step 3 for K = 2). The excluded edge stays
    /// outside T, so that later steps find few tree edges.
    fn choose_across(&mut self, cut: &Reduction) -> Candidate {
        let crosses = !self.connected(cut.w, cut.y_r);
        let candidate = if crosses { Candidate::H1 } else { Candidate::H2 };
        let [(_, near_w), (_, near_x)] = cut.joined(candidate);
        self.link(cut.c, [cut.x, near_x]);
        self.forest.assign_path(cut.w.0, near_w.0, cut.f.0);
        candidate
    }
}

impl Decide for SpanningTree {
    fn decide(&mut self, graph: &Multigraph, cut: &Reduction) -> Candidate {
        let mut rest = self.isolate(cut);
        self.mend(graph, cut, &mut rest);
        match rest.count {
            1 => self.choose_by_tree(cut, rest.root),
            _ => self.choose_across(cut),
        }
    }

    /// Makes `f`-`u`=`v`-`t` one edge. It is a tree edge only if the tree passed along it.
    fn contract(&mut self, _: &Multigraph, double: &DoubleEdge) {
        let DoubleEdge { u, v, f, p, q, t, w, x } = *double;
        let [f_in_tree, t_in_tree] = [f, t].map(|edge| self.in_tree[edge]);
        let joined = self.in_tree[p] || self.in_tree[q];
        self.forest.evert(u.0);
        let cover = f_in_tree.then(|| {
            self.cut_above(w.0);
            self.cover(f)
        });
        if !joined {
            self.forest.evert(v.0);
        }
        if t_in_tree {
            self.cut_above(x.0);
        }
        self.dissolve(u, v, &[f, p, q, t]);
        match cover {
            Some(cover) if t_in_tree && joined => {
                self.link(f, [w, x]);
                self.forest.set_value(self.node(f), cover.0);
            }
            _ => self.forest.assign_path(w.0, x.0, f.0),
        }
    }

    fn cost(&self, e: EdgeId, beside: [EdgeId; 4]) -> u32 {
        self.component_count(e, beside)
    }
}
