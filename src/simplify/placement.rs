//! Placement of the vertex that a contracted edge becomes, and its cost.

use super::quadric::Quadric;
use crate::vector::{Vector, difference, scaled, square, sum};

/// A vertex: its position, and the planes of all triangles that it has come from.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    pub position: Vector,
    /// Counted from `position`.
    pub quadric: Quadric,
}

/// A place for the vertex that an edge becomes.
#[derive(Clone, Copy, Debug)]
pub struct Placement {
    pub point: Point,
    /// Quadric error, and a little for the length of the edge.
    pub cost: f64,
}

/// Error that rounding can cause, relative to area times squared length.
const ROUNDING: f64 = 1e-12;

/// Weight of length: negligible beside a visible error. Where the surface is flat it decides, so
/// that short edges go first and vertices stay evenly spread.
const LENGTH: f64 = 1e-6;

impl Placement {
    /// Returns the best place: the midpoint or an end if that has no error, so that flat faces,
    /// straight creases and corners stay exactly what they are, and else the minimum of the
    /// quadrics (Garland and Heckbert, section 4). O(1).
    pub fn best(u: &Point, v: &Point) -> Self {
        let edge = difference(v.position, u.position);
        let both = together(u, v, edge);
        let middle = scaled(edge, 0.5);
        let bulk = both.area() * square(edge);
        let [at_u, at_v, at_middle] = [both.here(), both.at(edge), both.at(middle)];
        let (place, error) = if at_middle <= ROUNDING * bulk {
            (MergePoint::Middle, at_middle)
        } else if at_u.min(at_v) <= ROUNDING * bulk {
            if at_u <= at_v { (MergePoint::U, at_u) } else { (MergePoint::V, at_v) }
        } else {
            let optimum = both.minimum(LENGTH * both.area(), middle);
            let least = at_u.min(at_v).min(at_middle);
            let error = both.at(optimum);
            // Written so that NaN counts as far.
            let near = square(difference(optimum, middle)) <= square(edge);
            if near && error <= least {
                (MergePoint::At(optimum), error)
            } else if at_middle == least {
                (MergePoint::Middle, at_middle)
            } else if at_u == least {
                (MergePoint::U, at_u)
            } else {
                (MergePoint::V, at_v)
            }
        };
        Self::at(place, u, v, edge, &both, error.max(0.0) + LENGTH * bulk)
    }

    /// Returns the end with the lesser error, the first of two equal ones, at the cost of that
    /// error alone. O(1).
    pub fn cheaper_end(u: &Point, v: &Point) -> Self {
        let edge = difference(v.position, u.position);
        let both = together(u, v, edge);
        let [at_u, at_v] = [both.here(), both.at(edge)];
        let (place, error) =
            if at_u <= at_v { (MergePoint::U, at_u) } else { (MergePoint::V, at_v) };
        Self::at(place, u, v, edge, &both, error.max(0.0))
    }

    /// Returns the two ends and the midpoint, the cheaper ones first. O(1).
    pub fn others(u: &Point, v: &Point) -> [Self; 3] {
        let edge = difference(v.position, u.position);
        let both = together(u, v, edge);
        let middle = scaled(edge, 0.5);
        let errors = [both.here(), both.at(edge), both.at(middle)];
        let mut places = [
            (MergePoint::U, errors[0]),
            (MergePoint::V, errors[1]),
            (MergePoint::Middle, errors[2]),
        ];
        places.sort_by(|a, b| a.1.total_cmp(&b.1));
        places.map(|(place, error)| Self::at(place, u, v, edge, &both, error))
    }

    #[inline]
    fn at(
        place: MergePoint,
        u: &Point,
        v: &Point,
        edge: Vector,
        both: &Quadric,
        cost: f64,
    ) -> Self {
        let (position, offset) = match place {
            MergePoint::U => (u.position, [0.0; 3]),
            MergePoint::V => (v.position, edge),
            MergePoint::Middle => {
                let halves = [u, v].map(|end| scaled(end.position, 0.5));
                (sum(halves[0], halves[1]), scaled(edge, 0.5))
            }
            MergePoint::At(offset) => (sum(u.position, offset), offset),
        };
        Self { point: Point { position, quadric: both.seen_from(offset) }, cost }
    }
}

/// Offsets count from u.
#[derive(Clone, Copy)]
enum MergePoint {
    U,
    V,
    Middle,
    At(Vector),
}

/// Returns the sum of both quadrics, counted from u.
#[inline]
fn together(u: &Point, v: &Point, edge: Vector) -> Quadric {
    u.quadric.plus(&v.quadric.seen_from(scaled(edge, -1.0)))
}
