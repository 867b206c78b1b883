//! Quadrics: the sum of squared distances to planes as a polynomial of degree two (Garland and
//! Heckbert, *Surface Simplification Using Quadric Error Metrics*, SIGGRAPH 1997, section 5).
//!
//! Departs from the paper: planes are weighted by area, and each quadric counts from a point of its
//! own instead of the common origin, which keeps the zeros of flat regions free of cancellation.

use crate::vector::{Vector, difference, dot, scaled, sum};

/// x ↦ xᵀAx + 2bᵀx + c for x relative to some point, in length units to the fourth power.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Quadric {
    /// A by rows, from the diagonal on.
    a: [f64; 6],
    b: Vector,
    c: f64,
}

impl Quadric {
    /// Makes the quadric of the plane of a triangle through the point counted from, for a third of
    /// its area; `normal` is the cross product of two sides.
    pub fn from_triangle(normal: Vector) -> Self {
        let twice_area = dot(normal, normal).sqrt();
        if twice_area == 0.0 {
            return Self::default();
        }
        let [x, y, z] = normal;
        let weight = 1.0 / (6.0 * twice_area);
        let a = [x * x, x * y, x * z, y * y, y * z, z * z].map(|product| product * weight);
        Self { a, b: [0.0; 3], c: 0.0 }
    }

    /// Returns the sum of both, which must count from the same point.
    #[inline]
    pub fn plus(&self, other: &Self) -> Self {
        let a = std::array::from_fn(|k| self.a[k] + other.a[k]);
        Self { a, b: sum(self.b, other.b), c: self.c + other.c }
    }

    /// Returns the same quadric, counted from the point at `offset`.
    #[inline]
    pub fn seen_from(&self, offset: Vector) -> Self {
        let b = sum(self.b, self.times(offset));
        Self { a: self.a, b, c: self.c + dot(self.b, offset) + dot(b, offset) }
    }

    /// Returns the value at `x`; it is negative only by rounding.
    #[inline]
    pub fn at(&self, x: Vector) -> f64 {
        dot(x, self.times(x)) + 2.0 * dot(self.b, x) + self.c
    }

    /// Returns the value at the point counted from.
    #[inline]
    pub fn here(&self) -> f64 {
        self.c
    }

    /// Returns the total area of the planes: the trace of A, as normals have length 1.
    #[inline]
    pub fn area(&self) -> f64 {
        self.a[0] + self.a[3] + self.a[5]
    }

    /// Returns the point where the quadric plus `pull` times the squared distance to `anchor` is
    /// least. The pull makes flat and straight places definite (after Trettner and Kobbelt, *Fast
    /// and Robust QEM Minimization using Probabilistic Quadrics*, 2020). Not finite if there is no
    /// such point.
    #[inline]
    pub fn minimum(&self, pull: f64, anchor: Vector) -> Vector {
        let [xx, xy, xz, yy, yz, zz] = self.a;
        let (xx, yy, zz) = (xx + pull, yy + pull, zz + pull);
        let right = difference(scaled(anchor, pull), self.b);
        let cofactors = [
            yy * zz - yz * yz,
            xz * yz - xy * zz,
            xy * yz - xz * yy,
            xx * zz - xz * xz,
            xy * xz - xx * yz,
            xx * yy - xy * xy,
        ];
        let determinant = xx * cofactors[0] + xy * cofactors[1] + xz * cofactors[2];
        scaled(product(&cofactors, right), 1.0 / determinant)
    }

    #[inline]
    fn times(&self, x: Vector) -> Vector {
        product(&self.a, x)
    }
}

/// Returns a symmetric matrix, given by rows from the diagonal on, times a vector.
#[inline]
fn product([xx, xy, xz, yy, yz, zz]: &[f64; 6], [x, y, z]: Vector) -> Vector {
    [xx * x + xy * y + xz * z, xy * x + yy * y + yz * z, xz * x + yz * y + zz * z]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vector::cross;

    const CORNERS: [[Vector; 3]; 3] = [
        [[0.0, 0.0, 0.0], [2.0, 0.0, 1.0], [0.0, 3.0, 1.0]],
        [[1.0, 1.0, 0.0], [2.0, 5.0, 1.0], [0.0, 3.0, -1.0]],
        [[1.0, -1.0, 4.0], [2.0, 2.0, 2.0], [-3.0, 3.0, 1.0]],
    ];

    fn normal([p, q, r]: [Vector; 3]) -> Vector {
        cross(difference(q, p), difference(r, p))
    }

    /// Returns a third of the area times the squared distance to each plane.
    fn plainly(x: Vector) -> f64 {
        let of_plane = |corners: [Vector; 3]| {
            let n = normal(corners);
            let height = dot(n, difference(x, corners[0]));
            height * height / dot(n, n).sqrt() / 6.0
        };
        CORNERS.map(of_plane).iter().sum()
    }

    fn whole() -> Quadric {
        let of = |corners: [Vector; 3]| {
            Quadric::from_triangle(normal(corners)).seen_from(scaled(corners[0], -1.0))
        };
        CORNERS.map(of).iter().fold(Quadric::default(), |all, one| all.plus(one))
    }

    fn assert_near(a: f64, b: f64) {
        assert!((a - b).abs() < 1e-9, "{a} is not {b}");
    }

    #[test]
    fn quadrics_are_sums_of_squared_distances_wherever_they_count_from() {
        let q = whole();
        for x in [[0.0; 3], [1.0, 2.0, 3.0], [-4.0, 0.5, 0.25]] {
            assert_near(q.at(x), plainly(x));
            assert_near(q.seen_from(x).here(), plainly(x));
            let offset = [0.5, -1.0, 2.0];
            assert_near(q.seen_from(offset).at(difference(x, offset)), plainly(x));
        }
        assert_near(q.area(), CORNERS.map(|c| dot(normal(c), normal(c)).sqrt() / 6.0).iter().sum());
    }

    #[test]
    fn the_minimum_is_where_all_planes_meet_or_else_at_the_anchor() {
        let meeting = whole().minimum(0.0, [0.0; 3]);
        assert_near(whole().at(meeting), 0.0);
        let flat = Quadric::from_triangle([0.0, 0.0, 2.0]);
        let [x, y, z] = flat.minimum(1e-6, [3.0, 4.0, 5.0]);
        assert_near(x, 3.0);
        assert_near(y, 4.0);
        assert!(z.abs() < 1e-4);
        assert!(!flat.minimum(0.0, [0.0; 3])[0].is_finite());
    }
}
