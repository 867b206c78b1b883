//! Augmentation that touches only what it visits.
//!
//! The trees of all unpaired triangles grow together, breadth first, in rounds: in each round every
//! tree may double. Where two trees meet they make an augmenting path, and only these two are
//! felled: their triangles are free again for the trees around. Growing together keeps trees small,
//! as paths are found half-way; with one tree at a time the last few paths would each search much
//! of the mesh. Growing by doubling rather than by single triangles keeps one tree after the other
//! in the cache.

use super::AugmentationStats;
use super::forest::{Forest, Place, TreeId};
use crate::dual::{DualGraph, Matching};
use crate::triangulation::TriangleId;

/// Number of triangles that a tree may take in during the first round.
const FIRST_SHARE: usize = 32;

/// How many times more triangles a tree may take in during each round than in the one before.
const GROWTH: usize = 2;

/// Augments until no path is left.
///
/// Invariant: every neighbour of an outer triangle that is not listed in its tree, to be scanned, is
/// in the same tree, and if outer in the same blossom. So when a round neither grows a tree nor finds
/// a path, the forest proves that the matching is maximum (Edmonds).
pub(super) fn augment(
    graph: &DualGraph,
    matching: &mut Matching,
    on_path: &mut dyn FnMut(),
) -> AugmentationStats {
    let mut forest = Forest::new(graph);
    let mut stats = AugmentationStats::default();
    let mut trees: Vec<TreeId> = matching.unpaired().map(|root| forest.plant(root)).collect();
    let mut share = FIRST_SHARE;
    loop {
        let before = (stats.paths, forest.visited());
        let mut all_scanned = true;
        for &tree in &trees {
            if !forest.stands(tree) {
                continue;
            }
            match grow(graph, &mut forest, matching, tree, share) {
                Growth::Path(length) => {
                    stats.add_path(length);
                    on_path();
                }
                Growth::UsedUp => all_scanned = false,
                Growth::Scanned => {}
            }
        }
        if all_scanned && before == (stats.paths, forest.visited()) {
            break;
        }
        trees.retain(|&tree| forest.stands(tree));
        share = share.saturating_mul(GROWTH);
    }
    stats.triangles_visited = forest.visited();
    stats
}

/// How a tree's turn ended.
enum Growth {
    /// It met another tree; both are felled. Length of the path.
    Path(usize),
    /// It has taken in its share and has more to scan.
    UsedUp,
    /// Nothing is left to scan for now.
    Scanned,
}

/// Lets `tree` take in `share` more triangles.
fn grow(
    graph: &DualGraph,
    forest: &mut Forest<'_>,
    matching: &mut Matching,
    tree: TreeId,
    share: usize,
) -> Growth {
    let enough = forest.visited() + share;
    forest.retry_barred(tree);
    while let Some(v) = forest.next_to_scan(tree) {
        if let Some((w, other)) = scan(graph, forest, matching, tree, v) {
            let length = forest.augment(matching, v, w);
            forest.fell(tree);
            forest.fell(other);
            return Growth::Path(length);
        }
        if forest.visited() >= enough {
            return Growth::UsedUp;
        }
    }
    Growth::Scanned
}

/// Grows `tree` by the neighbours of its outer triangle `v`; an outer neighbour in another tree is
/// returned with that.
///
/// Where an inner triangle of another tree bars the way, `v` has to be scanned again later.
fn scan(
    graph: &DualGraph,
    forest: &mut Forest<'_>,
    matching: &Matching,
    tree: TreeId,
    v: TriangleId,
) -> Option<(TriangleId, TreeId)> {
    let mut barred = false;
    for (side, w) in graph.sides(v).into_iter().enumerate() {
        if w == TriangleId::NONE || w == matching.mate_or_none(v) {
            continue;
        }
        match forest.place(w) {
            Place::Inner(other) => barred |= other != tree,
            Place::Free => {
                let mate = matching.mate_or_none(w);
                debug_assert_ne!(mate, TriangleId::NONE, "every unpaired triangle is a root");
                forest.grow(tree, v, w, mate);
            }
            Place::Outer(other) if other != tree => return Some((w, other)),
            Place::Outer(_) => forest.shrink(matching, tree, v, side, w),
        }
    }
    if barred {
        forest.bar(tree, v);
    }
    None
}
