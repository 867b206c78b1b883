//! Matchings: which triangle is paired with which.

use super::DualGraph;
use crate::prefetch::prefetch;
use crate::triangulation::{IdVec, TriangleId};

/// A matching in a dual graph: disjoint pairs of edge-adjacent triangles. 4 bytes a triangle.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Matching {
    mate: IdVec<TriangleId, TriangleId>,
    unpaired: usize,
}

impl Matching {
    /// The matching of `triangles` triangles that pairs none.
    pub fn empty(triangles: usize) -> Self {
        Self { mate: IdVec::filled(TriangleId::NONE, triangles), unpaired: triangles }
    }

    /// The matching in which each triangle has this mate, or [`TriangleId::NONE`]. O(n).
    pub(crate) fn from_mates(mate: Vec<TriangleId>) -> Self {
        let unpaired = mate.iter().filter(|&&mate| mate == TriangleId::NONE).count();
        Self { mate: mate.into(), unpaired }
    }

    /// The triangle that `f` is paired with.
    #[inline]
    pub fn mate(&self, f: TriangleId) -> Option<TriangleId> {
        self.mate[f].some()
    }

    /// Like [`Matching::mate`], with [`TriangleId::NONE`] for an unpaired triangle.
    #[inline]
    pub(crate) fn mate_or_none(&self, f: TriangleId) -> TriangleId {
        self.mate[f]
    }

    /// Has the cache fetch the mate of `f`.
    #[inline]
    pub(crate) fn prefetch(&self, f: TriangleId) {
        prefetch(self.mate.as_slice(), f.index());
    }

    /// Whether `f` is paired.
    #[inline]
    pub fn is_paired(&self, f: TriangleId) -> bool {
        self.mate[f] != TriangleId::NONE
    }

    /// Pairs two unpaired triangles.
    ///
    /// # Panics
    /// If one of them is paired already, or both are the same.
    #[inline]
    pub fn pair(&mut self, f: TriangleId, g: TriangleId) {
        assert!(f != g && !self.is_paired(f) && !self.is_paired(g), "a triangle has one mate");
        self.pair_unpaired(f, g);
    }

    /// Like [`Matching::pair`] where the caller knows that both are unpaired: nothing is read.
    #[inline]
    pub(crate) fn pair_unpaired(&mut self, f: TriangleId, g: TriangleId) {
        debug_assert!(f != g && !self.is_paired(f) && !self.is_paired(g));
        self.mate[f] = g;
        self.mate[g] = f;
        self.unpaired -= 2;
    }

    /// Number of triangles (paired or not).
    pub fn len(&self) -> usize {
        self.mate.len()
    }

    /// Whether there is no triangle at all.
    pub fn is_empty(&self) -> bool {
        self.mate.is_empty()
    }

    /// Number k of unpaired triangles.
    pub fn unpaired_count(&self) -> usize {
        self.unpaired
    }

    /// The unpaired triangles in order.
    pub fn unpaired(&self) -> impl Iterator<Item = TriangleId> {
        self.mate.ids().filter(|&f| !self.is_paired(f))
    }

    /// Makes every pair of an augmenting path's new edges: each triangle of the path gets a new
    /// mate, and its two unpaired ends are paired from now on.
    pub(crate) fn replace_along(&mut self, new_pairs: &[(TriangleId, TriangleId)]) {
        for &(f, g) in new_pairs {
            self.mate[f] = g;
            self.mate[g] = f;
        }
        self.unpaired -= 2;
    }

    /// Whether mates are mutual and neighbours in `graph`, and the count of the unpaired is right.
    /// O(n).
    pub fn is_matching_of(&self, graph: &DualGraph) -> bool {
        let legal = |f: TriangleId| match self.mate(f) {
            Some(g) => self.mate[g] == f && graph.sides(f).contains(&g),
            None => true,
        };
        self.len() == graph.len()
            && self.mate.ids().all(legal)
            && self.unpaired().count() == self.unpaired
    }

    /// The proof that every triangle is paired with one across an edge of `graph`. O(n).
    ///
    /// # Errors
    /// The matching itself, if a triangle is unpaired or the matching is not one of `graph`.
    pub fn certify(self, graph: &DualGraph) -> Result<PerfectMatching, Self> {
        if self.unpaired == 0 && self.is_matching_of(graph) {
            Ok(PerfectMatching { mate: self.mate })
        } else {
            Err(self)
        }
    }
}

/// A matching that pairs every triangle.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PerfectMatching {
    mate: IdVec<TriangleId, TriangleId>,
}

impl PerfectMatching {
    /// The triangle that `f` is paired with.
    #[inline]
    pub fn mate(&self, f: TriangleId) -> TriangleId {
        self.mate[f]
    }

    /// Number of pairs.
    pub fn pair_count(&self) -> usize {
        self.mate.len() / 2
    }

    /// The pairs, each with its lower triangle first, in order of those.
    pub fn pairs(&self) -> impl Iterator<Item = (TriangleId, TriangleId)> {
        self.mate.ids().map(|f| (f, self.mate[f])).filter(|(f, g)| f.index() < g.index())
    }
}
