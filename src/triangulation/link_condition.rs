//! The link condition, which decides whether an edge can be contracted (Ramaswami-Siqueira, section
//! 2).

use super::contraction::ShrinkingTriangulation;
use super::ids::{HalfEdgeId, IdVec, VertexId};

impl ShrinkingTriangulation {
    /// Returns whether contracting the edge of `h` keeps the surface: no vertex but the apexes of
    /// its two triangles is joined to both ends, and the component is not the tetrahedron
    /// (Ramaswami-Siqueira, section 2, *link condition*). O(deg u + deg v).
    pub fn is_contractible(&self, h: HalfEdgeId, marks: &mut LinkMarks) -> bool {
        let (u, v) = (self.origin(h), self.destination(h));
        if self.star[u].degree == 3 || self.star[v].degree == 3 {
            // A vertex of degree 3 has but one neighbour besides the apexes: the other end.
            return !self.is_in_tetrahedron(h);
        }
        marks.renew();
        for spoke in self.spokes(u) {
            marks.set(self.destination(spoke));
        }
        let common = self.spokes(v).filter(|&spoke| marks.has(self.destination(spoke))).count();
        debug_assert!(common >= 2, "the apexes are joined to both ends");
        common == 2
    }
}

/// Marks on vertices that are wiped in O(1), for [`ShrinkingTriangulation::is_contractible`].
#[derive(Clone, Debug)]
pub struct LinkMarks {
    stamp: IdVec<VertexId, u32>,
    now: u32,
}

impl LinkMarks {
    /// Makes unset marks for `vertices` vertices. O(n), 4 bytes a vertex.
    pub fn new(vertices: usize) -> Self {
        Self { stamp: IdVec::filled(0, vertices), now: 0 }
    }

    /// Unsets all marks.
    #[inline]
    fn renew(&mut self) {
        if self.now == u32::MAX {
            *self = Self::new(self.stamp.len());
        }
        self.now += 1;
    }

    #[inline]
    fn set(&mut self, v: VertexId) {
        self.stamp[v] = self.now;
    }

    #[inline]
    fn has(&self, v: VertexId) -> bool {
        self.stamp[v] == self.now
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn old_marks_do_not_come_back_when_the_clock_turns_over() {
        let mut marks = LinkMarks::new(2);
        let [one, other] = [VertexId(0), VertexId(1)];
        marks.renew();
        marks.set(one);
        marks.now = u32::MAX;
        marks.set(other);
        marks.renew();
        assert_eq!((marks.has(one), marks.has(other)), (false, false));
    }
}
