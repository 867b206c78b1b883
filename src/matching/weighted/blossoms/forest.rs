//! What several trees need besides what one needs.

use std::collections::VecDeque;

use super::super::nodes::NONE;

/// Trees that stand together. 4 bytes a node or blossom, and 8 an event with 32-bit numbers.
#[derive(Debug, Default)]
pub(super) struct Forest {
    /// For each node and blossom the tree that has touched it last.
    pub(super) tree: Vec<u32>,
    /// For each tree but the present one what it has touched; of that it is in `Trees::touched`.
    pub(super) touched: Vec<Vec<u32>>,
    /// The tree that is grown.
    pub(super) present: u32,
    /// Events at the present time. First in, first out: then the trees share a region of equal
    /// costs.
    pub(super) now: VecDeque<u32>,
    /// Trees that stand.
    pub(super) standing: usize,
    /// Events in the queue at which it is purged.
    pub(super) most_events: usize,
}

pub(super) const TOGETHER: &str = "trees grow together";

impl Forest {
    /// Notes that a top belongs to the present tree.
    pub(super) fn take(&mut self, top: u32) {
        let place = top as usize;
        if place >= self.tree.len() {
            self.tree.resize(place + 1, NONE);
        }
        self.tree[place] = self.present;
    }
}
