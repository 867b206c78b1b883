//! The dual graph with a Pulli-Segal rank beside each triangle's neighbours.

use crate::dual::{DualGraph, Row, Sides};
use crate::prefetch::prefetch;
use crate::triangulation::{TriangleId, Triangulation};

/// Number of the priority set of an unpaired triangle; the highest goes first.
///
/// A triangle's priority never falls: edges are locked and never freed. So each triangle enters
/// each queue at most once, parallel edges apart, and an entry is out of date exactly if the
/// priority has changed since.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) enum Priority {
    /// In no set any more: paired, or left alone with no free edge.
    Done,
    /// Set 0: three free edges.
    ThreeFree,
    /// Set 1: two free edges, both shared with triangles of set 0.
    TwoFreeToLowest,
    /// Set 2: two free edges.
    TwoFree,
    /// Set 3: one free edge or none.
    AtMostOneFree,
}

/// A triangle's priority and, below it, how long it has had that: the greatest rank goes first.
///
/// Time is a number below 2^29.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Rank(u32);

impl Rank {
    pub(super) const AGE_BITS: u32 = 29;

    pub(super) const fn new(priority: Priority, entered: u32) -> Self {
        Self(((priority as u32 + 1) << Self::AGE_BITS) - 1 - entered)
    }

    /// Returns the priority that the rank was made of.
    pub(super) fn priority(self) -> Priority {
        match self.0 >> Self::AGE_BITS {
            0 => Priority::Done,
            1 => Priority::ThreeFree,
            2 => Priority::TwoFreeToLowest,
            3 => Priority::TwoFree,
            _ => Priority::AtMostOneFree,
        }
    }
}

impl Priority {
    /// Returns the priority of an unpaired triangle between neighbours of these priorities.
    pub(super) fn among(around: [Self; 3]) -> Self {
        let count = |priority| around.iter().map(|&p| usize::from(p == priority)).sum::<usize>();
        match (count(Self::Done), count(Self::ThreeFree)) {
            (0, _) => Self::ThreeFree,
            (1, 2) => Self::TwoFreeToLowest,
            (1, _) => Self::TwoFree,
            _ => Self::AtMostOneFree,
        }
    }
}

/// A dual graph in which each triangle has a rank. 16 bytes a triangle.
///
/// A triangle's neighbours and its rank share a cache line: the greedy algorithm reads both.
pub(super) struct RankedGraph {
    rows: Vec<Row>,
    has_boundary: bool,
}

impl RankedGraph {
    const START: Rank = Rank::new(Priority::ThreeFree, 0);

    /// Makes the ranked dual graph of `triangulation`, every triangle in set 0. O(n).
    pub(super) fn new(triangulation: &Triangulation) -> Self {
        Self { rows: DualGraph::rows_of(triangulation, |_| Self::START.0), has_boundary: false }
    }

    /// Copies `graph` and puts every triangle in set 0. O(n).
    pub(super) fn copy_of(graph: &DualGraph) -> Self {
        let ranked = |row: &Row| Row { beside: Self::START.0, ..*row };
        Self { rows: graph.rows().iter().map(ranked).collect(), has_boundary: graph.has_boundary() }
    }

    /// Returns the graph without the ranks. O(1).
    pub(super) fn into_dual(self) -> DualGraph {
        DualGraph::from_rows(self.rows, self.has_boundary)
    }

    /// Returns the number of triangles.
    pub(super) fn len(&self) -> usize {
        self.rows.len()
    }

    /// Iterates over all triangles in order.
    pub(super) fn triangles(&self) -> impl ExactSizeIterator<Item = TriangleId> + use<> {
        (0..self.len()).map(TriangleId::new)
    }

    /// Returns whether some triangle has a side without a neighbour.
    pub(super) fn has_boundary(&self) -> bool {
        self.has_boundary
    }

    /// Returns the triangles across the three sides of `f`.
    #[inline]
    pub(super) fn sides(&self, f: TriangleId) -> [TriangleId; 3] {
        self.rows[f.index()].sides
    }

    /// Returns the rank of `f`; beyond a boundary everything is done.
    #[inline]
    pub(super) fn rank(&self, f: TriangleId) -> Rank {
        self.rows.get(f.index()).map_or(Rank::new(Priority::Done, 0), |row| Rank(row.beside))
    }

    /// Returns the priority of `f`; beyond a boundary everything is done.
    #[inline]
    pub(super) fn priority(&self, f: TriangleId) -> Priority {
        self.rank(f).priority()
    }

    /// Sets the rank of `f`.
    #[inline]
    pub(super) fn set_rank(&mut self, f: TriangleId, rank: Rank) {
        self.rows[f.index()].beside = rank.0;
    }

    /// Prefetches the sides and ranks of the neighbours of `f`.
    #[inline]
    pub(super) fn prefetch_around(&self, f: TriangleId) {
        self.sides(f).into_iter().for_each(|g| prefetch(&self.rows, g.index()));
    }
}

impl Sides for RankedGraph {
    #[inline]
    fn sides_or_none(&self, f: TriangleId) -> [TriangleId; 3] {
        self.sides(f)
    }
}
