//! The solver's entry: the widths of numbers, one after the other, and what comes back.

use std::num::Wrapping;
use std::ops::ControlFlow;

use super::barrier::Barrier;
use super::blossoms::{Outcome, Trees};
use super::certificate::Certificate;
use super::cubic::Rows;
use super::half::half_integral;
use super::limits::Limits;
use super::nodes::Nodes;
use super::number::Number;
use super::observer::{News, Observer};
use super::parts::{has_parts, run_in_parts};
use super::places::Places;
use super::problem::{CubicProblem, Mates, Problem};
use super::refusal::Refusal;
use super::roots::Roots;
use super::sparse::Sparse;
use super::start::start;
use super::work::Work;

/// A matching of least cost with the proof that it is one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Solution {
    /// The node that each node is paired with, [`NONE`](super::NONE) if it stays unpaired.
    pub mates: Vec<u32>,
    /// The proof, for [`verify`](super::verify).
    pub certificate: Certificate,
    /// Sum of the costs of all pairs and the prices of all unpaired nodes.
    pub cost: i128,
    /// Work of the run.
    pub work: Work,
}

impl Mates for Solution {
    fn node_count(&self) -> usize {
        self.mates.len()
    }

    fn mate(&self, node: u32) -> u32 {
        self.mates[node as usize]
    }
}

/// A reason why there is no solution.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SolveError {
    /// Nodes without a price cannot all be paired; the barrier proves it.
    #[error(
        "no matching pairs every node that must be paired; remove locks or set a price for \
         unpaired nodes"
    )]
    Infeasible(Barrier),
    /// The hook ended the run.
    #[error("stopped")]
    Stopped {
        /// A number that the cost of no matching is below.
        bound: i128,
    },
    /// Nodes and edges are too many to be numbered with 32 bits.
    #[error("too many nodes or edges")]
    TooLarge,
    /// A cost or price is beyond ± [`GREATEST_COST`](super::GREATEST_COST).
    #[error("a cost or price is beyond ± 2^90")]
    TooCostly,
    /// An edge leads to a node that does not exist.
    #[error("node {0} does not exist")]
    NoSuchNode(u32),
    /// A side of the first node leads to the second, which has no side of the same cost back.
    #[error("the edge from node {0} to node {1} is missing or has another cost the other way")]
    Asymmetric(u32, u32),
}

/// Finds a perfect matching of least cost in a graph of at most three edges a node.
///
/// Time grows little faster than n on surfaces; the worst case is O(n² log n). About 60 bytes a
/// node with costs to 2²⁷, 100 beyond, plus 8 if many costs are nearly equal, and 8 in large graphs
/// whose numbers lead far apart. Equal input gives equal output. `hook` is called between searches
/// and can end the run.
///
/// # Errors
/// The edges are not symmetric; a cost or the graph is too large; the hook ended the run; or there
/// is no such matching, with proof.
pub fn solve_cubic(
    problem: &impl CubicProblem,
    hook: &mut dyn FnMut(News) -> ControlFlow<()>,
) -> Result<Solution, SolveError> {
    let mut observer = Observer::new(hook);
    cubic_solution(problem, Limits::DEFAULT, &mut observer)
}

/// Finds a perfect matching of least cost in any graph.
///
/// Like [`solve_cubic`], three to five times as slow on the same graph. Worst case O(n·m log n);
/// about 32 bytes a node and 32 an edge with costs to 2⁵⁹.
///
/// # Errors
/// An edge leads to a node that does not exist; a cost or the graph is too large; the hook ended
/// the run; or there is no such matching, with proof.
pub fn solve_sparse(
    problem: &impl Problem,
    hook: &mut dyn FnMut(News) -> ControlFlow<()>,
) -> Result<Solution, SolveError> {
    sparse_solution(problem, Limits::DEFAULT, &mut Observer::new(hook))
}

/// Tries 32, 64 and 128 bits.
pub(super) fn cubic_solution(
    problem: &impl CubicProblem,
    limits: Limits,
    observer: &mut Observer,
) -> Result<Solution, SolveError> {
    if problem.node_count() > Rows::<Wrapping<i32>>::MOST_NODES {
        return Err(SolveError::TooLarge);
    }
    let places = Places::of(problem, limits);
    let ranges = || limits.ranges(problem.node_count());
    let mut outcome = run_narrow(Rows::new(problem, &places, ranges()), limits, observer);
    if is_too_narrow(&outcome) {
        let rows = Rows::<Wrapping<i64>>::new(problem, &places, ranges());
        outcome = run_whole(rows, limits, observer);
    }
    if is_too_narrow(&outcome) {
        let rows = Rows::<Wrapping<i128>>::new(problem, &places, ranges());
        outcome = run_whole(rows, limits, observer);
    }
    places.restore(outcome).map(solution).map_err(error)
}

/// Tries 64 and 128 bits.
pub(super) fn sparse_solution(
    problem: &impl Problem,
    limits: Limits,
    observer: &mut Observer,
) -> Result<Solution, SolveError> {
    let mut outcome = run(Sparse::<Wrapping<i64>>::new(problem), limits, observer);
    if is_too_narrow(&outcome) {
        outcome = run(Sparse::<Wrapping<i128>>::new(problem), limits, observer);
    }
    outcome.map(solution).map_err(error)
}

fn is_too_narrow(outcome: &Result<Outcome, Refusal>) -> bool {
    matches!(outcome, Err(Refusal::TooNarrow))
}

fn error(refusal: Refusal) -> SolveError {
    match refusal {
        Refusal::TooNarrow => SolveError::TooCostly,
        Refusal::TooLarge => SolveError::TooLarge,
        Refusal::NoSuchNode(node) => SolveError::NoSuchNode(node),
        Refusal::Asymmetric(from, to) => SolveError::Asymmetric(from, to),
        Refusal::Infeasible(mut nodes) => {
            nodes.sort_unstable();
            nodes.dedup();
            SolveError::Infeasible(Barrier { nodes })
        }
        Refusal::Stopped(bound) => SolveError::Stopped { bound: -(-bound).div_euclid(2) },
    }
}

/// Runs all phases, in parts if the graph is large.
fn run_narrow(
    rows: Result<Rows<Wrapping<i32>>, Refusal>,
    limits: Limits,
    observer: &mut Observer,
) -> Result<Outcome, Refusal> {
    let mut rows = rows?;
    if has_parts(&mut rows, limits) {
        run_in_parts(rows, limits, observer)
    } else {
        run_whole(Ok(rows), limits, observer)
    }
}

/// Runs all phases with all nodes in view.
fn run_whole<N: Number>(
    rows: Result<Rows<N>, Refusal>,
    limits: Limits,
    observer: &mut Observer,
) -> Result<Outcome, Refusal> {
    run(Ok(rows?.whole()), limits, observer)
}

/// Runs all phases.
fn run<S: Nodes>(
    nodes: Result<S, Refusal>,
    limits: Limits,
    observer: &mut Observer,
) -> Result<Outcome, Refusal> {
    let mut work = Work::of::<S::N>();
    let mut nodes = nodes?;
    let (free, _) = start(&mut nodes, limits);
    work.free_after_start = free.len() as u64;
    let roots =
        half_integral(&mut nodes, Roots::new(free), Vec::new(), limits, &mut work, observer)?;
    work.blossom_roots = roots.len() as u64;
    let mut trees = Trees::new(nodes, work);
    trees.pair_all(Roots::new(roots), 0, limits, observer)?;
    Ok(trees.finish())
}

/// Adds up the costs that the certificate proves to be those of the matching.
fn solution(outcome: Outcome) -> Solution {
    Solution {
        mates: outcome.mates,
        certificate: outcome.certificate,
        cost: outcome.twice_the_cost / 2,
        work: outcome.work,
    }
}
