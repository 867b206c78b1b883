//! The check of a matching and its certificate, from the definition of the linear program alone.
//!
//! Minimise Σ c(e)·x(e) over x ≥ 0 with x(δ(v)) = 1 for every node v and x(δ(B)) ≥ 1 for every odd
//! set B of nodes. A node with a price has one more edge, of that cost, to the *ground*, which
//! takes any number of edges and lies outside all sets. The dual program is: maximise Σ y(v) + Σ
//! z(B) with z ≥ 0 and, for every edge e = {u, v}, y(u) + y(v) + Σ {z(B) : e ∈ δ(B)} ≤ c(e). A
//! matching and a dual solution of equal value are both optimal, and nothing else has to be looked
//! at.
//!
//! In potentials (see [`Certificate`]) the constraint of an edge reads π(u) + π(v) − 2 Z ≤ c(e)
//! with Z the sum of z over all sets that hold both ends.

mod nesting;

use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

use super::certificate::Certificate;
use super::problem::{Edge, Mates, NONE, Problem};
use crate::parallel::{collect, map, ranges};
use nesting::Nesting;

/// A reason why a matching and a certificate prove nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CertificateError {
    /// Matching, certificate and graph are not of the same size.
    #[error("graph, matching and certificate differ in the number of nodes")]
    Size,
    /// The lists of odd sets differ in length.
    #[error("there are not as many values as odd sets")]
    SetCount,
    /// The sum of two numbers does not fit 128 bits.
    #[error("numbers too large to add")]
    Overflow,
    /// A node is paired with itself, with none that exists, or not mutually.
    #[error("node {0} and its mate are no pair")]
    NoPair(u32),
    /// An unpaired node has no price.
    #[error("node {0} is unpaired and has no price")]
    MustBePaired(u32),
    /// A node's innermost odd set does not exist.
    #[error("node {0} is in an odd set that does not exist")]
    NoSuchSet(u32),
    /// The number of an odd set's parent is not greater than its own, or too great.
    #[error("odd set {0} has an impossible parent")]
    Parent(u32),
    /// An odd set holds an even number of nodes.
    #[error("odd set {0} holds an even number of nodes")]
    Even(u32),
    /// An odd set has a negative value.
    #[error("odd set {0} has a negative value")]
    Negative(u32),
    /// The potentials of the ends of an edge exceed its cost.
    #[error("the potentials of nodes {0} and {1} exceed the cost of their edge")]
    Edge(u32, u32),
    /// The potential of a node exceeds its price.
    #[error("the potential of node {0} exceeds its price")]
    Price(u32),
    /// No edge joins a pair, or each costs more than the potentials account for.
    #[error("nodes {0} and {1} are paired at a cost that their potentials do not justify")]
    Loose(u32, u32),
    /// The matching costs more than the certificate proves to be necessary.
    #[error("the matching's cost differs from the certificate's bound")]
    Gap,
}

use CertificateError as E;

/// Checks that `matching` is of least cost among all matchings of `problem` that leave only priced
/// nodes unpaired, and that `certificate` proves it.
///
/// O(nodes + edges) time, two bytes a node and 36 an odd set. Shares no code with the solver and
/// trusts nothing of what it is given.
///
/// # Errors
/// Names the first defect found; matching and certificate are then worth nothing together.
pub fn verify(
    problem: &impl Problem,
    matching: &(impl Mates + ?Sized),
    certificate: &Certificate,
) -> Result<(), CertificateError> {
    let nodes = problem.node_count();
    if [matching.node_count(), certificate.potentials.len(), certificate.innermost.len()]
        != [nodes; 3]
    {
        return Err(E::Size);
    }
    let sets = OddSets::check(certificate)?;
    let unpaired = unpaired_cost(problem, matching, certificate)?;
    let paired = paired_cost(problem, matching, certificate, &sets)?;
    let cost = unpaired.checked_add(paired).ok_or(E::Overflow)?;
    let bound = sets.bound(certificate)?;
    if cost == bound { Ok(()) } else { Err(E::Gap) }
}

/// The odd sets of a certificate, found to be in order.
struct OddSets {
    nesting: Nesting,
    /// Sum of z over each set and all that hold it; 0 for the root.
    inside: Vec<i128>,
}

impl OddSets {
    fn check(certificate: &Certificate) -> Result<Self, CertificateError> {
        let count = certificate.parents.len();
        if certificate.values.len() != count {
            return Err(E::SetCount);
        }
        for (set, &parent) in (0..).zip(&certificate.parents) {
            if parent != NONE && (parent <= set || parent as usize >= count) {
                return Err(E::Parent(set));
            }
            if certificate.values.at(set as usize) < 0 {
                return Err(E::Negative(set));
            }
        }
        check_odd(certificate)?;
        let mut inside = vec![0_i128; count + 1];
        for (set, &parent) in certificate.parents.iter().enumerate().rev() {
            let outside = if parent == NONE { 0 } else { inside[parent as usize] };
            inside[set] = certificate.values.at(set).checked_add(outside).ok_or(E::Overflow)?;
        }
        Ok(Self { nesting: Nesting::new(&certificate.parents), inside })
    }

    /// Returns 2c − π(u) − π(v) + 2Z of an edge, or nothing if that is too large.
    fn slack(&self, certificate: &Certificate, edge: Edge) -> Option<i128> {
        let [a, b] = edge.ends.map(|end| certificate.innermost[end as usize]);
        let inside = if a == NONE || b == NONE {
            0
        } else if a == b {
            self.inside[a as usize]
        } else {
            self.inside[self.nesting.smallest_common(a, b) as usize]
        };
        let [u, v] = edge.ends.map(|end| certificate.potentials.at(end as usize));
        let room = edge.cost.checked_add(inside)?.checked_mul(2)?;
        room.checked_sub(u)?.checked_sub(v)
    }

    /// Returns Σ y + Σ z.
    fn bound(&self, certificate: &Certificate) -> Result<i128, CertificateError> {
        let mut values = (0..certificate.values.len()).map(|set| certificate.values.at(set));
        let sets = values.try_fold(0_i128, i128::checked_add).ok_or(E::Overflow)?;
        let potentials_in = |range: Range<usize>| {
            range.into_iter().try_fold(0_i128, |sum, node| {
                let set = certificate.innermost[node];
                let inside = if set == NONE { 0 } else { self.inside[set as usize] };
                let potential = certificate.potentials.at(node).checked_sub(inside);
                potential.and_then(|y| sum.checked_add(y)).ok_or(E::Overflow)
            })
        };
        let nodes = sum(map(ranges(certificate.innermost.len()), potentials_in))?;
        sets.checked_add(nodes).ok_or(E::Overflow)
    }
}

/// Checks that every set holds an odd number of nodes.
fn check_odd(certificate: &Certificate) -> Result<(), CertificateError> {
    let mut odd = vec![false; certificate.parents.len()];
    for (node, &set) in (0..).zip(&certificate.innermost) {
        if set != NONE {
            *odd.get_mut(set as usize).ok_or(E::NoSuchSet(node))? ^= true;
        }
    }
    for (set, &parent) in (0..).zip(&certificate.parents) {
        if !odd[set as usize] {
            return Err(E::Even(set));
        }
        if parent != NONE {
            odd[parent as usize] ^= true;
        }
    }
    Ok(())
}

/// Checks pairs and prices; returns the cost of the unpaired nodes, in halves.
fn unpaired_cost(
    problem: &impl Problem,
    matching: &(impl Mates + ?Sized),
    certificate: &Certificate,
) -> Result<i128, CertificateError> {
    let nodes = problem.node_count() as u32;
    let cost_in = |range: Range<usize>| {
        let mut cost = 0_i128;
        for node in range.start as u32..range.end as u32 {
            let mate = matching.mate(node);
            if mate != NONE && (mate >= nodes || mate == node || matching.mate(mate) != node) {
                return Err(E::NoPair(node));
            }
            let Some(price) = problem.price(node) else {
                if mate == NONE {
                    return Err(E::MustBePaired(node));
                }
                continue;
            };
            let price = price.checked_mul(2).ok_or(E::Overflow)?;
            if price < certificate.potentials.at(node as usize) {
                return Err(E::Price(node));
            }
            if mate == NONE {
                cost = cost.checked_add(price).ok_or(E::Overflow)?;
            }
        }
        Ok(cost)
    };
    sum(map(ranges(problem.node_count()), cost_in))
}

/// Checks all edges; returns the cost of the pairs, in halves.
///
/// A pair must have an edge without slack. That is its cheapest one, as no slack is negative.
fn paired_cost(
    problem: &impl Problem,
    matching: &(impl Mates + ?Sized),
    certificate: &Certificate,
    sets: &OddSets,
) -> Result<i128, CertificateError> {
    // At the lower node of each pair.
    let tight: Vec<AtomicBool> = collect(problem.node_count(), |_| AtomicBool::new(false));
    let parts = ranges(problem.node_count()).len();
    let cost_in = |part| {
        let mut cost = 0_i128;
        for edge in problem.edges_in(part, parts).filter(|edge| edge.ends[0] != edge.ends[1]) {
            let [u, v] = edge.ends;
            let slack = sets.slack(certificate, edge).ok_or(E::Overflow)?;
            if slack < 0 {
                return Err(E::Edge(u, v));
            }
            let is_first = || !tight[u.min(v) as usize].swap(true, Ordering::Relaxed);
            if slack == 0 && matching.mate(u) == v && is_first() {
                let twice = edge.cost.checked_mul(2);
                cost = twice.and_then(|twice| cost.checked_add(twice)).ok_or(E::Overflow)?;
            }
        }
        Ok(cost)
    };
    let cost = sum(map((0..parts).collect(), cost_in))?;
    let is_loose = |&node: &u32| {
        let mate = matching.mate(node);
        mate != NONE && !tight[node.min(mate) as usize].load(Ordering::Relaxed)
    };
    match (0..problem.node_count() as u32).find(is_loose) {
        Some(node) => Err(E::Loose(node, matching.mate(node))),
        None => Ok(cost),
    }
}

/// Adds up what was found in all parts; the first defect is that of the first part with one.
fn sum(parts: Vec<Result<i128, CertificateError>>) -> Result<i128, CertificateError> {
    parts.into_iter().try_fold(0_i128, |sum, part| sum.checked_add(part?).ok_or(E::Overflow))
}
