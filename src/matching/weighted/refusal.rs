//! Reasons why a run ends without a matching.

/// A reason why a run ends without a matching.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Refusal {
    /// The numbers or the nodes are not wide enough; wider ones may be.
    TooNarrow,
    /// Nodes and edges cannot be numbered.
    TooLarge,
    /// This node of an edge does not exist.
    NoSuchNode(u32),
    /// An edge from the first node to the second is missing or has another cost the other way.
    Asymmetric(u32, u32),
    /// These nodes, some perhaps more than once, show that there is no perfect matching.
    Infeasible(Vec<u32>),
    /// The observer has stopped the search. Twice the cost of every perfect matching is at least
    /// this.
    Stopped(i128),
}
