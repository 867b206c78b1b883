//! The driver: one step after the other until two nodes are left, and back again.

use super::graph::{Candidate, DoubleEdge, EdgeId, Multigraph, NodeId, Receipt, Reduction, Step};
use crate::triangulation::IdVec;

/// A structure that chooses between Frink's candidates.
///
/// It is updated before every step is carried out.
pub(super) trait Decide {
    /// Returns a candidate that is connected and bridgeless, and updates the structure for it.
    fn decide(&mut self, graph: &Multigraph, cut: &Reduction) -> Candidate;

    /// Updates the structure for a contraction.
    fn contract(&mut self, graph: &Multigraph, double: &DoubleEdge);

    /// Returns the cost of a decision for edge `e`, with these edges beside it. The cheapest edge
    /// is taken.
    fn cost(&self, e: EdgeId, beside: [EdgeId; 4]) -> u32;
}

/// Returns a perfect matching of `graph` that avoids `f`. n / 2 steps, and 6 bytes a node for
/// receipts.
pub(super) fn matching_without(
    mut graph: Multigraph,
    f: EdgeId,
    decider: &mut impl Decide,
) -> IdVec<EdgeId, bool> {
    let mut matched = IdVec::filled(false, graph.ends.len());
    let steps = graph.around.len() / 2 - 1;
    let mut receipts: Vec<Receipt> = Vec::with_capacity(steps);
    for _ in 0..steps {
        receipts.push(match next_step(&graph, f, decider) {
            Step::Contract(double) => {
                decider.contract(&graph, &double);
                graph.contract(&double)
            }
            Step::Reduce(cut) => {
                let candidate = decider.decide(&graph, &cut);
                graph.reduce(&cut, candidate)
            }
        });
    }
    // Two nodes and three edges are left.
    let [u, _] = graph.ends[f];
    let [one, _] = graph.others(u, f);
    matched[one] = true;
    while let Some(receipt) = receipts.pop() {
        receipt.undo(&mut matched);
    }
    debug_assert!(!matched[f]);
    matched
}

/// Returns a contraction at `f` if there is one, or else the reduction that costs least.
fn next_step(graph: &Multigraph, f: EdgeId, decider: &impl Decide) -> Step {
    let mut best: Option<(u32, NodeId, EdgeId, EdgeId)> = None;
    for u in graph.ends[f] {
        let others = graph.others(u, f);
        let far = others.map(|edge| graph.far_end(edge, u));
        if far[0] == far[1] {
            return Step::Contract(contraction(graph, f, u, others));
        }
        let w = graph.far_end(f, u);
        // An edge beside f is no simple one.
        for i in (0..2).filter(|&i| far[i] != w) {
            let (e, c) = (others[i], others[1 - i]);
            let [r, s] = graph.others(far[i], e);
            let cost = decider.cost(e, [f, c, r, s]);
            if best.is_none_or(|(least, ..)| cost < least) {
                best = Some((cost, u, e, c));
            }
        }
    }
    let (_, u, e, c) = best.expect("two edges at u that end in different nodes: one is simple");
    Step::Reduce(reduction(graph, f, u, e, c))
}

fn contraction(graph: &Multigraph, f: EdgeId, u: NodeId, [p, q]: [EdgeId; 2]) -> DoubleEdge {
    let v = graph.far_end(p, u);
    let [a, b] = graph.others(v, p);
    let t = if a == q { b } else { a };
    let (w, x) = (graph.far_end(f, u), graph.far_end(t, v));
    debug_assert!(w != v && w != x, "two nodes are left, or there is a bridge");
    DoubleEdge { u, v, f, p, q, t, w, x }
}

fn reduction(graph: &Multigraph, f: EdgeId, u: NodeId, e: EdgeId, c: EdgeId) -> Reduction {
    let v = graph.far_end(e, u);
    let [r, s] = graph.others(v, e);
    let (w, x) = (graph.far_end(f, u), graph.far_end(c, u));
    let (y_r, y_s) = (graph.far_end(r, v), graph.far_end(s, v));
    debug_assert!(u != y_r && u != y_s, "e is simple");
    Reduction { u, v, e, f, c, r, s, w, x, y_r, y_s }
}
