//! The outcome of the first stage.

use std::borrow::Cow;

use super::proof::Proof;
use crate::dual::{DualGraph, Matching};
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

impl<'t> InitialPairing<'t> {
    /// Pairs the triangles of `triangulation` itself by `pair`.
    pub(crate) fn from_input(
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
