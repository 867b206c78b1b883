//! Simplification to an exact number of vertices that keeps the topology: edges are contracted in
//! order of quadric error (Garland and Heckbert, *Surface Simplification Using Quadric Error
//! Metrics*, SIGGRAPH 1997) where the link condition holds. It takes the place of the tool that
//! made A2 to A5 of A1 and B2 to B5 of B1 (Lemos et al., section 4, Table 4.2).
//!
//! Edges wait in a tournament tree. A contraction prices the edges of the vertex that it leaves
//! anew; an edge that is refused for its triangles or degrees waits behind all others until
//! something changes near it, or until nothing better is left.
//!
//! [`Simplifier`] has an example. The functions of its parts have no examples of their own.

mod key;
mod placement;
mod quadric;
mod rule;
mod shape;
mod tournament;

use crate::vector::{Vector, cross, difference, scaled};
use placement::{Placement, Point};
use quadric::Quadric;
use rule::{placement, price};
use shape::{Face, Limits, STAGES};
use tournament::Tournament;

pub use rule::Rule;
pub use shape::Shape;

use crate::counted::counted;
use crate::mesh::Mesh;
use crate::triangulation::{
    HalfEdgeId, IdVec, LinkMarks, ShrinkingTriangulation, TriangleId, Triangulation, VertexId,
};

/// Reason why a triangulation cannot be simplified to the requested number of vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SimplifyError {
    /// There are not as many vertices.
    #[error("{} wanted, but there are only {present}", vertices(*.wanted))]
    TooMany {
        /// Requested number of vertices.
        wanted: usize,
        /// Vertices there are.
        present: usize,
    },
    /// Every edge left fails the link condition: the triangulation is irreducible, at least in the
    /// order in which edges were contracted.
    #[error(
        "{} wanted, but with {reached} left no edge can be contracted without a change of topology",
        vertices(*.wanted)
    )]
    Irreducible {
        /// Requested number of vertices.
        wanted: usize,
        /// Vertices left.
        reached: usize,
    },
}

fn vertices(count: usize) -> String {
    counted(count, "vertex", "vertices")
}

/// A triangulation on its way to fewer vertices.
///
/// Genus and components stay what they are. Deterministic: equal input gives equal bytes on every
/// machine. A vertex costs about 220 bytes, the triangulation (56 of them) included.
///
/// ```
/// # use triquad::{Triangulation, mesh::Mesh, simplify::Simplifier};
/// # let octahedron = vec![
/// #     [0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5],
/// # ];
/// # let positions = vec![
/// #     [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0],
/// #     [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0],
/// # ];
/// # let list = Mesh::from_triangles(positions, octahedron);
/// let triangulation = Triangulation::build(&list)?;
/// let mut simplifier = Simplifier::new(triangulation, list.positions());
/// simplifier.reduce_to(5)?;
/// let (five, triangulation) = simplifier.result();
/// assert_eq!((five.positions().len(), triangulation.genus()), (5, 0));
/// simplifier.reduce_to(4)?; // goes on where it was
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Simplifier {
    triangulation: ShrinkingTriangulation,
    points: IdVec<VertexId, Point>,
    /// Keys of edges, at the smaller of their half-edges.
    queue: Tournament,
    /// True if an edge at the vertex may have been refused since all of them were priced.
    has_refused: IdVec<VertexId, bool>,
    marks: LinkMarks,
    /// True if an edge may have become possible without having been priced anew.
    stale: bool,
    /// Length of the input, at which prices of all sizes of mesh are alike.
    scale: f64,
    rule: Rule,
}

/// Refused edges of vertices of larger degree are priced anew only when nothing else is left.
const SMALL_DEGREE: u32 = 64;

impl Simplifier {
    /// Takes a triangulation over and prices its edges; `positions` are those of the list that it
    /// was built from. O(n).
    ///
    /// # Panics
    /// If there are fewer positions than vertices.
    pub fn new(triangulation: Triangulation, positions: &[Vector]) -> Self {
        Self::with_rule(triangulation, positions, Rule::Guarded)
    }

    /// Does the same as [`Simplifier::new`] by another rule.
    ///
    /// # Panics
    /// If there are fewer positions than vertices.
    pub fn with_rule(triangulation: Triangulation, positions: &[Vector], rule: Rule) -> Self {
        let vertices = triangulation.vertex_id_count();
        let triangulation = ShrinkingTriangulation::from(triangulation);
        let scale = power_of_two_near_extent(positions);
        let points = with_planes(&triangulation, &positions[..vertices], 1.0 / scale);
        Self {
            queue: all_priced(rule, &triangulation, &points),
            triangulation,
            points,
            has_refused: IdVec::filled(false, vertices),
            marks: LinkMarks::new(vertices),
            stale: false,
            scale,
            rule,
        }
    }

    /// Returns the number of vertices left; those that no triangle uses do not count.
    pub fn vertex_count(&self) -> usize {
        self.triangulation.vertex_count()
    }

    /// Contracts edges until `vertices` are left. O(n log n) for bounded degrees, linear in
    /// practice.
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
                None if self.stale => {
                    self.queue = all_priced(self.rule, &self.triangulation, &self.points);
                    self.stale = false;
                }
                None => {
                    let reached = self.vertex_count();
                    return Err(SimplifyError::Irreducible { wanted: vertices, reached });
                }
            }
        }
        Ok(())
    }

    /// Returns the vertices and triangles left, in their old order. O(n + m log m) for n vertices
    /// of the input and m left.
    pub fn result(&self) -> (Mesh, Triangulation) {
        let (survivors, triangulation) = self.triangulation.survivors();
        let position = |&v: &VertexId| scaled(self.points[v].position, self.scale);
        let positions = survivors.iter().map(position).collect();
        let corners = |f| triangulation.corners(f).map(|v| v.index() as u32);
        let triangles = triangulation.triangles().map(corners).collect();
        (Mesh::from_triangles(positions, triangles), triangulation)
    }

    /// Contracts an edge, or puts it back with a later key.
    fn attempt(&mut self, h: HalfEdgeId, key: u32) {
        // The link condition comes last: it seldom fails where the rest holds.
        let point = match self.rule {
            Rule::Guarded => self.guarded_point(h, key::stage(key)),
            Rule::Plain => Some(placement(self.rule, &self.triangulation, &self.points, h).point),
        };
        let later = match point {
            Some(point) if self.triangulation.is_contractible(h, &mut self.marks) => {
                return self.contract(h, point);
            }
            Some(_) => Tournament::ABSENT,
            None => key::later(key),
        };
        self.queue.set(h.index(), later);
        for v in [self.triangulation.origin(h), self.triangulation.destination(h)] {
            self.has_refused[v] = true;
        }
    }

    /// Returns the best point that the limits of the stage allow, if there is one.
    fn guarded_point(&self, h: HalfEdgeId, stage: usize) -> Option<Point> {
        let allowed = self.degrees_allow(h, &STAGES[stage]);
        if allowed { self.allowed_point(h, stage) } else { None }
    }

    #[inline]
    fn degrees_allow(&self, h: HalfEdgeId, limits: &Limits) -> bool {
        let ends = [self.triangulation.origin(h), self.triangulation.destination(h)];
        let [one, other] = ends.map(|v| self.triangulation.degree(v));
        one + other - 4 <= limits.degree
    }

    /// Returns the best point for the vertex that the edge becomes that the limits of the stage
    /// allow.
    fn allowed_point(&self, h: HalfEdgeId, stage: usize) -> Option<Point> {
        let ends = [self.triangulation.origin(h), self.triangulation.destination(h)];
        let [u, v] = ends.map(|end| &self.points[end]);
        let allowed = |point: &Point| self.triangles_allow(ends, point.position, &STAGES[stage]);
        let best = Placement::best(u, v).point;
        if allowed(&best) {
            return Some(best);
        }
        let others = if stage == 0 { &[][..] } else { &Placement::others(u, v) };
        others.iter().map(|other| other.point).find(allowed)
    }

    /// Returns whether the triangles at either end of an edge, but those at both, may have that end
    /// moved to `place`: none turns too far, and none is less round than allowed unless one was
    /// before.
    fn triangles_allow(&self, [u, v]: [VertexId; 2], place: Vector, limits: &Limits) -> bool {
        if limits.any_triangle {
            return true;
        }
        let (k, at) = (&self.triangulation, |v| self.points[v].position);
        let mut least = f64::INFINITY;
        for (end, other) in [(u, v), (v, u)] {
            for h in k.spokes(end) {
                let (a, b) = (k.destination(h), k.origin(h.prev()));
                if a == other || b == other {
                    continue;
                }
                let after = Face::new(place, at(a), at(b));
                if !limits.allow_turn(&Face::new(at(end), at(a), at(b)), &after) {
                    return false;
                }
                least = least.min(after.roundness);
            }
        }
        least >= limits.roundness || least >= self.least_roundness([u, v])
    }

    /// Returns the least roundness of a triangle at either end.
    fn least_roundness(&self, ends: [VertexId; 2]) -> f64 {
        let k = &self.triangulation;
        let roundness = |h: HalfEdgeId| {
            let sides = h.triangle().half_edges();
            let [p, q, r] = sides.map(|side| self.points[k.origin(side)].position);
            Face::new(p, q, r).roundness
        };
        ends.into_iter().flat_map(|end| k.spokes(end)).map(roundness).fold(1.0, f64::min)
    }

    /// Contracts an edge into the end with more edges, puts that at `point`, and prices what
    /// changed.
    fn contract(&mut self, h: HalfEdgeId, point: Point) {
        let k = &self.triangulation;
        let more = k.degree(k.destination(h)) > k.degree(k.origin(h));
        let h = if more { k.twin(h) } else { h };
        let (u, sides) = (k.origin(h), [h, k.twin(h)]);
        for side in sides.iter().flat_map(|side| side.triangle().half_edges()) {
            self.queue.set(side.index(), Tournament::ABSENT);
        }
        // The receipt is not kept: simplification is not undone.
        let _ = self.triangulation.contract(h);
        self.points[u] = point;
        self.price_star(u);
        match self.rule {
            Rule::Guarded => self.reconsider_refused_round(u),
            // What the link condition refused waits for a contraction into one of its ends.
            Rule::Plain => self.stale = true,
        }
    }

    /// Prices the edges at `u`.
    fn price_star(&mut self, u: VertexId) {
        for h in self.triangulation.spokes(u) {
            let twin = self.triangulation.twin(h);
            self.queue.set(h.max(twin).index(), Tournament::ABSENT);
            let key = price(self.rule, &self.triangulation, &self.points, h.min(twin));
            self.queue.set(h.min(twin).index(), key);
        }
        self.has_refused[u] = false;
    }

    /// Prices edges anew that were refused, at the neighbours of `u`: what they were refused for
    /// may have changed. Nothing farther away has.
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
                if key::stage(self.queue.key(edge.index())) > 0 {
                    self.queue.set(
                        edge.index(),
                        price(self.rule, &self.triangulation, &self.points, edge),
                    );
                }
            }
        }
    }
}

/// Prices all edges.
fn all_priced(
    rule: Rule,
    k: &ShrinkingTriangulation,
    points: &IdVec<VertexId, Point>,
) -> Tournament {
    let key = |h| {
        let h = HalfEdgeId::new(h);
        let is_edge = h < k.twin(h) && k.is_alive(h.triangle());
        if is_edge { price(rule, k, points, h) } else { Tournament::ABSENT }
    };
    Tournament::new((0..k.half_edge_id_count()).map(key))
}

/// Makes vertices at `positions` times `scale`, each with the planes of its triangles.
fn with_planes(
    k: &ShrinkingTriangulation,
    positions: &[Vector],
    scale: f64,
) -> IdVec<VertexId, Point> {
    let at = |&p: &Vector| Point { position: scaled(p, scale), quadric: Quadric::default() };
    let mut points: IdVec<VertexId, Point> = positions.iter().map(at).collect::<Vec<_>>().into();
    for f in (0..k.half_edge_id_count() / 3).map(TriangleId::new) {
        let corners = f.half_edges().map(|h| k.origin(h));
        let [p, q, r] = corners.map(|v| points[v].position);
        let plane = Quadric::from_triangle(cross(difference(q, p), difference(r, p)));
        for v in corners {
            points[v].quadric = points[v].quadric.plus(&plane);
        }
    }
    points
}

/// Returns a power of two near the extent, so that scaling by it and back changes no bit.
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
