//! Perfect matchings by Frink's reductions (Lemos et al., section 3.2 and appendix A): DS and GW.
//!
//! TEXT

mod covers;
mod ds;
mod graph;
mod gw;
mod solve;
#[cfg(test)]
mod tests;
mod tree_rule;

use std::ops::Range;

use crate::dual::{DualGraph, Matching, NotADualGraph};
use crate::triangulation::{Id, IdVec, TriangleId};
use covers::covers;
use ds::DynamicGraph;
use graph::{EdgeId, Multigraph, Numbering};
use gw::SpanningTree;
use solve::matching_without;

/// What decides between the candidates.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum Method {
    /// DS, in the spirit of Diks and Stanczyk: fully dynamic connectivity and a link-cut tree.
    /// O(n log² n) time.
    DynamicConnectivity,
    /// GW, in the spirit of Gawrychowski and Wasylkiewicz: a link-cut tree alone. O(n log n) time.
    LinkCutTree,
}

impl Method {
    /// Both.
    pub const ALL: [Self; 2] = [Self::DynamicConnectivity, Self::LinkCutTree];
}

/// Why a graph is not one that Petersen's theorem speaks of. Nodes are numbered from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum IllegalGraph {
    /// A loop, more than three edges at a node, or an end that does not exist.
    #[error(transparent)]
    NotADualGraph(#[from] NotADualGraph),
    /// A node has fewer than three edges.
    #[error("node {0} has fewer than three edges")]
    Degree(u32),
    /// The graph falls apart.
    #[error("node {0} is not connected with node 0")]
    Disconnected(u32),
    /// Without the edge between these nodes there would be no way from one to the other.
    #[error("the edge between nodes {0} and {1} is a bridge")]
    Bridge(u32, u32),
    /// There is no node.
    #[error("the graph has no node")]
    Empty,
}

/// The perfect matching of a cubic bridgeless graph by DS, component by component.
///
/// In the spirit of Diks and Stanczyk (2010), whose full text was not at hand; see [`cubic`](self).
/// O(n log² n) time, about 300 bytes a node. No randomness.
///
/// # Errors
/// Names a node with fewer than three edges, or a bridge.
pub fn diks_stanczyk(graph: &DualGraph) -> Result<Matching, IllegalGraph> {
    each_component(graph, Method::DynamicConnectivity)
}

/// The perfect matching of a cubic bridgeless graph by GW, component by component.
///
/// In the spirit of Gawrychowski and Wasylkiewicz (2024), whose full text was not at hand; see
/// [`cubic`](self). O(n log n) time, about 90 bytes a node. No randomness.
///
/// # Errors
/// Names a node with fewer than three edges, or a bridge.
pub fn gawrychowski_wasylkiewicz(graph: &DualGraph) -> Result<Matching, IllegalGraph> {
    each_component(graph, Method::LinkCutTree)
}

fn each_component(graph: &DualGraph, method: Method) -> Result<Matching, IllegalGraph> {
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
    fn new(numbering: &Numbering, places: Range<usize>) -> Result<Self, IllegalGraph> {
        let start = places.start;
        let graph = Multigraph::of_component(numbering, places)?;
        let cover = covers(&graph).map_err(|bridge| {
            let [a, b] = graph.ends[bridge].map(|v| numbering.triangle(start + v.index()).0);
            IllegalGraph::Bridge(a, b)
        })?;
        Ok(Self { graph, cover })
    }

    /// A perfect matching that avoids `excluded`.
    fn matching_without(self, excluded: EdgeId, method: Method) -> IdVec<EdgeId, bool> {
        match method {
            Method::DynamicConnectivity => {
                let mut decider = DynamicGraph::new(&self.graph);
                matching_without(self.graph, excluded, &mut decider)
            }
            Method::LinkCutTree => {
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
/// use triquad::pairing::cubic::{CubicGraph, Method};
///
/// let k4 = CubicGraph::from_edges(4, &[(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)])?;
/// assert!(matches!(k4.matching_without(5, Method::LinkCutTree)[..], [1, 4] | [2, 3]));
/// # Ok::<(), triquad::pairing::cubic::IllegalGraph>(())
/// ```
#[derive(Clone, Debug)]
pub struct CubicGraph {
    component: Component,
    /// The component's edge for each edge as given.
    edge: Vec<EdgeId>,
}

impl CubicGraph {
    /// The graph with nodes `0..nodes` and these edges, which are numbered from 0 on; parallel edges
    /// are allowed. O(n α), 40 bytes a node.
    ///
    /// # Errors
    /// Names what is wrong: the first node with a loop, with another degree than 3 or not connected
    /// with node 0, or else a bridge.
    pub fn from_edges(nodes: usize, edges: &[(u32, u32)]) -> Result<Self, IllegalGraph> {
        if nodes == 0 {
            return Err(IllegalGraph::Empty);
        }
        let dual = DualGraph::from_edges(nodes, edges)?;
        let mut numbering = Numbering::new(&dual);
        let places = numbering.visit(TriangleId::new(0));
        if let Some(f) = dual.triangles().find(|&f| !numbering.is_seen(f)) {
            return Err(IllegalGraph::Disconnected(f.0));
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

    /// Number of nodes; even.
    pub fn node_count(&self) -> usize {
        self.component.graph.around.len()
    }

    /// The edges of a perfect matching that avoids the edge `excluded`, in order.
    ///
    /// Deterministic. Works on a copy; for cost see [`Method`].
    ///
    /// # Panics
    /// If there is no edge `excluded`.
    pub fn matching_without(&self, excluded: u32, method: Method) -> Vec<u32> {
        let excluded = self.edge[excluded as usize];
        let matched = self.component.clone().matching_without(excluded, method);
        (0..).zip(&self.edge).filter(|&(_, &edge)| matched[edge]).map(|(name, _)| name).collect()
    }
}
