//! Greedy potentials and pairs.

use super::displace::{displace_each, raise};
use super::limits::Limits;
use super::nodes::{NONE, Nodes};

/// Raises the potential of each free node as far as that goes, and pairs it along an edge that
/// thereby becomes tight. O(nodes in range).
///
/// Then free nodes [displace](displace_each) others. Returns the nodes that stay free, and those on
/// the border, which [`raise_each`] is for.
pub(super) fn start<S: Nodes>(nodes: &mut S, limits: Limits) -> (Vec<u32>, Vec<u32>) {
    let mut border = Vec::new();
    let mut free = Vec::new();
    for node in nodes.range() {
        if nodes.is_on_border(node) {
            border.push(node);
        } else if nodes.mate(node) == NONE {
            raise(nodes, node);
            if nodes.mate(node) == NONE {
                free.push(node);
            }
        }
    }
    displace_each(nodes, &mut free, limits.displacements);
    (free, border)
}

/// Raises the potentials of those `border` nodes that are free, and adds the ones that stay so to
/// the `free` nodes. Those come in order.
pub(super) fn raise_each<S: Nodes>(nodes: &mut S, border: Vec<u32>, free: &mut Vec<u32>) {
    for node in border {
        if nodes.mate(node) == NONE {
            raise(nodes, node);
            free.push(node);
        }
    }
    free.retain(|&node| nodes.mate(node) == NONE);
    free.sort_unstable();
}
