//! Vertex splits on half-edges alone; no per-vertex data is kept.

use super::contraction::ShrinkingTriangulation;
use super::half_edges::{Side, Triangulation};
use super::ids::{HalfEdgeId, IdVec, VertexId};
use super::receipt::VertexSplit;
use super::surroundings::Surroundings;

/// A triangulation whose contractions are being undone: half-edges alone, so that a split touches
/// nothing else. 24 bytes a triangle.
#[derive(Debug)]
pub(crate) struct ExpandingTriangulation {
    pub(super) sides: IdVec<HalfEdgeId, Side>,
    pub(super) vertex_ids: usize,
    pub(super) vertices: usize,
    pub(super) components: usize,
}

/// Read access to half-edge connectivity, common to all triangulation types.
pub(crate) trait Connectivity {
    /// Returns the vertex that half-edge `h` leaves.
    fn origin(&self, h: HalfEdgeId) -> VertexId;

    /// Returns the other side of the edge of `h`.
    fn twin(&self, h: HalfEdgeId) -> HalfEdgeId;
}

impl Connectivity for ExpandingTriangulation {
    #[inline]
    fn origin(&self, h: HalfEdgeId) -> VertexId {
        self.sides[h].origin
    }

    #[inline]
    fn twin(&self, h: HalfEdgeId) -> HalfEdgeId {
        self.sides[h].twin
    }
}

impl Connectivity for ShrinkingTriangulation {
    #[inline]
    fn origin(&self, h: HalfEdgeId) -> VertexId {
        self.origin(h)
    }

    #[inline]
    fn twin(&self, h: HalfEdgeId) -> HalfEdgeId {
        self.twin(h)
    }
}

impl ShrinkingTriangulation {
    /// Drops the per-vertex data, so that only vertex splits remain possible. O(1).
    pub(crate) fn into_expanding(self) -> ExpandingTriangulation {
        let Self { sides, star, vertices, components } = self;
        ExpandingTriangulation { sides, vertex_ids: star.len(), vertices, components }
    }

    /// Returns the triangulation that it began as, when every contraction has been undone. O(1).
    ///
    /// # Panics
    /// In debug builds, if a contraction has not been undone.
    pub fn into_triangulation(self) -> Triangulation {
        self.into_expanding().into_triangulation()
    }
}

impl ExpandingTriangulation {
    /// Returns the number of half-edges when every contraction has been undone; ids are below it.
    pub(crate) fn half_edge_id_count(&self) -> usize {
        self.sides.len()
    }

    /// Returns the number of vertices when every contraction has been undone, with those that no
    /// triangle uses; ids are below it.
    pub(crate) fn vertex_id_count(&self) -> usize {
        self.vertex_ids
    }

    /// Returns the surroundings of the edge of the last contraction that has not been undone.
    #[inline]
    pub(crate) fn surroundings(&self, receipt: &VertexSplit) -> Surroundings {
        Surroundings::new(&self.sides, receipt.half_edge())
    }

    /// Returns the surroundings where edges have been flipped since the contraction. `moved` maps a
    /// half-edge of that time, on no flipped edge, to its present place if it has moved.
    #[inline]
    pub(crate) fn surroundings_among_flips(
        &mut self,
        receipt: &VertexSplit,
        moved: impl Fn(HalfEdgeId) -> Option<HalfEdgeId>,
    ) -> Surroundings {
        let mut e = self.surroundings(receipt);
        let outer = [&mut e.ta, &mut e.tb, &mut e.tc, &mut e.td];
        for (side, twin) in [e.a, e.b, e.c, e.d].into_iter().zip(outer) {
            if let Some(place) = moved(*twin) {
                *twin = place;
                self.sides[side].twin = place;
            }
        }
        e
    }

    /// Undoes the last contraction that has not been undone, given the surroundings of its edge.
    /// Returns the degree of the vertex that comes back. O(that degree).
    #[inline]
    pub(crate) fn split(&mut self, receipt: VertexSplit, e: &Surroundings) -> u32 {
        debug_assert_eq!(receipt.half_edge(), e.h);
        self.vertices += 1;
        e.split(&mut self.sides)
    }

    /// Returns the triangulation that it began as, when every contraction has been undone. O(1).
    ///
    /// # Panics
    /// In debug builds, if a contraction has not been undone.
    pub(crate) fn into_triangulation(self) -> Triangulation {
        debug_assert_eq!(self.vertices_in_use(), self.vertices, "a contraction is not undone");
        let Self { sides, vertex_ids, vertices, components } = self;
        Triangulation {
            sides,
            vertices: vertex_ids,
            unreferenced: vertex_ids - vertices,
            components,
        }
    }

    /// Returns the number of vertices that a half-edge leaves, those of removed triangles among
    /// them. O(n).
    fn vertices_in_use(&self) -> usize {
        let mut in_use = IdVec::<VertexId, bool>::filled(false, self.vertex_ids);
        self.sides.as_slice().iter().for_each(|side| in_use[side.origin] = true);
        in_use.as_slice().iter().filter(|&&in_use| in_use).count()
    }
}

#[cfg(test)]
mod tests {
    use crate::irreducible::{Discipline, ramaswami_siqueira};
    use crate::samples::{surfaces, triangulation};
    use crate::triangulation::{ShrinkingTriangulation, VertexId};

    #[test]
    fn splits_are_those_of_a_shrinking_triangulation() {
        for surface in surfaces(20, 61) {
            let input = triangulation(&surface);
            let [one, other] = [(); 2].map(|()| {
                let k = ShrinkingTriangulation::from(input.clone());
                let order = (0..k.vertex_id_count()).map(VertexId::new);
                ramaswami_siqueira(k, order, Discipline::FirstInFirstOut)
            });
            let (mut k, mut t) = (one.triangulation, other.triangulation.into_expanding());
            for (split, same) in one.splits.into_iter().zip(other.splits).rev() {
                let h = split.half_edge();
                k.split(split);
                let e = t.surroundings(&same);
                assert_eq!(t.split(same, &e), k.degree(k.destination(h)));
                assert_eq!(t.sides, k.sides);
            }
            assert_eq!(t.into_triangulation(), input);
            assert_eq!(k.into_triangulation(), input);
        }
    }

    #[test]
    #[cfg(debug_assertions)]
    #[should_panic(expected = "a contraction is not undone")]
    fn what_is_still_contracted_is_no_triangulation() {
        let mut k =
            ShrinkingTriangulation::from(triangulation(&triquad_generators::classic::octahedron()));
        let edge = k.outgoing(VertexId::new(0)).unwrap();
        let _ = k.contract(edge);
        k.into_triangulation();
    }
}
