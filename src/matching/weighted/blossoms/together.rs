//! Roots that are left grow together, with one clock.
//!
//! Where many paths must pass the same bottleneck, one tree at a time would search the same region
//! again for each root. Here trees meet half-way. Two trees that meet are felled: their nodes are
//! free for the others.
//!
//! An event stays in the queue when the tree that it came from is felled. So whatever happens is
//! looked at again when its time has come.

use super::super::nodes::{Label, Nodes};
use super::super::number::Number;
use super::super::observer::{Observer, Stage};
use super::super::queue::Queue;
use super::super::refusal::Refusal;
use super::forest::{Forest, TOGETHER};
use super::search::{Found, Trees};

impl<S: Nodes> Trees<S> {
    /// Pairs all roots. Those whose potentials have the same parity grow together, so that slacks
    /// between their trees are even; the others are free nodes meanwhile.
    pub(super) fn grow_together(
        &mut self,
        roots: Vec<u32>,
        observer: &mut Observer,
    ) -> Result<(), Refusal> {
        for is_odd in [false, true] {
            let is_wanted = |trees: &Self, root: u32| {
                trees.is_free(root) && trees.family.standing(root, S::N::ZERO).1.is_odd() == is_odd
            };
            let chosen: Vec<u32> =
                roots.iter().copied().filter(|&root| is_wanted(self, root)).collect();
            self.plant(&chosen)?;
            let grown = self.grow_forest(observer);
            self.forest = None;
            grown?;
        }
        Ok(())
    }

    /// Makes a tree of each root.
    fn plant(&mut self, roots: &[u32]) -> Result<(), Refusal> {
        self.clock = S::N::ZERO;
        self.queue.clear();
        self.scan.clear();
        self.touched.clear();
        let most_events = self.family.nodes.len() as usize;
        self.forest = Some(Forest { most_events, ..Forest::default() });
        for &root in roots {
            let top = self.root_top(root)?;
            // A node that was a root and has been paired may be in the blossom of another root.
            if self.family.label(top).is_none() {
                self.begin_tree();
                self.make_outer(top);
            }
        }
        self.work.blossom_searches += self.standing() as u64;
        self.work.forest_roots += self.standing() as u64;
        Ok(())
    }

    /// Makes a tree without nodes the present one.
    fn begin_tree(&mut self) {
        let Some(forest) = &mut self.forest else { return };
        let tree = forest.touched.len() as u32;
        forest.touched.push(Vec::new());
        forest.standing += 1;
        self.turn_to(tree);
    }

    /// Grows all trees until none stands.
    fn grow_forest(&mut self, observer: &mut Observer) -> Result<(), Refusal> {
        while self.standing() > 0 {
            let found = if let Some(node) = self.scan.pop_front() {
                if !self.turn_to_outer(node) {
                    continue;
                }
                self.work.scans += 1;
                if let Some(&soon) = self.scan.get(2) {
                    self.family.nodes.prefetch_around(soon);
                }
                self.scan_node(node)?
            } else {
                self.next_event()?
            };
            if found == Found::Mate {
                let present = self.forest().present;
                self.fell(present)?;
                if observer.stops(Stage::Blossoms, self.standing()) {
                    return Err(Refusal::Stopped(self.stop()?));
                }
            }
        }
        Ok(())
    }

    /// Lets the next event happen, if it is still one.
    fn next_event(&mut self) -> Result<Found, Refusal> {
        let Some(code) = self.next_code()? else {
            let mut inner = self.inner_nodes(&self.touched);
            for touched in &self.forest().touched {
                inner.extend(self.inner_nodes(touched));
            }
            return Err(Refusal::Infeasible(inner));
        };
        let is_due = match code.checked_sub(self.family.nodes.codes()) {
            Some(place) => self.turn_to_top(self.family.nodes.len() + place),
            None => self.turn_to_outer(self.family.nodes.origin(code)),
        };
        if is_due { self.occur(code) } else { Ok(Found::Nothing) }
    }

    /// Removes the next event. If there is none now, all those of the next time are.
    fn next_code(&mut self) -> Result<Option<u32>, Refusal> {
        let forest = self.forest.as_mut().expect(TOGETHER);
        if forest.now.is_empty() {
            let Some((time, code)) = self.queue.pop() else { return Ok(None) };
            if time > S::N::LIMIT {
                return Err(Refusal::TooNarrow);
            }
            self.work.clock_ticks += u64::from(time > self.clock);
            self.clock = time;
            forest.now.push_back(code);
            while let Some(code) = self.queue.pop_at(time) {
                forest.now.push_back(code);
            }
        }
        Ok(forest.now.pop_front())
    }

    fn forest(&self) -> &Forest {
        self.forest.as_ref().expect(TOGETHER)
    }

    fn standing(&self) -> usize {
        self.forest().standing
    }

    /// Makes a tree the present one.
    fn turn_to(&mut self, tree: u32) {
        let Some(forest) = &mut self.forest else { return };
        std::mem::swap(&mut self.touched, &mut forest.touched[forest.present as usize]);
        std::mem::swap(&mut self.touched, &mut forest.touched[tree as usize]);
        forest.present = tree;
    }

    /// Turns to the tree of a node, if its top is outer; returns whether it is.
    fn turn_to_outer(&mut self, node: u32) -> bool {
        let top = self.family.top(node);
        self.family.label(top) == Label::Outer && self.turn_to_top(top)
    }

    /// Turns to the tree of a top, if it is outermost and in one; returns whether it is.
    fn turn_to_top(&mut self, top: u32) -> bool {
        if !self.family.is_outermost(top) || self.family.label(top).is_none() {
            return false;
        }
        let tree = self.forest().tree[top as usize];
        if tree != self.forest().present {
            self.turn_to(tree);
        }
        true
    }

    /// Returns the tree that an edge between two outer tops leads to, if it is another than that it
    /// comes from.
    pub(super) fn other_tree(&self, half_edge: u32) -> Option<u32> {
        let forest = self.forest.as_ref()?;
        let nodes = &self.family.nodes;
        let [from, to] = [nodes.origin(half_edge), nodes.head(half_edge)]
            .map(|node| forest.tree[self.family.top(node) as usize]);
        (from != to).then_some(to)
    }

    /// Takes a tree's labels off, and queues the edges to its nodes from other trees. One that has
    /// been felled before has nothing left.
    pub(super) fn fell(&mut self, tree: u32) -> Result<(), Refusal> {
        let before = self.forest().present;
        self.turn_to(tree);
        let touched = std::mem::take(&mut self.touched);
        if touched.is_empty() {
            self.turn_to(before);
            return Ok(());
        }
        let mut tops = Vec::new();
        for &top in &touched {
            let is_own = self.family.is_outermost(top)
                && self.forest().tree[top as usize] == tree
                && !self.family.label(top).is_none();
            if is_own {
                self.take_label(top)?;
                tops.push(top);
            }
        }
        for &top in &tops {
            self.await_edges_of(top, Label::Free);
        }
        self.dissolve_void(touched)?;
        if let Some(forest) = &mut self.forest {
            forest.standing -= 1;
        }
        self.turn_to(before);
        self.purge();
        Ok(())
    }

    /// Removes events that felled trees have left behind, when they may be the greater part.
    fn purge(&mut self) {
        if self.queue.len() <= self.forest().most_events {
            return;
        }
        let mut queue = std::mem::replace(&mut self.queue, Queue::new());
        let family = &self.family;
        queue.purge(|_, code| match code.checked_sub(family.nodes.codes()) {
            Some(place) => family.is_outermost(family.nodes.len() + place),
            None => family.label(family.top(family.nodes.origin(code))) == Label::Outer,
        });
        self.queue = queue;
        let most = 2 * self.queue.len();
        if let Some(forest) = &mut self.forest {
            forest.most_events = forest.most_events.max(most);
        }
    }

    /// Fells all trees; returns a bound that the cost of no matching is below, in halves.
    fn stop(&mut self) -> Result<i128, Refusal> {
        for tree in 0..self.forest().touched.len() as u32 {
            self.fell(tree)?;
        }
        Ok(self.bound())
    }
}
