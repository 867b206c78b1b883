//! The end: blossoms are taken apart and written down for the certificate.

use super::super::certificate::{Certificate, Integers};
use super::super::nodes::Nodes;
use super::super::number::Number;
use super::super::problem::NONE as NO_NODE;
use super::super::refusal::Refusal;
use super::super::work::Work;
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

    /// Takes all blossoms apart, from the outside in. O(n log n).
    pub(crate) fn finish(mut self) -> Result<Outcome, Refusal> {
        let sets = self.odd_sets()?;
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
        Ok(Outcome { mates, certificate, twice_the_cost, work: self.work })
    }

    /// Numbers the blossoms that have a value, parents above their kids, and pairs all nodes.
    fn odd_sets(&mut self) -> Result<OddSets, Refusal> {
        let has_value = |place: &usize| {
            let blossom = &self.family.blossoms[*place];
            !blossom.kids.is_empty() && blossom.value != S::N::ZERO
        };
        let places = 0..self.family.blossoms.len();
        let count = places.clone().filter(has_value).count();
        let mut innermost = vec![NO_NODE; self.family.nodes.len() as usize];
        let mut parents = vec![NO_NODE; count];
        let mut values = vec![S::N::ZERO; count];
        let tops = places.map(|place| self.family.nodes.len() + place as u32);
        let outermost = tops.filter(|&top| self.family.is_outermost(top));
        let mut stack: Vec<(u32, u32)> = outermost.map(|top| (top, NO_NODE)).collect();
        let mut unused = count;
        let mut surplus = 0;
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
            for kid in self.family.dissolve(top)? {
                match self.family.place(kid.top) {
                    None => innermost[kid.top as usize] = number,
                    Some(_) => stack.push((kid.top, number)),
                }
            }
        }
        let values = S::N::integers(values.into_iter());
        Ok(OddSets { innermost, parents, values, surplus })
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
