//! Taking blossoms apart: the kids become outermost.

use super::super::nodes::{Label, NONE, Nodes};
use super::super::number::Number;
use super::super::refusal::Refusal;
use super::family::{Family, Kid, Set};

impl<S: Nodes> Family<S> {
    /// Makes the kids of an outermost blossom outermost; they have its label, and the blossom ends.
    ///
    /// Returns the kids and the one that keeps the set, if that is a blossom. Potentials stay.
    /// O(nodes of all kids but the largest).
    pub(crate) fn split(&mut self, top: u32) -> Result<(Vec<Kid>, u32), Refusal> {
        let set = self.blossom(top).set;
        let kids = self.remove_blossom(top);
        let Set { offset, label, .. } = self.sets[set as usize];
        let heir = self.largest(&kids);
        for kid in kids.iter().filter(|kid| kid.top != heir) {
            self.give_set(kid.top, offset, label)?;
        }
        let nodes = self.nodes.len();
        if heir < nodes {
            self.give_set(heir, offset, label)?;
            self.remove_set(set);
            return Ok((kids, NONE));
        }
        self.sets[set as usize].top = heir;
        let blossom = self.blossom_mut(heir);
        blossom.up = NONE;
        blossom.set = set;
        Ok((kids, heir))
    }

    /// Returns the kid with the most nodes, the first of several.
    pub(crate) fn largest(&self, kids: &[Kid]) -> u32 {
        let mut largest = kids[0].top;
        for kid in &kids[1..] {
            if self.size(kid.top) > self.size(largest) {
                largest = kid.top;
            }
        }
        largest
    }

    /// Makes a kid outermost, with a set of its own if it is a blossom.
    fn give_set(&mut self, kid: u32, offset: S::N, label: Label) -> Result<(), Refusal> {
        let set = if kid < self.nodes.len() {
            self.nodes.set_label(kid, label);
            NONE
        } else {
            let set = self.new_set(Set { offset: S::N::ZERO, top: kid, label })?;
            let blossom = self.blossom_mut(kid);
            blossom.up = NONE;
            blossom.set = set;
            set
        };
        self.for_each_node(kid, |family, node| {
            family.nodes.add_potential(node, offset);
            family.nodes.set_set(node, set);
        });
        Ok(())
    }

    /// Calls a function with every node of a top.
    pub(crate) fn for_each_node(&mut self, top: u32, mut f: impl FnMut(&mut Self, u32)) {
        let (mut node, last) = self.ends(top);
        loop {
            f(self, node);
            if node == last {
                return;
            }
            node = self.next(node);
        }
    }

    /// Takes an unlabelled outermost blossom with a mate apart and pairs its kids.
    ///
    /// Returns the kids, all outermost.
    pub(crate) fn dissolve(&mut self, top: u32) -> Result<Vec<Kid>, Refusal> {
        let mate = self.blossom(top).mate;
        let (kids, _) = self.split(top)?;
        let base = self.top(self.nodes.origin(mate));
        self.set_mate(base, mate);
        let start = position(&kids, base);
        self.pair_round(&kids, start + 1, kids.len() - 1);
        Ok(kids)
    }

    /// Pairs an even number of consecutive kids, from a place of the cycle on.
    pub(crate) fn pair_round(&mut self, kids: &[Kid], from: usize, count: usize) {
        for place in (from..from + count).step_by(2) {
            let [first, second] = [kids[place % kids.len()], kids[(place + 1) % kids.len()]];
            self.set_mate(first.top, first.edge);
            let back = self.nodes.twin(first.edge);
            self.set_mate(second.top, back);
        }
    }
}

/// Returns the place of a kid in the cycle.
pub(crate) fn position(kids: &[Kid], top: u32) -> usize {
    kids.iter().position(|kid| kid.top == top).expect("the kid is on the cycle")
}
