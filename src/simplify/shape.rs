//! Limits on the triangles and degrees that a contraction may leave, and measures of the result.

use crate::mesh::Mesh;
use crate::vector::{ORDINARY, Vector, cross, difference, dot, square, to_unit_size};

/// Limits of one stage; later stages are used where nothing else is left.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Most edges at the vertex that an edge becomes.
    pub degree: u32,
    /// Least cosine of the angle by which a triangle may turn.
    turn: f64,
    /// Least `Face::roundness`, unless one was less before.
    pub roundness: f64,
    /// True if triangles have no limits.
    pub any_triangle: bool,
}

const fn limits(degree: u32, turn: f64, roundness: f64) -> Limits {
    Limits { degree, turn, roundness, any_triangle: false }
}

const fn any_triangle(degree: u32) -> Limits {
    Limits { degree, turn: -1.0, roundness: 0.0, any_triangle: true }
}

/// Stage by stage. At the last one only the link condition counts.
pub const STAGES: [Limits; 5] = [
    limits(9, 0.5, 0.09),
    limits(10, 0.2, 0.02),
    limits(12, 0.0, 0.001),
    any_triangle(24),
    any_triangle(u32::MAX),
];

impl Limits {
    /// Returns whether a triangle `before` may become `after` as far as its normal goes.
    #[inline]
    pub fn allow_turn(&self, before: &Face, after: &Face) -> bool {
        let turned = dot(before.normal, after.normal);
        let product = square(before.normal) * square(after.normal);
        // A triangle without area has no normal to turn.
        product == 0.0 || (turned > 0.0 && turned * turned >= self.turn * self.turn * product)
    }
}

/// A triangle's normal, twice its area long, and its roundness.
#[derive(Clone, Copy, Debug)]
pub struct Face {
    normal: Vector,
    /// The square of 4√3 area / (sum of squared sides): 1 if equilateral, 0 without area.
    pub roundness: f64,
}

impl Face {
    /// Measures the triangle with these corners.
    #[inline]
    pub fn new(p: Vector, q: Vector, r: Vector) -> Self {
        let [one, two, three] = [difference(q, p), difference(r, p), difference(r, q)];
        let normal = cross(one, two);
        let sides = square(one) + square(two) + square(three);
        let roundness = 12.0 * square(normal) / (sides * sides);
        // All corners in one point: 0 / 0.
        Self { normal, roundness: if roundness.is_finite() { roundness } else { 0.0 } }
    }
}

/// Largest degree and extreme angles of a triangulation.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Shape {
    /// Most edges at a vertex.
    pub largest_degree: u32,
    /// Cosine of the smallest angle of a triangle.
    pub smallest_angle_cosine: f64,
    /// Cosine of the largest angle of a triangle.
    pub largest_angle_cosine: f64,
}

impl Shape {
    /// Measures the triangles of `list`. The angles of triangles with sides of no length are taken
    /// for 0 and 180 degrees. O(n).
    ///
    /// # Panics
    /// If `list` holds anything but triangles of its vertices.
    pub fn new(list: &Mesh) -> Self {
        assert_eq!(list.faces().arity(), Some(3), "only triangles have a shape");
        let mut degrees = vec![0u32; list.positions().len()];
        let (mut smallest, mut largest) = (-1.0f64, 1.0f64);
        for corners in list.faces().corners().as_chunks::<3>().0 {
            let corners = corners.map(|v| v as usize);
            corners.iter().for_each(|&v| degrees[v] += 1);
            let [p, q, r] = corners.map(|v| list.positions()[v]);
            let cosines = [cosine_at(p, q, r), cosine_at(q, r, p), cosine_at(r, p, q)];
            for cosine in cosines {
                match cosine {
                    Some(cosine) => {
                        smallest = smallest.max(cosine);
                        largest = largest.min(cosine);
                    }
                    None => (smallest, largest) = (1.0, -1.0),
                }
            }
        }
        Self {
            largest_degree: degrees.into_iter().max().unwrap_or(0),
            smallest_angle_cosine: smallest,
            largest_angle_cosine: largest,
        }
    }

    /// Returns the smallest angle in degrees; its last digits may differ between machines.
    pub fn smallest_angle(&self) -> f64 {
        self.smallest_angle_cosine.acos().to_degrees()
    }

    /// Returns the largest angle in degrees; its last digits may differ between machines.
    pub fn largest_angle(&self) -> f64 {
        self.largest_angle_cosine.acos().to_degrees()
    }
}

/// Returns the cosine of the angle at `p`, or `None` if a side there has no length.
fn cosine_at(p: Vector, q: Vector, r: Vector) -> Option<f64> {
    let [mut one, mut two] = [difference(q, p), difference(r, p)];
    if ![one, two].into_iter().all(|side| ORDINARY.contains(&square(side))) {
        [[one], [two]] = [to_unit_size([one]), to_unit_size([two])];
    }
    let cosine = dot(one, two) / (square(one).sqrt() * square(two).sqrt());
    cosine.is_finite().then(|| cosine.clamp(-1.0, 1.0))
}
