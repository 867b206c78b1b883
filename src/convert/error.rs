//! Why a conversion has no result.

use super::report::Report;
use crate::matching::weighted::{CertificateError, SolveError};
use crate::quadrangulation::Mismatch;
use crate::triangulation::Survey;

/// Why a mesh was not converted.
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
    Unproved(#[from] CertificateError),
    /// [`Progress`](super::Progress) stopped the conversion; the report has what was counted.
    #[error("stopped after {} augmenting paths", .0.paths.paths)]
    Stopped(Box<Report>),
}
