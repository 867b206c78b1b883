//! Why a conversion has no result.

use super::report::Report;
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
    /// [`Progress`](super::Progress) stopped the augmentation; the report has what was counted.
    #[error("stopped after {} augmenting paths", .0.paths.paths)]
    Stopped(Box<Report>),
}
