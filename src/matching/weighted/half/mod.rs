//! The half-integral phase: edges may have value ½, and then form odd cycles (Derigs and Metz
//! 1986).
//!
//! The linear program without odd sets. Its optimum leaves few odd cycles, and finding it needs no
//! blossoms: a tree ends where one would have to be made. First single trees, cut at a limit that
//! grows; if many roots stay, all that are left grow together.

mod forest;
mod path;
mod search;

use std::ops::ControlFlow;

use super::limits::Limits;
use super::nodes::{Label, NONE, Nodes};
use super::observer::{Observer, Stage};
use super::refusal::Refusal;
use super::roots::Roots;
use super::work::Work;
use search::{Found, Tree};

/// Grows trees of single roots for some rounds. What is left of them is for [`half_integral`].
///
/// Adds a node of every new odd cycle to `cycles`.
pub(super) fn first_rounds<S: Nodes>(
    nodes: &mut S,
    roots: &mut Roots,
    cycles: &mut Vec<u32>,
    limits: Limits,
    work: &mut Work,
) -> Result<(), Refusal> {
    let mut goes_on = |_| ControlFlow::Continue(());
    let observer = &mut Observer::new(&mut goes_on);
    let mut cut = roots.take_blocked();
    let mut limit = limits.first;
    for _ in 0..limits.single_rounds {
        let mut tree = Tree::new(nodes, cycles);
        grow_each(&mut tree, &mut cut, &mut roots.blocked, limit, work, observer)?;
        limit = limits.next(limit);
    }
    roots.cut = cut;
    Ok(())
}

/// Pairs all roots or puts them on odd cycles. The ones that were cut before miss as many rounds.
///
/// Returns one node of each cycle, also of those that there were, each with a node in `cycles`.
pub(super) fn half_integral<S: Nodes>(
    nodes: &mut S,
    mut left: Roots,
    mut cycles: Vec<u32>,
    limits: Limits,
    work: &mut Work,
    observer: &mut Observer,
) -> Result<Vec<u32>, Refusal> {
    let mut roots = left.take_blocked();
    let mut limit = limits.first;
    let mut round = 0;
    while !(roots.is_empty() && left.cut.is_empty()) {
        round += 1;
        if round > limits.single_rounds {
            left.join_cut(&mut roots);
            let visits = roots.len().saturating_mul(limit) as u64;
            if visits > u64::from(limits.patience) * u64::from(nodes.len()) {
                roots.retain(|&root| nodes.mate(root) == NONE);
                forest::grow(nodes, &roots, &mut cycles, work, observer)?;
                break;
            }
        }
        let mut tree = Tree::new(nodes, &mut cycles);
        grow_each(&mut tree, &mut roots, &mut left.blocked, limit, work, observer)?;
        limit = limits.next(limit);
    }
    Ok(one_of_each(nodes, cycles))
}

/// Grows one tree from each root; keeps the roots whose trees were cut, and puts those apart that
/// are blocked.
fn grow_each<S: Nodes>(
    tree: &mut Tree<S>,
    roots: &mut Vec<u32>,
    blocked: &mut Vec<u32>,
    limit: usize,
    work: &mut Work,
    observer: &mut Observer,
) -> Result<(), Refusal> {
    let mut kept = 0;
    for place in 0..roots.len() {
        let root = roots[place];
        if observer.stops(Stage::HalfIntegral, roots.len() - place + kept) {
            return Err(Refusal::Stopped(tree.nodes.potential_sum()));
        }
        if tree.nodes.mate(root) != NONE {
            continue;
        }
        match tree.grow(root, limit, work)? {
            Found::Mate => {}
            Found::Border => blocked.push(root),
            Found::Nothing => {
                roots[kept] = root;
                kept += 1;
            }
        }
    }
    roots.truncate(kept);
    roots.retain(|&root| tree.nodes.mate(root) == NONE);
    Ok(())
}

/// Returns one node of each odd cycle there still is, in order.
fn one_of_each<S: Nodes>(nodes: &mut S, mut on_cycles: Vec<u32>) -> Vec<u32> {
    on_cycles.sort_unstable();
    let mut roots = Vec::new();
    for root in on_cycles {
        if nodes.label(root) != Label::Half || nodes.is_marked(root) {
            continue;
        }
        roots.push(root);
        let mut node = root;
        while !nodes.is_marked(node) {
            nodes.set_marked(node, true);
            node = nodes.head(nodes.mate(node));
        }
    }
    for &root in &roots {
        let mut node = root;
        while nodes.is_marked(node) {
            nodes.set_marked(node, false);
            node = nodes.head(nodes.mate(node));
        }
    }
    roots
}
