//! Cuts of one polygon into triangles, by shape.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use crate::vector::{cross, difference, dot};

/// A triangle, by the places of its corners in the polygon.
pub(super) type Triangle = [u32; 3];

/// Polygons up to this many corners get the best of all cuts; the time is cubic.
const SMALL: usize = 16;

/// A polygon with distinct corners in space.
pub(super) struct Polygon {
    points: Vec<[f64; 3]>,
    normal: [f64; 3],
}

impl Polygon {
    /// Makes a polygon, scaled to size 1 so that nothing overflows.
    pub(super) fn new(points: impl Iterator<Item = [f64; 3]>) -> Self {
        let mut points: Vec<_> = points.map(|point| point.map(|x| x / 2.0)).collect();
        let origin = points[0];
        points.iter_mut().for_each(|point| *point = difference(*point, origin));
        let size = points.as_flattened().iter().fold(0.0, |size: f64, x| size.max(x.abs()));
        if size > 0.0 {
            points.iter_mut().for_each(|point| *point = point.map(|x| x / size));
        }
        let normal = normal(&points);
        Self { points, normal }
    }

    /// Returns 1 for a regular triangle, 0 for one without area, less if it is turned.
    pub(super) fn shape(&self, triangle: Triangle) -> f64 {
        let [p, q, r] = triangle.map(|corner| self.points[corner as usize]);
        let sides = [difference(q, p), difference(r, q), difference(p, r)];
        let squares = sides.map(|side| dot(side, side));
        let area = cross(sides[0], sides[1]);
        let sum = squares[0] + squares[1] + squares[2];
        let value = 12_f64.sqrt() * dot(area, area).sqrt() / sum;
        match value {
            _ if value.is_nan() => 0.0,
            _ if dot(area, self.normal) < 0.0 => -value,
            _ => value,
        }
    }

    /// Returns the best cut whose diagonals all have a price; none if there is none.
    ///
    /// The best has the least sum of prices, then the best worst shape, then the best sum of
    /// shapes. Of polygons of more than 16 corners, the best-shaped ears are cut off first.
    pub(super) fn cut(&self, price: &dyn Fn(u32, u32) -> Option<u32>) -> Option<Vec<Triangle>> {
        let (mut triangles, left) = self.clip_ears(price)?;
        triangles.extend(self.cut_best(&left, price)?);
        Some(triangles)
    }

    /// Cuts off ears until few corners are left; returns the ears and those corners.
    fn clip_ears(
        &self,
        price: &dyn Fn(u32, u32) -> Option<u32>,
    ) -> Option<(Vec<Triangle>, Vec<u32>)> {
        let n = self.points.len();
        if n <= SMALL {
            return Some((Vec::new(), (0..n as u32).collect()));
        }
        let mut before: Vec<u32> = (0..n as u32).map(|c| (c + n as u32 - 1) % n as u32).collect();
        let mut after: Vec<u32> = (0..n as u32).map(|c| (c + 1) % n as u32).collect();
        let ear = |before: &[u32], after: &[u32], c: u32| {
            let corners = [before[c as usize], c, after[c as usize]];
            Ear { shape: self.shape(corners), corners }
        };
        let mut heap: BinaryHeap<_> = (0..n as u32).map(|c| ear(&before, &after, c)).collect();
        let mut ears = Vec::new();
        while n - ears.len() > SMALL {
            let Ear { corners, .. } = heap.pop()?;
            let [p, c, q] = corners;
            let is_current = before[c as usize] == p && after[c as usize] == q;
            if !is_current || price(p, q).is_none() {
                continue;
            }
            ears.push(corners);
            (after[p as usize], before[q as usize]) = (q, p);
            (before[c as usize], after[c as usize]) = (c, c);
            heap.push(ear(&before, &after, p));
            heap.push(ear(&before, &after, q));
        }
        Some((ears, (0..n as u32).filter(|&c| after[c as usize] != c).collect()))
    }

    /// Returns the best cut of the polygon of some of the corners, by dynamic programming.
    fn cut_best(
        &self,
        corners: &[u32],
        price: &dyn Fn(u32, u32) -> Option<u32>,
    ) -> Option<Vec<Triangle>> {
        let n = corners.len();
        // The best cut of the corners from i to j, with its third corner over the side from j to i.
        let mut best = vec![Some((Value::NOTHING, 0)); n * n];
        for length in 2..n {
            for i in 0..n - length {
                let j = i + length;
                let is_side = length == n - 1;
                let own = if is_side { Some(0) } else { price(corners[i], corners[j]) };
                best[i * n + j] = own.and_then(|own| {
                    let values = (i + 1..j).filter_map(|k| {
                        let parts = [best[i * n + k]?.0, best[k * n + j]?.0];
                        let shape = self.shape([corners[i], corners[k], corners[j]]);
                        Some((Value::join(parts, own, shape), k))
                    });
                    // The last of equal ones: of a square, the cut at its first corner.
                    values.reduce(|a, b| if b.0.compare(&a.0).is_ge() { b } else { a })
                });
            }
        }
        best[n - 1]?;
        let mut triangles = Vec::with_capacity(n - 2);
        let mut open = vec![[0, n - 1]];
        while let Some([i, j]) = open.pop() {
            if j - i < 2 {
                continue;
            }
            let (_, k) = best[i * n + j]?;
            triangles.push([corners[i], corners[k], corners[j]]);
            open.extend([[k, j], [i, k]]);
        }
        Some(triangles)
    }
}

/// Returns the normal of a polygon, twice its area long (Newell).
fn normal(points: &[[f64; 3]]) -> [f64; 3] {
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).fold([0.0; 3], |sum, (&p, &q)| {
        let part = cross(p, q);
        [0, 1, 2].map(|axis| sum[axis] + part[axis])
    })
}

/// The value of a cut: better is greater.
#[derive(Clone, Copy)]
struct Value {
    price: u32,
    worst: f64,
    sum: f64,
}

impl Value {
    const NOTHING: Self = Self { price: 0, worst: f64::INFINITY, sum: 0.0 };

    /// Returns the value of two parts and a triangle between them, cut off at a price.
    fn join([a, b]: [Self; 2], price: u32, shape: f64) -> Self {
        Self {
            price: a.price + b.price + price,
            worst: a.worst.min(b.worst).min(shape),
            sum: a.sum + b.sum + shape,
        }
    }

    fn compare(&self, other: &Self) -> Ordering {
        let by_price = other.price.cmp(&self.price);
        by_price.then(self.worst.total_cmp(&other.worst)).then(self.sum.total_cmp(&other.sum))
    }
}

/// A corner that may be cut off, with its neighbours.
struct Ear {
    shape: f64,
    corners: Triangle,
}

impl Ord for Ear {
    fn cmp(&self, other: &Self) -> Ordering {
        self.shape.total_cmp(&other.shape).then(other.corners.cmp(&self.corners))
    }
}

impl PartialOrd for Ear {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Ear {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Ear {}
