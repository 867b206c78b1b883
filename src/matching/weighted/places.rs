//! Places of the nodes in memory: neighbours close together.
//!
//! The parts that threads work on are ranges of places; few edges may join two of them. The numbers
//! that meshes from arrays or scanners give to triangles mostly do as places. Shuffled ones do not.
//! Places depend on the graph alone, so results are the same on any number of threads.

use std::ops::Range;

use super::blossoms::Outcome;
use super::certificate::{Certificate, Integers};
use super::limits::Limits;
use super::patches::Patches;
use super::problem::CubicProblem;
use super::refusal::Refusal;
use crate::parallel::{collect, map};

/// The places of the nodes of a problem. 8 bytes a node, none if all are at their own numbers.
#[derive(Default)]
pub(super) struct Places {
    /// The node at each place; empty if every node is at its own.
    nodes: Vec<u32>,
    /// The place of each node.
    places: Vec<u32>,
}

impl Places {
    /// Leaves the nodes where they are, unless too many have neighbours in other parts. O(n).
    pub(super) fn of(problem: &impl CubicProblem, limits: Limits) -> Self {
        let count = problem.node_count();
        if limits.parts(count) == 1 {
            return Self::default();
        }
        let border = |range: Range<u32>| {
            let is_beyond = |node: &u32| *node < count as u32 && !range.contains(node);
            let is_on_border = |&node: &u32| problem.neighbours(node).iter().any(is_beyond);
            range.clone().filter(is_on_border).count()
        };
        let border: usize = map(limits.ranges(count).collect(), border).into_iter().sum();
        if limits.allow(border, count) {
            return Self::default();
        }
        let nodes = Patches::new(problem, limits.patch).into_parts(limits.parts(count));
        let mut places = vec![0; count];
        (0..).zip(&nodes).for_each(|(place, &node)| places[node as usize] = place);
        Self { nodes, places }
    }

    /// Returns the node at a place.
    #[inline]
    pub(super) fn node_at(&self, place: u32) -> u32 {
        self.nodes.get(place as usize).copied().unwrap_or(place)
    }

    /// Returns the place of a node; a node that does not exist has its own.
    #[inline]
    pub(super) fn place_of(&self, node: u32) -> u32 {
        self.places.get(node as usize).copied().unwrap_or(node)
    }

    /// Returns what was found at the places as that of the nodes.
    pub(super) fn restore(&self, found: Result<Outcome, Refusal>) -> Result<Outcome, Refusal> {
        match found {
            _ if self.nodes.is_empty() => found,
            Ok(outcome) => Ok(self.outcome(outcome)),
            Err(Refusal::Asymmetric(from, to)) => {
                Err(Refusal::Asymmetric(self.node_at(from), self.node_at(to)))
            }
            Err(Refusal::Infeasible(nodes)) => {
                Err(Refusal::Infeasible(nodes.into_iter().map(|node| self.node_at(node)).collect()))
            }
            Err(other) => Err(other),
        }
    }

    fn outcome(&self, outcome: Outcome) -> Outcome {
        let Certificate { potentials, innermost, parents, values } = outcome.certificate;
        let potentials = match potentials {
            Integers::Narrow(values) => Integers::Narrow(self.by_node(&values)),
            Integers::Wide(values) => Integers::Wide(self.by_node(&values)),
            Integers::Widest(values) => Integers::Widest(self.by_node(&values)),
        };
        let innermost = self.by_node(&innermost);
        let mut mates = self.by_node(&outcome.mates);
        mates.iter_mut().for_each(|mate| *mate = self.node_at(*mate));
        let certificate = Certificate { potentials, innermost, parents, values };
        Outcome { mates, certificate, ..outcome }
    }

    /// Returns the values at the places of all nodes.
    fn by_node<T: Copy + Send + Sync>(&self, values: &[T]) -> Vec<T> {
        collect(values.len(), |node| values[self.place_of(node as u32) as usize])
    }
}
