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
    /// Vertices that these tests have visited, a cost that no machine changes. RS visits the
    /// link of v but for u and the apexes, and at the edges put aside that wait for a processed
    /// vertex when u gains it. S visits the link of v up to the first vertex joined to u. BF
    /// visits the links of both ends, or at none if one of them has degree 3.
    pub link_vertices_visited: u64,
    /// The sum of d_u · d_v over the tests of all edges [u, v], d the degrees: their cost without
    /// any data structure (section 3).
    pub degree_products: u64,
}

impl Counts {
    /// Counts a test of an edge whose ends have these degrees.
    pub(super) fn add_test(&mut self, [u, v]: [u32; 2]) {
        self.link_condition_tests += 1;
        self.degree_products += u64::from(u) * u64::from(v);
    }
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
