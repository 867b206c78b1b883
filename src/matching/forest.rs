//! Alternating trees with blossoms (Edmonds), below pairing and augmentation alike.
//!
//! After Tarjan, *Data Structures and Network Algorithms*, chapter 9. A tree grows from an
//! unpaired triangle, its root, along unmatched and matched edges in turn. Triangles at even
//! distance are outer, the others inner. An edge between two outer triangles of one tree closes an
//! odd cycle, a blossom. It is shrunk into its base, the triangle of the cycle nearest the root.
//! Disjoint sets with path compression give the base that a triangle has been shrunk into. Every
//! inner triangle of the cycle turns outer and keeps the *bridge*, the edge that closed it.
//! Blossoms nest. Paths are read off with an explicit stack, not by recursion.

use crate::dual::{Matching, Sides};
use crate::prefetch::prefetch;
use crate::triangulation::TriangleId;

/// The place of a triangle in the forest.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Place {
    /// In no tree.
    Free,
    /// In the tree of this number, reached only at odd distance from the root.
    Inner(TreeId),
    /// In the tree of this number, and reached by a path of even length.
    Outer(TreeId),
}

/// Number of a tree, from 1.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct TreeId(u32);

/// The data of one triangle.
///
/// All zero means: in tree 0, which is none. So fresh memory needs no initialisation, and pages
/// that no search touches are never made resident.
#[derive(Clone, Copy, Default, bytemuck::Zeroable)]
struct Node {
    /// The tree that took it in last; when that tree has been felled the rest means nothing.
    tree: u32,
    /// Disjoint sets: its base, or a triangle nearer to it.
    base: u32,
    /// Its label in the two low bits; above them the time at which a search for a base passed.
    label_and_mark: u32,
    /// Not for outer ones: the outer triangle from which it was reached.
    parent: u32,
    /// Blossomed: the bridge, as triangle and side at its own end.
    bridge: u32,
    /// The next triangle in the list of its tree that it stands in.
    next: u32,
}

const LABEL: u32 = 3;
const OUTER: u32 = 1;
const INNER: u32 = 2;
/// Inner at first, outer since a blossom took it in.
const BLOSSOMED: u32 = 3;
/// Number of bits below the mark.
const MARK: u32 = 2;

/// End of a list of triangles.
const END: u32 = u32::MAX;

/// A first-in first-out list of triangles, linked through `Node::next`.
#[derive(Clone, Copy)]
struct List {
    head: u32,
    tail: u32,
}

impl List {
    const EMPTY: Self = Self { head: END, tail: END };

    fn push(&mut self, nodes: &mut [Node], f: u32) {
        nodes[f as usize].next = END;
        match self.tail {
            END => self.head = f,
            tail => nodes[tail as usize].next = f,
        }
        self.tail = f;
    }

    fn pop(&mut self, nodes: &[Node]) -> Option<u32> {
        let f = self.head;
        if f == END {
            return None;
        }
        self.head = nodes[f as usize].next;
        if self.head == END {
            self.tail = END;
        }
        Some(f)
    }

    fn first(&self) -> Option<u32> {
        (self.head != END).then_some(self.head)
    }

    /// Moves all of `other` behind this list.
    fn append(&mut self, nodes: &mut [Node], other: &mut Self) {
        match self.tail {
            END => *self = *other,
            tail if other.head != END => {
                nodes[tail as usize].next = other.head;
                self.tail = other.tail;
            }
            _ => {}
        }
        *other = Self::EMPTY;
    }
}

struct Tree {
    root: u32,
    /// False once it has been felled: its triangles are free.
    stands: bool,
    /// Outer triangles still to be scanned.
    queue: List,
    /// Outer triangles beside an inner one of another tree, to be scanned again later.
    barred: List,
}

/// Alternating trees over the triangles of a dual graph. 24 bytes for each triangle ever visited.
pub(crate) struct Forest {
    nodes: Vec<Node>,
    trees: Vec<Tree>,
    clock: u32,
    /// Triangles that entered a tree, once for every time that they did.
    visited: usize,
    path: Vec<(TriangleId, TriangleId)>,
    segments: Vec<(TriangleId, TriangleId)>,
}

impl Forest {
    /// Makes an empty forest over `triangles` triangles. Takes memory only where trees grow.
    pub(crate) fn new(triangles: usize) -> Self {
        let nodes = bytemuck::zeroed_vec(triangles);
        let (path, segments) = (Vec::new(), Vec::new());
        Self { nodes, trees: vec![Self::no_tree()], clock: 0, visited: 0, path, segments }
    }

    fn no_tree() -> Tree {
        Tree { root: END, stands: false, queue: List::EMPTY, barred: List::EMPTY }
    }

    /// Forgets everything but the count of visits. Θ(n).
    pub(crate) fn clear(&mut self) {
        self.nodes.fill(Node::default());
        self.trees.truncate(1);
        self.clock = 0;
    }

    /// Returns the triangles that entered a tree, once for every time that they did.
    pub(crate) fn visited(&self) -> usize {
        self.visited
    }

    /// Returns the place of `f`.
    #[inline]
    pub(crate) fn place(&self, f: TriangleId) -> Place {
        let node = &self.nodes[f.index()];
        match (self.trees[node.tree as usize].stands, node.label_and_mark & LABEL) {
            (false, _) => Place::Free,
            (true, INNER) => Place::Inner(TreeId(node.tree)),
            _ => Place::Outer(TreeId(node.tree)),
        }
    }

    /// Starts a tree at the unpaired triangle `root`.
    pub(crate) fn plant(&mut self, root: TriangleId) -> TreeId {
        debug_assert_eq!(self.place(root), Place::Free);
        self.visited += 1;
        let tree = self.trees.len() as u32;
        self.nodes[root.index()] =
            Node { tree, base: root.0, label_and_mark: OUTER, ..Node::default() };
        let mut queue = List::EMPTY;
        queue.push(&mut self.nodes, root.0);
        self.trees.push(Tree { root: root.0, stands: true, queue, barred: List::EMPTY });
        TreeId(tree)
    }

    /// Adds the free pair `inner` - `outer` to the tree of the outer triangle `parent`.
    #[inline]
    pub(crate) fn grow(
        &mut self,
        tree: TreeId,
        parent: TriangleId,
        inner: TriangleId,
        outer: TriangleId,
    ) {
        debug_assert!(self.place(inner) == Place::Free && self.place(outer) == Place::Free);
        self.visited += 2;
        let node = |label, base| Node {
            tree: tree.0,
            base,
            label_and_mark: label,
            parent: parent.0,
            ..Node::default()
        };
        self.nodes[inner.index()] = node(INNER, inner.0);
        self.nodes[outer.index()] = node(OUTER, outer.0);
        self.trees[tree.0 as usize].queue.push(&mut self.nodes, outer.0);
    }

    /// Takes the next triangle of `tree` to be scanned.
    #[inline]
    pub(crate) fn next_to_scan(&mut self, tree: TreeId) -> Option<TriangleId> {
        self.trees[tree.0 as usize].queue.pop(&self.nodes).map(TriangleId)
    }

    /// Prefetches what scanning the next triangle of `tree` will read.
    #[inline]
    pub(crate) fn prefetch_next(&self, graph: &impl Sides, matching: &Matching, tree: TreeId) {
        let Some(next) = self.trees[tree.0 as usize].queue.first() else { return };
        for w in graph.sides_or_none(TriangleId(next)) {
            prefetch(&self.nodes, w.index());
            matching.prefetch(w);
        }
    }

    /// Puts the scanned triangle `f` of `tree` aside until [`Forest::retry_barred`].
    pub(crate) fn bar(&mut self, tree: TreeId, f: TriangleId) {
        self.trees[tree.0 as usize].barred.push(&mut self.nodes, f.0);
    }

    /// Queues the triangles of `tree` that were put aside.
    pub(crate) fn retry_barred(&mut self, tree: TreeId) {
        let tree = &mut self.trees[tree.0 as usize];
        tree.queue.append(&mut self.nodes, &mut tree.barred);
    }

    /// Forgets `tree`: its triangles are free again. O(1).
    pub(crate) fn fell(&mut self, tree: TreeId) {
        self.trees[tree.0 as usize].stands = false;
    }

    /// Returns whether `tree` has not been felled.
    pub(crate) fn stands(&self, tree: TreeId) -> bool {
        self.trees[tree.0 as usize].stands
    }

    /// Returns the base of the outermost blossom around `f`, or `f` itself.
    #[inline]
    fn base(&mut self, f: TriangleId) -> TriangleId {
        let mut at = f.0;
        // Path halving.
        loop {
            let up = self.nodes[at as usize].base;
            if up == at {
                return TriangleId(at);
            }
            let higher = self.nodes[up as usize].base;
            self.nodes[at as usize].base = higher;
            at = higher;
        }
    }

    /// Shrinks the blossom that an edge closes between the outer triangles `x` and `y` of `tree`.
    ///
    /// The edge is side `side` of `x`. Inner triangles of the cycle turn outer and are queued. If
    /// one blossom holds both triangles already, nothing changes.
    #[inline]
    pub(crate) fn shrink(
        &mut self,
        graph: &impl Sides,
        matching: &Matching,
        tree: TreeId,
        x: TriangleId,
        side: usize,
        y: TriangleId,
    ) {
        if self.base(x) == self.base(y) {
            return;
        }
        let base = self.common_base(matching, x, y);
        let back = graph.sides_or_none(y).into_iter().position(|z| z == x);
        let back = back.expect("neighbours are mutual");
        for (end, side) in [(x, side), (y, back)] {
            let bridge = (3 * end.index() + side) as u32;
            let mut v = self.base(end);
            while v != base {
                let w = matching.mate_or_none(v);
                let node = &mut self.nodes[w.index()];
                debug_assert_eq!(node.label_and_mark & LABEL, INNER);
                node.label_and_mark |= BLOSSOMED;
                node.bridge = bridge;
                node.base = base.0;
                let parent = TriangleId(node.parent);
                self.nodes[v.index()].base = base.0;
                self.trees[tree.0 as usize].queue.push(&mut self.nodes, w.0);
                v = self.base(parent);
            }
        }
    }

    /// Returns the base where the ways from `x` and `y` to their root meet.
    ///
    /// Both ways are walked in turn: at most twice as much is walked as is shrunk afterwards.
    fn common_base(&mut self, matching: &Matching, x: TriangleId, y: TriangleId) -> TriangleId {
        self.tick();
        let mut here = self.base(x);
        let mut there = self.base(y);
        loop {
            let node = &mut self.nodes[here.index()];
            if node.label_and_mark >> MARK == self.clock {
                return here;
            }
            node.label_and_mark = self.clock << MARK | node.label_and_mark & LABEL;
            here = match matching.mate(here) {
                Some(w) => self.base(TriangleId(self.nodes[w.index()].parent)),
                None => TriangleId::NONE,
            };
            // A way that has reached the root is not walked any further.
            if there != TriangleId::NONE {
                std::mem::swap(&mut here, &mut there);
            }
        }
    }

    /// Moves the clock that marks passed bases; wipes the marks when it overflows.
    fn tick(&mut self) {
        if self.clock == u32::MAX >> MARK {
            self.nodes.iter_mut().for_each(|node| node.label_and_mark &= LABEL);
            self.clock = 0;
        }
        self.clock += 1;
    }

    /// Augments `matching` along the path that the edge `x` - `y` completes.
    ///
    /// It leads from `x` back to its root and from `y` back to its root. If `y` is in no tree, the
    /// path ends there. Returns the length of the path in edges.
    pub(crate) fn augment(
        &mut self,
        graph: &impl Sides,
        matching: &mut Matching,
        x: TriangleId,
        y: TriangleId,
    ) -> usize {
        self.path.clear();
        self.path.push((x, y));
        for end in [x, y] {
            match self.place(end) {
                Place::Outer(tree) => self.collect_way_to_root(graph, matching, tree, end),
                _ => self.visited += 1,
            }
        }
        matching.replace_along(&self.path);
        2 * self.path.len() - 1
    }

    /// Collects the unmatched edges of the even alternating path from `from` to its root.
    ///
    /// `from` is outer. Where the path runs round a blossom, the part between the bridge and the
    /// triangle is another such path, put on a stack. The order of the edges does not matter.
    fn collect_way_to_root(
        &mut self,
        graph: &impl Sides,
        matching: &Matching,
        tree: TreeId,
        from: TriangleId,
    ) {
        self.segments.push((from, TriangleId(self.trees[tree.0 as usize].root)));
        while let Some((mut v, end)) = self.segments.pop() {
            while v != end {
                let mate = matching.mate_or_none(v);
                let node = &self.nodes[v.index()];
                if node.label_and_mark & LABEL == BLOSSOMED {
                    let near = TriangleId(node.bridge / 3);
                    let far = graph.sides_or_none(near)[node.bridge as usize % 3];
                    self.segments.push((near, mate));
                    self.path.push((near, far));
                    v = far;
                } else {
                    let parent = TriangleId(self.nodes[mate.index()].parent);
                    self.path.push((mate, parent));
                    v = parent;
                }
            }
        }
    }
}
