//! Perfect matchings of least cost, with proof.
//!
//! Costs are integers, negative ones as well. Of all matchings that pair every node the one of
//! least total cost is found, exactly; a node with a *price* may stay unpaired at that price. Every
//! answer comes with a [`Certificate`], and [`verify`] checks it by the definition of the problem
//! alone. Where there is no such matching, a [`Barrier`] proves that.
//!
//! The dual graph of a triangulation, with a cost on each side of each triangle:
//!
//! ```
//! use std::ops::ControlFlow;
//! use triquad::dual::DualGraph;
//! use triquad::matching::weighted::{DualProblem, solve_cubic, verify};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let edges = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)];
//! let graph = DualGraph::from_edges(4, &edges)?;
//! let costs = [[5, 3, 4], [5, 6, 2], [3, 6, 7], [4, 2, 7]];
//! let problem = DualProblem::new(&graph, &costs);
//!
//! let solution = solve_cubic(&problem, &mut |_| ControlFlow::Continue(()))?;
//! assert_eq!(solution.mates, [2, 3, 0, 1]);
//! assert_eq!(solution.cost, 3 + 2);
//! verify(&problem, &solution, &solution.certificate)?;
//! # Ok(())
//! # }
//! ```
//!
//! Any other graph, here with a price for nodes that stay unpaired:
//!
//! ```
//! use std::ops::ControlFlow;
//! use triquad::matching::weighted::{EdgeList, NONE, Prices, solve_sparse, verify};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! // A star: only one of its three rays can be a pair.
//! let problem = EdgeList::new(4, &[(0, 1), (0, 2), (0, 3)], &[7, -4, 1]);
//! let problem = problem.with_prices(Prices::Equal(10));
//!
//! let solution = solve_sparse(&problem, &mut |_| ControlFlow::Continue(()))?;
//! assert_eq!(solution.mates, [2, NONE, 0, NONE]);
//! assert_eq!(solution.cost, 10 - 4 + 10);
//! verify(&problem, &solution, &solution.certificate)?;
//! # Ok(())
//! # }
//! ```
//!
//! The method is Edmonds' (1965), arranged for large sparse graphs: greedy potentials and pairs;
//! free nodes displace others (Jonker and Volgenant 1987); then a half-integral optimum by trees
//! without blossoms; then one tree with blossoms from each odd cycle that is left. Trees are grown
//! one at a time, cut at a limit that grows from round to round. Those that are many for their
//! limit grow together at last.
//!
//! Imports of this room go one way: problems and certificates; the check and the barriers, which
//! use nothing else; the places of nodes; nodes in their two layouts; the phases; the solver's
//! entry. Only the adapter `dual` names triangles, and only the layouts prefetch.
//!
//! Functions that read one part of a certificate or a barrier have no examples of their own.

mod barrier;
mod blossoms;
mod certificate;
mod cubic;
mod cycles;
mod displace;
mod dual;
mod edge_list;
mod half;
mod limits;
mod nodes;
mod number;
mod observer;
mod parts;
mod patches;
mod places;
mod prices;
mod problem;
mod queue;
mod refusal;
mod roots;
mod solve;
mod sparse;
mod start;
#[cfg(test)]
mod tests;
mod verify;
mod work;

pub use barrier::Barrier;
pub use certificate::{Certificate, Integers};
pub use dual::DualProblem;
pub use edge_list::EdgeList;
pub use observer::{News, Stage};
pub use prices::Prices;
pub(crate) use problem::cubic_edges;
pub use problem::{CubicProblem, Edge, GREATEST_COST, Mates, NONE, Problem};
pub use solve::{Solution, SolveError, solve_cubic, solve_sparse};
pub use verify::{CertificateError, verify};
pub use work::Work;
