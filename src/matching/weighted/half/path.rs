//! Paths of a tree without blossoms, towards its root.

use super::super::nodes::{Label, NONE, Nodes};

/// Returns the next outer node above an outer one, `None` above a root.
fn above<S: Nodes>(nodes: &S, outer: u32) -> Option<u32> {
    let mate = nodes.mate(outer);
    (mate != NONE).then(|| nodes.head(nodes.parent(nodes.head(mate))))
}

/// Returns the lowest outer node above, or among, two outer ones of one tree.
fn common_outer<S: Nodes>(nodes: &mut S, x: u32, y: u32) -> u32 {
    let mut walkers = [Some(x), Some(y)];
    let common = loop {
        if let Some(node) = walkers[0] {
            if nodes.is_marked(node) {
                break node;
            }
            nodes.set_marked(node, true);
            walkers[0] = above(nodes, node);
        }
        walkers.swap(0, 1);
    };
    for start in [x, y] {
        let mut walker = Some(start);
        while let Some(node) = walker.filter(|&node| nodes.is_marked(node)) {
            nodes.set_marked(node, false);
            walker = above(nodes, node);
        }
    }
    common
}

/// Pairs an outer node along a half-edge and re-pairs all nodes above it up to the root.
pub(super) fn flip<S: Nodes>(nodes: &mut S, half_edge: u32) {
    let mut new = half_edge;
    loop {
        let outer = nodes.origin(new);
        let old = nodes.mate(outer);
        nodes.set_mate(outer, new);
        if old == NONE {
            return;
        }
        let inner = nodes.head(old);
        let up = nodes.parent(inner);
        nodes.set_mate(inner, up);
        new = nodes.twin(up);
    }
}

/// Makes the cycle that a half-edge between two outer nodes of a tree closes one of edges of value
/// ½, and re-pairs the nodes above it.
///
/// Returns a node of the cycle; the labels are for the caller to set.
pub(super) fn close_cycle<S: Nodes>(nodes: &mut S, half_edge: u32) -> u32 {
    let [x, y] = [nodes.origin(half_edge), nodes.head(half_edge)];
    let base = common_outer(nodes, x, y);
    let mut outer = x;
    while outer != base {
        let inner = nodes.head(nodes.mate(outer));
        let up = nodes.parent(inner);
        nodes.set_mate(inner, up);
        outer = nodes.head(up);
    }
    let mut next = nodes.twin(half_edge);
    outer = y;
    while outer != base {
        let old = nodes.mate(outer);
        nodes.set_mate(outer, next);
        let inner = nodes.head(old);
        nodes.set_mate(inner, nodes.twin(old));
        let up = nodes.parent(inner);
        next = nodes.twin(up);
        outer = nodes.head(up);
    }
    flip(nodes, next);
    base
}

/// Labels all nodes of a cycle.
pub(super) fn mark_half<S: Nodes>(nodes: &mut S, on_cycle: u32) {
    let mut node = on_cycle;
    while nodes.label(node) != Label::Half {
        nodes.set_label(node, Label::Half);
        node = nodes.head(nodes.mate(node));
    }
}
