//! Euler-tour trees: forests that are cut and joined, with queries of whole trees.
//!
//! Henzinger and King, *Randomized fully dynamic graph algorithms* (1999), with splay trees. A tree
//! is kept as the closed walk round it, which passes every edge twice, once each way, and every
//! vertex once by a node of its own:
//!
//! ```text
//!     b   d
//!     |   |          a [ab b ba] [ac c [cd d dc] ca]
//!     a---c
//! ```
//!
//! The walk may start at any of its nodes. Joining or removing an edge cuts and pastes such
//! sequences.

use super::none::NONE;

/// Two marks that nodes can carry; they are independent of each other, and named after their use in
/// [`DynamicConnectivity`](super::DynamicConnectivity).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum NodeMark {
    /// There, on ways: the edge's level is that of the tour.
    Tree = 1,
    /// There, on vertices: non-tree edges of the tour's level hang on it.
    NonTree = 2,
}

/// Number of mark bits, which lie below counts and labels.
const MARKS: u32 = 2;
const MARK_MASK: u32 = (1 << MARKS) - 1;

#[derive(Clone, Copy)]
struct TourNode {
    parent: u32,
    /// In the order of the walk.
    child: [u32; 2],
    /// Of the subtree in the splay tree: number of vertices and, below it, the marks that occur.
    total: u32,
    /// Label and own marks.
    label: u32,
    /// Of one way along an edge, the other way; of a vertex, nothing.
    twin: u32,
}

/// A forest whose nodes, vertices and both ways of edges, are named by the forest and labelled by
/// the caller with numbers below 2^30.
///
/// Operations are O(log n) amortised for trees of n vertices. 24 bytes for each vertex and for each
/// way; names of removed nodes are used again.
///
/// ```
/// use triquad::dynamic::EulerTourForest;
///
/// let mut forest = EulerTourForest::with_capacity(0);
/// let [a, b, c] = [0, 1, 2].map(|label| forest.add_vertex(label));
/// let ab = forest.link(a, b, 0);
/// forest.link(b, c, 1);
/// assert!(forest.connected(a, c) && forest.vertex_count(b) == 3);
/// forest.cut(ab);
/// assert!(!forest.connected(a, c) && forest.vertex_count(b) == 2);
/// ```
#[derive(Clone)]
pub struct EulerTourForest {
    nodes: Vec<TourNode>,
    /// First of the unused nodes, which are linked by `parent`.
    unused: u32,
}

impl EulerTourForest {
    /// Makes the empty forest, with room for so many nodes; a tree of n vertices has 3n − 2
    /// nodes.
    pub fn with_capacity(nodes: usize) -> Self {
        Self { nodes: Vec::with_capacity(nodes), unused: NONE }
    }

    /// Returns the bound of the names of nodes.
    pub fn name_bound(&self) -> usize {
        self.nodes.len()
    }

    /// Adds a tree of one vertex. The first vertices are named 0, 1, 2 … until anything else has
    /// been done. O(1).
    ///
    /// # Panics
    /// In debug builds, if `label` is not below 2^30.
    pub fn add_vertex(&mut self, label: u32) -> u32 {
        let vertex = self.add(label);
        self.nodes[vertex as usize].total = 1 << MARKS;
        vertex
    }

    /// Removes a vertex without edges. O(1).
    ///
    /// # Panics
    /// In debug builds, if `vertex` has edges.
    pub fn remove_vertex(&mut self, vertex: u32) {
        debug_assert!(self.is_alone(vertex));
        self.discard(vertex);
    }

    /// Returns whether the vertex has no edges. O(1).
    pub fn is_alone(&self, vertex: u32) -> bool {
        let TourNode { parent, child, .. } = self.nodes[vertex as usize];
        parent == NONE && child == [NONE; 2]
    }

    /// Returns the label of a node. O(1).
    pub fn label(&self, node: u32) -> u32 {
        self.nodes[node as usize].label >> MARKS
    }

    /// Returns whether both nodes are in one tree.
    pub fn connected(&mut self, a: u32, b: u32) -> bool {
        self.splay(a);
        self.splay(b);
        a == b || self.nodes[a as usize].parent != NONE
    }

    /// Returns the number of vertices of the tree of `node`.
    pub fn vertex_count(&mut self, node: u32) -> u32 {
        self.splay(node);
        self.nodes[node as usize].total >> MARKS
    }

    /// Joins two trees by an edge between the vertices `a` and `b`. Returns the node of the way
    /// from `a` to `b`, by which the edge is cut again; both ways get the label.
    ///
    /// # Panics
    /// In debug builds, if `a` and `b` are in one tree, or `label` is not below 2^30.
    pub fn link(&mut self, a: u32, b: u32, label: u32) -> u32 {
        debug_assert!(!self.connected(a, b), "{a} and {b} are connected");
        let [there, back] = [self.add(label), self.add(label)];
        self.nodes[there as usize].twin = back;
        self.nodes[back as usize].twin = there;
        self.begin_at(b);
        self.splay(a);
        // before a, there, from b on, back, after a
        let after = std::mem::replace(&mut self.nodes[a as usize].child[1], NONE);
        self.update(a);
        self.adopt(back, b, 0);
        self.adopt(back, after, 1);
        self.adopt(there, a, 0);
        self.adopt(there, back, 1);
        there
    }

    /// Removes the edge of which `way` is one node.
    ///
    /// # Panics
    /// If `way` is a vertex.
    pub fn cut(&mut self, way: u32) {
        let twin = self.nodes[way as usize].twin;
        assert!(twin != NONE, "{way} is a vertex");
        let [before, after] = self.take_out(way);
        let twin_came_first = before != NONE && self.connected(before, twin);
        let [left, right] = self.take_out(twin);
        // left · twin · right · way · after, or before · way · left · twin · right
        let (first, last) = if twin_came_first { (left, after) } else { (before, right) };
        self.join(first, last);
        self.discard(way);
        self.discard(twin);
    }

    /// Sets or clears a mark of `node`.
    pub fn set_mark(&mut self, node: u32, mark: NodeMark, on: bool) {
        self.splay(node);
        let label = &mut self.nodes[node as usize].label;
        *label = *label & !(mark as u32) | if on { mark as u32 } else { 0 };
        self.update(node);
    }

    /// Returns whether `node` itself has the mark. O(1).
    pub fn has_mark(&self, node: u32, mark: NodeMark) -> bool {
        self.nodes[node as usize].label & mark as u32 != 0
    }

    /// Returns the first node with this mark in the tree of `node`, if there is one; where a walk
    /// begins is up to the forest.
    pub fn first_marked(&mut self, node: u32, mark: NodeMark) -> Option<u32> {
        self.splay(node);
        self.first_marked_below(node, mark)
    }

    /// Returns the next node with this mark after `node` in the same walk, until the forest is
    /// changed.
    pub fn next_marked(&mut self, node: u32, mark: NodeMark) -> Option<u32> {
        self.splay(node);
        self.first_marked_below(self.nodes[node as usize].child[1], mark)
    }

    /// Returns the first node with this mark in the subtree of a node or none, near the root of the
    /// splay tree.
    fn first_marked_below(&mut self, mut at: u32, mark: NodeMark) -> Option<u32> {
        let has = |at: u32| at != NONE && self.nodes[at as usize].total & mark as u32 != 0;
        if !has(at) {
            return None;
        }
        loop {
            let [left, right] = self.nodes[at as usize].child;
            if has(left) {
                at = left;
            } else if self.has_mark(at, mark) {
                break;
            } else {
                at = right;
            }
        }
        self.splay(at);
        Some(at)
    }

    /// Makes a node of no tree.
    fn add(&mut self, label: u32) -> u32 {
        debug_assert!(label <= u32::MAX >> MARKS);
        let node = TourNode {
            parent: NONE,
            child: [NONE; 2],
            total: 0,
            label: label << MARKS,
            twin: NONE,
        };
        if self.unused == NONE {
            self.nodes.push(node);
            return self.nodes.len() as u32 - 1;
        }
        let name = self.unused;
        self.unused = std::mem::replace(&mut self.nodes[name as usize], node).parent;
        name
    }

    fn discard(&mut self, node: u32) {
        self.nodes[node as usize].parent = self.unused;
        self.unused = node;
    }

    /// Makes the closed walk start at `node`, which becomes the root of the splay tree.
    fn begin_at(&mut self, node: u32) {
        self.splay(node);
        let before = std::mem::replace(&mut self.nodes[node as usize].child[0], NONE);
        if before != NONE {
            self.nodes[before as usize].parent = NONE;
            self.update(node);
            self.join(node, before);
            self.splay(node);
        }
    }

    /// Makes `node` a tree of its own, and returns what was before and after it.
    fn take_out(&mut self, node: u32) -> [u32; 2] {
        self.splay(node);
        let parts = std::mem::replace(&mut self.nodes[node as usize].child, [NONE; 2]);
        for part in parts.into_iter().filter(|&part| part != NONE) {
            self.nodes[part as usize].parent = NONE;
        }
        parts
    }

    /// Appends the sequence with root `second` to that with root `first`; either may be empty.
    fn join(&mut self, first: u32, second: u32) {
        if first == NONE || second == NONE {
            return;
        }
        let mut last = first;
        while self.nodes[last as usize].child[1] != NONE {
            last = self.nodes[last as usize].child[1];
        }
        self.splay(last);
        self.adopt(last, second, 1);
    }

    /// Makes `child`, which may be none, the child of the root `parent` on `side`.
    fn adopt(&mut self, parent: u32, child: u32, side: usize) {
        self.nodes[parent as usize].child[side] = child;
        self.set_parent(child, parent);
        self.update(parent);
    }

    /// Returns the node's own part of the total of a subtree.
    #[inline]
    fn own_total(node: &TourNode) -> u32 {
        (u32::from(node.twin == NONE) << MARKS) | node.label & MARK_MASK
    }

    /// Returns the total of the subtree of a node or none.
    #[inline]
    fn total(&self, node: u32) -> u32 {
        self.nodes.get(node as usize).map_or(0, |node| node.total)
    }

    /// Returns the total of a node over subtrees with these totals.
    #[inline]
    fn sum(node: &TourNode, below: [u32; 2]) -> u32 {
        let [a, b] = below;
        let own = Self::own_total(node);
        let count = (a & !MARK_MASK) + (b & !MARK_MASK) + (own & !MARK_MASK);
        count | (a | b | own) & MARK_MASK
    }

    /// Computes the total of `node` from its children.
    #[inline]
    fn update(&mut self, node: u32) {
        let here = &self.nodes[node as usize];
        let total = Self::sum(here, here.child.map(|child| self.total(child)));
        self.nodes[node as usize].total = total;
    }

    fn splay(&mut self, node: u32) {
        loop {
            let parent = self.nodes[node as usize].parent;
            if parent == NONE {
                return;
            }
            match self.nodes[parent as usize].parent {
                NONE => self.step(node, parent),
                grandparent => self.double_step(node, parent, grandparent),
            }
        }
    }

    /// Exchanges `v` with its parent, the root; for drawings of the steps see the link-cut trees.
    #[inline]
    fn step(&mut self, v: u32, parent: u32) {
        let (mut here, mut up) = (self.nodes[v as usize], self.nodes[parent as usize]);
        let side = usize::from(up.child[1] == v);
        here.parent = NONE;
        here.total = up.total;
        up.parent = v;
        up.child[side] = std::mem::replace(&mut here.child[1 - side], parent);
        self.set_parent(up.child[side], parent);
        up.total = Self::sum(&up, up.child.map(|child| self.total(child)));
        self.nodes[v as usize] = here;
        self.nodes[parent as usize] = up;
    }

    /// Moves `v` above its parent and grandparent. Only their totals are computed: `v` gets that of
    /// the whole, which stays the same.
    #[inline]
    fn double_step(&mut self, v: u32, parent: u32, grandparent: u32) {
        let mut here = self.nodes[v as usize];
        let (mut up, mut top) = (self.nodes[parent as usize], self.nodes[grandparent as usize]);
        let side = usize::from(top.child[1] == parent);
        here.parent = top.parent;
        here.total = top.total;
        up.parent = v;
        if up.child[side] == v {
            top.child[side] = std::mem::replace(&mut up.child[1 - side], grandparent);
            up.child[side] = std::mem::replace(&mut here.child[1 - side], parent);
            top.parent = parent;
            self.set_parent(up.child[side], parent);
            top.total = Self::sum(&top, top.child.map(|child| self.total(child)));
            up.total = Self::sum(&up, [self.total(up.child[side]), top.total]);
        } else {
            top.child[side] = std::mem::replace(&mut here.child[1 - side], grandparent);
            up.child[1 - side] = std::mem::replace(&mut here.child[side], parent);
            top.parent = v;
            self.set_parent(up.child[1 - side], parent);
            top.total = Self::sum(&top, top.child.map(|child| self.total(child)));
            up.total = Self::sum(&up, up.child.map(|child| self.total(child)));
        }
        self.set_parent(top.child[side], grandparent);
        self.nodes[v as usize] = here;
        self.nodes[parent as usize] = up;
        self.nodes[grandparent as usize] = top;
        if here.parent != NONE {
            let slots = &mut self.nodes[here.parent as usize].child;
            slots[usize::from(slots[1] == grandparent)] = v;
        }
    }

    #[inline]
    fn set_parent(&mut self, node: u32, parent: u32) {
        if node != NONE {
            self.nodes[node as usize].parent = parent;
        }
    }
}
