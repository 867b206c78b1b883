//! Sets of edges of a surface.

use super::ids::HalfEdgeId;
use super::surface::Surface;

/// A set of edges of a surface. One byte a triangle.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct EdgeSet {
    /// Bit `i` of entry `f`: side `i` of triangle `f`. Both sides of an edge have equal bits.
    bits: Vec<u8>,
    count: usize,
}

impl EdgeSet {
    /// Makes the empty set of edges of a surface. O(n).
    pub fn empty(surface: &impl Surface) -> Self {
        Self { bits: vec![0; surface.triangle_count()], count: 0 }
    }

    /// Adds the edge of a side. Returns whether it is new.
    ///
    /// # Panics
    /// If the set is that of another surface and the side does not exist.
    pub fn insert(&mut self, surface: &impl Surface, side: HalfEdgeId) -> bool {
        let is_new = !self.contains(side);
        for side in [Some(side), surface.across(side)].into_iter().flatten() {
            self.bits[side.triangle().index()] |= 1 << (side.index() % 3);
        }
        self.count += usize::from(is_new);
        is_new
    }

    /// Returns whether the edge of a side is in the set.
    #[inline]
    pub fn contains(&self, side: HalfEdgeId) -> bool {
        self.bits[side.triangle().index()] >> (side.index() % 3) & 1 != 0
    }

    /// Returns the sides of a triangle whose edges are in the set: bit `i` stands for side `i`.
    #[inline]
    pub(crate) fn sides(&self, triangle: usize) -> u8 {
        self.bits[triangle]
    }

    /// Returns the number of edges.
    pub fn len(&self) -> usize {
        self.count
    }

    /// Returns whether no edge is in the set.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }
}
