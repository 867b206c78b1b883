//! All remaining roots grow together with one clock.
//!
//! Costs that are nearly equal over wide regions leave roots whose partners are far away; one tree
//! at a time would search the same region again and again. Here trees meet half-way. A tree whose
//! root is paired is felled: its nodes are free for the others.

use std::collections::VecDeque;

use super::super::cycles::leave_cycle;
use super::super::nodes::{Label, NONE, Nodes};
use super::super::number::Number;
use super::super::observer::{Observer, Stage};
use super::super::queue::Queue;
use super::super::refusal::Refusal;
use super::super::work::Work;
use super::path::{close_cycle, flip, mark_half};

/// All trees. 8 bytes a node, and 8 an event with 32-bit numbers.
struct Forest<'a, S: Nodes> {
    nodes: &'a mut S,
    /// A node of every odd cycle that was made.
    cycles: &'a mut Vec<u32>,
    clock: S::N,
    /// Half-edges by the time at which they become tight.
    queue: Queue<S::N>,
    /// Tight half-edges. First in, first out: then the trees share a region of equal costs.
    now: VecDeque<u32>,
    /// Outer nodes whose edges have not been scanned.
    scan: VecDeque<u32>,
    /// For each labelled node its root.
    root: Vec<u32>,
    /// Members of a tree as a ring through its root.
    next: Vec<u32>,
    standing: usize,
    /// Events in the queue at which it is purged.
    most_events: usize,
    visits: u64,
}

/// Grows trees from all roots until every root is paired or on an odd cycle.
pub(super) fn grow<S: Nodes>(
    nodes: &mut S,
    roots: &[u32],
    cycles: &mut Vec<u32>,
    work: &mut Work,
    observer: &mut Observer,
) -> Result<(), Refusal> {
    let count = nodes.len() as usize;
    let mut forest = Forest {
        nodes,
        cycles,
        clock: S::N::ZERO,
        queue: Queue::new(),
        now: VecDeque::new(),
        scan: VecDeque::new(),
        root: vec![NONE; count],
        next: vec![NONE; count],
        standing: roots.len(),
        most_events: count,
        visits: 0,
    };
    work.forest_roots = roots.len() as u64;
    forest.plant(roots);
    forest.run(roots, work, observer)?;
    work.visits += forest.visits;
    Ok(())
}

impl<S: Nodes> Forest<'_, S> {
    /// Labels all roots. Their potentials are made even, so that slacks between trees are.
    fn plant(&mut self, roots: &[u32]) {
        for &root in roots {
            let potential = self.nodes.potential(root);
            self.nodes.add_potential(root, potential.half() + potential.half() - potential);
            self.next[root as usize] = root;
            self.add_outer(root, root);
        }
    }

    fn run(
        &mut self,
        roots: &[u32],
        work: &mut Work,
        observer: &mut Observer,
    ) -> Result<(), Refusal> {
        while self.standing > 0 {
            if let Some(node) = self.scan.pop_front() {
                if self.nodes.label(node) == Label::Outer {
                    self.scan_node(node);
                }
            } else if let Some(half_edge) = self.now.pop_front() {
                let is_due = self.due_time(half_edge) == Some(self.clock);
                let is_paired = is_due && self.occur(half_edge)?;
                if is_paired && observer.stops(Stage::HalfIntegral, self.standing) {
                    return Err(Refusal::Stopped(self.stop(roots)?));
                }
            } else if let Some((time, half_edge)) = self.queue.pop() {
                if time > S::N::LIMIT {
                    return Err(Refusal::TooNarrow);
                }
                work.clock_ticks += u64::from(time > self.clock);
                self.clock = time;
                self.now.push_back(half_edge);
            } else {
                return Err(Refusal::Infeasible(self.inner_nodes()));
            }
        }
        Ok(())
    }

    /// Fells all trees; returns Σ y: no matching costs less, in halves.
    fn stop(&mut self, roots: &[u32]) -> Result<i128, Refusal> {
        for &root in roots {
            if self.nodes.label(root) == Label::Outer && self.root[root as usize] == root {
                self.fell(root)?;
            }
        }
        Ok(self.nodes.potential_sum())
    }

    /// Returns the inner nodes. If nothing can happen any more, the outer ones are alone without.
    fn inner_nodes(&self) -> Vec<u32> {
        (0..self.nodes.len()).filter(|&node| self.nodes.label(node) == Label::Inner).collect()
    }

    fn add_outer(&mut self, node: u32, root: u32) {
        self.nodes.set_label(node, Label::Outer);
        self.nodes.add_potential(node, -self.clock);
        self.nodes.prefetch_around(node);
        self.root[node as usize] = root;
        self.scan.push_back(node);
        self.visits += 1;
    }

    /// Returns the potential at the present time.
    #[inline]
    fn potential(&self, node: u32) -> S::N {
        let stored = self.nodes.potential(node);
        match self.nodes.label(node) {
            Label::Outer => stored + self.clock,
            Label::Inner => stored - self.clock,
            Label::Free | Label::Half => stored,
        }
    }

    /// Returns when a half-edge becomes tight: never, as things are, if its origin is not outer or
    /// its head is inner.
    #[inline]
    fn due_time(&self, half_edge: u32) -> Option<S::N> {
        let node = self.nodes.origin(half_edge);
        if self.nodes.label(node) != Label::Outer {
            return None;
        }
        let potential = self.nodes.potential(node) + self.clock;
        if half_edge == self.nodes.ground(node) {
            return self.nodes.price(node).map(|price| self.clock + price - potential);
        }
        let other = self.nodes.head(half_edge);
        let slack = self.nodes.cost(half_edge) - potential - self.potential(other);
        match self.nodes.label(other) {
            Label::Inner => None,
            Label::Outer => Some(self.clock + slack.half()),
            Label::Free | Label::Half => Some(self.clock + slack),
        }
    }

    /// Queues a half-edge for the time at which it becomes tight.
    #[inline]
    fn await_tight(&mut self, half_edge: u32) {
        let Some(time) = self.due_time(half_edge) else { return };
        debug_assert!(time >= self.clock);
        if time == self.clock {
            self.now.push_back(half_edge);
        } else {
            self.queue.push(time, half_edge);
        }
    }

    /// Queues the edges of an outer node.
    fn scan_node(&mut self, node: u32) {
        let mate = self.nodes.mate(node);
        for half_edge in self.nodes.sides(node) {
            if half_edge != mate && self.nodes.twin(half_edge) != NONE {
                self.await_tight(half_edge);
            }
        }
        self.await_tight(self.nodes.ground(node));
    }

    /// Removes events that felled trees have left behind, when they may be the greater part.
    fn purge(&mut self) {
        if self.queue.len() <= self.most_events {
            return;
        }
        let mut queue = std::mem::replace(&mut self.queue, Queue::new());
        queue.purge(|time, half_edge| self.due_time(half_edge) == Some(time));
        self.queue = queue;
        self.most_events = self.most_events.max(2 * self.queue.len());
    }

    /// Goes along a tight edge; returns whether a root was paired.
    fn occur(&mut self, half_edge: u32) -> Result<bool, Refusal> {
        let root = self.root[self.nodes.origin(half_edge) as usize];
        if half_edge == self.nodes.ground(self.nodes.origin(half_edge)) {
            flip(self.nodes, half_edge);
            self.fell(root)?;
            return Ok(true);
        }
        match self.nodes.label(self.nodes.head(half_edge)) {
            Label::Outer => self.meet(half_edge, root).map(|()| true),
            _ => self.advance(half_edge, root),
        }
    }

    /// Pairs the roots of two trees, or makes an odd cycle in one.
    fn meet(&mut self, half_edge: u32, root: u32) -> Result<(), Refusal> {
        let back = self.nodes.twin(half_edge);
        let other_root = self.root[self.nodes.origin(back) as usize];
        if root == other_root {
            let on_cycle = close_cycle(self.nodes, half_edge);
            self.fell(root)?;
            mark_half(self.nodes, on_cycle);
            self.cycles.push(on_cycle);
            return Ok(());
        }
        flip(self.nodes, half_edge);
        flip(self.nodes, back);
        self.fell(root)?;
        self.fell(other_root)
    }

    /// Goes on to a node in no tree; returns whether the root was paired.
    fn advance(&mut self, half_edge: u32, root: u32) -> Result<bool, Refusal> {
        let back = self.nodes.twin(half_edge);
        let node = self.nodes.origin(back);
        if self.nodes.label(node) == Label::Half {
            leave_cycle(self.nodes, node);
        } else if !self.nodes.is_no_mate(self.nodes.mate(node)) {
            self.nodes.set_parent(node, back);
            self.nodes.set_label(node, Label::Inner);
            self.nodes.add_potential(node, self.clock);
            let outer = self.nodes.head(self.nodes.mate(node));
            let [at_root, inner, at_outer] = [root, node, outer].map(|node| node as usize);
            self.next[inner] = outer;
            self.next[at_outer] = self.next[at_root];
            self.next[at_root] = node;
            self.root[inner] = root;
            self.add_outer(outer, root);
            return Ok(false);
        }
        self.nodes.set_mate(node, back);
        flip(self.nodes, half_edge);
        self.fell(root)?;
        Ok(true)
    }

    /// Takes a tree's labels off and queues the edges to its nodes from other trees.
    fn fell(&mut self, root: u32) -> Result<(), Refusal> {
        self.standing -= 1;
        let mut is_within = true;
        self.for_each_member(root, |forest, node| {
            let potential = forest.potential(node);
            is_within &= -S::N::LIMIT <= potential && potential <= S::N::LIMIT;
            forest.nodes.add_potential(node, potential - forest.nodes.potential(node));
            forest.nodes.set_label(node, Label::Free);
        });
        self.for_each_member(root, Self::await_released);
        self.purge();
        if is_within { Ok(()) } else { Err(Refusal::TooNarrow) }
    }

    fn for_each_member(&mut self, root: u32, mut f: impl FnMut(&mut Self, u32)) {
        let mut node = root;
        loop {
            f(self, node);
            node = self.next[node as usize];
            if node == root {
                return;
            }
        }
    }

    /// Queues the edges from outer nodes to a free one.
    fn await_released(&mut self, node: u32) {
        for half_edge in self.nodes.sides(node) {
            let twin = self.nodes.twin(half_edge);
            if twin != NONE {
                self.await_tight(twin);
            }
        }
    }
}
