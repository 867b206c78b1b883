//! The check accepts what the definition accepts, and refuses whatever has been tampered with.

use proptest::prelude::*;

use super::super::certificate::{Certificate, Integers};
use super::super::limits::Limits;
use super::super::problem::{NONE, Problem};
use super::super::verify::verify;
use super::cubic::solve;
use super::graphs::{Rows, any_graph, cubic_graph};

/// A matching and a certificate, laid open.
#[derive(Clone, Debug, PartialEq)]
struct Answer {
    mates: Vec<u32>,
    potentials: Vec<i128>,
    innermost: Vec<u32>,
    parents: Vec<u32>,
    values: Vec<i128>,
}

impl Answer {
    fn of(graph: &Rows) -> Option<Self> {
        let solution = solve(graph, Limits::DEFAULT).ok()?;
        let open = |numbers: &Integers| (0..numbers.len()).map(|i| numbers.at(i)).collect();
        Some(Self {
            mates: solution.mates,
            potentials: open(&solution.certificate.potentials),
            innermost: solution.certificate.innermost,
            parents: solution.certificate.parents,
            values: open(&solution.certificate.values),
        })
    }

    fn is_verified(&self, graph: &Rows) -> bool {
        let certificate = Certificate {
            potentials: Integers::Widest(self.potentials.clone()),
            innermost: self.innermost.clone(),
            parents: self.parents.clone(),
            values: Integers::Widest(self.values.clone()),
        };
        verify(graph, &self.mates, &certificate).is_ok()
    }

    /// The definition, with every set written out. `None` if something is not even well-formed.
    fn is_optimal(&self, graph: &Rows) -> Option<bool> {
        let sets = self.sets()?;
        let cost = self.cost(graph)?;
        let inside = |node: usize| sets.iter().zip(&self.values).filter(move |(s, _)| s[node]);
        let y = |node: usize| -> i128 {
            self.potentials[node] - inside(node).map(|(_, z)| z).sum::<i128>()
        };
        let feasible = graph.edges().all(|edge| {
            let [u, v] = edge.ends.map(|end| end as usize);
            let cut = sets.iter().zip(&self.values).filter(|(set, _)| set[u] != set[v]);
            y(u) + y(v) + cut.map(|(_, z)| z).sum::<i128>() <= 2 * edge.cost
        });
        let nodes = 0..self.mates.len();
        let affordable = nodes.clone().all(|node| {
            graph.price(node as u32).is_none_or(|price| self.potentials[node] <= 2 * price)
        });
        let odd = sets.iter().all(|set| set.iter().filter(|&&inside| inside).count() % 2 == 1);
        let bound = nodes.map(y).sum::<i128>() + self.values.iter().sum::<i128>();
        let positive = self.values.iter().all(|&z| z >= 0);
        Some(feasible && affordable && odd && positive && 2 * cost == bound)
    }

    /// Returns for every odd set whether it holds each node.
    fn sets(&self) -> Option<Vec<Vec<bool>>> {
        let count = self.parents.len();
        let mut sets = vec![vec![false; self.mates.len()]; count];
        for (node, &innermost) in self.innermost.iter().enumerate() {
            let mut set = innermost;
            while set != NONE {
                sets.get_mut(set as usize)?[node] = true;
                let parent = self.parents[set as usize];
                if parent <= set {
                    return None;
                }
                set = parent;
            }
        }
        let ordered = |(set, &parent): (usize, &u32)| {
            parent == NONE || (parent as usize > set && (parent as usize) < count)
        };
        self.parents.iter().enumerate().all(ordered).then_some(sets)
    }

    /// Returns the cost of the matching if it is one.
    fn cost(&self, graph: &Rows) -> Option<i128> {
        let mut cost = 0;
        for (node, &mate) in (0_u32..).zip(&self.mates) {
            if mate == NONE {
                cost += graph.price(node)?;
            } else if *self.mates.get(mate as usize)? != node || mate == node {
                return None;
            } else if node < mate {
                let edges = graph.edges().filter(|edge| edge.ends == [node, mate]);
                cost += edges.map(|edge| edge.cost).min()?;
            }
        }
        Some(cost)
    }
}

/// One change to an answer; positions are taken modulo the lengths.
#[derive(Clone, Copy, Debug)]
enum Tampering {
    /// Exchanges the partners of two pairs.
    Cross(usize, usize),
    /// Gives a node another mate, or none.
    Mate(usize, u32),
    /// Parts a pair.
    Part(usize),
    Potential(usize, i128),
    /// Raises one potential and lowers another.
    Shift(usize, usize, i128),
    Value(usize, i128),
    Parent(usize, u32),
    Innermost(usize, u32),
}

fn tampering() -> impl Strategy<Value = Tampering> {
    let change = || prop_oneof![-2..3_i128, Just(1 << 40), Just(i128::MAX), Just(i128::MIN)];
    let number = || prop_oneof![9 => 0..40_u32, 1 => Just(NONE)];
    prop_oneof![
        (any::<usize>(), any::<usize>()).prop_map(|(a, b)| Tampering::Cross(a, b)),
        (any::<usize>(), number()).prop_map(|(node, mate)| Tampering::Mate(node, mate)),
        any::<usize>().prop_map(Tampering::Part),
        (any::<usize>(), change()).prop_map(|(node, by)| Tampering::Potential(node, by)),
        (any::<usize>(), any::<usize>(), -2..3_i128)
            .prop_map(|(a, b, by)| Tampering::Shift(a, b, by)),
        (any::<usize>(), change()).prop_map(|(set, by)| Tampering::Value(set, by)),
        (any::<usize>(), number()).prop_map(|(set, parent)| Tampering::Parent(set, parent)),
        (any::<usize>(), number()).prop_map(|(node, set)| Tampering::Innermost(node, set)),
    ]
}

impl Tampering {
    fn apply(self, answer: &mut Answer) {
        let (nodes, sets) = (answer.mates.len(), answer.parents.len().max(1));
        match self {
            Self::Cross(a, b) => cross(&mut answer.mates, a % nodes, b % nodes),
            Self::Mate(node, mate) => answer.mates[node % nodes] = mate,
            Self::Part(node) => {
                let mate = std::mem::replace(&mut answer.mates[node % nodes], NONE);
                answer.mates.get_mut(mate as usize).into_iter().for_each(|mate| *mate = NONE);
            }
            Self::Potential(node, by) => {
                let potential = &mut answer.potentials[node % nodes];
                *potential = potential.saturating_add(by);
            }
            Self::Shift(a, b, by) => {
                answer.potentials[a % nodes] += by;
                answer.potentials[b % nodes] -= by;
            }
            Self::Value(set, by) => {
                let value = answer.values.get_mut(set % sets).into_iter();
                value.for_each(|value| *value = value.saturating_add(by));
            }
            Self::Parent(set, parent) => {
                answer.parents.get_mut(set % sets).into_iter().for_each(|slot| *slot = parent);
            }
            Self::Innermost(node, set) => answer.innermost[node % nodes] = set,
        }
    }
}

fn cross(mates: &mut [u32], a: usize, b: usize) {
    let [c, d] = [mates[a], mates[b]];
    if a != b && c != NONE && d != NONE && c as usize != b {
        (mates[a], mates[b]) = (b as u32, a as u32);
        (mates[c as usize], mates[d as usize]) = (d, c);
    }
}

/// Compares the check with the definition; numbers near the ends of 128 bits are beyond the latter.
fn compare(graph: &Rows, change: Tampering) -> Result<bool, TestCaseError> {
    let Some(original) = Answer::of(graph).filter(|_| graph.node_count() > 0) else {
        return Ok(false);
    };
    prop_assert!(original.is_verified(graph));
    prop_assert_eq!(original.is_optimal(graph), Some(true));
    let mut answer = original.clone();
    change.apply(&mut answer);
    let mut numbers = answer.potentials.iter().chain(&answer.values);
    let is_huge = numbers.any(|number| number.unsigned_abs() > 1 << 110);
    let expected = !is_huge && answer.is_optimal(graph) == Some(true);
    prop_assert_eq!(answer.is_verified(graph), expected, "{:?}", change);
    if expected && answer != original {
        let same_proof = answer.innermost == original.innermost
            && answer.parents == original.parents
            && answer.values == original.values;
        let is_other_matching = matches!(change, Tampering::Cross(..) | Tampering::Part(_));
        let is_other_optimum = same_proof && is_other_matching;
        let is_other_proof = matches!(change, Tampering::Shift(..));
        prop_assert!(is_other_optimum || is_other_proof, "{change:?} should have been noticed");
    }
    Ok(answer != original && !expected)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn the_check_is_the_definition(graph in any_graph(1..30), change in tampering()) {
        compare(&graph, change)?;
    }

    #[test]
    fn the_check_is_the_definition_on_cubic_graphs(
        graph in cubic_graph(2..15), change in tampering(),
    ) {
        compare(&graph, change)?;
    }
}
