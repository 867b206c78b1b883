//! Reason why a conversion has no result.

use super::report::Report;
use crate::matching::weighted::SolveError;
use crate::pairing::{Algorithm, ProofError};
use crate::quadrangulation::{CostCountError, Mismatch, NoSuchEdge};
use crate::triangulation::Survey;

/// Reason why a mesh was not converted.
#[derive(Clone, Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ConvertError {
    /// The input is no triangulation of closed surfaces; the survey has every law that it breaks.
    #[error(transparent)]
    Refused(#[from] Box<Survey>),
    /// The result failed its check: a mistake of this library.
    #[error("the result failed its check, please report this: {0}")]
    Wrong(#[from] Mismatch),
    /// The costs of the edges cannot be used.
    #[error("the costs of the edges: {0}")]
    Costs(SolveError),
    /// The proof of least cost is wrong: a mistake of this library.
    #[error("the proof of least cost failed its check, please report this: {0}")]
    Unproved(#[from] ProofError),
    /// More triangles are left than must be: a mistake of this library.
    #[error("more triangles are left than must be, please report this")]
    NotFewest,
    /// There is not one cost for each edge.
    #[error("{0}")]
    CostCount(#[from] CostCountError),
    /// An edge to keep is none of the mesh.
    #[error("{0}")]
    NoSuchEdge(#[from] NoSuchEdge),
    /// The algorithm works on closed, two-sided surfaces only.
    #[error(
        "{0} works on closed, two-sided surfaces only: it needs three neighbours at every triangle \
         and two sides at every edge; use best, tq, ps or sg"
    )]
    NeedsClosed(Algorithm),
    /// The algorithm does not support the requested aim.
    #[error("{aim} cannot be given to {algorithm}; use best")]
    NeedsBest {
        /// The requested aim.
        aim: &'static str,
        /// The algorithm.
        algorithm: Algorithm,
    },
    /// [`Progress`](super::Progress) stopped the conversion; the report has what was counted.
    #[error("stopped after {} augmenting paths", .0.paths.paths)]
    Stopped(Box<Report>),
}
