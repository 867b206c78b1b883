//! Receipts of contractions.

use super::ids::HalfEdgeId;

/// Receipt of one contraction, undone last-in first-out; not `Clone`, so at most once.
#[must_use = "without its receipt a contraction is permanent"]
#[derive(Debug)]
#[repr(transparent)]
pub struct VertexSplit(pub(super) HalfEdgeId);

impl VertexSplit {
    /// Returns the half-edge that was contracted, from the end that stayed to the end that went.
    pub fn half_edge(&self) -> HalfEdgeId {
        self.0
    }
}
