//! Reason why a conversion has no result.

use super::report::Report;
use crate::counted::counted;
use crate::matching::weighted::SolveError;
use crate::pairing::{Algorithm, ProofError};
use crate::quadrangulation::{CheckError, CostCountError, NoSuchEdgeError};
use crate::triangulation::Survey;

/// Reason why a mesh was not converted. Displayed numbers of vertices and faces count from 1,
/// stored ones from 0.
///
/// `Debug` writes the message, of a refused mesh with the remedy: an error that `main` returns is
/// printed by `Debug`.
#[derive(Clone, thiserror::Error)]
#[non_exhaustive]
pub enum ConvertError {
    /// The input is no triangulation of closed surfaces; the survey has every law that it breaks
    /// after [`Converter::orient`](super::Converter::orient), those that
    /// [`Converter::open`](super::Converter::open) allows last.
    #[error(transparent)]
    Refused(#[from] Box<Survey>),
    /// The result failed its check: a mistake of this library.
    #[error("the result failed its check, please report this: {0}")]
    Wrong(CheckError),
    /// The costs of the edges cannot be used.
    #[error("the costs of the edges: {0}")]
    Costs(SolveError),
    /// The proof of least cost is wrong: a mistake of this library.
    #[error("the proof of least cost failed its check, please report this: {0}")]
    Unproved(ProofError),
    /// More triangles are left than must be: a mistake of this library.
    #[error("more triangles are left than must be, please report this")]
    NotFewest,
    /// There is not one cost for each edge.
    #[error(transparent)]
    CostCount(#[from] CostCountError),
    /// An edge to keep is none of the mesh.
    #[error(transparent)]
    NoSuchEdge(#[from] NoSuchEdgeError),
    /// The algorithm works on closed, two-sided surfaces only.
    #[error(
        "{0} works on closed, two-sided surfaces only: it needs three neighbours at every triangle \
         and two sides at every edge; use one of: {list}",
        list = works_on_open()
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
    #[error(
        "stopped after {}",
        counted(.0.paths.paths, "augmenting path", "augmenting paths")
    )]
    Stopped(Box<Report>),
}

impl std::fmt::Debug for ConvertError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{self}")?;
        match self {
            Self::Refused(survey) => survey
                .violations
                .first()
                .map_or(Ok(()), |first| write!(f, " [{}]; {}", first.law, first.law.remedy())),
            _ => Ok(()),
        }
    }
}

/// Returns the names of the algorithms that need no closed surface.
fn works_on_open() -> String {
    let mut algorithms = Algorithm::ALL.to_vec();
    algorithms.retain(|algorithm| algorithm.works_on_open());
    algorithms.into_iter().map(Algorithm::id).collect::<Vec<_>>().join(", ")
}

// Their texts stand in the message, so they are no sources: a chain of errors has each text once.
impl From<CheckError> for ConvertError {
    fn from(mismatch: CheckError) -> Self {
        Self::Wrong(mismatch)
    }
}

impl From<ProofError> for ConvertError {
    fn from(error: ProofError) -> Self {
        Self::Unproved(error)
    }
}

#[cfg(test)]
mod tests {
    use std::error::Error;

    use super::*;

    /// The messages of an error and of its sources.
    fn chain(error: &dyn Error) -> Vec<String> {
        let mut messages = vec![error.to_string()];
        let mut source = error.source();
        while let Some(error) = source {
            messages.push(error.to_string());
            source = error.source();
        }
        messages
    }

    #[test]
    fn no_text_stands_twice_in_a_chain_of_errors() {
        let count = CostCountError { given: 3, edges: 6 };
        let edge = NoSuchEdgeError { position: 0, ends: [1, 2] };
        let vertices = CheckError::VertexCount { quads: 4, triangles: 5 };
        let errors = [count.into(), edge.into(), ConvertError::from(vertices)];
        for error in errors {
            let chain = chain(&error);
            for (at, text) in chain.iter().enumerate() {
                assert!(!chain[..at].iter().any(|before| before.contains(text)), "{chain:?}");
            }
        }
    }
}
