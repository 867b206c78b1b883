//! Cubic multigraphs in flat arrays, and the two reductions that shrink them.

use std::ops::Range;

use super::error::CubicGraphError;
use crate::dual::DualGraph;
use crate::prefetch::prefetch;
use crate::triangulation::{Id, IdVec, TriangleId};

/// A node of a cubic graph, numbered breadth-first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct NodeId(pub(super) u32);

/// An edge of a cubic graph. Reductions retire edges and never make new names.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct EdgeId(pub(super) u32);

impl EdgeId {
    /// Stands for "no edge".
    pub(super) const NONE: Self = Self(u32::MAX);
}

impl Id for NodeId {
    fn new(index: usize) -> Self {
        Self(index as u32)
    }
    fn index(self) -> usize {
        self.0 as usize
    }
}

impl Id for EdgeId {
    fn new(index: usize) -> Self {
        Self(index as u32)
    }
    fn index(self) -> usize {
        self.0 as usize
    }
}

/// Breadth-first numbers for the triangles of a dual graph, component by component.
///
/// Neighbours get numbers, and with them memory, near each other; and the tree that the search
/// follows needs no storage, see [`Multigraph`].
pub(super) struct Numbering<'g> {
    graph: &'g DualGraph,
    /// All triangles seen so far, in the order in which they were.
    order: Vec<TriangleId>,
    /// Place in `order`, or [`Self::UNSEEN`].
    place: IdVec<TriangleId, u32>,
}

impl<'g> Numbering<'g> {
    const UNSEEN: u32 = u32::MAX;

    /// Makes a numbering in which no triangle has been seen. O(n).
    pub(super) fn new(graph: &'g DualGraph) -> Self {
        let place = IdVec::filled(Self::UNSEEN, graph.len());
        Self { graph, order: Vec::with_capacity(graph.len()), place }
    }

    /// Returns whether a component with `f` has been numbered.
    pub(super) fn is_seen(&self, f: TriangleId) -> bool {
        self.place[f] != Self::UNSEEN
    }

    /// Numbers the component of `root`. Returns its places. O(its size).
    pub(super) fn visit(&mut self, root: TriangleId) -> Range<usize> {
        let start = self.order.len();
        self.see(root);
        let mut next = start;
        while next < self.order.len() {
            self.fetch_ahead(next);
            for g in self.graph.neighbours(self.order[next]) {
                if !self.is_seen(g) {
                    self.see(g);
                }
            }
            next += 1;
        }
        start..next
    }

    /// Prefetches triangles that are needed soon: neighbours may lie anywhere in the order of the
    /// file.
    #[inline]
    fn fetch_ahead(&self, place: usize) {
        const STEPS: usize = 8;
        if let Some(&f) = self.order.get(place + STEPS) {
            self.graph.prefetch_around(f);
            self.graph.neighbours(f).for_each(|g| prefetch(self.place.as_slice(), g.index()));
        }
    }

    fn see(&mut self, f: TriangleId) {
        self.place[f] = self.order.len() as u32;
        self.order.push(f);
    }

    /// Returns the triangle at a place.
    pub(super) fn triangle(&self, place: usize) -> TriangleId {
        self.order[place]
    }

    /// Returns the node that `f` is in the graph of its component, whose places begin at `start`.
    pub(super) fn node(&self, f: TriangleId, start: usize) -> NodeId {
        NodeId(self.place[f] - start as u32)
    }

    /// Calls `visit` with each edge of a component, its lower end first, in the order that they
    /// have in its [`Multigraph`].
    pub(super) fn for_each_edge(
        &self,
        component: Range<usize>,
        mut visit: impl FnMut([TriangleId; 2]),
    ) {
        for place in component {
            self.fetch_ahead(place);
            let f = self.order[place];
            for g in self.graph.neighbours(f) {
                if self.place[g] > place as u32 {
                    visit([f, g]);
                }
            }
        }
    }
}

/// A connected cubic multigraph without loops: ends of edges and edges of nodes, 24 bytes a node.
///
/// As built, the first edge of every node but node 0 leads to its parent in a breadth-first tree:
/// numbers are breadth-first, edges are made in the order of their lower ends, and the parent is
/// the lowest neighbour.
#[derive(Clone, Debug)]
pub(super) struct Multigraph {
    pub(super) ends: IdVec<EdgeId, [NodeId; 2]>,
    pub(super) around: IdVec<NodeId, [EdgeId; 3]>,
}

impl Multigraph {
    /// Builds the component with these places. O(its size).
    ///
    /// # Errors
    /// Names a triangle with fewer than three neighbours.
    pub(super) fn from_component(
        numbering: &Numbering,
        component: Range<usize>,
    ) -> Result<Self, CubicGraphError> {
        let start = component.start;
        let mut ends = Vec::with_capacity(component.len() * 3 / 2);
        let mut around = IdVec::filled([EdgeId::NONE; 3], component.len());
        numbering.for_each_edge(component, |edge| {
            let nodes = edge.map(|f| numbering.node(f, start));
            for v in nodes {
                let slot = around[v].iter_mut().find(|slot| **slot == EdgeId::NONE);
                *slot.expect("a dual graph has degrees of at most 3") = EdgeId::new(ends.len());
            }
            ends.push(nodes);
        });
        match around.ids().find(|&v: &NodeId| around[v].contains(&EdgeId::NONE)) {
            Some(v) => Err(CubicGraphError::Degree(numbering.triangle(start + v.index()).0)),
            None => Ok(Self { ends: ends.into(), around }),
        }
    }

    /// Returns the parent of `v` in the breadth-first tree of a graph as built, and the edge to it.
    pub(super) fn parent(&self, v: NodeId) -> Option<(NodeId, EdgeId)> {
        let edge = self.around[v][0];
        (v.0 != 0).then(|| (self.far_end(edge, v), edge))
    }

    /// Returns the other end of `edge`.
    #[inline]
    pub(super) fn far_end(&self, edge: EdgeId, v: NodeId) -> NodeId {
        let [a, b] = self.ends[edge];
        debug_assert!(v == a || v == b);
        NodeId(a.0 ^ b.0 ^ v.0)
    }

    /// Returns the two edges at `v` beside `edge`.
    #[inline]
    pub(super) fn others(&self, v: NodeId, edge: EdgeId) -> [EdgeId; 2] {
        match self.around[v] {
            [a, b, c] if a == edge => [b, c],
            [a, b, c] if b == edge => [a, c],
            [a, b, _] => [a, b],
        }
    }

    /// Carries out a reduction: `f` and `c` live on, merged with one of `r` and `s` each. O(1).
    pub(super) fn reduce(&mut self, cut: &Reduction, candidate: Candidate) -> Receipt {
        let [(r, y_r), (s, y_s)] = cut.joined(candidate);
        self.merge(cut.f, cut.u, r, y_r);
        self.merge(cut.c, cut.u, s, y_s);
        Receipt { matched_if_not: cut.e, new: cut.c, merged: s }
    }

    /// Carries out a contraction: `f` lives on, merged with `t`. O(1).
    pub(super) fn contract(&mut self, double: &DoubleEdge) -> Receipt {
        self.merge(double.f, double.u, double.t, double.x);
        Receipt { matched_if_not: double.p, new: EdgeId::NONE, merged: EdgeId::NONE }
    }

    /// Moves the end `u` of `edge` to `y`, where it takes the place of `other`.
    fn merge(&mut self, edge: EdgeId, u: NodeId, other: EdgeId, y: NodeId) {
        let end = self.ends[edge].iter_mut().find(|end| **end == u);
        *end.expect("a reduction removes both ends") = y;
        let slot = self.around[y].iter_mut().find(|slot| **slot == other);
        *slot.expect("edges know their ends") = edge;
    }
}

/// A place where the graph can be reduced, see the drawing in the [module's text](super).
#[derive(Clone, Copy, Debug)]
pub(super) struct Reduction {
    pub(super) u: NodeId,
    pub(super) v: NodeId,
    /// The simple edge `u`-`v`.
    pub(super) e: EdgeId,
    /// The excluded edge `u`-`w`.
    pub(super) f: EdgeId,
    /// The third edge at `u`, to `x`.
    pub(super) c: EdgeId,
    /// The other edges at `v`, to `y_r` and `y_s`.
    pub(super) r: EdgeId,
    pub(super) s: EdgeId,
    pub(super) w: NodeId,
    pub(super) x: NodeId,
    pub(super) y_r: NodeId,
    pub(super) y_s: NodeId,
}

/// Frink's two ways to put the graph together again.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Candidate {
    /// `w`-`y_r` and `x`-`y_s`.
    H1,
    /// `w`-`y_s` and `x`-`y_r`.
    H2,
}

impl Candidate {
    /// Returns the exclusive or of the numbers of two slots that a new edge joins; see
    /// [`Reduction::slots`].
    pub(super) fn step(self) -> usize {
        match self {
            Self::H1 => 2,
            Self::H2 => 3,
        }
    }
}

impl Reduction {
    /// Returns the four slots, w, x, y_r and y_s: edges that join the pair `u`, `v` to the rest,
    /// each with its end there.
    pub(super) fn slots(&self) -> [(EdgeId, NodeId); 4] {
        [(self.f, self.w), (self.c, self.x), (self.r, self.y_r), (self.s, self.y_s)]
    }

    /// Returns the edges at `v` that are merged with `f` and with `c`, each with its far end.
    pub(super) fn joined(&self, candidate: Candidate) -> [(EdgeId, NodeId); 2] {
        let [r, s] = [(self.r, self.y_r), (self.s, self.y_s)];
        match candidate {
            Candidate::H1 => [r, s],
            Candidate::H2 => [s, r],
        }
    }
}

/// A pair of parallel edges `p`, `q` between `u` and `v`, beside the excluded edge `f` from `w` to
/// `u`, and `t` from `v` to `x`.
#[derive(Clone, Copy, Debug)]
pub(super) struct DoubleEdge {
    pub(super) u: NodeId,
    pub(super) v: NodeId,
    pub(super) f: EdgeId,
    pub(super) p: EdgeId,
    pub(super) q: EdgeId,
    pub(super) t: EdgeId,
    pub(super) w: NodeId,
    pub(super) x: NodeId,
}

/// A step that is possible.
#[derive(Clone, Copy, Debug)]
pub(super) enum Step {
    Contract(DoubleEdge),
    Reduce(Reduction),
}

/// Receipt of a step, which undoes it for the matching. 12 bytes.
#[must_use = "without its receipt a step is not undone"]
pub(super) struct Receipt {
    /// `e` or `p`: matched unless `new` is.
    matched_if_not: EdgeId,
    /// `c`, or none after a contraction.
    new: EdgeId,
    /// The edge at `v` that was merged with `c`: matched if `new` is.
    merged: EdgeId,
}

impl Receipt {
    /// Turns a matching of the graph after the step into one of the graph before. O(1).
    pub(super) fn undo(self, matched: &mut IdVec<EdgeId, bool>) {
        let both = self.new != EdgeId::NONE && matched[self.new];
        matched[self.matched_if_not] = !both;
        if both {
            matched[self.merged] = true;
        }
    }
}
