//! One alternating tree without blossoms.

use super::super::cycles::leave_cycle;
use super::super::nodes::{Label, NONE, Nodes};
use super::super::number::Number;
use super::super::queue::Queue;
use super::super::refusal::Refusal;
use super::super::work::Work;
use super::path::{close_cycle, flip, mark_half};

/// The tree that is grown.
pub(super) struct Tree<'a, S: Nodes> {
    pub(super) nodes: &'a mut S,
    clock: S::N,
    /// A node of every odd cycle that was made.
    cycles: &'a mut Vec<u32>,
    /// Half-edges by the time at which they become tight.
    queue: Queue<S::N>,
    /// The root, then by turns an inner node and its mate, an outer one.
    members: Vec<u32>,
    /// Place of the first outer member whose edges have not been scanned.
    scan: usize,
}

/// Outcome of a search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Found {
    /// The root is paired or on an odd cycle.
    Mate,
    /// Nothing yet.
    Nothing,
    /// A node on the border would have to change.
    Border,
}

impl<'a, S: Nodes> Tree<'a, S> {
    pub(super) fn new(nodes: &'a mut S, cycles: &'a mut Vec<u32>) -> Self {
        let (clock, queue) = (S::N::ZERO, Queue::new());
        Self { nodes, clock, cycles, queue, members: Vec::new(), scan: 0 }
    }

    /// Grows a tree from a root until that is paired or `limit` outer nodes are in the tree.
    pub(super) fn grow(
        &mut self,
        root: u32,
        limit: usize,
        work: &mut Work,
    ) -> Result<Found, Refusal> {
        if self.nodes.is_on_border(root) {
            return Ok(Found::Border);
        }
        self.clock = S::N::ZERO;
        self.queue.clear();
        self.members.clear();
        self.scan = 0;
        self.add_outer(root);
        let found = self.search(limit, work);
        work.half_searches += 1;
        work.visits += self.members.len().div_ceil(2) as u64;
        found
    }

    fn search(&mut self, limit: usize, work: &mut Work) -> Result<Found, Refusal> {
        let most = limit.saturating_mul(2) - 1;
        loop {
            while self.scan < self.members.len() {
                if self.members.len() >= most {
                    return self.end(Found::Nothing);
                }
                let node = self.members[self.scan];
                self.scan += 2;
                match self.scan_node(node)? {
                    Found::Nothing => {}
                    found => return Ok(found),
                }
            }
            let Some((time, half_edge)) = self.queue.pop() else {
                let inner = self.members.iter().skip(1).step_by(2);
                return Err(Refusal::Infeasible(inner.copied().collect()));
            };
            if time > S::N::LIMIT {
                return Err(Refusal::TooNarrow);
            }
            work.clock_ticks += u64::from(time > self.clock);
            self.clock = time;
            if self.members.len() >= most {
                return self.end(Found::Nothing);
            }
            match self.occur(half_edge)? {
                Found::Nothing => {}
                found => return Ok(found),
            }
        }
    }

    fn add_outer(&mut self, node: u32) {
        self.nodes.set_label(node, Label::Outer);
        self.nodes.add_potential(node, -self.clock);
        self.nodes.prefetch_around(node);
        self.members.push(node);
    }

    /// Looks at the edges of an outer node.
    #[inline]
    fn scan_node(&mut self, node: u32) -> Result<Found, Refusal> {
        let potential = self.nodes.potential(node) + self.clock;
        let mate = self.nodes.mate(node);
        for half_edge in self.nodes.sides(node) {
            let twin = self.nodes.twin(half_edge);
            if half_edge == mate || twin == NONE {
                continue;
            }
            let other = self.nodes.origin(twin);
            let slack = self.nodes.cost(half_edge) - potential - self.nodes.potential(other);
            let found = match self.nodes.label(other) {
                Label::Inner => Found::Nothing,
                Label::Outer => self.meet_outer(half_edge, slack - self.clock)?,
                label => self.meet_free(half_edge, other, label, slack)?,
            };
            if found != Found::Nothing {
                return Ok(found);
            }
        }
        if let Some(price) = self.nodes.price(node) {
            self.queue.push_last(self.clock + price - potential, self.nodes.ground(node));
        }
        Ok(Found::Nothing)
    }

    /// An edge to an outer node closes an odd cycle when it becomes tight.
    fn meet_outer(&mut self, half_edge: u32, slack: S::N) -> Result<Found, Refusal> {
        debug_assert!(!slack.is_odd() && slack >= S::N::ZERO);
        if slack == S::N::ZERO {
            return self.close(half_edge);
        }
        self.queue.push_last(self.clock + slack.half(), half_edge);
        Ok(Found::Nothing)
    }

    /// An edge to a node in no tree; if that has no mate, the search ends there.
    #[inline]
    fn meet_free(
        &mut self,
        half_edge: u32,
        other: u32,
        label: Label,
        slack: S::N,
    ) -> Result<Found, Refusal> {
        debug_assert!(slack >= S::N::ZERO);
        if slack == S::N::ZERO {
            return self.advance(half_edge);
        }
        let time = self.clock + slack;
        if label == Label::Half || self.nodes.is_no_mate(self.nodes.mate(other)) {
            self.queue.push_last(time, half_edge);
        } else {
            self.queue.push(time, half_edge);
        }
        Ok(Found::Nothing)
    }

    /// Lets happen what was queued.
    fn occur(&mut self, half_edge: u32) -> Result<Found, Refusal> {
        let node = self.nodes.origin(half_edge);
        if half_edge == self.nodes.ground(node) {
            flip(self.nodes, half_edge);
            return self.end(Found::Mate);
        }
        match self.nodes.label(self.nodes.head(half_edge)) {
            Label::Inner => Ok(Found::Nothing),
            Label::Outer => self.close(half_edge),
            Label::Free | Label::Half => self.advance(half_edge),
        }
    }

    /// Goes along a tight edge from the tree to a node in no tree.
    fn advance(&mut self, half_edge: u32) -> Result<Found, Refusal> {
        let back = self.nodes.twin(half_edge);
        let node = self.nodes.origin(back);
        if self.nodes.is_on_border(node) {
            return self.end(Found::Border);
        }
        if self.nodes.label(node) == Label::Half {
            leave_cycle(self.nodes, node);
        } else if !self.nodes.is_no_mate(self.nodes.mate(node)) {
            if self.nodes.is_on_border(self.nodes.head(self.nodes.mate(node))) {
                return self.end(Found::Border);
            }
            self.nodes.set_parent(node, back);
            self.nodes.set_label(node, Label::Inner);
            self.nodes.add_potential(node, self.clock);
            self.members.push(node);
            self.add_outer(self.nodes.head(self.nodes.mate(node)));
            return Ok(Found::Nothing);
        }
        self.nodes.set_mate(node, back);
        flip(self.nodes, half_edge);
        self.end(Found::Mate)
    }

    /// Ends the search with an odd cycle.
    fn close(&mut self, half_edge: u32) -> Result<Found, Refusal> {
        let on_cycle = close_cycle(self.nodes, half_edge);
        let found = self.end(Found::Mate)?;
        mark_half(self.nodes, on_cycle);
        self.cycles.push(on_cycle);
        Ok(found)
    }

    /// Takes all labels off and makes potentials final.
    fn end(&mut self, found: Found) -> Result<Found, Refusal> {
        let mut is_within = true;
        for (place, &node) in self.members.iter().enumerate() {
            let change = if place % 2 == 0 { self.clock } else { -self.clock };
            self.nodes.set_label(node, Label::Free);
            self.nodes.add_potential(node, change);
            let potential = self.nodes.potential(node);
            is_within &= -S::N::LIMIT <= potential && potential <= S::N::LIMIT;
        }
        if is_within { Ok(found) } else { Err(Refusal::TooNarrow) }
    }
}
