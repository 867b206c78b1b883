//! Fully dynamic connectivity: edges come and go, with queries of any two nodes in between.
//!
//! Holm, de Lichtenberg and Thorup, *Poly-logarithmic deterministic fully-dynamic algorithms for
//! connectivity, minimum spanning tree, 2-edge, and biconnectivity* (2001), section 3.
//!
//! A spanning forest F of the graph determines the connected pairs. Every edge has a level, 0 at
//! first, which only rises. F_i is the part of F with levels of at least i, and
//!
//! * the ends of an edge of level i are connected in F_i,
//! * a tree of F_i has at most n / 2^i nodes.
//!
//! When an edge of F of level l is deleted, its tree falls in two, in F_0, …, F_l. The levels from
//! l down to 0 are searched for an edge that joins the halves again. At level i the smaller half
//! has at most n / 2^(i+1) nodes, so its tree edges of level i may rise to i + 1. So may then any
//! edge of level i with both ends in that half; one with its other end outside is the replacement.
//!
//! ```text
//!      smaller half        other half      h rises: it was visited in vain, which thus happens
//!       o----o      /        o----o         to it at most log n times
//!        \ h |   deleted     |    |         g joins the halves: no other edge is visited
//!         ---o------g--------o----o
//! ```
//!
//! The forests are Euler-tour trees in one arena. A vertex has a node in the tour of F_i as long as
//! it has edges there; each node refers to the node of the same element one level up. A way of a
//! tree edge is marked in the tour of the edge's own level, and a vertex in that of a level at
//! which it has non-tree edges, which hang on it in a list.

use super::euler_tour::{EulerTourForest, NodeMark};
use super::none::NONE;

/// Effect of a deletion on the spanning forest.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Deletion {
    /// Nothing: the edge was not in it.
    NonTree,
    /// The edge was in it, and this one has taken its place.
    Replaced(u32),
    /// The edge was in it, and its ends are not connected any more.
    Split,
}

/// One edge.
#[derive(Clone, Copy)]
struct EdgeRecord {
    ends: [u32; 2],
    /// Of a non-tree edge, its neighbours in the lists of its two ends.
    next: [u32; 2],
    previous: [u32; 2],
    /// Of a tree edge, the node of one way in the tour of F_0.
    way: u32,
}

const NO_EDGE: EdgeRecord =
    EdgeRecord { ends: [NONE; 2], next: [NONE; 2], previous: [NONE; 2], way: NONE };

/// Fewer than 2^30 nodes, so no level exceeds 29.
const LEVELS: usize = 30;

/// Number of edges of a level that are tried as replacements before any rises. A constant, so that
/// the bounds hold; see [`DynamicConnectivity::replacement`].
const TRIALS: u32 = 16;

/// Outcome of trying some edges.
enum Trial {
    Found(u32),
    /// There was none, and all have been tried.
    NoneLeft,
    Unknown,
}

/// A multigraph without loops over the nodes `0..n`, whose edges are named by the caller.
///
/// Insertion and deletion are O(log² n) amortised, a query O(log n). Everything is deterministic.
/// At least 96 bytes a node (32 + 64 for a tree edge) and 29 for each edge name, and 96 for each
/// further level at which a vertex has tree edges.
///
/// ```
/// use triquad::dynamic::{Deletion, DynamicConnectivity};
///
/// let mut graph = DynamicConnectivity::new(3, 3);
/// for (edge, (a, b)) in [(0, 1), (1, 2), (2, 0)].into_iter().enumerate() {
///     graph.insert(edge as u32, a, b);
/// }
/// assert_eq!(graph.delete(0), Deletion::Replaced(2));
/// assert_eq!(graph.delete(2), Deletion::Split);
/// assert!(graph.connected(1, 2) && !graph.connected(0, 1));
/// ```
#[derive(Clone)]
pub struct DynamicConnectivity {
    /// Number of nodes.
    nodes: u32,
    /// Number of edges of a level that are tried before any rises.
    trials: u32,
    tours: EulerTourForest,
    /// For each node of a tour, that of the same vertex or way one level up.
    above: Vec<u32>,
    /// For each node of a vertex, the first non-tree edge of this level.
    first: Vec<u32>,
    edges: Vec<EdgeRecord>,
    level: Vec<u8>,
}

impl DynamicConnectivity {
    /// Makes a graph of `n` nodes and no edges, for edges with names below `edge_names`. O(n +
    /// `edge_names`).
    ///
    /// # Panics
    /// If `n` is not below 2^30, or `edge_names` exceeds that.
    pub fn new(n: usize, edge_names: usize) -> Self {
        Self::with_trials(n, edge_names, TRIALS)
    }

    fn with_trials(n: usize, edge_names: usize, trials: u32) -> Self {
        assert!(n < 1 << 30 && edge_names <= 1 << 30, "2^30 nodes or more edges than that");
        let mut tours = EulerTourForest::with_capacity(3 * n);
        (0..n as u32).for_each(|v| assert_eq!(tours.add_vertex(v), v));
        Self {
            nodes: n as u32,
            trials,
            tours,
            above: vec![NONE; n],
            first: vec![NONE; n],
            edges: vec![NO_EDGE; edge_names],
            level: vec![0; edge_names],
        }
    }

    /// Returns whether there is an edge of this name. O(1).
    pub fn contains(&self, edge: u32) -> bool {
        self.edges[edge as usize].ends != NO_EDGE.ends
    }

    /// Returns the ends of an edge, as they were given; O(1).
    ///
    /// # Panics
    /// If there is no such edge.
    pub fn ends(&self, edge: u32) -> [u32; 2] {
        assert!(self.contains(edge), "there is no edge {edge}");
        self.edges[edge as usize].ends
    }

    /// Returns whether the edge is in the spanning forest. O(1).
    pub fn is_tree_edge(&self, edge: u32) -> bool {
        self.edges[edge as usize].way != NONE
    }

    /// Returns whether `a` and `b` are connected.
    pub fn connected(&mut self, a: u32, b: u32) -> bool {
        self.tours.connected(a, b)
    }

    /// Inserts an edge between `a` and `b`. Returns whether it joined two components, and so is in
    /// the spanning forest.
    ///
    /// # Panics
    /// If there is an edge of this name already, or the ends are equal or do not exist.
    pub fn insert(&mut self, edge: u32, a: u32, b: u32) -> bool {
        assert!(!self.contains(edge), "there is an edge {edge} already");
        assert!(a != b, "edge {edge} is a loop");
        assert!(a.max(b) < self.nodes, "edge {edge} has an end that does not exist");
        self.edges[edge as usize].ends = [a, b];
        self.level[edge as usize] = 0;
        let joins = !self.connected(a, b);
        if joins {
            self.edges[edge as usize].way = self.link([a, b], edge);
            self.tours.set_mark(self.edges[edge as usize].way, NodeMark::Tree, true);
        } else {
            self.hang(edge, [a, b]);
        }
        joins
    }

    /// Deletes an edge and returns the effect on the spanning forest.
    ///
    /// # Panics
    /// If there is no such edge.
    pub fn delete(&mut self, edge: u32) -> Deletion {
        let ends = self.ends(edge);
        let level = self.level[edge as usize];
        if !self.is_tree_edge(edge) {
            let nodes = ends.map(|v| self.vertex_at(v, level));
            self.unhang(edge, nodes);
            self.edges[edge as usize] = NO_EDGE;
            return Deletion::NonTree;
        }
        let mut way = std::mem::replace(&mut self.edges[edge as usize], NO_EDGE).way;
        while way != NONE {
            let up = self.above[way as usize];
            self.tours.cut(way);
            way = up;
        }
        let chains = ends.map(|v| self.chain(v));
        let replacement = (0..=level).rev().find_map(|i| {
            let halves = [chains[0][i as usize], chains[1][i as usize]];
            self.replacement(halves, i).map(|found| (found, i))
        });
        if let Some((found, level)) = replacement {
            self.plant(found, level);
        }
        ends.into_iter().for_each(|v| self.prune(v));
        replacement.map_or(Deletion::Split, |(found, _)| Deletion::Replaced(found))
    }

    /// Returns an edge of level `i` between the trees of F_i that have nodes `halves`, taken from
    /// its lists.
    ///
    /// A few edges are tried where they are, which costs no more than to find the halves: often one
    /// of them will do, or there are no others. Otherwise, what is visited in vain rises to level
    /// i + 1.
    fn replacement(&mut self, halves: [u32; 2], i: u8) -> Option<u32> {
        let [one, other] = halves.map(|half| self.tours.vertex_count(half));
        let small = halves[usize::from(one > other)];
        debug_assert!(u64::from(one.min(other)) << (i + 1) <= u64::from(self.nodes));
        match self.try_some(small, i) {
            Trial::Found(edge) => return Some(edge),
            Trial::NoneLeft => return None,
            Trial::Unknown => {}
        }
        while let Some(way) = self.tours.first_marked(small, NodeMark::Tree) {
            self.raise_tree_edge(way, i);
        }
        while let Some(x) = self.tours.first_marked(small, NodeMark::NonTree) {
            let edge = self.first[x as usize];
            let nodes = self.nodes_of(edge, x, i);
            let inside = self.tours.connected(nodes[0], nodes[1]);
            self.unhang(edge, nodes);
            if !inside {
                return Some(edge);
            }
            self.level[edge as usize] = i + 1;
            let raised = self.edges[edge as usize].ends.map(|v| self.vertex_at(v, i + 1));
            self.hang(edge, raised);
        }
        None
    }

    /// Tries the first few non-tree edges of level `i` at the tree of `small` in F_i. One that
    /// leads out is removed from its lists.
    fn try_some(&mut self, small: u32, i: u8) -> Trial {
        let mut left = self.trials;
        let mut next = self.tours.first_marked(small, NodeMark::NonTree);
        while let Some(x) = next {
            let mut edge = self.first[x as usize];
            while edge != NONE {
                let Some(fewer) = left.checked_sub(1) else { return Trial::Unknown };
                left = fewer;
                let nodes = self.nodes_of(edge, x, i);
                if !self.tours.connected(nodes[0], nodes[1]) {
                    self.unhang(edge, nodes);
                    return Trial::Found(edge);
                }
                let end = self.end_at(edge, self.tours.label(x));
                edge = self.edges[edge as usize].next[end];
            }
            next = self.tours.next_marked(x, NodeMark::NonTree);
        }
        Trial::NoneLeft
    }

    /// Returns the nodes of the ends of `edge` in F_i, one of which is `x`.
    fn nodes_of(&mut self, edge: u32, x: u32, i: u8) -> [u32; 2] {
        let v = self.tours.label(x);
        let ends = self.edges[edge as usize].ends;
        ends.map(|end| if end == v { x } else { self.vertex_at(end, i) })
    }

    /// Makes the tree edge of level `i` with this way in F_i one of level i + 1.
    fn raise_tree_edge(&mut self, way: u32, i: u8) {
        self.tours.set_mark(way, NodeMark::Tree, false);
        let edge = self.tours.label(way);
        self.level[edge as usize] = i + 1;
        let nodes = self.edges[edge as usize].ends.map(|v| self.vertex_at(v, i + 1));
        let raised = self.link(nodes, edge);
        self.above[way as usize] = raised;
        self.tours.set_mark(raised, NodeMark::Tree, true);
    }

    /// Makes `edge`, which is in no list, a tree edge of `level`: links its ends in F_0, …,
    /// F_level.
    fn plant(&mut self, edge: u32, level: u8) {
        let mut nodes = self.edges[edge as usize].ends;
        let mut way = self.link(nodes, edge);
        self.edges[edge as usize].way = way;
        for _ in 0..level {
            nodes = nodes.map(|node| self.above[node as usize]);
            let up = self.link(nodes, edge);
            self.above[way as usize] = up;
            way = up;
        }
        self.tours.set_mark(way, NodeMark::Tree, true);
    }

    /// Links two vertices of one tour forest; returns the new way.
    fn link(&mut self, nodes: [u32; 2], edge: u32) -> u32 {
        let way = self.tours.link(nodes[0], nodes[1], edge);
        self.know_new_nodes();
        self.above[way as usize] = NONE;
        way
    }

    /// Extends the arrays after the arena of tours may have grown.
    fn know_new_nodes(&mut self) {
        let bound = self.tours.name_bound();
        if self.above.len() < bound {
            self.above.resize(bound, NONE);
            self.first.resize(bound, NONE);
        }
    }

    /// Returns the node of the vertex `v` in F_level, made if there is none.
    fn vertex_at(&mut self, v: u32, level: u8) -> u32 {
        let mut node = v;
        for _ in 0..level {
            if self.above[node as usize] == NONE {
                let up = self.tours.add_vertex(v);
                self.know_new_nodes();
                self.above[up as usize] = NONE;
                self.first[up as usize] = NONE;
                self.above[node as usize] = up;
            }
            node = self.above[node as usize];
        }
        node
    }

    /// Returns all nodes of the vertex `v`, from F_0 upwards.
    fn chain(&self, v: u32) -> [u32; LEVELS] {
        let mut chain = [NONE; LEVELS];
        let mut node = v;
        for slot in &mut chain {
            *slot = node;
            node = self.above[node as usize];
            if node == NONE {
                break;
            }
        }
        chain
    }

    /// Removes the nodes of `v` above F_0 that have no edges any more.
    fn prune(&mut self, v: u32) {
        let chain = self.chain(v);
        for pair in chain.windows(2).rev().filter(|pair| pair[1] != NONE) {
            if !self.tours.is_alone(pair[1]) {
                break;
            }
            debug_assert!(self.first[pair[1] as usize] == NONE, "its ends are connected");
            self.tours.remove_vertex(pair[1]);
            self.above[pair[0] as usize] = NONE;
        }
    }

    /// Puts a non-tree edge in front of the lists of `nodes`, its ends in the tours of its level.
    fn hang(&mut self, edge: u32, nodes: [u32; 2]) {
        for (end, node) in nodes.into_iter().enumerate() {
            let old = std::mem::replace(&mut self.first[node as usize], edge);
            self.edges[edge as usize].next[end] = old;
            self.edges[edge as usize].previous[end] = NONE;
            if old == NONE {
                self.tours.set_mark(node, NodeMark::NonTree, true);
            } else {
                let v = self.edges[edge as usize].ends[end];
                let end = self.end_at(old, v);
                self.edges[old as usize].previous[end] = edge;
            }
        }
    }

    /// Takes a non-tree edge out of the lists of `nodes`, its ends in the tours of its level.
    fn unhang(&mut self, edge: u32, nodes: [u32; 2]) {
        let EdgeRecord { ends, next, previous, .. } = self.edges[edge as usize];
        for (end, node) in nodes.into_iter().enumerate() {
            let (v, next, previous) = (ends[end], next[end], previous[end]);
            if next != NONE {
                let end = self.end_at(next, v);
                self.edges[next as usize].previous[end] = previous;
            }
            if previous != NONE {
                let end = self.end_at(previous, v);
                self.edges[previous as usize].next[end] = next;
            } else {
                self.first[node as usize] = next;
                if next == NONE {
                    self.tours.set_mark(node, NodeMark::NonTree, false);
                }
            }
        }
    }

    /// Returns which end of `edge` the node `v` is, 0 or 1.
    fn end_at(&self, edge: u32, v: u32) -> usize {
        usize::from(self.edges[edge as usize].ends[1] == v)
    }
}

#[cfg(test)]
mod tests;
