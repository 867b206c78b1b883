//! Link-cut trees: forests that are cut and joined, with queries of paths.
//!
//! Sleator and Tarjan, *A data structure for dynamic trees* (1983), in the form of *Self-adjusting
//! binary search trees* (1985). Every tree of the forest is partitioned into vertical paths. A path
//! is a splay tree ordered by depth, whose root remembers the parent of the path's topmost node:
//!
//! ```text
//!        a              a                       access(e):  the path from the root down to e
//!       / \            / .                      becomes one splay tree, and e its root
//!      b   c    as    b   c     one path each
//!     / \            . \        a-b-e, d, c
//!    d   e          d   e
//! ```

use super::none::NONE;

/// The children of the subtree have changed sides; this is still to be handed down.
const REVERSED: u32 = 1 << 31;
/// All nodes of the subtree have this node's value; this is still to be handed down.
const SPREAD: u32 = 1 << 30;
const VALUE: u32 = SPREAD - 1;

#[derive(Clone, Copy)]
struct PathNode {
    /// In the splay tree; of its root, the tree parent of the topmost node of the path.
    parent: u32,
    /// Left are the nodes nearer to the root of the tree.
    child: [u32; 2],
    /// The value and two flags.
    tag: u32,
}

/// A forest of rooted trees over the nodes `0..n`, each with a value below 2^30.
///
/// All operations are O(log n) amortised, with splay trees and therefore without randomness.
/// 16 bytes a node.
///
/// ```
/// use triquad::dynamic::LinkCutForest;
///
/// let mut forest = LinkCutForest::from_parents(4, |_| None);
/// forest.link(1, 0);
/// forest.link(2, 0);
/// assert_eq!(forest.lca(1, 2), 0);
/// forest.evert(1);
/// assert_eq!(forest.lca(0, 2), 0);
/// assert!(!forest.connected(2, 3));
/// ```
#[derive(Clone)]
pub struct LinkCutForest {
    nodes: Vec<PathNode>,
}

impl LinkCutForest {
    /// The greatest value a node can have.
    pub const MAX_VALUE: u32 = VALUE;

    /// Makes the forest in which `parent(v)` is the parent of node `v`, or none if `v` is a root;
    /// all values are 0. O(n).
    ///
    /// The parents must not run in circles; that is not checked.
    ///
    /// # Panics
    /// If `n` exceeds 2^32 - 1.
    pub fn from_parents(n: usize, parent: impl Fn(u32) -> Option<u32>) -> Self {
        assert!(n <= NONE as usize, "more than 2^32 - 1 nodes");
        let node = |v| PathNode { parent: parent(v).unwrap_or(NONE), child: [NONE; 2], tag: 0 };
        Self { nodes: (0..n as u32).map(node).collect() }
    }

    /// Returns the value of node `v`.
    pub fn value(&mut self, v: u32) -> u32 {
        self.splay(v);
        self.nodes[v as usize].tag & VALUE
    }

    /// Gives node `v` a value.
    ///
    /// # Panics
    /// In debug builds, if `value` exceeds [`Self::MAX_VALUE`].
    pub fn set_value(&mut self, v: u32, value: u32) {
        debug_assert!(value <= VALUE);
        self.splay(v);
        self.nodes[v as usize].tag = value;
    }

    /// Returns whether `a` and `b` are in one tree.
    pub fn connected(&mut self, a: u32, b: u32) -> bool {
        self.access(a);
        self.access(b);
        self.was_reached(a, b)
    }

    /// Returns, after access to `a` and then to `b`, whether they are in one tree. The former has
    /// no parent left unless the latter access passed it.
    fn was_reached(&self, a: u32, b: u32) -> bool {
        a == b || self.nodes[a as usize].parent != NONE
    }

    /// Returns the lowest common ancestor of `a` and `b`.
    ///
    /// # Panics
    /// In debug builds, if `a` and `b` are in different trees.
    pub fn lca(&mut self, a: u32, b: u32) -> u32 {
        self.access(a);
        let meeting = self.access(b);
        debug_assert!(self.was_reached(a, b), "{a} and {b} have no common ancestor");
        meeting
    }

    /// Makes `v` the root of its tree.
    pub fn evert(&mut self, v: u32) {
        self.access(v);
        self.nodes[v as usize].tag ^= REVERSED;
    }

    /// Makes the tree of `child` a subtree of `parent`, after making `child` its root.
    ///
    /// # Panics
    /// In debug builds, if both are in one tree already.
    pub fn link(&mut self, child: u32, parent: u32) {
        self.evert(child);
        self.access(parent);
        debug_assert!(!self.was_reached(child, parent), "{child} and {parent} are connected");
        self.nodes[child as usize].parent = parent;
    }

    /// Joins the trees of `a` and `b` by the edges `a`-`middle`-`b`, where `middle` is a tree of
    /// its own; one access less than two links.
    ///
    /// # Panics
    /// In debug builds, if `middle` is not alone or `a` and `b` are in one tree already.
    pub fn link_through(&mut self, a: u32, middle: u32, b: u32) {
        self.evert(a);
        self.access(b);
        debug_assert!(!self.was_reached(a, b), "{a} and {b} are connected");
        let node = self.nodes[middle as usize];
        debug_assert!(node.parent == NONE && node.child == [NONE; 2], "{middle} is not alone");
        self.nodes[a as usize].parent = middle;
        self.nodes[middle as usize].parent = b;
    }

    /// Removes the edge between `a` and `b`, which become the roots of their trees.
    ///
    /// # Panics
    /// If there is no such edge.
    pub fn cut(&mut self, a: u32, b: u32) {
        self.evert(a);
        let above = self.cut_above(b);
        self.push(a);
        let edge = above == Some(a) && self.nodes[a as usize].child[1] == NONE;
        assert!(edge, "{a} and {b} are not adjacent");
    }

    /// Cuts `v` from its parent: `v` becomes the root of a tree of its own. Returns some node of
    /// the path from the parent to the old root, or `None` if `v` was a root.
    pub fn cut_above(&mut self, v: u32) -> Option<u32> {
        self.access(v);
        let above = std::mem::replace(&mut self.nodes[v as usize].child[0], NONE);
        if above == NONE {
            return None;
        }
        self.nodes[above as usize].parent = NONE;
        Some(above)
    }

    /// Takes whole trees apart: every one of `nodes`, which must be all nodes of some trees, is
    /// alone afterwards, its value 0. O(1) each.
    ///
    /// If a node is missing, the forest is broken; that is checked in debug builds, as far as it
    /// shows.
    pub fn dissolve(&mut self, nodes: &[u32]) {
        for &v in nodes {
            let PathNode { parent, child, .. } = self.nodes[v as usize];
            let known = |other: u32| other == NONE || nodes.contains(&other);
            debug_assert!([parent, child[0], child[1]].into_iter().all(known));
            self.nodes[v as usize] = PathNode { parent: NONE, child: [NONE; 2], tag: 0 };
        }
    }

    /// Gives all nodes of the path from the root down to `v` this value.
    ///
    /// # Panics
    /// In debug builds, if `value` exceeds [`Self::MAX_VALUE`].
    pub fn assign_above(&mut self, v: u32, value: u32) {
        debug_assert!(value <= VALUE);
        self.access(v);
        self.nodes[v as usize].tag = SPREAD | value;
    }

    /// Gives all nodes of the path between `a` and `b`, both included, this value; `a` becomes the
    /// root.
    ///
    /// # Panics
    /// In debug builds, if `a` and `b` are in different trees, or `value` exceeds
    /// [`Self::MAX_VALUE`].
    pub fn assign_path(&mut self, a: u32, b: u32, value: u32) {
        self.evert(a);
        self.assign_above(b, value);
        debug_assert!(self.was_reached(a, b), "no path from {a} to {b}");
    }

    /// Makes the path from the root to `v` one splay tree with root `v`, which has no right child
    /// then. Returns the last node at which a path was joined: the lowest common ancestor of `v`
    /// and of the node accessed before, if that is in the same tree.
    fn access(&mut self, v: u32) -> u32 {
        let (mut below, mut at) = (NONE, v);
        loop {
            self.splay(at);
            self.nodes[at as usize].child[1] = below;
            let above = self.nodes[at as usize].parent;
            if above == NONE {
                break;
            }
            (below, at) = (at, above);
        }
        if at != v {
            self.splay(v);
        }
        at
    }

    /// Makes `v` the root of its splay tree, with nothing left to push from it.
    ///
    /// Pushing just ahead of the steps is enough: what is pending further up reverses both subtrees
    /// and steps alike.
    #[inline]
    fn splay(&mut self, v: u32) {
        // Paths are short, and often there is nothing to do.
        match self.parent_in_path(v) {
            Some(parent) => self.splay_below(v, parent),
            None => self.push(v),
        }
    }

    /// Splays a node with a `parent` in its splay tree.
    fn splay_below(&mut self, v: u32, parent: u32) {
        let mut next = Some(parent);
        while let Some(parent) = next {
            match self.parent_in_path(parent) {
                Some(grandparent) => self.double_step(v, parent, grandparent),
                None => return self.step(v, parent),
            }
            next = self.parent_in_path(v);
        }
    }

    /// Returns the parent of `v` in its splay tree.
    #[inline]
    fn parent_in_path(&self, v: u32) -> Option<u32> {
        let parent = self.nodes[v as usize].parent;
        (parent != NONE && self.nodes[parent as usize].child.contains(&v)).then_some(parent)
    }

    /// Exchanges `v` with its parent, the root of the splay tree:
    ///
    /// ```text
    ///      parent          v
    ///      /    \         / \
    ///     v      C  →    A  parent
    ///    / \                /    \
    ///   A   B              B      C
    /// ```
    #[inline]
    fn step(&mut self, v: u32, parent: u32) {
        self.push(parent);
        self.push(v);
        let (mut here, mut up) = (self.nodes[v as usize], self.nodes[parent as usize]);
        let side = usize::from(up.child[1] == v);
        let inner = here.child[1 - side];
        (here.parent, here.child[1 - side]) = (up.parent, parent);
        (up.parent, up.child[side]) = (v, inner);
        self.nodes[v as usize] = here;
        self.nodes[parent as usize] = up;
        self.set_parent(inner, parent);
    }

    /// Moves `v` above its parent and grandparent:
    ///
    /// ```text
    ///           g         v                       g               v
    ///          / \       / \                     / \            /   \
    ///         p   D     A   p                   p   D          p     g
    ///        / \    →      / \       or        / \      →    / \   / \
    ///       v   C         B   g                A   v        A   B C   D
    ///      / \               / \                  / \
    ///     A   B             C   D                B   C
    /// ```
    #[inline]
    fn double_step(&mut self, v: u32, parent: u32, grandparent: u32) {
        self.push(grandparent);
        self.push(parent);
        self.push(v);
        let mut here = self.nodes[v as usize];
        let (mut up, mut top) = (self.nodes[parent as usize], self.nodes[grandparent as usize]);
        let side = usize::from(top.child[1] == parent);
        let above = std::mem::replace(&mut here.parent, top.parent);
        debug_assert_eq!(above, parent);
        let to_top;
        if up.child[side] == v {
            to_top = std::mem::replace(&mut up.child[1 - side], grandparent);
            up.child[side] = std::mem::replace(&mut here.child[1 - side], parent);
            self.set_parent(up.child[side], parent);
            top.parent = parent;
        } else {
            to_top = std::mem::replace(&mut here.child[1 - side], grandparent);
            up.child[1 - side] = std::mem::replace(&mut here.child[side], parent);
            self.set_parent(up.child[1 - side], parent);
            top.parent = v;
        }
        up.parent = v;
        top.child[side] = to_top;
        self.set_parent(to_top, grandparent);
        self.nodes[v as usize] = here;
        self.nodes[parent as usize] = up;
        self.nodes[grandparent as usize] = top;
        if here.parent != NONE {
            let slots = &mut self.nodes[here.parent as usize].child;
            if let Some(slot) = slots.iter_mut().find(|slot| **slot == grandparent) {
                *slot = v;
            }
        }
    }

    #[inline]
    fn set_parent(&mut self, v: u32, parent: u32) {
        if v != NONE {
            self.nodes[v as usize].parent = parent;
        }
    }

    /// Hands what is pending at `v` on to its children.
    #[inline]
    fn push(&mut self, v: u32) {
        let PathNode { child, tag, .. } = self.nodes[v as usize];
        if tag <= VALUE {
            return;
        }
        for below in child.into_iter().filter(|&below| below != NONE) {
            let old = &mut self.nodes[below as usize].tag;
            *old = match tag & SPREAD {
                0 => *old ^ (tag & REVERSED),
                _ => (*old ^ tag) & REVERSED | tag & !REVERSED,
            };
        }
        let node = &mut self.nodes[v as usize];
        node.tag = tag & VALUE;
        if tag & REVERSED != 0 {
            node.child.swap(0, 1);
        }
    }
}
