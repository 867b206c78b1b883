//! Edge contraction, and the vertex split that undoes it
//! (Ramaswami-Siqueira, section 4.5 and Algorithm 4.7; Lemos et al., section 3.3).
//!
//! A contraction rewrites nothing inside the two triangles that it removes: only the twins of the
//! four half-edges round them change, and the origins of the spokes that move from one end to the
//! other. The removed triangles thus keep their surroundings, and a split needs one half-edge only.
//! Departs from the paper, whose edge records have no counterpart here.

use super::half_edges::{Side, Triangulation};
use super::ids::{HalfEdgeId, IdVec, TriangleId, VertexId};
use super::receipt::VertexSplit;
use super::spokes::Spokes;
use super::surroundings::{Surroundings, join};

/// A triangulation whose edges can be contracted, and the contractions undone last-in first-out.
///
/// Ids are kept: a contraction retires a vertex and two triangles, its split revives them, and
/// nothing is renumbered in between. 24 bytes a triangle and 8 a vertex.
#[derive(Clone, Debug)]
pub struct ShrinkingTriangulation {
    pub(super) sides: IdVec<HalfEdgeId, Side>,
    pub(super) star: IdVec<VertexId, Star>,
    pub(super) vertices: usize,
    pub(super) components: usize,
}

/// Data of one vertex. Both are stored together because they change together.
#[derive(Clone, Copy, Debug)]
pub(super) struct Star {
    /// A half-edge that leaves the vertex; none for retired and unreferenced vertices.
    pub(super) outgoing: HalfEdgeId,
    /// Number of edges at the vertex; undefined for a retired vertex.
    pub(super) degree: u32,
}

impl Star {
    /// Nothing leaves the vertex.
    const LONELY: Self = Self { outgoing: HalfEdgeId::NONE, degree: 0 };

    /// Counts half-edge `h`, which leaves the vertex.
    #[inline]
    fn add(&mut self, h: HalfEdgeId) {
        self.outgoing = h;
        self.degree += 1;
    }
}

/// Outcome of one contraction.
pub(crate) struct Contraction {
    pub(crate) receipt: VertexSplit,
    /// The apexes of the two triangles that are gone.
    pub(crate) apexes: [VertexId; 2],
    /// The half-edge from the end that stayed to the second apex. It is a new one; that to the
    /// first apex stays the same.
    pub(crate) spoke_to_second: HalfEdgeId,
}

impl From<Triangulation> for ShrinkingTriangulation {
    /// Takes a triangulation over, with all its ids. O(n).
    fn from(triangulation: Triangulation) -> Self {
        let Triangulation { sides, vertices, unreferenced, components } = triangulation;
        let mut star = IdVec::filled(Star::LONELY, vertices);
        for (h, side) in sides.as_slice().iter().enumerate() {
            star[side.origin].add(HalfEdgeId::new(h));
        }
        Self { sides, star, vertices: vertices - unreferenced, components }
    }
}

impl From<&Triangulation> for ShrinkingTriangulation {
    /// Copies a triangulation, with all its ids. O(n); faster than taking a clone over.
    fn from(triangulation: &Triangulation) -> Self {
        let mut star = IdVec::filled(Star::LONELY, triangulation.vertices);
        let sides = triangulation.sides().iter().enumerate().map(|(h, &side)| {
            star[side.origin].add(HalfEdgeId::new(h));
            side
        });
        Self {
            sides: sides.collect::<Vec<_>>().into(),
            star,
            vertices: triangulation.vertices - triangulation.unreferenced,
            components: triangulation.components,
        }
    }
}

impl ShrinkingTriangulation {
    /// Returns the vertex that half-edge `h` leaves.
    #[inline]
    pub fn origin(&self, h: HalfEdgeId) -> VertexId {
        self.sides[h].origin
    }

    /// Returns the vertex that half-edge `h` leads to.
    #[inline]
    pub fn destination(&self, h: HalfEdgeId) -> VertexId {
        self.sides[h.next()].origin
    }

    /// Returns the other side of the edge of `h`.
    #[inline]
    pub fn twin(&self, h: HalfEdgeId) -> HalfEdgeId {
        self.sides[h].twin
    }

    /// Returns the number of edges at `v`, which must not be retired.
    #[inline]
    pub fn degree(&self, v: VertexId) -> u32 {
        self.star[v].degree
    }

    /// Returns a half-edge that leaves `v`, or `None` if `v` is retired or in no triangle.
    #[inline]
    pub fn outgoing(&self, v: VertexId) -> Option<HalfEdgeId> {
        self.star[v].outgoing.some()
    }

    /// Returns whether triangle `f` has not been removed by a contraction.
    pub fn is_alive(&self, f: TriangleId) -> bool {
        f.half_edges().iter().all(|&h| self.star[self.origin(h)].outgoing != HalfEdgeId::NONE)
    }

    /// Iterates over the half-edges that leave `v`, clockwise. O(deg v).
    ///
    /// # Panics
    /// If `v` is retired or in no triangle.
    pub fn spokes(&self, v: VertexId) -> Spokes<'_> {
        let first = self.star[v].outgoing.some().expect("only a vertex in use has spokes");
        Spokes::round(&self.sides, first)
    }

    /// Returns the apexes of the two triangles at the edge of `h`: first that of the triangle of
    /// `h`.
    #[inline]
    pub fn apexes(&self, h: HalfEdgeId) -> [VertexId; 2] {
        [self.origin(h.prev()), self.origin(self.twin(h).prev())]
    }

    /// Iterates over the spokes that contracting `h` moves, clockwise. They are the spokes of the
    /// destination of `h` except those to its origin and to the apexes.
    #[inline]
    pub fn far_spokes(&self, h: HalfEdgeId) -> Spokes<'_> {
        let first = self.twin(h.next()).next();
        Spokes::between(&self.sides, first, self.twin(self.twin(h).prev()))
    }

    /// Returns the number of vertices left.
    pub fn vertex_count(&self) -> usize {
        self.vertices
    }

    /// Returns the number of vertices of the triangulation it began as; vertex ids are below it.
    pub fn vertex_id_count(&self) -> usize {
        self.star.len()
    }

    /// Returns the number of half-edges of the triangulation it began as; half-edge ids are below
    /// it.
    pub fn half_edge_id_count(&self) -> usize {
        self.sides.len()
    }

    /// Returns whether the component of the edge of `h` is a tetrahedron, whose edges cannot be
    /// contracted although they satisfy the link condition. There both ends have degree 3.
    #[inline]
    pub fn is_in_tetrahedron(&self, h: HalfEdgeId) -> bool {
        self.star[self.origin(h)].degree == 3 && self.star[self.destination(h)].degree == 3
    }

    /// Contracts the edge of `h` into the origin of `h`, retiring its destination and the two
    /// triangles at the edge. O(deg v) for the vertex v that goes.
    ///
    /// # Panics
    /// In debug builds, if the edge is retired or its component is a tetrahedron. The caller must
    /// have checked the link condition: without it the result is no triangulation.
    pub fn contract(&mut self, h: HalfEdgeId) -> VertexSplit {
        let e = Surroundings::new(&self.sides, h);
        let centre = self.origin(h);
        e.move_spokes(&mut self.sides, centre);
        self.close(h, &e).receipt
    }

    /// Contracts like [`ShrinkingTriangulation::contract`], for callers that already have the far
    /// spokes of `h`.
    #[inline]
    pub(crate) fn contract_with(
        &mut self,
        h: HalfEdgeId,
        far_spokes: impl Iterator<Item = HalfEdgeId>,
    ) -> Contraction {
        let centre = self.origin(h);
        far_spokes.for_each(|spoke| self.sides[spoke].origin = centre);
        self.close(h, &Surroundings::new(&self.sides, h))
    }

    /// Contracts the edge of `h`, whose far spokes have been moved already.
    #[inline]
    fn close(&mut self, h: HalfEdgeId, e: &Surroundings) -> Contraction {
        let (u, v) = (self.origin(h), self.origin(e.hp));
        let (x, y) = (self.origin(e.b), self.origin(e.d));
        debug_assert!(self.is_alive(h.triangle()) && self.twin(e.hp) == h);
        debug_assert!(!self.is_in_tetrahedron(h));
        self.sides[e.td].origin = u;
        join(&mut self.sides, e.ta, e.tb);
        join(&mut self.sides, e.tc, e.td);
        self.star[u].outgoing = e.td;
        self.star[v].outgoing = HalfEdgeId::NONE;
        self.star[x].outgoing = e.ta;
        self.star[y].outgoing = e.tc;
        self.star[x].degree -= 1;
        self.star[y].degree -= 1;
        self.star[u].degree = self.star[u].degree + self.star[v].degree - 4;
        self.vertices -= 1;
        Contraction { receipt: VertexSplit(h), apexes: [x, y], spoke_to_second: e.td }
    }

    /// Undoes the last contraction that has not been undone: origins, twins and degrees are bit for
    /// bit what they were. O(deg v).
    ///
    /// # Panics
    /// In debug builds, if a later contraction of the neighbourhood has not been undone.
    pub fn split(&mut self, receipt: VertexSplit) {
        let VertexSplit(h) = receipt;
        let e = Surroundings::new(&self.sides, h);
        let degree = e.split(&mut self.sides);
        let (u, v) = (self.origin(h), self.origin(e.hp));
        let (x, y) = (self.origin(e.b), self.origin(e.d));
        self.star[u].outgoing = h;
        self.star[v].outgoing = e.hp;
        self.star[x].outgoing = e.b;
        self.star[y].outgoing = e.d;
        self.star[x].degree += 1;
        self.star[y].degree += 1;
        self.star[v].degree = degree;
        self.star[u].degree = self.star[u].degree + 4 - degree;
        self.vertices += 1;
    }

    /// Iterates over the spokes that the last contraction, that of `receipt`, has moved to the end
    /// that stayed.
    pub fn moved_spokes(&self, receipt: &VertexSplit) -> Spokes<'_> {
        // The removed triangles at the edge still hold their surroundings.
        self.far_spokes(receipt.0)
    }

    /// Returns the vertices that are left, in order, and the triangulation that they and the
    /// triangles that are left form, both renumbered in order. O(n + m log m) for m triangles left.
    pub fn survivors(&self) -> (Vec<VertexId>, Triangulation) {
        let alive = |&v: &VertexId| self.star[v].outgoing != HalfEdgeId::NONE;
        let survivors: Vec<VertexId> = self.star.ids().filter(alive).collect();
        debug_assert_eq!(survivors.len(), self.vertices);
        let mut renumbered = IdVec::filled(0, self.star.len());
        for (new, &old) in survivors.iter().enumerate() {
            renumbered[old] = new as u32;
        }
        let left = self.triangles_round(&survivors);
        let mut place = IdVec::filled(0, self.sides.len() / 3);
        for (new, &f) in left.iter().enumerate() {
            place[f] = new as u32;
        }
        let moved = |h: HalfEdgeId| HalfEdgeId(3 * place[h.triangle()] + h.0 % 3);
        let side =
            |h| Side { origin: VertexId(renumbered[self.origin(h)]), twin: moved(self.twin(h)) };
        let sides: Vec<Side> = left.iter().flat_map(|f| f.half_edges()).map(side).collect();
        let triangulation = Triangulation {
            sides: sides.into(),
            vertices: survivors.len(),
            unreferenced: 0,
            components: self.components,
        };
        (survivors, triangulation)
    }

    /// Returns the triangles round `vertices`, in order. Removed triangles are not visited. O(m log
    /// m) for m triangles.
    fn triangles_round(&self, vertices: &[VertexId]) -> Vec<TriangleId> {
        let spokes = vertices.iter().flat_map(|&v| self.spokes(v));
        let first_sides = spokes.filter(|h| h.0.is_multiple_of(3));
        let mut triangles: Vec<TriangleId> = first_sides.map(HalfEdgeId::triangle).collect();
        triangles.sort_unstable();
        triangles
    }
}
