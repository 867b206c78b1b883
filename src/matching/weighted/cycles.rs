//! Odd cycles of edges of value ½. The mate of each node on one is the next node round.

use super::nodes::{Label, Nodes};

/// Pairs off the nodes of a cycle but one, which is free and without a mate from now on.
pub(super) fn leave_cycle<S: Nodes>(nodes: &mut S, leaver: u32) {
    let mut first = nodes.head(nodes.mate(leaver));
    nodes.set_label(leaver, Label::Free);
    while first != leaver {
        let edge = nodes.mate(first);
        let back = nodes.twin(edge);
        let second = nodes.origin(back);
        let next = nodes.head(nodes.mate(second));
        nodes.set_mate(second, back);
        nodes.set_label(first, Label::Free);
        nodes.set_label(second, Label::Free);
        first = next;
    }
}

/// Returns whether no node of a cycle is on the border.
pub(super) fn is_cycle_inside<S: Nodes>(nodes: &S, on_cycle: u32) -> bool {
    let mut node = on_cycle;
    loop {
        if nodes.is_on_border(node) {
            return false;
        }
        node = nodes.head(nodes.mate(node));
        if node == on_cycle {
            return true;
        }
    }
}
