//! DS and GW: perfect matchings by Frink's reductions (Lemos et al., section 3.2 and appendix A).
//!
//! Both are in the spirit of papers whose full text was not at hand: K. Diks and P. Stanczyk
//! (SOFSEM 2010), and its successor by P. Gawrychowski and M. Wasylkiewicz (ESA 2024). What the
//! abstracts name, dynamic connectivity with a dynamic tree and a dynamic tree alone, is used here;
//! the rest was reconstructed. It is proved below and in the files of the two deciders, and tested
//! on every labelled graph of up to eight nodes. Details may differ from the printed papers.
//!
//! # The theorem
//!
//! *In a connected cubic multigraph without loops and bridges there is, for every edge f, a perfect
//! matching that avoids f.* (Petersen; the dual graph of a closed surface is such a graph.) Remove
//! two nodes, find a matching of what is left that avoids what f has become, extend it. With n / 2
//! steps there, and n / 2 back, one thing alone is not done in constant time: to choose so that no
//! bridge arises.
//!
//! # One step
//!
//! Let f = uw be the excluded edge. If the other edges at u end in different nodes, one of them
//! does not end in w; it is simple, and called e = uv. Without u and v four *slots* are left, at w,
//! x, y_r and y_s, which need not be four nodes, and Frink's candidates fill them with two edges:
//!
//! ```text
//!     w         y_r           w -------- y_r           w         y_r
//!      \f       /r                 f'                    \ f'   /
//!       u --e-- v         H1:                     H2:      \ /
//!      /c       \s                                         / \
//!     x         y_s           x -------- y_s             / c'  \
//!                                  c'                  x         y_s
//! ```
//!
//! f' is what f has become: the way back has a matching that avoids f'. If it avoids c' too, e is
//! matched; if c' is matched, the edges that were merged into it, c and s (or r), are. So f and the
//! edge merged with it stay unmatched, and the last case of the appendix, both new edges matched,
//! which takes an alternating cycle to mend, does not occur (Biedl, Bose, Demaine, Lubiw, 2001).
//!
//! If the other edges at u are parallel, there is no simple edge to take, but also nothing to
//! choose: the path w-u=v-x is replaced by one edge, and one of the parallel edges is matched.
//!
//! ```text
//!           p                      There is a bridge exactly if there was one before; x is not w,
//!     w -f- u === v -t- x          or the third edge at w would be a bridge. The appendix does
//!           q              →       not mention this case. It is needed: in a ring of double edges
//!     w ------- f' ---- x          joined by single ones, f single, it is the only one.
//! ```
//!
//! Edges are never made: f' is called f, c' is called c, and the names of e, r, s retire. A receipt
//! of three numbers undoes a step for the matching.
//!
//! # Why one candidate is always good
//!
//! Let H' be the graph without u and v.
//!
//! *H' in two components.* Each has two slots: with one slot, that edge would be a bridge, and with
//! none there would be no way there. The slots of u, w and x, are not together, or e would be a
//! bridge. So one candidate runs from one component to the other, twice. It is connected, and has
//! no bridge: the new edges are on a cycle; and a bridge of one component has a slot on either side
//! (or it would have been a bridge before), which are joined through the other component as well.
//!
//! *H' connected.* The new edges are no bridges. An edge k that becomes one was a bridge of H', has
//! slots on both sides, as before, and is crossed by neither new edge: on each of its sides are the
//! two slots of one new edge. (A loop, at a node with two slots, is the special case that k is that
//! node's third edge.) Now take *any* spanning tree T' of H'. All bridges of H' are in it. So a
//! candidate is good if *no edge of T' separates the slots of one of its edges from those of the
//! other*. And it cannot be that both candidates fail this test: the four slots hang together in T'
//! as in one of
//!
//! ```text
//!     w       x       w       y_r       w       y_r       w   y_r
//!      \     /         \     /           \     /           \ /
//!       o---o           o---o             o---o             o
//!      /     \         /     \           /     \           / \
//!    y_r     y_s      x      y_s       y_s      x         x   y_s
//!
//!    against H1       against none     against H2      against none
//! ```
//!
//! and tree edges that separate 2 from 2 all do it in the same way. The test may turn a good
//! candidate down, as the tree edge in question need not be a bridge, but not both; that is enough,
//! and this is why no structure for bridges is needed.
//!
//! # What decides
//!
//! * `ds` keeps the graph in a `DynamicConnectivity` and its spanning forest in a `LinkCutForest`.
//!   The former answers whether H' is connected; deletions mend the forest.
//! * `gw` keeps a spanning tree in a `LinkCutForest`, and for each tree edge a non-tree edge that
//!   covers it. Covers mend the tree, and the connectivity of H' follows.
//!
//! Of up to four moves at f the one that touches fewest tree edges is taken. Nodes are numbered
//! breadth-first, for the sake of the cache. Nothing is random: a seed would have nothing to do.

mod bridge_certificate;
mod diks_stanczyk;
mod error;
mod gawrychowski_wasylkiewicz;
mod graph;
mod solve;
#[cfg(test)]
mod tests;
mod tree_rule;

use std::ops::Range;

use crate::dual::{DualGraph, Matching};
use crate::triangulation::{Id, IdVec, TriangleId};
use bridge_certificate::cover_tree_edges;
use diks_stanczyk::DynamicGraph;
pub use error::CubicGraphError;
use gawrychowski_wasylkiewicz::SpanningTree;
use graph::{EdgeId, Multigraph, Numbering};
use solve::matching_without;

/// The structure that decides between the candidates.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum Decider {
    /// DS, in the spirit of Diks and Stanczyk: fully dynamic connectivity and a link-cut tree.
    /// O(n log² n) time.
    DynamicConnectivity,
    /// GW, in the spirit of Gawrychowski and Wasylkiewicz: a link-cut tree alone. O(n log n) time.
    LinkCutTree,
}

impl Decider {
    /// Both structures.
    pub const ALL: [Self; 2] = [Self::DynamicConnectivity, Self::LinkCutTree];
}

/// Returns the perfect matching of a cubic bridgeless graph by DS, component by component.
///
/// In the spirit of Diks and Stanczyk (2010), whose full text was not at hand; see [`cubic`](self).
/// O(n log² n) time, about 300 bytes a node. No randomness.
///
/// # Errors
/// Names a node with fewer than three edges, or a bridge.
pub fn diks_stanczyk(graph: &DualGraph) -> Result<Matching, CubicGraphError> {
    each_component(graph, Decider::DynamicConnectivity)
}

/// Returns the perfect matching of a cubic bridgeless graph by GW, component by component.
///
/// In the spirit of Gawrychowski and Wasylkiewicz (2024), whose full text was not at hand; see
/// [`cubic`](self). O(n log n) time, about 90 bytes a node. No randomness.
///
/// # Errors
/// Names a node with fewer than three edges, or a bridge.
pub fn gawrychowski_wasylkiewicz(graph: &DualGraph) -> Result<Matching, CubicGraphError> {
    each_component(graph, Decider::LinkCutTree)
}

fn each_component(graph: &DualGraph, method: Decider) -> Result<Matching, CubicGraphError> {
    let mut numbering = Numbering::new(graph);
    let mut matching = Matching::empty(graph.len());
    for root in graph.triangles() {
        if numbering.is_seen(root) {
            continue;
        }
        let places = numbering.visit(root);
        let component = Component::new(&numbering, places.clone())?;
        let matched = component.matching_without(EdgeId(0), method);
        let mut is_matched = matched.as_slice().iter();
        numbering.for_each_edge(places, |[f, g]| {
            if is_matched.next() == Some(&true) {
                matching.pair(f, g);
            }
        });
    }
    Ok(matching)
}

/// A connected cubic graph, and the proof that it has no bridge.
#[derive(Clone, Debug)]
struct Component {
    graph: Multigraph,
    cover: IdVec<graph::NodeId, EdgeId>,
}

impl Component {
    fn new(numbering: &Numbering, places: Range<usize>) -> Result<Self, CubicGraphError> {
        let start = places.start;
        let graph = Multigraph::from_component(numbering, places)?;
        let cover = cover_tree_edges(&graph).map_err(|bridge| {
            let [a, b] = graph.ends[bridge].map(|v| numbering.triangle(start + v.index()).0);
            CubicGraphError::Bridge(a, b)
        })?;
        Ok(Self { graph, cover })
    }

    /// Returns a perfect matching that avoids `excluded`.
    fn matching_without(self, excluded: EdgeId, method: Decider) -> IdVec<EdgeId, bool> {
        match method {
            Decider::DynamicConnectivity => {
                let mut decider = DynamicGraph::new(&self.graph);
                matching_without(self.graph, excluded, &mut decider)
            }
            Decider::LinkCutTree => {
                let mut decider = SpanningTree::new(&self.graph, &self.cover);
                drop(self.cover);
                matching_without(self.graph, excluded, &mut decider)
            }
        }
    }
}

/// A connected bridgeless cubic multigraph without loops: one that Petersen's theorem speaks of.
///
/// ```
/// use triquad::pairing::cubic::{CubicGraph, Decider};
///
/// let k4 = CubicGraph::from_edges(4, &[(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)])?;
/// assert!(matches!(k4.matching_without(5, Decider::LinkCutTree)[..], [1, 4] | [2, 3]));
/// # Ok::<(), triquad::pairing::cubic::CubicGraphError>(())
/// ```
#[derive(Clone, Debug)]
pub struct CubicGraph {
    component: Component,
    /// The component's edge for each edge as given.
    edge: Vec<EdgeId>,
}

impl CubicGraph {
    /// Builds the graph with nodes `0..nodes` and these edges, which are numbered from 0 on;
    /// parallel edges are allowed. O(n log n) at worst, in practice O(n); 34 bytes a node, twice
    /// that meanwhile.
    ///
    /// # Errors
    /// The first of these that is found: no node; what [`DualGraph::from_edges`] refuses; the
    /// lowest node not connected with node 0; a node with fewer than three edges; a bridge.
    pub fn from_edges(nodes: usize, edges: &[(u32, u32)]) -> Result<Self, CubicGraphError> {
        if nodes == 0 {
            return Err(CubicGraphError::Empty);
        }
        let dual = DualGraph::from_edges(nodes, edges)?;
        let mut numbering = Numbering::new(&dual);
        let places = numbering.visit(TriangleId::new(0));
        if let Some(f) = dual.triangles().find(|&f| !numbering.is_seen(f)) {
            return Err(CubicGraphError::Disconnected(f.0));
        }
        let component = Component::new(&numbering, places)?;
        let mut taken = IdVec::filled(false, edges.len());
        let place = |&(a, b): &(u32, u32)| {
            let [a, b] = [a, b].map(|f| numbering.node(TriangleId(f), 0));
            let joins = |e: &EdgeId| !taken[*e] && component.graph.far_end(*e, a) == b;
            let edge = component.graph.around[a].into_iter().find(joins);
            let edge = edge.expect("every edge has been numbered");
            taken[edge] = true;
            edge
        };
        let edge = edges.iter().map(place).collect();
        Ok(Self { component, edge })
    }

    /// Returns the number of nodes; even.
    pub fn node_count(&self) -> usize {
        self.component.graph.around.len()
    }

    /// Returns the edges of a perfect matching that avoids the edge `excluded`, in order.
    ///
    /// Deterministic. Works on a copy; for cost see [`Decider`].
    ///
    /// # Panics
    /// If there is no edge `excluded`.
    pub fn matching_without(&self, excluded: u32, method: Decider) -> Vec<u32> {
        let excluded = self.edge[excluded as usize];
        let matched = self.component.clone().matching_without(excluded, method);
        (0..).zip(&self.edge).filter(|&(_, &edge)| matched[edge]).map(|(name, _)| name).collect()
    }
}
