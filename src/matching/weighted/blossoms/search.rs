//! One search.

use std::collections::VecDeque;

use super::super::cycles::{is_cycle_inside, leave_cycle};
use super::super::nodes::{Label, NONE, Nodes};
use super::super::number::Number;
use super::super::queue::Queue;
use super::super::refusal::Refusal;
use super::super::work::Work;
use super::family::{Family, rise};
use super::forest::Forest;

/// The tree that is grown, among all nodes and blossoms.
pub(crate) struct Trees<S: Nodes> {
    pub(crate) family: Family<S>,
    pub(super) clock: S::N,
    /// Half-edges by the time at which they may become tight; `codes` + b is the expansion of the
    /// blossom in place b.
    pub(super) queue: Queue<S::N>,
    /// Outer nodes whose edges have not been scanned.
    pub(super) scan: VecDeque<u32>,
    /// Every top of the tree that got a label or was released, in order.
    pub(super) touched: Vec<u32>,
    /// What there is besides if several trees stand.
    pub(super) forest: Option<Forest>,
    scanned: usize,
    pub(crate) work: Work,
}

/// Outcome of a search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Found {
    /// The root is paired.
    Mate,
    /// Nothing yet.
    Nothing,
    /// A node on the border would have to change.
    Border,
}

impl<S: Nodes> Trees<S> {
    pub(crate) fn new(nodes: S, work: Work) -> Self {
        Self::of(Family::new(nodes), work)
    }

    pub(super) fn of(family: Family<S>, work: Work) -> Self {
        Self {
            family,
            clock: S::N::ZERO,
            queue: Queue::new(),
            scan: VecDeque::new(),
            touched: Vec::new(),
            forest: None,
            scanned: 0,
            work,
        }
    }

    /// Grows one tree until its root is paired or `limit` nodes more than the root's are scanned.
    pub(super) fn search(&mut self, root: u32, limit: usize) -> Result<Found, Refusal> {
        self.clock = S::N::ZERO;
        self.queue.clear();
        self.scan.clear();
        self.touched.clear();
        self.scanned = 0;
        if !self.may_change(root) {
            return Ok(Found::Border);
        }
        let top = self.root_top(root)?;
        let limit = limit.saturating_add(self.family.size(top) as usize);
        self.make_outer(top);
        let found = self.grow(limit)?;
        self.end()?;
        self.work.blossom_searches += 1;
        self.work.scans += self.scanned as u64;
        Ok(found)
    }

    fn grow(&mut self, limit: usize) -> Result<Found, Refusal> {
        loop {
            while let Some(&node) = self.scan.front() {
                if self.scanned >= limit {
                    return Ok(Found::Nothing);
                }
                self.scan.pop_front();
                self.scanned += 1;
                if let Some(&soon) = self.scan.get(2) {
                    self.family.nodes.prefetch_around(soon);
                }
                match self.scan_node(node)? {
                    Found::Nothing => {}
                    found => return Ok(found),
                }
            }
            let Some((time, code)) = self.queue.pop() else {
                return Err(Refusal::Infeasible(self.inner_nodes(&self.touched)));
            };
            if time > S::N::LIMIT {
                return Err(Refusal::TooNarrow);
            }
            if time > self.clock {
                self.work.clock_ticks += 1;
            }
            self.clock = time;
            if self.scanned >= limit {
                return Ok(Found::Nothing);
            }
            match self.occur(code)? {
                Found::Nothing => {}
                found => return Ok(found),
            }
        }
    }

    /// Returns the nodes labelled inner. If nothing can happen any more, no blossom is, and all
    /// outer tops are odd components without these nodes: one more than there are of them.
    pub(super) fn inner_nodes(&self, touched: &[u32]) -> Vec<u32> {
        let inner =
            |&&top: &&u32| self.family.is_outermost(top) && self.family.label(top) == Label::Inner;
        touched.iter().filter(inner).copied().collect()
    }

    /// Labels a top outer: its potentials rise from now on.
    pub(super) fn make_outer(&mut self, top: u32) {
        self.family.set_label(top, Label::Outer);
        self.family.raise(top, -self.clock);
        if let Some(place) = self.family.place(top) {
            self.family.blossoms[place].value -= self.clock;
        }
        self.scan_all(top);
        self.touch(top);
    }

    /// Labels a top inner: its potentials fall from now on, until its value is used up.
    fn make_inner(&mut self, top: u32) {
        self.family.set_label(top, Label::Inner);
        self.family.raise(top, self.clock);
        self.touch(top);
        if let Some(place) = self.family.place(top) {
            let blossom = &mut self.family.blossoms[place];
            let expansion = self.clock + blossom.value;
            blossom.value = expansion;
            let set = blossom.set;
            self.family.clear_pending(set);
            self.queue.push(expansion, self.family.nodes.codes() + place as u32);
        }
    }

    /// Notes that a top belongs to the tree.
    pub(super) fn touch(&mut self, top: u32) {
        self.touched.push(top);
        if let Some(forest) = &mut self.forest {
            forest.take(top);
        }
    }

    /// Queues all nodes of a top for scanning.
    pub(super) fn scan_all(&mut self, top: u32) {
        let (mut node, last) = self.family.ends(top);
        loop {
            self.scan.push_back(node);
            if node == last {
                return;
            }
            node = self.family.next(node);
        }
    }

    /// Looks at the edges of an outer node.
    pub(super) fn scan_node(&mut self, node: u32) -> Result<Found, Refusal> {
        let (label, potential) = self.family.standing(node, self.clock);
        debug_assert_eq!(label, Label::Outer);
        if potential > S::N::LIMIT {
            return Err(Refusal::TooNarrow);
        }
        for half_edge in self.family.nodes.sides(node) {
            let twin = self.family.nodes.twin(half_edge);
            if twin == NONE {
                continue;
            }
            match self.look_along(half_edge, twin, potential)? {
                Found::Nothing => {}
                found => return Ok(found),
            }
        }
        if let Some(price) = self.family.nodes.price(node) {
            self.push_last(self.clock + price - potential, self.family.nodes.ground(node));
        }
        Ok(Found::Nothing)
    }

    /// Looks at one edge of an outer node with this potential.
    #[inline]
    fn look_along(&mut self, half_edge: u32, twin: u32, potential: S::N) -> Result<Found, Refusal> {
        let nodes = &self.family.nodes;
        let [u, v] = [nodes.origin(half_edge), nodes.origin(twin)];
        let set = nodes.set(v);
        if set != NONE && set == nodes.set(u) {
            return Ok(Found::Nothing);
        }
        let (label, theirs) = self.family.standing(v, self.clock);
        let slack = nodes.cost(half_edge) - potential - theirs;
        debug_assert!(slack >= S::N::ZERO || label == Label::Inner);
        match label {
            Label::Inner if set != NONE => self.family.pending[set as usize].push(half_edge),
            Label::Inner => {}
            _ if slack == S::N::ZERO && self.has_to_wait(half_edge) => {}
            Label::Outer if slack == S::N::ZERO => return self.join_outer(half_edge),
            Label::Outer => {
                debug_assert!(!slack.is_odd());
                self.queue.push(self.clock + slack.half(), half_edge);
            }
            Label::Free | Label::Half if slack == S::N::ZERO => return Ok(self.advance(half_edge)),
            Label::Free | Label::Half => self.await_tight(half_edge, v, slack),
        }
        Ok(Found::Nothing)
    }

    /// Queues an edge to an unlabelled node.
    pub(super) fn await_tight(&mut self, half_edge: u32, to: u32, slack: S::N) {
        let time = self.clock + slack;
        if self.is_target(to) {
            self.push_last(time, half_edge);
        } else {
            self.queue.push(time, half_edge);
        }
    }

    /// Puts a tight edge behind those of other trees, if there are any.
    pub(super) fn has_to_wait(&mut self, half_edge: u32) -> bool {
        self.forest.as_mut().map(|forest| forest.now.push_back(half_edge)).is_some()
    }

    /// Queues an event that ends the search, if no other tree stands.
    fn push_last(&mut self, time: S::N, code: u32) {
        match self.forest {
            None => self.queue.push_last(time, code),
            Some(_) => self.queue.push(time, code),
        }
    }

    /// Goes along a tight edge between two outer tops: in one tree they become a blossom, those of
    /// two trees become a path.
    fn join_outer(&mut self, half_edge: u32) -> Result<Found, Refusal> {
        match self.other_tree(half_edge) {
            None => self.shrink(half_edge).map(|()| Found::Nothing),
            Some(tree) => {
                self.augment(half_edge);
                let back = self.family.nodes.twin(half_edge);
                self.augment(back);
                self.fell(tree)?;
                Ok(Found::Mate)
            }
        }
    }

    /// Returns whether a tree that reaches this unlabelled node is done.
    fn is_target(&self, node: u32) -> bool {
        let family = &self.family;
        family.nodes.label(node) == Label::Half
            || family.nodes.is_no_mate(family.mate(family.top(node)))
    }

    /// Lets happen what was queued.
    pub(super) fn occur(&mut self, code: u32) -> Result<Found, Refusal> {
        if let Some(place) = code.checked_sub(self.family.nodes.codes()) {
            self.expand_if_due(self.family.nodes.len() + place)?;
            return Ok(Found::Nothing);
        }
        let u = self.family.nodes.origin(code);
        if code == self.family.nodes.ground(u) {
            let (_, potential) = self.family.standing(u, self.clock);
            // If the tree of an earlier label was felled, the event may come too soon.
            if self.family.nodes.price(u) != Some(potential) {
                return Ok(Found::Nothing);
            }
            self.augment(code);
            return Ok(Found::Mate);
        }
        let v = self.family.nodes.head(code);
        let set = self.family.nodes.set(v);
        if set != NONE && set == self.family.nodes.set(u) {
            return Ok(Found::Nothing);
        }
        let (label, _) = self.family.standing(v, self.clock);
        match label {
            Label::Inner if set != NONE => self.family.pending[set as usize].push(code),
            Label::Inner => {}
            Label::Outer => {
                if self.family.slack(code, self.clock) == S::N::ZERO {
                    return self.join_outer(code);
                }
            }
            Label::Free | Label::Half => {
                let slack = self.family.slack(code, self.clock);
                if slack == S::N::ZERO {
                    return Ok(self.advance(code));
                }
                self.queue.push(self.clock + slack, code);
            }
        }
        Ok(Found::Nothing)
    }

    /// Goes along a tight edge from the tree to an unlabelled node.
    fn advance(&mut self, half_edge: u32) -> Found {
        let back = self.family.nodes.twin(half_edge);
        let node = self.family.nodes.origin(back);
        if !self.may_change(node) {
            return Found::Border;
        }
        if self.family.nodes.label(node) == Label::Half {
            leave_cycle(&mut self.family.nodes, node);
            self.family.nodes.set_mate(node, back);
            self.augment(half_edge);
            return Found::Mate;
        }
        let top = self.family.top(node);
        let mate = self.family.mate(top);
        if self.family.nodes.is_no_mate(mate) {
            self.family.set_mate(top, back);
            self.augment(half_edge);
            return Found::Mate;
        }
        if self.family.nodes.is_on_border(self.family.nodes.head(mate)) {
            return Found::Border;
        }
        self.family.set_parent(top, back);
        self.make_inner(top);
        self.make_outer(self.family.top(self.family.nodes.head(mate)));
        Found::Nothing
    }

    /// Returns whether neither the node nor the half-integral cycle that it is on has part in the
    /// border.
    fn may_change(&self, node: u32) -> bool {
        let nodes = &self.family.nodes;
        match nodes.label(node) {
            Label::Half => is_cycle_inside(nodes, node),
            _ => !nodes.is_on_border(node),
        }
    }

    /// Pairs an outer top along a half-edge and re-pairs all tops above it up to the root.
    fn augment(&mut self, half_edge: u32) {
        let mut new = half_edge;
        loop {
            let family = &mut self.family;
            let outer = family.top(family.nodes.origin(new));
            let old = family.mate(outer);
            family.set_mate(outer, new);
            if old == NONE {
                return;
            }
            let inner = family.top(family.nodes.head(old));
            let up = family.parent(inner);
            family.set_mate(inner, up);
            new = family.nodes.twin(up);
        }
    }

    /// Takes all labels off; takes blossoms without value apart.
    fn end(&mut self) -> Result<(), Refusal> {
        for place in 0..self.touched.len() {
            let top = self.touched[place];
            if self.family.is_outermost(top) {
                self.take_label(top)?;
            }
        }
        let touched = std::mem::take(&mut self.touched);
        self.touched = self.dissolve_void(touched)?;
        Ok(())
    }

    /// Takes blossoms without label and value apart; returns the emptied list.
    pub(super) fn dissolve_void(&mut self, mut tops: Vec<u32>) -> Result<Vec<u32>, Refusal> {
        while let Some(top) = tops.pop() {
            let Some(place) = self.family.place(top) else { continue };
            let blossom = &self.family.blossoms[place];
            let is_void = blossom.value == S::N::ZERO && blossom.mate != NONE;
            if is_void && self.family.is_outermost(top) && self.family.label(top).is_none() {
                let kids = self.family.dissolve(top)?;
                tops.extend(kids.iter().map(|kid| kid.top));
            }
        }
        Ok(tops)
    }

    /// Makes potentials and value of a top final.
    pub(super) fn take_label(&mut self, top: u32) -> Result<(), Refusal> {
        let label = self.family.label(top);
        if label.is_none() {
            return Ok(());
        }
        let change = rise(label, self.clock);
        self.family.set_label(top, Label::Free);
        self.family.raise(top, change);
        let size = match self.family.place(top) {
            None => self.family.nodes.potential(top),
            Some(place) => {
                let blossom = &mut self.family.blossoms[place];
                blossom.value += change;
                let (value, set) = (blossom.value, blossom.set);
                self.family.clear_pending(set);
                value
            }
        };
        let within = -S::N::LIMIT <= size && size <= S::N::LIMIT;
        if within { Ok(()) } else { Err(Refusal::TooNarrow) }
    }
}
