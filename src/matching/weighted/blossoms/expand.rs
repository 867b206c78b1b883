//! Expanding: an inner blossom whose value is used up makes way for its kids.

use super::super::nodes::{Label, NONE, Nodes};
use super::super::number::Number;
use super::super::refusal::Refusal;
use super::family::Kid;
use super::search::Trees;
use super::split::position;

impl<S: Nodes> Trees<S> {
    /// Expands a blossom, if it exists, is inner and outermost, and has no value left.
    pub(super) fn expand_if_due(&mut self, top: u32) -> Result<(), Refusal> {
        let family = &self.family;
        let is_due = family.is_outermost(top)
            && family.label(top) == Label::Inner
            && family.blossom(top).value == self.clock;
        if is_due { self.expand(top) } else { Ok(()) }
    }

    /// Replaces an inner blossom by the kids on the even way from its parent's edge to its mate.
    ///
    /// The other kids leave the tree in pairs.
    fn expand(&mut self, top: u32) -> Result<(), Refusal> {
        let (parent, mate) = (self.family.blossom(top).parent, self.family.blossom(top).mate);
        let (kids, heir) = self.family.split(top)?;
        let [first, last] = [parent, mate]
            .map(|half_edge| position(&kids, self.family.top(self.family.nodes.origin(half_edge))));
        let way = Way::new(&kids, first, last);
        let mut back = parent;
        for step in 0..=way.steps {
            let kid = kids[way.place(step)].top;
            let ahead = match way.edge(&kids, step) {
                None => mate,
                Some(Edge::Along(edge)) => edge,
                Some(Edge::Against(edge)) => self.family.nodes.twin(edge),
            };
            self.family.set_mate(kid, if step % 2 == 0 { ahead } else { back });
            if step % 2 == 0 {
                self.family.set_parent(kid, back);
                self.keep_inner(kid);
            } else {
                self.turn_outer(kid);
            }
            if step < way.steps {
                back = self.family.nodes.twin(ahead);
            }
        }
        let (from, count) = way.rest();
        self.family.pair_round(&kids, from, count);
        for place in from..from + count {
            self.release(kids[place % kids.len()].top);
        }
        self.await_edges(&kids, heir);
        Ok(())
    }

    /// Keeps a kid of an expanded blossom inner; its own value falls from now on.
    fn keep_inner(&mut self, kid: u32) {
        self.touch(kid);
        if let Some(place) = self.family.place(kid) {
            let blossom = &mut self.family.blossoms[place];
            blossom.value += self.clock;
            self.queue.push(blossom.value, self.family.nodes.codes() + place as u32);
        }
    }

    /// Labels a kid of an expanded inner blossom outer.
    fn turn_outer(&mut self, kid: u32) {
        self.family.raise(kid, -self.clock);
        if let Some(place) = self.family.place(kid) {
            let set = self.family.blossoms[place].set;
            self.family.clear_pending(set);
        }
        self.make_outer(kid);
    }

    /// Takes the label off a kid of an expanded inner blossom.
    fn release(&mut self, kid: u32) {
        self.family.set_label(kid, Label::Free);
        self.family.raise(kid, -self.clock);
        self.touch(kid);
    }

    /// Queues the edges from outer nodes to the kids that are not outer.
    ///
    /// For the kid that kept the blossom's set they are in the set's list; for the others, all
    /// their edges are scanned.
    fn await_edges(&mut self, kids: &[Kid], heir: u32) {
        for kid in kids {
            let label = self.family.label(kid.top);
            if label == Label::Outer {
                continue;
            }
            if kid.top != heir {
                self.await_edges_of(kid.top, label);
            } else if label == Label::Free {
                self.await_pending(self.family.blossom(heir).set);
            }
        }
    }

    /// Queues the edges from outer nodes to those of a top with this label.
    pub(super) fn await_edges_of(&mut self, kid: u32, label: Label) {
        let (mut node, last) = self.family.ends(kid);
        loop {
            for half_edge in self.family.nodes.sides(node) {
                let twin = self.family.nodes.twin(half_edge);
                if twin != NONE {
                    self.await_edge(twin, node, label);
                }
            }
            if node == last {
                return;
            }
            node = self.family.next(node);
        }
    }

    /// Queues an edge to a node of a kid that is inner or free, if it comes from an outer node.
    fn await_edge(&mut self, half_edge: u32, node: u32, label: Label) {
        let family = &mut self.family;
        let (other, _) = family.standing(family.nodes.origin(half_edge), self.clock);
        if other != Label::Outer {
            return;
        }
        if label == Label::Free {
            let slack = family.slack(half_edge, self.clock);
            if slack != S::N::ZERO || !self.has_to_wait(half_edge) {
                self.queue.push(self.clock + slack, half_edge);
            }
        } else if let Some(pending) = family.pending.get_mut(family.nodes.set(node) as usize) {
            pending.push(half_edge);
        }
    }

    /// Queues the edges that met a set while it was inner and still lead to it.
    fn await_pending(&mut self, set: u32) {
        for half_edge in std::mem::take(&mut self.family.pending[set as usize]) {
            if self.family.nodes.set(self.family.nodes.head(half_edge)) == set {
                let slack = self.family.slack(half_edge, self.clock);
                self.queue.push(self.clock + slack, half_edge);
            }
        }
    }
}

/// A half-edge of a cycle and whether the way follows it or its twin.
enum Edge {
    Along(u32),
    Against(u32),
}

/// The even way round a cycle from one kid to another.
struct Way {
    first: usize,
    steps: usize,
    is_forward: bool,
    count: usize,
}

impl Way {
    fn new(kids: &[Kid], first: usize, last: usize) -> Self {
        let count = kids.len();
        let ahead = (last + count - first) % count;
        let is_forward = ahead.is_multiple_of(2);
        Self { first, steps: if is_forward { ahead } else { count - ahead }, is_forward, count }
    }

    /// Returns the place of a kid on the way.
    fn place(&self, step: usize) -> usize {
        let ahead = if self.is_forward { step } else { self.count - step };
        (self.first + ahead) % self.count
    }

    /// Returns the edge to the next kid on the way, `None` from the last.
    fn edge(&self, kids: &[Kid], step: usize) -> Option<Edge> {
        if step == self.steps {
            None
        } else if self.is_forward {
            Some(Edge::Along(kids[self.place(step)].edge))
        } else {
            Some(Edge::Against(kids[self.place(step + 1)].edge))
        }
    }

    /// Returns the first place and the number of the kids that are not on the way.
    fn rest(&self) -> (usize, usize) {
        let from = if self.is_forward { self.place(self.steps) } else { self.first };
        (from + 1, self.count - self.steps - 1)
    }
}
