//! Matchings: which triangle is paired with which.

use std::ops::Range;

use super::graph::DualGraph;
use crate::parallel::{map, ranges};
use crate::prefetch::prefetch;
use crate::triangulation::{HalfEdgeId, IdVec, TriangleId};

/// A matching in a dual graph: disjoint pairs of edge-adjacent triangles. 4 bytes a triangle.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Matching {
    mate: IdVec<TriangleId, TriangleId>,
    unpaired: usize,
}

impl Matching {
    /// Makes the matching of `triangles` triangles that pairs none. O(n).
    pub fn empty(triangles: usize) -> Self {
        Self { mate: IdVec::filled(TriangleId::NONE, triangles), unpaired: triangles }
    }

    /// Makes the matching in which each triangle has this mate, or [`TriangleId::NONE`]. O(n).
    pub(crate) fn from_mates(mate: Vec<TriangleId>) -> Self {
        let unpaired = mate.iter().filter(|&&mate| mate == TriangleId::NONE).count();
        Self { mate: mate.into(), unpaired }
    }

    /// Returns the triangle that `f` is paired with, or `None` if it is unpaired.
    #[inline]
    pub fn mate(&self, f: TriangleId) -> Option<TriangleId> {
        self.mate[f].some()
    }

    /// Returns the mate as [`Matching::mate`] does, with [`TriangleId::NONE`] for no mate.
    #[inline]
    pub(crate) fn mate_or_none(&self, f: TriangleId) -> TriangleId {
        self.mate[f]
    }

    /// Prefetches the mate of `f`.
    #[inline]
    pub(crate) fn prefetch(&self, f: TriangleId) {
        prefetch(self.mate.as_slice(), f.index());
    }

    /// Returns whether `f` is paired.
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

    /// Pairs two triangles of which the caller has seen that they are unpaired. Reads nothing.
    #[inline]
    pub(crate) fn pair_unpaired(&mut self, f: TriangleId, g: TriangleId) {
        debug_assert!(f != g && !self.is_paired(f) && !self.is_paired(g));
        self.mate[f] = g;
        self.mate[g] = f;
        self.unpaired -= 2;
    }

    /// Takes `f` and its mate apart, if it has one.
    pub(crate) fn unpair(&mut self, f: TriangleId) {
        if let Some(mate) = self.mate(f) {
            self.mate[f] = TriangleId::NONE;
            self.mate[mate] = TriangleId::NONE;
            self.unpaired += 2;
        }
    }

    /// Returns the number of triangles, paired or not.
    pub fn len(&self) -> usize {
        self.mate.len()
    }

    /// Returns whether there is no triangle.
    pub fn is_empty(&self) -> bool {
        self.mate.is_empty()
    }

    /// Returns the number k of unpaired triangles.
    pub fn unpaired_count(&self) -> usize {
        self.unpaired
    }

    /// Iterates over the unpaired triangles in order. O(n) for all of them.
    pub fn unpaired(&self) -> impl Iterator<Item = TriangleId> {
        self.mate.ids().filter(|&f| !self.is_paired(f))
    }

    /// Iterates over the sides between two mates, those of the lower triangles, in order. O(n).
    ///
    /// A pair that shares several edges of `graph` lies across each of them.
    pub fn sides<'m>(&'m self, graph: &'m DualGraph) -> impl Iterator<Item = HalfEdgeId> + 'm {
        let is_inside = move |side: &HalfEdgeId| {
            let (f, beyond) =
                (side.triangle(), graph.sides_or_none(side.triangle())[side.index() % 3]);
            beyond != TriangleId::NONE && f < beyond && self.mate[f] == beyond
        };
        graph.triangles().flat_map(TriangleId::half_edges).filter(is_inside)
    }

    /// Pairs the ends of every new edge of an augmenting path.
    ///
    /// Each triangle of the path gets a new mate; the two ends of the path were unpaired before.
    pub(crate) fn replace_along(&mut self, new_pairs: &[(TriangleId, TriangleId)]) {
        for &(f, g) in new_pairs {
            self.mate[f] = g;
            self.mate[g] = f;
        }
        self.unpaired -= 2;
    }

    /// Returns whether mates are mutual and neighbours in `graph`, and the count of the unpaired is
    /// right. O(n).
    pub fn is_matching_of(&self, graph: &DualGraph) -> bool {
        let legal = |f: TriangleId| match self.mate(f) {
            Some(g) => self.mate[g] == f && graph.sides_or_none(f).contains(&g),
            None => true,
        };
        // Legal triangles of a range, and unpaired ones.
        let count = |range: Range<usize>| {
            let all = || range.clone().map(TriangleId::new);
            (all().filter(|&f| legal(f)).count(), all().filter(|&f| !self.is_paired(f)).count())
        };
        if self.len() != graph.len() {
            return false;
        }
        let counts = map(ranges(self.len()), count);
        let sum = |(legal, unpaired), (l, u)| (legal + l, unpaired + u);
        counts.into_iter().fold((0, 0), sum) == (self.len(), self.unpaired)
    }

    /// Proves that every triangle is paired with one across an edge of `graph`. O(n).
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
    /// Returns the triangle that `f` is paired with.
    #[inline]
    pub fn mate(&self, f: TriangleId) -> TriangleId {
        self.mate[f]
    }

    /// Returns the number of pairs.
    pub fn pair_count(&self) -> usize {
        self.mate.len() / 2
    }

    /// Iterates over the pairs in order of their lower triangles, which come first. O(n).
    pub fn pairs(&self) -> impl Iterator<Item = (TriangleId, TriangleId)> {
        self.pairs_from(0..self.mate.len())
    }

    /// Iterates over the pairs whose lower triangles are in this range, in order.
    pub(crate) fn pairs_from(
        &self,
        lower: Range<usize>,
    ) -> impl Iterator<Item = (TriangleId, TriangleId)> {
        let pairs = lower.map(TriangleId::new).map(|f| (f, self.mate[f]));
        pairs.filter(|(f, g)| f.index() < g.index())
    }
}
