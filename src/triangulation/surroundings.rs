//! The half-edges round an edge that is contracted or split.

use super::half_edges::Side;
use super::ids::{HalfEdgeId, IdVec, VertexId};

/// The half-edges round edge `h` from u to v, named once for contraction and split.
///
/// ```text
///            x                 triangle (h, a, b):  u -> v -> x
///          ↗ | ↖               triangle (hp, c, d): v -> u -> y
///     tb / b   a \ ta          ta, tb, tc, td are the twins of a, b, c, d:
///      /  ---h-->  \           ta: x -> v,  tb: u -> x,  tc: y -> u,  td: v -> y
///     u  <--hp---   v
///      \           /
///     tc \ c   d / td
///          ↘ | ↙
///            y
/// ```
pub(crate) struct Surroundings {
    pub(crate) h: HalfEdgeId,
    pub(crate) hp: HalfEdgeId,
    pub(crate) a: HalfEdgeId,
    pub(crate) b: HalfEdgeId,
    pub(crate) c: HalfEdgeId,
    pub(crate) d: HalfEdgeId,
    pub(crate) ta: HalfEdgeId,
    pub(crate) tb: HalfEdgeId,
    pub(crate) tc: HalfEdgeId,
    pub(crate) td: HalfEdgeId,
}

impl Surroundings {
    /// Reads the surroundings from the two triangles at the edge of `h`. They are the same before
    /// and after a contraction.
    #[inline]
    pub(super) fn new(sides: &IdVec<HalfEdgeId, Side>, h: HalfEdgeId) -> Self {
        let hp = sides[h].twin;
        let (a, b) = (h.next(), h.prev());
        let (c, d) = (hp.next(), hp.prev());
        let [ta, tb, tc, td] = [a, b, c, d].map(|side| sides[side].twin);
        Self { h, hp, a, b, c, d, ta, tb, tc, td }
    }

    /// Moves the spokes of v, except those to u, x and y, to `centre`. Returns their number.
    #[inline]
    pub(super) fn move_spokes(&self, sides: &mut IdVec<HalfEdgeId, Side>, centre: VertexId) -> u32 {
        let mut moved = 0;
        let mut g = self.ta.next();
        while g != self.td {
            sides[g].origin = centre;
            moved += 1;
            g = sides[g].twin.next();
        }
        moved
    }

    /// Undoes the contraction of the edge on half-edges. Returns the degree of v. O(deg v).
    #[inline]
    pub(super) fn split(&self, sides: &mut IdVec<HalfEdgeId, Side>) -> u32 {
        debug_assert!(
            sides[self.ta].twin == self.tb && sides[self.tc].twin == self.td,
            "not the last receipt"
        );
        let v = sides[self.hp].origin;
        let moved = self.move_spokes(sides, v);
        sides[self.td].origin = v;
        join(sides, self.ta, self.a);
        join(sides, self.tb, self.b);
        join(sides, self.tc, self.c);
        join(sides, self.td, self.d);
        moved + 3
    }
}

/// Makes `g` and `h` the two sides of one edge.
#[inline]
pub(super) fn join(sides: &mut IdVec<HalfEdgeId, Side>, g: HalfEdgeId, h: HalfEdgeId) {
    sides[g].twin = h;
    sides[h].twin = g;
}
