//! A view of the nodes in a range.

use std::ops::Range;

use super::super::nodes::{Label, NONE, Nodes};
use super::super::number::Number;
use super::row::{Row, SET};
use crate::prefetch::prefetch;

const PARENT: u32 = 2;
const LABEL: u32 = 4;
const PAIRED: u64 = 1 << 6;
const MARK: u64 = 1 << 7;

/// All nodes, or if `PART` those of a range. Half-edge `4v + i` leaves node `v` across side `i`,
/// `4v + 3` to the ground.
pub(crate) struct Cubic<'a, N: Number, const PART: bool> {
    pub(super) rows: &'a mut [Row<N>],
    /// Those of all nodes; empty if no node has one.
    pub(super) prices: &'a [Option<N>],
    pub(super) first: u32,
    /// Number of all nodes.
    pub(super) count: u32,
}

impl<N: Number, const PART: bool> Cubic<'_, N, PART> {
    /// Returns the place of a node in the rows.
    #[inline]
    fn place(&self, node: u32) -> usize {
        if PART { node.wrapping_sub(self.first) as usize } else { node as usize }
    }

    #[inline]
    fn row(&self, node: u32) -> &Row<N> {
        &self.rows[self.place(node)]
    }

    #[inline]
    fn row_mut(&mut self, node: u32) -> &mut Row<N> {
        &mut self.rows[self.place(node)]
    }

    #[inline]
    fn state(&self, node: u32) -> u64 {
        self.row(node).state.into()
    }

    #[inline]
    fn put(&mut self, node: u32, clear: u64, bits: u64) {
        let state = self.state(node) & !clear | bits;
        self.row_mut(node).state = N::state(state);
    }
}

impl<N: Number, const PART: bool> Nodes for Cubic<'_, N, PART> {
    type N = N;
    const MOST_SETS: u32 = if size_of::<N>() == 4 { (1 << 24) - 2 } else { u32::MAX - 2 };

    fn len(&self) -> u32 {
        self.count
    }
    fn range(&self) -> Range<u32> {
        let first = if PART { self.first } else { 0 };
        first..first + self.rows.len() as u32
    }
    #[inline]
    fn is_on_border(&self, node: u32) -> bool {
        if !PART {
            return false;
        }
        let range = self.range();
        self.row(node).twins.iter().any(|&twin| twin != NONE && !range.contains(&(twin >> 2)))
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
        self.row(half_edge >> 2).twins[(half_edge & 3) as usize]
    }
    #[inline]
    fn ground(&self, node: u32) -> u32 {
        4 * node + 3
    }
    #[inline]
    fn sides(&self, node: u32) -> Range<u32> {
        4 * node..4 * node + 3
    }
    #[inline]
    fn cost(&self, half_edge: u32) -> N {
        self.row(half_edge >> 2).costs[(half_edge & 3) as usize]
    }
    #[inline]
    fn price(&self, node: u32) -> Option<N> {
        self.prices.get(node as usize).copied().flatten()
    }
    #[inline]
    fn prefetch(&self, node: u32) {
        prefetch(self.rows, self.place(node));
    }

    #[inline]
    fn potential(&self, node: u32) -> N {
        self.row(node).potential
    }
    #[inline]
    fn add_potential(&mut self, node: u32, change: N) {
        self.row_mut(node).potential += change;
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
