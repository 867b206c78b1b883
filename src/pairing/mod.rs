//! First stage of every conversion: an initial pairing of edge-adjacent triangles, perfect or not.
//!
//! Adding an algorithm takes one file with its function and one variant of [`Algorithm`] with its
//! place in [`Algorithm::ALL`]. The compiler names the remaining lines, all of them in
//! `algorithm.rs`. Tests and the command line iterate over [`Algorithm::ALL`].
//!
//! # Examples
//!
//! By name, or as functions of the dual graph:
//!
//! ```
//! use triquad::random::Random;
//! use triquad::triangulation::Survey;
//! use triquad::{Algorithm, DualGraph, Mesh, Triangulation, pairing};
//!
//! let triangles = vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
//! let triangulation = Triangulation::build(&Mesh::from_triangles(vec![[0.0; 3]; 4], triangles))?;
//! for algorithm in Algorithm::ALL {
//!     let mut random = Random::stream(7, &[algorithm.id()]);
//!     let initial = algorithm.pair(&triangulation, &mut random);
//!     assert!(initial.matching.is_matching_of(&initial.dual));
//!     println!("{algorithm}: {}", algorithm.description());
//! }
//! assert!(Algorithm::Best.works_on_open() && !Algorithm::DiksStanczyk.works_on_open());
//!
//! let graph = DualGraph::new(&triangulation);
//! let greedy = pairing::simple_greedy(&graph, &mut Random::stream(7, &[]));
//! assert!(greedy.unpaired_count() <= 2);
//! let by_priority = pairing::pulli_segal(&graph, None);
//! assert!(by_priority.is_matching_of(&graph));
//! let by_length = pairing::velho(&graph, |_edge| 1.0);
//! assert!(by_length.is_matching_of(&graph));
//! assert_eq!(pairing::eager_rescue(&graph).unpaired_count(), 0);
//! let cubic = pairing::gawrychowski_wasylkiewicz(&graph).expect("3-regular and bridgeless");
//! assert_eq!(cubic.unpaired_count(), 0);
//! assert_eq!(pairing::fewest_left_over(&graph).expect("the proof holds"), 0);
//! # Ok::<(), Box<Survey>>(())
//! ```
//!
//! Costs of your own:
//!
//! ```
//! use std::ops::ControlFlow;
//! use triquad::dual::DualGraph;
//! use triquad::pairing::{Objective, best_matching};
//!
//! let graph = DualGraph::from_edges(4, &[(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)])?;
//! // One cost a side of each triangle.
//! let objective = Objective::perfect(vec![[5, 3, 4], [5, 6, 2], [3, 6, 7], [4, 2, 7]]);
//! let found = best_matching(&graph, objective, &mut |_| ControlFlow::Continue(()));
//! let (matching, proof) = found.expect("a perfect matching");
//! assert_eq!(matching.unpaired_count(), 0);
//! proof.verify(&graph, &matching).expect("none costs less");
//! # Ok::<(), triquad::dual::DualGraphError>(())
//! ```
//!
//! [`best()`] and [`lrs()`] are called through [`Converter`](crate::Converter), which prepares
//! their costs and orders. They, and the parts of an [`Objective`], have no examples of their own.

mod algorithm;
mod best;
pub mod cubic;
mod eager_rescue;
mod in_order;
mod initial;
mod lrs;
mod objective;
mod proof;
mod pulli_segal;
mod ranked_graph;
mod shuffler;
mod simple_greedy;
mod velho;

pub use algorithm::Algorithm;
pub use best::{best, best_matching, fewest_left_over};
pub use cubic::{diks_stanczyk, gawrychowski_wasylkiewicz};
pub use eager_rescue::eager_rescue;
pub use initial::InitialPairing;
pub use lrs::{Expansion, LRS_ORDER, lrs};
pub use objective::{Keeping, Leftover, Objective, ObjectiveProblem};
pub use proof::{Proof, ProofError};
pub use pulli_segal::pulli_segal;
pub use simple_greedy::simple_greedy;
pub use velho::velho;
