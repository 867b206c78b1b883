//! Second stage: augmenting paths until the matching is perfect (Lemos et al., section 3.1).
//!
//! All kinds of augmentation search with the alternating trees of [`matching`](crate::matching).
//! They differ in where trees start and in what is cleared after a path. Where `local` gives its
//! search up, it takes another matching from [`pairing`](crate::pairing) or from the weighted
//! solver.
//!
//! [`make_maximum`] has an example. Names and means have no examples of their own.

mod detour;
mod local;
mod rebuild;
mod stats;
mod tarjan;

use std::ops::ControlFlow;

use crate::dual::{DualGraph, Matching};
use crate::names::named;

pub use stats::AugmentationStats;

/// A kind of search for augmenting paths.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Augmentation {
    /// `local`: ours. The trees of all unpaired triangles grow together and meet half-way. Memory
    /// is touched only where a tree passes.
    #[default]
    Local,
    /// `tarjan`: as Lemos et al. describe it. One breadth-first tree at a time, all state set up
    /// anew for each path: Θ(n) for each path.
    Tarjan,
    /// `rebuild`: the paths of `tarjan`, with the graph too set up anew for each, node by node. The
    /// printed times suggest that this was run.
    Rebuild,
}

impl Augmentation {
    /// All kinds of augmentation.
    pub const ALL: [Self; 3] = [Self::Local, Self::Tarjan, Self::Rebuild];

    /// Returns the name on the command line and in records.
    pub fn id(self) -> &'static str {
        match self {
            Self::Local => "local",
            Self::Tarjan => "tarjan",
            Self::Rebuild => "rebuild",
        }
    }
}

named!(Augmentation, "augmentation", id);

/// Augments `matching` until no augmenting path is left: a maximum matching of `graph`.
///
/// `on_path` is called after each path and can stop the search there.
///
/// ```
/// use std::ops::ControlFlow;
/// use triquad::{Augmentation, DualGraph, Matching, make_maximum};
///
/// let ring = DualGraph::from_edges(6, &[(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (5, 0)])?;
/// let none = Matching::empty(ring.len());
/// let proceed = || ControlFlow::Continue(());
/// let (matching, stats) = make_maximum(&ring, none, Augmentation::Local, proceed);
/// assert_eq!((matching.unpaired_count(), stats.paths), (0, 3));
/// # Ok::<(), triquad::dual::DualGraphError>(())
/// ```
///
/// # Cost
/// O(k n α) time for k unpaired triangles; 24 bytes a triangle, with `rebuild` about 60 more.
/// `local` usually visits little more than their neighbourhoods, and takes memory only there.
///
/// After 4 n visits, if paths lead through a bottleneck, `local` takes the others from a matching
/// found from nothing: TQ's, O(n). If it has to give up once more it takes a maximum one: GW's,
/// O(n log n) and 90 bytes a triangle, if the surface is closed.
///
/// # Panics
/// If `matching` is not one of `graph`: in debug builds always, in others if the sizes differ.
pub fn make_maximum(
    graph: &DualGraph,
    mut matching: Matching,
    augmentation: Augmentation,
    mut on_path: impl FnMut() -> ControlFlow<()>,
) -> (Matching, AugmentationStats) {
    assert_eq!(graph.len(), matching.len(), "the matching of another graph");
    debug_assert!(matching.is_matching_of(graph));
    let stats = match augmentation {
        Augmentation::Local => local::augment(graph, &mut matching, &mut on_path),
        Augmentation::Tarjan => tarjan::augment(graph, &mut matching, &mut on_path),
        Augmentation::Rebuild => rebuild::augment(graph, &mut matching, &mut on_path),
    };
    debug_assert!(matching.is_matching_of(graph));
    (matching, stats)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn augmentations_are_read_back_as_they_are_written() {
        for augmentation in Augmentation::ALL {
            assert_eq!(augmentation.to_string().parse(), Ok(augmentation));
        }
        let refusal = "global".parse::<Augmentation>().unwrap_err();
        let expected = "\"global\" is no augmentation; use one of: local, tarjan, rebuild";
        assert_eq!(refusal.to_string(), expected);
    }

    #[cfg(feature = "serde")]
    #[test]
    fn augmentations_are_their_names_in_json() {
        assert_eq!(serde_json::to_string(&Augmentation::Tarjan).unwrap(), "\"tarjan\"");
        assert_eq!(
            serde_json::from_str::<Augmentation>("\"local\"").unwrap(),
            Augmentation::default()
        );
    }
}
