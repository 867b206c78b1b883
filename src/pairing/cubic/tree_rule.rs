//! The rule for trees: with a spanning tree of what is left, no search for bridges is needed.

use super::graph::{Candidate, Reduction};
use crate::dynamic::LinkCutForest;

/// Returns a candidate that is connected and bridgeless, by any spanning tree of the graph without
/// `u`, `v`.
///
/// No edge of the tree separates the ends of one new edge from those of the other. With the tree
/// rooted at w, let p be where the ways to x and y_s part. A tree edge has w and y_r on one side, x
/// and y_s on the other, exactly if it is above p but not on the way to y_r:
///
/// ```text
///    w             p is above y_r: H1          w             p is not above y_r:
///    |             (w-y_r, x-y_s)             / \            the edge above p rules
///    p---y_r                               y_r   p           out H1, so take H2
///   / \                                         / \          (w-y_s, x-y_r)
///  x   y_s                                     x   y_s
/// ```
///
/// Any other slot can be the `root`, in the order w, x, y_r, y_s; the candidates look the same from
/// all. Five accesses, O(log n) amortised. The root is that of the tree afterwards.
pub(super) fn tree_rule(tree: &mut LinkCutForest, cut: &Reduction, root: usize) -> Candidate {
    let slots = cut.slots().map(|(_, node)| node.0);
    let [beside, in_h1, in_h2] = [root ^ 1, root ^ 2, root ^ 3].map(|i| slots[i]);
    tree.evert(slots[root]);
    let parting = tree.lca(beside, in_h2);
    if tree.lca(parting, in_h1) == parting { Candidate::H1 } else { Candidate::H2 }
}
