//! Shrinking: a tight edge between two outer tops of the tree closes an odd cycle.

use super::super::nodes::{Label, NONE, Nodes};
use super::super::number::Number;
use super::super::refusal::Refusal;
use super::family::{Kid, Set, rise};
use super::search::Trees;

/// Two steps of the tree towards the root, from an outer top.
struct Ascent {
    /// Half-edge to the inner top.
    mate: u32,
    inner: u32,
    /// Half-edge from the inner top to the outer one.
    parent: u32,
    outer: u32,
}

impl<S: Nodes> Trees<S> {
    /// Makes a blossom of the cycle that a tight half-edge between outer tops closes.
    pub(super) fn shrink(&mut self, half_edge: u32) -> Result<(), Refusal> {
        let nodes = &self.family.nodes;
        let ends = [nodes.origin(half_edge), nodes.head(half_edge)];
        let [x, y] = ends.map(|node| self.family.top(node));
        debug_assert!(x != y);
        let base = self.common_outer(x, y);
        let kids = self.cycle(base, x, half_edge, y);
        let heir = self.family.largest(&kids);
        let set = match self.family.place(heir) {
            Some(place) => self.family.blossoms[place].set,
            None => {
                self.family.new_set(Set { offset: S::N::ZERO, top: NONE, label: Label::Outer })?
            }
        };
        self.make_heir_outer(heir);
        for kid in &kids {
            if kid.top != heir || self.family.place(heir).is_none() {
                self.absorb(kid.top, set);
            }
        }
        let mate = self.family.mate(base);
        let top = self.found_blossom(kids, set, mate, -self.clock);
        self.touch(top);
        Ok(())
    }

    /// Returns the lowest outer top above, or among, two outer ones.
    fn common_outer(&mut self, x: u32, y: u32) -> u32 {
        let mut walkers = [Some(x), Some(y)];
        let common = loop {
            if let Some(top) = walkers[0] {
                if self.family.is_marked(top) {
                    break top;
                }
                self.family.set_marked(top, true);
                walkers[0] = self.ascend(top).map(|ascent| ascent.outer);
            }
            walkers.swap(0, 1);
        };
        for start in [x, y] {
            let mut walker = Some(start);
            while let Some(top) = walker.filter(|&top| self.family.is_marked(top)) {
                self.family.set_marked(top, false);
                walker = self.ascend(top).map(|ascent| ascent.outer);
            }
        }
        common
    }

    /// Returns the way from an outer top to the next one above, `None` at the root.
    fn ascend(&self, outer: u32) -> Option<Ascent> {
        let mate = self.family.mate(outer);
        if mate == NONE {
            return None;
        }
        let inner = self.family.top(self.family.nodes.head(mate));
        let parent = self.family.parent(inner);
        Some(Ascent { mate, inner, parent, outer: self.family.top(self.family.nodes.head(parent)) })
    }

    /// Returns the cycle base … x – y … base.
    fn cycle(&self, base: u32, x: u32, half_edge: u32, y: u32) -> Vec<Kid> {
        let twin = |half_edge| self.family.nodes.twin(half_edge);
        let on_cycle = "the base is above both ends";
        let mut kids = vec![Kid { top: x, edge: half_edge }];
        let mut outer = x;
        while outer != base {
            let ascent = self.ascend(outer).expect(on_cycle);
            kids.push(Kid { top: ascent.inner, edge: twin(ascent.mate) });
            kids.push(Kid { top: ascent.outer, edge: twin(ascent.parent) });
            outer = ascent.outer;
        }
        kids.reverse();
        outer = y;
        while outer != base {
            let ascent = self.ascend(outer).expect(on_cycle);
            kids.push(Kid { top: outer, edge: ascent.mate });
            kids.push(Kid { top: ascent.inner, edge: ascent.parent });
            outer = ascent.outer;
        }
        kids
    }

    /// Makes the set of the largest kid outer, and the kid's value final.
    fn make_heir_outer(&mut self, heir: u32) {
        let Some(place) = self.family.place(heir) else { return };
        let label = self.family.label(heir);
        self.family.blossoms[place].value += rise(label, self.clock);
        if label == Label::Inner {
            let set = self.family.blossoms[place].set;
            self.family.clear_pending(set);
            self.family.set_label(heir, Label::Outer);
            self.family.raise(heir, -self.clock - self.clock);
            self.scan_all(heir);
        }
    }

    /// Moves the nodes of a kid to the outer set of a new blossom; potentials stay.
    fn absorb(&mut self, kid: u32, set: u32) {
        let label = self.family.label(kid);
        if label == Label::Inner {
            self.scan_all(kid);
        }
        let rise = rise(label, self.clock);
        let mut change = rise - self.family.sets[set as usize].offset - self.clock;
        if let Some(place) = self.family.place(kid) {
            let own = self.family.blossoms[place].set;
            change += self.family.sets[own as usize].offset;
            self.family.remove_set(own);
            self.family.blossoms[place].value += rise;
        } else {
            self.family.set_label(kid, Label::Free);
        }
        self.family.for_each_node(kid, |family, node| {
            family.nodes.add_potential(node, change);
            family.nodes.set_set(node, set);
        });
    }
}
