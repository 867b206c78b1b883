//! First stage of every conversion: an initial pairing of edge-adjacent triangles, perfect or not.
//!
//! Adding an algorithm takes one file with its function and one variant of [`Algorithm`] with its
//! id. The compiler names the remaining lines. Tests and the command line iterate over
//! [`Algorithm::ALL`].

mod algorithm;
mod best;
pub mod cubic;
mod eager_rescue;
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
pub use best::{best, best_matching, fewest_unpaired};
pub use cubic::{diks_stanczyk, gawrychowski_wasylkiewicz};
pub use eager_rescue::eager_rescue;
pub use initial::InitialPairing;
pub use lrs::{Expansion, LRS_ORDER, lrs};
pub use objective::{Keeping, Leftover, Objective, ObjectiveProblem};
pub use proof::{Proof, ProofError};
pub use pulli_segal::pulli_segal;
pub use simple_greedy::simple_greedy;
pub(crate) use velho::squared_length;
pub use velho::velho;
