//! The outcome of the first stage.

use std::borrow::Cow;

use crate::dual::{DualGraph, Matching};
use crate::matching::weighted::{Certificate, CertificateError, DualProblem, verify};
use crate::triangulation::Triangulation;

/// An initial pairing, and the triangulation whose triangles it pairs.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct InitialPairing<'t> {
    /// The input, or another triangulation of the same surface with the same vertices.
    pub triangulation: Cow<'t, Triangulation>,
    /// The dual graph of `triangulation`.
    pub dual: DualGraph,
    /// A matching in `dual`.
    pub matching: Matching,
    /// Number of edges of `triangulation` that the input does not have.
    pub edge_flips: usize,
    /// The proof that no perfect matching costs less, if costs were given.
    pub proof: Option<Proof>,
}

/// A proof that a perfect matching is one of least cost.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Proof {
    /// The cost of the edge across each side of each triangle.
    pub costs: Vec<[i32; 3]>,
    /// Dual values that bound the cost of every perfect matching from below.
    pub certificate: Certificate,
    /// Total cost of the matching.
    pub cost: i128,
}

impl Proof {
    /// Checks that the proof proves `matching` to be of least cost in `dual`. O(n).
    ///
    /// Shares no code with the solver.
    ///
    /// # Errors
    /// The first defect of matching or certificate.
    pub fn verify(&self, dual: &DualGraph, matching: &Matching) -> Result<(), CertificateError> {
        verify(&DualProblem::new(dual, &self.costs), matching, &self.certificate)
    }
}

impl<'t> InitialPairing<'t> {
    /// Pairs the triangles of `triangulation` itself by `pair`.
    pub(super) fn from_input(
        triangulation: &'t Triangulation,
        pair: impl FnOnce(&DualGraph) -> Matching,
    ) -> Self {
        let dual = DualGraph::new(triangulation);
        let matching = pair(&dual);
        Self::new(triangulation, dual, matching)
    }

    /// Makes the pairing of the triangles of `triangulation` by `matching`.
    pub(super) fn new(
        triangulation: &'t Triangulation,
        dual: DualGraph,
        matching: Matching,
    ) -> Self {
        debug_assert!(matching.is_matching_of(&dual));
        let triangulation = Cow::Borrowed(triangulation);
        Self { triangulation, dual, matching, edge_flips: 0, proof: None }
    }
}
