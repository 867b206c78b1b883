//! Samples with a depth buffer: convex polygons in, an image out.
//!
//! Coverage is decided in whole numbers: corners are rounded to 1/256 of a sample and a sample on a
//! side belongs to one of the two polygons there, so that neighbours neither overlap nor leave
//! gaps.

use std::ops::Range;

use super::vector::Vector;

/// Fixed-point units per sample, a power of two.
const UNIT_BITS: u32 = 8;
const UNIT: f64 = (1 << UNIT_BITS) as f64;
const HALF_UNIT: i64 = 1 << (UNIT_BITS - 1);

/// Farthest corner that is distinguished, in fixed-point units: products of two differences fit an
/// i64.
const FARTHEST: f64 = (1 << 29) as f64;

/// A corner on the grid of fixed-point units.
pub type Corner = [i64; 2];

/// Returns the corner at screen coordinates `x` and `y`.
pub fn corner(x: f64, y: f64) -> Corner {
    [x, y].map(|x| (x * UNIT).round().clamp(-FARTHEST, FARTHEST) as i64)
}

/// Returns twice the area of a polygon in square fixed-point units; positive if x turns to y, as it
/// does clockwise on the screen.
pub fn doubled_area(corners: &[Corner]) -> i64 {
    let [first, ..] = corners else { return 0 };
    let fan = corners.windows(2);
    fan.map(|pair| {
        let [a, b] = [0, 1].map(|i| [pair[i][0] - first[0], pair[i][1] - first[1]]);
        a[0] * b[1] - a[1] * b[0]
    })
    .sum()
}

/// A depth that changes linearly over the screen, within bounds.
#[derive(Clone, Copy, Debug)]
pub struct Slope {
    at_origin: f64,
    by_x: f64,
    by_y: f64,
    low: f64,
    high: f64,
}

impl Slope {
    /// Makes the slope through three points of the screen, unless they lie on a line.
    pub fn through([a, b, c]: [Vector; 3]) -> Option<Self> {
        let (p, q) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
        let area = p[0] * q[1] - p[1] * q[0];
        let (to_b, to_c) = (b[2] - a[2], c[2] - a[2]);
        let by_x = (to_b * q[1] - to_c * p[1]) / area;
        let by_y = (to_c * p[0] - to_b * q[0]) / area;
        let slope = Self {
            at_origin: a[2] - by_x * a[0] - by_y * a[1],
            by_x,
            by_y,
            low: a[2].min(b[2]).min(c[2]),
            high: a[2].max(b[2]).max(c[2]),
        };
        slope.at_origin.is_finite().then_some(slope)
    }

    /// Makes the slope from `a` to `b`, constant across, unless the two are one.
    pub fn along(a: Vector, b: Vector) -> Option<Self> {
        let across = [a[0] - (b[1] - a[1]), a[1] + (b[0] - a[0]), a[2]];
        Self::through([a, b, across])
    }

    fn row(&self, y: usize) -> impl Fn(usize) -> f32 {
        let (low, high, by_x) = (self.low, self.high, self.by_x);
        let start = self.at_origin + self.by_y * (y as f64 + 0.5);
        move |x| (start + by_x * (x as f64 + 0.5)).max(low).min(high) as f32
    }
}

/// The face and the ink seen at every sample so far.
#[derive(Debug)]
pub struct Canvas {
    /// Samples in a row.
    pub width: usize,
    /// Rows of samples.
    pub height: usize,
    /// Nearness of the face seen, minus infinity where there is none.
    pub near: Vec<f32>,
    /// Colour of the face seen.
    pub colour: Vec<[u8; 3]>,
    /// Strength of the line above it.
    pub ink: Vec<u8>,
}

impl Canvas {
    /// Makes an empty canvas.
    pub fn new([width, height]: [usize; 2]) -> Self {
        let samples = width * height;
        Self {
            width,
            height,
            near: vec![f32::NEG_INFINITY; samples],
            colour: vec![[0; 3]; samples],
            ink: vec![0; samples],
        }
    }

    /// Paints a convex polygon, in either orientation, wherever it is nearer than what is there.
    pub fn paint(&mut self, corners: &mut [Corner], depth: &Slope, colour: [u8; 3]) {
        let width = self.width;
        for_each_span(corners, [width, self.height], |y, span| {
            let near = depth.row(y);
            for x in span {
                let (sample, value) = (y * width + x, near(x));
                if value > self.near[sample] {
                    self.near[sample] = value;
                    self.colour[sample] = colour;
                }
            }
        });
    }

    /// Inks a convex polygon wherever it is not behind a face; the strongest ink stays.
    pub fn ink(&mut self, corners: &mut [Corner], depth: &Slope, strength: u8) {
        let width = self.width;
        for_each_span(corners, [width, self.height], |y, span| {
            let near = depth.row(y);
            for x in span {
                let sample = y * width + x;
                if near(x) >= self.near[sample] {
                    self.ink[sample] = self.ink[sample].max(strength);
                }
            }
        });
    }
}

/// Visits the samples whose centres lie in a convex polygon, row by row. O(rows + samples).
fn for_each_span(
    corners: &mut [Corner],
    [width, height]: [usize; 2],
    mut visit: impl FnMut(usize, Range<usize>),
) {
    let area = doubled_area(corners);
    if area == 0 {
        return;
    }
    if area < 0 {
        corners.reverse();
    }
    let heights = corners.iter().map(|corner| corner[1]);
    let (top, bottom) = heights.fold((i64::MAX, i64::MIN), |(a, b), y| (a.min(y), b.max(y)));
    let first = first_from(top).max(0);
    let last = last_until(bottom).min(height as i64 - 1);
    for y in first..=last {
        let (mut left, mut right) = (0, width as i64 - 1);
        for (i, &from) in corners.iter().enumerate() {
            let to = corners[if i + 1 == corners.len() { 0 } else { i + 1 }];
            narrow(from, to, (y << UNIT_BITS) + HALF_UNIT, &mut left, &mut right);
        }
        if left <= right {
            visit(y as usize, left as usize..right as usize + 1);
        }
    }
}

/// Cuts from a row of samples, at height `y`, what is not to the right of the side `from → to`.
fn narrow(from: Corner, to: Corner, y: i64, left: &mut i64, right: &mut i64) {
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    // Of a side and its reverse exactly one has the samples on it.
    let owned = dy < 0 || (dy == 0 && dx > 0);
    // Inside is where dy · x <= most.
    let most = dx * (y - from[1]) + dy * from[0] - i64::from(!owned);
    if dy > 0 {
        *right = (*right).min(last_until(most.div_euclid(dy)));
    } else if dy < 0 {
        *left = (*left).max(first_from(-most.div_euclid(-dy)));
    } else if dx != 0 && most < 0 {
        *right = -1;
    }
}

/// Returns the first sample whose centre is not before `position`.
fn first_from(position: i64) -> i64 {
    -((HALF_UNIT - position) >> UNIT_BITS)
}

/// Returns the last sample whose centre is not after `position`.
fn last_until(position: i64) -> i64 {
    (position - HALF_UNIT) >> UNIT_BITS
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const SIZE: [usize; 2] = [9, 7];

    /// Returns how often each sample is visited.
    fn visits(polygons: &mut [Vec<Corner>]) -> Vec<u32> {
        let mut visits = vec![0; SIZE[0] * SIZE[1]];
        for corners in polygons {
            for_each_span(corners, SIZE, |y, span| {
                span.for_each(|x| visits[y * SIZE[0] + x] += 1);
            });
        }
        visits
    }

    /// On which side of `a → b` the centre of a sample is: its sign.
    fn side(a: Corner, b: Corner, sample: usize) -> i64 {
        let centre = [sample % SIZE[0], sample / SIZE[0]].map(|i| 256 * i as i64 + 128);
        let [p, q] = [b, centre].map(|end| [end[0] - a[0], end[1] - a[1]]);
        (p[0] * q[1] - p[1] * q[0]).signum()
    }

    /// Half samples, so that many samples lie exactly on sides, and places far outside.
    fn grid_corner() -> impl Strategy<Value = Corner> {
        let coordinate =
            prop_oneof![9 => (-4..24i64).prop_map(|x| 128 * x), 1 => -900_000..900_000i64];
        [coordinate.clone(), coordinate]
    }

    proptest! {
        #[test]
        fn a_triangle_has_the_samples_inside_and_none_outside(
            triangle in [grid_corner(), grid_corner(), grid_corner()],
        ) {
            let [a, b, c] = triangle;
            // A corner that is there twice, as a section may leave it, changes nothing.
            let visits = visits(&mut [vec![a, b, b, c]]);
            for (sample, &count) in visits.iter().enumerate() {
                let sides = [(a, b), (b, c), (c, a)].map(|(a, b)| side(a, b, sample));
                let inside = sides == [1; 3] || sides == [-1; 3];
                let outside = sides.contains(&1) && sides.contains(&-1);
                prop_assert!(count <= 1 && (!inside || count == 1) && (!outside || count == 0));
            }
        }

        /// Triangles around a point inside a rectangle over the whole canvas.
        #[test]
        fn neighbours_neither_overlap_nor_leave_gaps(
            x in 0..18i64,
            y in 0..14i64,
            flip in any::<bool>(),
        ) {
            let corners = [[0, 0], [2304, 0], [2304, 1792], [0, 1792]];
            let hub = [128 * x, 128 * y];
            let triangle = |i: usize| vec![corners[i], corners[(i + 1) % 4], hub];
            let mut fan: Vec<_> = (0..4).map(triangle).collect();
            if flip {
                fan[2].reverse();
            }
            prop_assert!(visits(&mut fan).iter().all(|&count| count == 1));
        }
    }
}
