//! The end: blossoms are taken apart and written down for the certificate.

use super::super::certificate::{Certificate, Integers};
use super::super::nodes::Nodes;
use super::super::number::Number;
use super::super::problem::NONE as NO_NODE;
use super::super::work::Work;
use super::family::{Blossom, Kid};
use super::search::Trees;
use crate::parallel::collect;

/// A matching of least cost and its proof.
pub(crate) struct Outcome {
    pub(crate) mates: Vec<u32>,
    pub(crate) certificate: Certificate,
    pub(crate) twice_the_cost: i128,
    pub(crate) work: Work,
}

impl<S: Nodes> Trees<S> {
    /// Returns Σ y + Σ z: no matching costs less, in halves. O(n).
    pub(crate) fn bound(&self) -> i128 {
        let nodes = self.family.nodes.range();
        let potentials = nodes.map(|node| self.family.standing(node, S::N::ZERO).1.widen());
        let real = self.family.blossoms.iter().filter(|blossom| !blossom.kids.is_empty());
        let twice = real.map(|blossom| blossom.value.widen() * i128::from(blossom.size - 1));
        potentials.sum::<i128>() - twice.sum::<i128>()
    }

    /// Takes all blossoms apart, from the outside in. O(n).
    pub(crate) fn finish(mut self) -> Outcome {
        let sets = self.odd_sets();
        let nodes = &self.family.nodes;
        let count = nodes.len() as usize;
        let potentials = collect(count, |node| nodes.potential(node as u32));
        let mates = collect(count, |node| {
            let mate = nodes.mate(node as u32);
            if nodes.is_no_mate(mate) { NO_NODE } else { nodes.head(mate) }
        });
        let sum: i128 = potentials.iter().map(|potential| potential.widen()).sum();
        let certificate = Certificate {
            potentials: S::N::integers(potentials.into_iter()),
            innermost: sets.innermost,
            parents: sets.parents,
            values: sets.values,
        };
        let twice_the_cost = sum - sets.surplus;
        Outcome { mates, certificate, twice_the_cost, work: self.work }
    }

    /// Numbers the blossoms that have a value, parents above their kids, and pairs all nodes.
    fn odd_sets(&mut self) -> OddSets {
        let nodes = self.family.nodes.len();
        let tops = (0..self.family.blossoms.len() as u32).map(|place| nodes + place);
        let outermost: Vec<u32> = tops.filter(|&top| self.family.is_outermost(top)).collect();
        let mut places = self.line_up(&outermost);
        let has_value =
            |blossom: &&Blossom<S::N>| !blossom.kids.is_empty() && blossom.value != S::N::ZERO;
        let count = self.family.blossoms.iter().filter(has_value).count();
        let mut parents = vec![NO_NODE; count];
        let mut values = vec![S::N::ZERO; count];
        let mut unused = count;
        let mut surplus = 0;
        let mut stack: Vec<(u32, u32)> = outermost.iter().map(|&top| (top, NO_NODE)).collect();
        while let Some((top, parent)) = stack.pop() {
            let mut number = parent;
            let value = self.family.blossom(top).value;
            surplus += value.widen() * i128::from(self.family.size(top) - 1);
            if value != S::N::ZERO {
                unused -= 1;
                parents[unused] = parent;
                values[unused] = value;
                number = unused as u32;
            }
            for kid in self.pair_kids(top, &places) {
                match self.family.place(kid.top) {
                    // No blossom inside has this node.
                    None => places[kid.top as usize] = number,
                    Some(_) => stack.push((kid.top, number)),
                }
            }
        }
        let values = S::N::integers(values.into_iter());
        OddSets { innermost: places, parents, values, surplus }
    }

    /// Numbers the nodes in blossoms so that those of each blossom follow one another, and makes
    /// their potentials final. Nodes in none have [`NO_NODE`].
    fn line_up(&mut self, outermost: &[u32]) -> Vec<u32> {
        let mut places = collect(self.family.nodes.len() as usize, |_| NO_NODE);
        let mut next = 0;
        for &top in outermost {
            let offset = self.family.sets[self.family.blossom(top).set as usize].offset;
            self.family.for_each_node(top, |family, node| {
                family.nodes.add_potential(node, offset);
                places[node as usize] = next;
                next += 1;
            });
        }
        places
    }

    /// Ends a blossom: the kid with its base has its mate, the others are paired round the cycle.
    fn pair_kids(&mut self, top: u32, places: &[u32]) -> Vec<Kid> {
        let mate = self.family.blossom(top).mate;
        let base = places[self.family.nodes.origin(mate) as usize];
        let kids = self.family.remove_blossom(top);
        let has_base = |kid: &Kid| {
            let (first, last) = self.family.ends(kid.top);
            (places[first as usize]..=places[last as usize]).contains(&base)
        };
        let start = kids.iter().position(has_base).expect("the base is in one of the kids");
        self.family.set_mate(kids[start].top, mate);
        self.family.pair_round(&kids, start + 1, kids.len() - 1);
        kids
    }
}

/// The part of a certificate that describes odd sets.
struct OddSets {
    innermost: Vec<u32>,
    parents: Vec<u32>,
    values: Integers,
    /// Sum of z times the number of nodes but one: that much of the potentials counts twice.
    surplus: i128,
}
