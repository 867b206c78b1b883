//! Second stage: augmenting paths until the matching is perfect (Lemos et al., section 3.1).
//!
//! Both ways search with the alternating trees of [`matching`](crate::matching). They differ in
//! where trees start and in what is cleared after a path.

mod local;
mod stats;
mod tarjan;

use std::ops::ControlFlow;

use crate::dual::{DualGraph, Matching};

pub use stats::AugmentationStats;

/// How augmenting paths are searched for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Augmentation {
    /// `local`: ours. The trees of all unpaired triangles grow together and meet half-way; only what
    /// is visited is touched.
    Local,
    /// `tarjan`: as published. One breadth-first tree at a time, all state set up anew for each
    /// path: Θ(n) a path.
    Tarjan,
}

impl Augmentation {
    /// All ways there are.
    pub const ALL: [Self; 2] = [Self::Local, Self::Tarjan];

    /// Returns the name on the command line and in records.
    pub fn id(self) -> &'static str {
        match self {
            Self::Local => "local",
            Self::Tarjan => "tarjan",
        }
    }
}

impl std::fmt::Display for Augmentation {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.id())
    }
}

/// Augments `matching` until no augmenting path is left: a maximum matching of `graph`.
///
/// `on_path` is called after each path and may stop the search there. O(k n α) time for k unpaired
/// triangles; `local` usually visits little more than their neighbourhoods. 24 bytes a triangle;
/// with `local` usually only for those that it visits.
///
/// # Panics
/// If `matching` is not one of `graph`: in debug builds always, in others if the sizes differ.
pub fn make_maximum(
    graph: &DualGraph,
    mut matching: Matching,
    augmentation: Augmentation,
    on_path: &mut dyn FnMut() -> ControlFlow<()>,
) -> (Matching, AugmentationStats) {
    assert_eq!(graph.len(), matching.len(), "the matching of another graph");
    debug_assert!(matching.is_matching_of(graph));
    let stats = match augmentation {
        Augmentation::Local => local::augment(graph, &mut matching, on_path),
        Augmentation::Tarjan => tarjan::augment(graph, &mut matching, on_path),
    };
    debug_assert!(matching.is_matching_of(graph));
    (matching, stats)
}
