//! Free nodes take the mates of others: the row reduction of Jonker and Volgenant (1987), here in
//! graphs that need not be bipartite.
//!
//! A free node v whose cheapest edge leads to a paired node u may raise its potential beyond that
//! edge as far as its second cheapest edge goes, if that of u falls as much. The pair of u then has
//! slack and is given up for v and u, and the old mate of u is free in turn. No tree is grown and
//! nothing is queued: a step costs what it takes to look at one node. Most chains soon meet a free
//! node. On surfaces about four of five free nodes are paired so, those with the nearest partners.

use super::nodes::{NONE, Nodes};
use super::number::Number;

/// What the edges of a free node offer. The room of an edge is its cost less the potential of the
/// other end: as high as that, the node's own potential can be.
pub(super) struct Offers<N> {
    least: N,
    /// The half-edge that leaves the least room, one to a free node if there is.
    best: u32,
    is_free: bool,
    /// The least room of the others, [`Number::GREATEST`] if there are none.
    second: N,
}

/// Lets each of the `free` nodes begin a chain of up to `steps` displacements.
///
/// `free` becomes the nodes that are free then, in order. None of them is on the border. O(steps)
/// for each node.
pub(super) fn displace_each<S: Nodes>(nodes: &mut S, free: &mut Vec<u32>, steps: u32) {
    for node in free.iter_mut() {
        let mut left = steps;
        while left > 0
            && nodes.mate(*node) == NONE
            && let Some(next) = displace(nodes, *node)
        {
            *node = next;
            left -= 1;
        }
    }
    free.retain(|&node| nodes.mate(node) == NONE);
    free.sort_unstable();
    free.dedup();
}

/// Raises the potential of a free node and pairs it if it can. Returns what its edges offer, if it
/// stays free.
#[inline]
pub(super) fn raise<S: Nodes>(nodes: &mut S, node: u32) -> Option<Offers<S::N>> {
    let offers = offers(nodes, node)?;
    nodes.add_potential(node, offers.least - nodes.potential(node));
    if offers.is_free || offers.best == nodes.ground(node) {
        nodes.pair(offers.best);
        return None;
    }
    Some(offers)
}

/// Raises a free node, and takes the mate of another if it stays free. Returns the node that is
/// free now instead.
fn displace<S: Nodes>(nodes: &mut S, node: u32) -> Option<u32> {
    let Offers { least, best, second, .. } = raise(nodes, node)?;
    let other = nodes.head(best);
    let given_up = nodes.mate(other);
    let is_grounded = given_up == nodes.ground(other);
    if second == S::N::GREATEST {
        return None;
    }
    let rise = second - least;
    if rise == S::N::ZERO && !is_grounded || nodes.is_on_border(other) {
        return None;
    }
    let is_within = |potential| -S::N::LIMIT <= potential && potential <= S::N::LIMIT;
    if !is_within(least + rise) || !is_within(nodes.potential(other) - rise) {
        return None;
    }
    let next = (!is_grounded).then(|| nodes.head(given_up));
    if next.is_some_and(|next| nodes.is_on_border(next)) {
        return None;
    }
    nodes.add_potential(node, rise);
    nodes.add_potential(other, -rise);
    if let Some(next) = next {
        nodes.set_mate(next, NONE);
    }
    nodes.pair(best);
    next
}

/// Looks at the edges of a free node and at its ground; `None` if there is neither.
///
/// Which edge leaves the least room is hard to predict: nothing branches there.
#[inline]
fn offers<S: Nodes>(nodes: &S, node: u32) -> Option<Offers<S::N>> {
    // No room is that large.
    let none = S::N::GREATEST;
    let mut all = Offers { least: none, best: NONE, is_free: false, second: none };
    if let Some(price) = nodes.price(node) {
        (all.least, all.best) = (price, nodes.ground(node));
    }
    for side in nodes.sides(node) {
        let twin = nodes.twin(side);
        if twin == NONE {
            continue;
        }
        let other = nodes.origin(twin);
        let room = nodes.cost(side) - nodes.potential(other);
        let is_free = nodes.mate(other) == NONE;
        let is_better = (room < all.least) | ((room == all.least) & is_free & !all.is_free);
        all.second = all.second.min(if is_better { all.least } else { room });
        all.least = all.least.min(room);
        all.best = if is_better { side } else { all.best };
        all.is_free = if is_better { is_free } else { all.is_free };
    }
    (all.best != NONE).then_some(all)
}
