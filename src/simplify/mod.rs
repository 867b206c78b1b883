//! Simplification to an exact number of vertices that keeps the topology: edges are contracted in
//! order of quadric error (Garland and Heckbert, *Surface Simplification Using Quadric Error
//! Metrics*, SIGGRAPH 1997) where the link condition holds. Stands in for the tool that made A2 to
//! A5 of A1 and B2 to B5 of B1 (Lemos et al., section 4, Table 4.2).
//!
//! Edges wait in a [`Tournament`]. A contraction prices the edges of the vertex that it leaves anew;
//! an edge that is refused for its triangles or degrees waits behind all others until something
//! changes near it, or until nothing better is left.

mod placement;
mod quadric;
mod shape;
mod tournament;
mod vector;

use placement::{Placement, Point};
use quadric::Quadric;
use shape::{Face, Limits, STAGES};
use tournament::Tournament;
use vector::{Vector, cross, difference, scaled};

pub use shape::Shape;

use crate::mesh::FaceList;
use crate::triangulation::{
    HalfEdgeId, Id, IdVec, LinkMarks, ShrinkingTriangulation, Triangulation, VertexId,
};

/// Why a triangulation cannot be simplified to the number of vertices asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SimplifyError {
    /// There are not as many vertices.
    #[error("{wanted} vertices wanted, but there are only {present}")]
    TooMany {
        /// Vertices asked for.
        wanted: usize,
        /// Vertices there are.
        present: usize,
    },
    /// Every edge left fails the link condition: the triangulation is irreducible, at least in the
    /// order in which edges were contracted.
    #[error(
        "{wanted} vertices wanted, but with {reached} left no edge can be contracted without a \
         change of topology"
    )]
    Irreducible {
        /// Vertices asked for.
        wanted: usize,
        /// Vertices left.
        reached: usize,
    },
}

/// A triangulation on its way to fewer vertices.
///
/// Genus and components stay what they are. Deterministic: equal input gives equal bytes on every
/// machine. A vertex costs about 220 bytes, the triangulation (56 of them) included.
///
/// ```
/// # use triquad::{Triangulation, mesh::FaceList, simplify::Simplifier};
/// # let octahedron = vec![
/// #     [0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5],
/// # ];
/// # let positions = vec![
/// #     [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0],
/// #     [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0],
/// # ];
/// # let list = FaceList::from_triangles(positions, octahedron);
/// let triangulation = Triangulation::build(&list)?;
/// let mut simplifier = Simplifier::new(triangulation, &list.positions);
/// simplifier.reduce_to(5)?;
/// let (five, triangulation) = simplifier.result();
/// assert_eq!((five.positions.len(), triangulation.genus()), (5, 0));
/// simplifier.reduce_to(4)?; // goes on where it was
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Simplifier {
    triangulation: ShrinkingTriangulation,
    points: IdVec<VertexId, Point>,
    /// Keys of edges, at the smaller of their half-edges.
    queue: Tournament,
    /// Whether an edge at the vertex may have been refused since all of them were priced.
    has_refused: IdVec<VertexId, bool>,
    marks: LinkMarks,
    /// Whether an edge may have become possible without having been priced anew.
    stale: bool,
    /// Length of the input, at which prices of all sizes of mesh are alike.
    scale: f64,
}

/// Refused edges of vertices of larger degree are priced anew only when nothing else is left.
const SMALL_DEGREE: u32 = 64;

impl Simplifier {
    /// Prices all edges of a triangulation built from a list with these positions. O(n).
    ///
    /// # Panics
    /// If there are fewer positions than vertices.
    pub fn new(triangulation: Triangulation, positions: &[Vector]) -> Self {
        let vertices = triangulation.vertex_id_count();
        let triangulation = ShrinkingTriangulation::of(triangulation);
        let scale = power_of_two_near_extent(positions);
        let at = |&position: &Vector| Point {
            position: scaled(position, 1.0 / scale),
            quadric: Quadric::default(),
        };
        let points: Vec<Point> = positions[..vertices].iter().map(at).collect();
        let mut simplifier = Self {
            triangulation,
            points: points.into(),
            queue: Tournament::new(std::iter::empty::<u32>().collect::<Vec<_>>().into_iter()),
            has_refused: IdVec::filled(false, vertices),
            marks: LinkMarks::new(vertices),
            stale: false,
            scale,
        };
        simplifier.gather_planes();
        simplifier.price_all();
        simplifier
    }

    /// Number of vertices left; those that no triangle uses do not count.
    pub fn vertex_count(&self) -> usize {
        self.triangulation.vertex_count()
    }

    /// Contracts edges until `vertices` are left. O(n log n) for bounded degrees, linear in practice.
    ///
    /// # Errors
    /// There are fewer already, or topology stands in the way; what has been reached then stays.
    pub fn reduce_to(&mut self, vertices: usize) -> Result<(), SimplifyError> {
        let present = self.vertex_count();
        if vertices > present {
            return Err(SimplifyError::TooMany { wanted: vertices, present });
        }
        while self.vertex_count() > vertices {
            match self.queue.first() {
                Some((edge, key)) => self.attempt(HalfEdgeId::new(edge), key),
                None if self.stale => self.price_all(),
                None => {
                    let reached = self.vertex_count();
                    return Err(SimplifyError::Irreducible { wanted: vertices, reached });
                }
            }
        }
        Ok(())
    }

    /// The vertices and triangles left, in their old order. O(n) of the input.
    pub fn result(&self) -> (FaceList, Triangulation) {
        let (survivors, triangulation) = self.triangulation.survivors();
        let position = |&v: &VertexId| scaled(self.points[v].position, self.scale);
        let positions = survivors.iter().map(position).collect();
        let corners = |f| triangulation.corners(f).map(|v| v.index() as u32);
        let triangles = triangulation.triangles().map(corners).collect();
        (FaceList::from_triangles(positions, triangles), triangulation)
    }

    /// Contracts an edge, or says when to try again.
    fn attempt(&mut self, h: HalfEdgeId, key: u32) {
        let stage = stage_of(key);
        let limits = &STAGES[stage];
        let later = if !self.degrees_allow(h, limits) {
            next_stage(key)
        } else if !self.triangulation.is_contractible(h, &mut self.marks) {
            Tournament::ABSENT
        } else if let Some(point) = self.allowed_point(h, stage) {
            return self.contract(h, point);
        } else {
            next_stage(key)
        };
        self.queue.set(h.index(), later);
        for v in [self.triangulation.origin(h), self.triangulation.destination(h)] {
            self.has_refused[v] = true;
        }
    }

    #[inline]
    fn degrees_allow(&self, h: HalfEdgeId, limits: &Limits) -> bool {
        let ends = [self.triangulation.origin(h), self.triangulation.destination(h)];
        let [one, other] = ends.map(|v| self.triangulation.degree(v));
        one + other - 4 <= limits.degree
    }

    /// The best point for the vertex that the edge becomes that the limits of the stage allow.
    fn allowed_point(&self, h: HalfEdgeId, stage: usize) -> Option<Point> {
        let limits = &STAGES[stage];
        let (u, v) = (self.triangulation.origin(h), self.triangulation.destination(h));
        let best = Placement::best(&self.points[u], &self.points[v]).point;
        let worst = self.worst_roundness(u).min(self.worst_roundness(v));
        let allowed = |point: &Point| {
            limits.any_triangle()
                || (self.triangles_allow(u, v, point.position, limits, worst)
                    && self.triangles_allow(v, u, point.position, limits, worst))
        };
        if allowed(&best) {
            return Some(best);
        }
        if stage == 0 {
            return None;
        }
        let others = Placement::others(&self.points[u], &self.points[v]);
        others.into_iter().map(|other| other.point).find(allowed)
    }

    /// The least roundness, squared, of a triangle at `v`.
    fn worst_roundness(&self, v: VertexId) -> f64 {
        let k = &self.triangulation;
        let round = |h: HalfEdgeId| {
            let corners = h.triangle().half_edges().map(|side| self.points[k.origin(side)].position);
            Face::new(corners[0], corners[1], corners[2]).roundness
        };
        k.spokes(v).map(round).fold(1.0, f64::min)
    }

    /// Whether all triangles at `v` that do not contain `other` may have `v` moved to `place`.
    fn triangles_allow(
        &self,
        v: VertexId,
        other: VertexId,
        place: Vector,
        limits: &Limits,
        worst: f64,
    ) -> bool {
        let k = &self.triangulation;
        let here = self.points[v].position;
        k.spokes(v).all(|h| {
            let (a, b) = (k.destination(h), k.origin(h.prev()));
            if a == other || b == other {
                return true;
            }
            let [a, b] = [a, b].map(|corner| self.points[corner].position);
            limits.allow(&Face::new(here, a, b), &Face::new(place, a, b), worst)
        })
    }

    /// Contracts an edge into the end with more edges, puts that at `point`, and prices what changed.
    fn contract(&mut self, h: HalfEdgeId, point: Point) {
        let k = &self.triangulation;
        let more = k.degree(k.destination(h)) > k.degree(k.origin(h));
        let h = if more { k.twin(h) } else { h };
        let (gone, apexes) = (k.destination(h), [h, k.twin(h)]);
        for side in apexes.iter().flat_map(|side| side.triangle().half_edges()) {
            self.queue.set(side.index(), Tournament::ABSENT);
        }
        let u = k.origin(h);
        let _ = gone;
        let _ = self.triangulation.contract(h);
        self.points[u] = point;
        self.price_star(u);
        self.reconsider_refused_round(u);
    }

    /// Prices the edges at `u`.
    fn price_star(&mut self, u: VertexId) {
        for h in self.triangulation.spokes(u) {
            let twin = self.triangulation.twin(h);
            self.queue.set(h.max(twin).index(), Tournament::ABSENT);
            self.queue.set(h.min(twin).index(), self.price(h.min(twin)));
        }
        self.has_refused[u] = false;
    }

    /// Prices edges anew that were refused, at the neighbours of `u`: what they were refused for may
    /// have changed. Nothing farther away has.
    fn reconsider_refused_round(&mut self, u: VertexId) {
        for spoke in self.triangulation.spokes(u) {
            let v = self.triangulation.destination(spoke);
            if !self.has_refused[v] {
                continue;
            }
            if self.triangulation.degree(v) > SMALL_DEGREE {
                self.stale = true;
                continue;
            }
            self.has_refused[v] = false;
            for h in self.triangulation.spokes(v) {
                let edge = h.min(self.triangulation.twin(h));
                if stage_of(self.queue.key(edge.index())) > 0 {
                    self.queue.set(edge.index(), self.price(edge));
                }
            }
        }
    }

    /// The key of an edge that has not been refused.
    #[inline]
    fn price(&self, h: HalfEdgeId) -> u32 {
        let [u, v] = [self.triangulation.origin(h), self.triangulation.destination(h)];
        first_key(Placement::best(&self.points[u], &self.points[v]).cost)
    }

    /// Prices all edges.
    fn price_all(&mut self) {
        let k = &self.triangulation;
        let price = |h| {
            let h = HalfEdgeId::new(h);
            let is_edge = h < k.twin(h) && k.is_alive(h.triangle());
            if is_edge { self.price(h) } else { Tournament::ABSENT }
        };
        self.queue = Tournament::new((0..k.half_edge_id_count()).map(price));
        self.stale = false;
    }

    /// Gives every vertex the planes of its triangles.
    fn gather_planes(&mut self) {
        for first in (0..self.triangulation.half_edge_id_count()).step_by(3) {
            let sides = HalfEdgeId::new(first).triangle().half_edges();
            let corners = sides.map(|h| self.triangulation.origin(h));
            let [p, q, r] = corners.map(|v| self.points[v].position);
            let plane = Quadric::of_triangle(cross(difference(q, p), difference(r, p)));
            for v in corners {
                self.points[v].quadric = self.points[v].quadric.plus(&plane);
            }
        }
    }
}

/// Keys order by stage, then by cost: an upper and a lower part.
const STAGE_BIT: u32 = 29;

fn stage_of(key: u32) -> usize {
    (key >> STAGE_BIT) as usize
}

/// The key of an edge of this cost at the first stage. Costs are cut to 4 significant bits: among
/// edges nearly alike those near each other in memory go first.
fn first_key(cost: f64) -> u32 {
    let cost = if cost < f64::from(f32::MAX) { cost as f32 } else { f32::MAX };
    (cost.to_bits() >> 2) & !((1 << key_bits()) - 1)
}

fn key_bits() -> u32 {
    static K: std::sync::OnceLock<u32> = std::sync::OnceLock::new();
    *K.get_or_init(|| std::env::var("KB").map_or(18, |s| s.parse().unwrap()))
}

fn next_stage(key: u32) -> u32 {
    if stage_of(key) + 1 < STAGES.len() { key + (1 << STAGE_BIT) } else { Tournament::ABSENT }
}

/// A power of two, so that scaling by it and back changes no bit.
fn power_of_two_near_extent(positions: &[Vector]) -> f64 {
    let half_extent = |axis: usize| {
        let along = || positions.iter().map(|position| 0.5 * position[axis]);
        along().fold(f64::NEG_INFINITY, f64::max) - along().fold(f64::INFINITY, f64::min)
    };
    let extent = half_extent(0).max(half_extent(1)).max(half_extent(2));
    // The sign and the fraction of the number cut off.
    let power = f64::from_bits(extent.abs().to_bits() & 0x7ff0_0000_0000_0000);
    if power.is_normal() && (1.0 / power).is_normal() { power } else { 1.0 }
}
