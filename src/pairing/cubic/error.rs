//! Reason why a graph is refused.

use crate::dual::DualGraphError;

/// A graph outside Petersen's theorem, with the first defect found. Nodes are numbered from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum CubicGraphError {
    /// A loop, more than three edges at a node, an end that does not exist, or too many nodes.
    #[error(transparent)]
    DualGraphError(#[from] DualGraphError),
    /// A node has fewer than three edges.
    #[error("node {0} has fewer than three edges")]
    Degree(u32),
    /// The graph is not connected.
    #[error("node {0} is not connected with node 0")]
    Disconnected(u32),
    /// Without the edge between these nodes there would be no way from one to the other.
    #[error("the edge between nodes {0} and {1} is a bridge")]
    Bridge(u32, u32),
    /// There is no node.
    #[error("the graph has no node")]
    Empty,
}
