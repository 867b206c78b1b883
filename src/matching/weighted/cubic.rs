//! Nodes of at most three sides, each in one half of a cache line.

use super::nodes::{Label, NONE, Nodes};
use super::number::{Number, doubled};
use super::problem::{CubicProblem, NONE as NO_NODE};
use super::refusal::Refusal;
use crate::prefetch::prefetch;

/// One node. 32 bytes with 32-bit numbers.
///
/// State, from the lowest bit: mate side (2, 3 for the ground), parent side (2), label (2), whether
/// there is a mate (1), mark (1), set (the rest).
#[derive(Clone, Copy, Debug)]
#[repr(align(32))]
struct Row<N: Number> {
    twins: [u32; 3],
    costs: [N; 3],
    potential: N,
    state: N::State,
}

const PARENT: u32 = 2;
const LABEL: u32 = 4;
const PAIRED: u64 = 1 << 6;
const MARK: u64 = 1 << 7;
const SET: u32 = 8;

/// A cubic graph. Half-edge `4v + i` leaves node `v` across side `i`, `4v + 3` to the ground.
pub(super) struct Cubic<N: Number> {
    rows: Vec<Row<N>>,
    /// Empty if no node has one.
    prices: Vec<Option<N>>,
}

impl<N: Number> Cubic<N> {
    /// Reads a problem. O(n).
    pub(super) fn new(problem: &impl CubicProblem) -> Result<Self, Refusal> {
        let count = problem.node_count();
        // Half-edges, and a number for every blossom beyond them, in 32 bits.
        if count > (u32::MAX / 5) as usize {
            return Err(Refusal::TooLarge);
        }
        let nodes = 0..count as u32;
        let rows = nodes.clone().map(|node| row(problem, node));
        let mut rows = rows.collect::<Result<Vec<_>, _>>()?;
        nodes.clone().try_for_each(|node| join(&mut rows, node))?;
        let prices = if nodes.clone().any(|node| problem.price(node).is_some()) {
            let price = |node| problem.price(node).map(doubled).transpose();
            nodes.map(price).collect::<Result<_, _>>()?
        } else {
            Vec::new()
        };
        Ok(Self { rows, prices })
    }

    #[inline]
    fn state(&self, node: u32) -> u64 {
        self.rows[node as usize].state.into()
    }

    #[inline]
    fn put(&mut self, node: u32, clear: u64, bits: u64) {
        let state = self.state(node) & !clear | bits;
        self.rows[node as usize].state = N::state(state);
    }
}

/// State of a node without mate, label, mark and set.
const EMPTY: u64 = u64::MAX << SET;

/// Reads a node; neighbours stand for twins. The lowest three bits of the state are for [`join`].
#[inline]
fn row<N: Number>(problem: &impl CubicProblem, node: u32) -> Result<Row<N>, Refusal> {
    let neighbours = problem.neighbours(node);
    let costs = problem.costs(node);
    let mut row =
        Row { twins: [NONE; 3], costs: [N::ZERO; 3], potential: N::ZERO, state: N::state(EMPTY) };
    for (side, neighbour) in neighbours.into_iter().enumerate() {
        if neighbour != NO_NODE && neighbour != node {
            row.twins[side] = neighbour;
            row.costs[side] = doubled(costs[side])?;
        }
    }
    Ok(row)
}

/// Makes twins of a node's sides to later nodes; those to earlier ones have been made.
///
/// Several edges between two nodes correspond by cost, equal ones in the order of the sides. Bit i
/// of a state says whether side i has its twin.
#[inline]
fn join<N: Number>(rows: &mut [Row<N>], node: u32) -> Result<(), Refusal> {
    let row = rows[node as usize];
    let joined: u64 = row.state.into();
    for side in 0..3 {
        let neighbour = row.twins[side];
        if joined >> side & 1 != 0 || neighbour == NONE {
            continue;
        }
        let asymmetric = Refusal::Asymmetric(node, neighbour);
        if neighbour < node {
            return Err(asymmetric);
        }
        let other = rows.get_mut(neighbour as usize).ok_or(Refusal::NoSuchNode(neighbour))?;
        let theirs: u64 = other.state.into();
        let is_back = |&i: &usize| {
            let is_open = theirs >> i & 1 == 0;
            is_open && other.twins[i] == node && other.costs[i] == row.costs[side]
        };
        let back = (0..3).find(is_back).ok_or(asymmetric)?;
        other.twins[back] = 4 * node + side as u32;
        other.state = N::state(theirs | 1 << back);
        rows[node as usize].twins[side] = 4 * neighbour + back as u32;
    }
    rows[node as usize].state = N::state(EMPTY);
    Ok(())
}

impl<N: Number> Nodes for Cubic<N> {
    type N = N;
    const MOST_SETS: u32 = if size_of::<N>() == 4 { (1 << 24) - 2 } else { u32::MAX - 2 };

    fn len(&self) -> u32 {
        self.rows.len() as u32
    }
    fn codes(&self) -> u32 {
        4 * self.len()
    }
    #[inline]
    fn origin(&self, half_edge: u32) -> u32 {
        half_edge >> 2
    }
    #[inline]
    fn twin(&self, half_edge: u32) -> u32 {
        self.rows[(half_edge >> 2) as usize].twins[(half_edge & 3) as usize]
    }
    #[inline]
    fn ground(&self, node: u32) -> u32 {
        4 * node + 3
    }
    #[inline]
    fn sides(&self, node: u32) -> std::ops::Range<u32> {
        4 * node..4 * node + 3
    }
    #[inline]
    fn cost(&self, half_edge: u32) -> N {
        self.rows[(half_edge >> 2) as usize].costs[(half_edge & 3) as usize]
    }
    #[inline]
    fn price(&self, node: u32) -> Option<N> {
        self.prices.get(node as usize).copied().flatten()
    }
    #[inline]
    fn prefetch(&self, node: u32) {
        prefetch(&self.rows, node as usize);
    }

    #[inline]
    fn potential(&self, node: u32) -> N {
        self.rows[node as usize].potential
    }
    #[inline]
    fn add_potential(&mut self, node: u32, change: N) {
        self.rows[node as usize].potential += change;
    }
    #[inline]
    fn mate(&self, node: u32) -> u32 {
        let state = self.state(node);
        if state & PAIRED == 0 { NONE } else { 4 * node + (state & 3) as u32 }
    }
    #[inline]
    fn set_mate(&mut self, node: u32, half_edge: u32) {
        debug_assert!(half_edge == NONE || half_edge >> 2 == node);
        let paired = if half_edge == NONE { 0 } else { PAIRED | u64::from(half_edge & 3) };
        self.put(node, PAIRED | 3, paired);
    }
    #[inline]
    fn parent(&self, node: u32) -> u32 {
        4 * node + (self.state(node) >> PARENT & 3) as u32
    }
    #[inline]
    fn set_parent(&mut self, node: u32, half_edge: u32) {
        debug_assert!(half_edge >> 2 == node);
        self.put(node, 3 << PARENT, u64::from(half_edge & 3) << PARENT);
    }
    #[inline]
    fn label(&self, node: u32) -> Label {
        Label::of(self.state(node) >> LABEL)
    }
    #[inline]
    fn set_label(&mut self, node: u32, label: Label) {
        self.put(node, 3 << LABEL, (label as u64) << LABEL);
    }
    #[inline]
    fn is_marked(&self, node: u32) -> bool {
        self.state(node) & MARK != 0
    }
    #[inline]
    fn set_marked(&mut self, node: u32, marked: bool) {
        self.put(node, MARK, if marked { MARK } else { 0 });
    }
    #[inline]
    fn set(&self, node: u32) -> u32 {
        let set = (self.state(node) >> SET) as u32;
        if set > Self::MOST_SETS { NONE } else { set }
    }
    #[inline]
    fn set_set(&mut self, node: u32, set: u32) {
        self.put(node, u64::MAX << SET, u64::from(set) << SET);
    }
}
