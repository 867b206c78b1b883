//! The outcome that all three algorithms share.

use crate::triangulation::{ShrinkingTriangulation, VertexSplit};

/// Work of an algorithm besides the contractions, as in Tables 6 to 11.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Counts {
    /// Tests of an edge against the link condition (ℓ). RS contracts edges at vertices of degree 3
    /// without a test.
    pub link_condition_tests: usize,
    /// Edges that were tested more than once (ε). An edge whose end moves stays the same edge; of
    /// two that become one, the one at the end that stays remains.
    pub edges_tested_more_than_once: usize,
}

/// A triangulation without contractible edges, and the receipts that lead back to the input.
#[derive(Debug)]
#[non_exhaustive]
pub struct Contracted {
    /// The triangulation that is left.
    pub triangulation: ShrinkingTriangulation,
    /// The receipts of all contractions, the first contraction first.
    pub splits: Vec<VertexSplit>,
    /// Tests of edges.
    pub counts: Counts,
}
