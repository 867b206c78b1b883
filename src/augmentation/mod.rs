//! Second stage: augmenting paths until the matching is perfect (Lemos et al., section 3.1).
//!
//! Both ways search for augmenting paths with Edmonds' alternating trees and blossoms
//! (`forest.rs`); they differ in where trees start and in what is forgotten after a path.

mod forest;
mod local;
mod single_tree;
mod tarjan;

use std::ops::ControlFlow;

use crate::dual::{DualGraph, Matching, PerfectMatching};
use crate::triangulation::TriangleId;
use forest::Forest;
use single_tree::augment_from;

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
    /// Both.
    pub const ALL: [Self; 2] = [Self::Local, Self::Tarjan];

    /// The name on the command line and in records.
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

/// What an augmentation did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct AugmentationStats {
    /// Number of augmenting paths.
    pub paths: usize,
    /// Sum of the lengths of the paths; a path's length is its number of dual edges, at least 1.
    pub total_length: usize,
    /// Length of the longest path.
    pub longest: usize,
    /// Triangles that entered a search tree, once for every time that they did.
    pub triangles_visited: usize,
}

impl AugmentationStats {
    /// Mean length of a path in dual edges; 0 without paths.
    pub fn mean_length(&self) -> f64 {
        if self.paths == 0 { 0.0 } else { self.total_length as f64 / self.paths as f64 }
    }

    fn add_path(&mut self, length: usize) {
        self.paths += 1;
        self.total_length += length;
        self.longest = self.longest.max(length);
    }
}

/// Pairs single triangles by short augmenting paths while a pairing is still being made.
pub(crate) struct Rescue {
    forest: Forest,
}

impl Rescue {
    /// For matchings of `triangles` triangles; takes memory only as far as it is used.
    pub(crate) fn new(triangles: usize) -> Self {
        Self { forest: Forest::new(triangles) }
    }

    /// Pairs the unpaired triangle `f` by an augmenting path to the nearest other unpaired one, which
    /// is returned, unless that takes a search of more than `limit` triangles.
    pub(crate) fn pair(
        &mut self,
        graph: &DualGraph,
        matching: &mut Matching,
        f: TriangleId,
        limit: usize,
    ) -> Option<TriangleId> {
        augment_from(f, graph, &mut self.forest, matching, limit).map(|path| path.end)
    }
}

/// Augments `matching` until no augmenting path is left: a maximum matching of `graph`.
///
/// `on_path` is called after each path and may stop the search there. O(k n α) time for k unpaired triangles, where `local`
/// usually needs little more than the neighbourhoods of those. 24 bytes a triangle, with `local`
/// usually only for those that it visits.
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

/// Like [`make_maximum`], on the dual graph of a closed surface, where the result is perfect.
///
/// # Panics
/// If `graph` has no perfect matching: it is not a bridgeless 3-regular graph.
pub fn make_perfect(
    graph: &DualGraph,
    matching: Matching,
    augmentation: Augmentation,
    on_path: &mut dyn FnMut(),
) -> (PerfectMatching, AugmentationStats) {
    let on_path = &mut || {
        on_path();
        ControlFlow::Continue(())
    };
    let (matching, stats) = make_maximum(graph, matching, augmentation, on_path);
    let perfect = matching.certify(graph);
    (perfect.expect("a bridgeless 3-regular graph has a perfect matching (Theorem 2.1)"), stats)
}
