//! Where the two ends of a contracted edge meet, and what that costs.

use super::quadric::Quadric;
use super::vector::{Vector, difference, scaled, square, sum};

/// A vertex: where it is, and the planes of all triangles that it has come from.
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

/// What length counts for: nearly nothing beside an error one can see, but where the surface is
/// flat it decides, so that short edges go first and vertices stay evenly spread.
const LENGTH: f64 = 1e-6;

impl Placement {
    /// The best place: the midpoint or an end if that has no error, so that flat faces, straight
    /// creases and corners stay exactly what they are, and else the minimum of the quadrics
    /// (Garland and Heckbert, section 4). O(1).
    pub fn best(u: &Point, v: &Point) -> Self {
        let edge = difference(v.position, u.position);
        let both = together(u, v, edge);
        let middle = scaled(edge, 0.5);
        let bulk = both.area() * square(edge);
        let [at_u, at_v, at_middle] = [both.here(), both.at(edge), both.at(middle)];
        let (place, error) = if at_middle <= ROUNDING * bulk {
            (Place::Middle, at_middle)
        } else if at_u.min(at_v) <= ROUNDING * bulk {
            if at_u <= at_v { (Place::U, at_u) } else { (Place::V, at_v) }
        } else {
            let optimum = both.minimum(LENGTH * both.area(), middle);
            let least = at_u.min(at_v).min(at_middle);
            let error = both.at(optimum);
            // Written so that a place which is no number is far.
            let near = square(difference(optimum, middle)) <= square(edge);
            if near && error <= least {
                (Place::At(optimum), error)
            } else if at_middle == least {
                (Place::Middle, at_middle)
            } else if at_u == least {
                (Place::U, at_u)
            } else {
                (Place::V, at_v)
            }
        };
        Self::at(place, u, v, edge, &both, error.max(0.0) + LENGTH * bulk)
    }

    /// The two ends and the midpoint, the cheaper ones first. O(1).
    pub fn others(u: &Point, v: &Point) -> [Self; 3] {
        let edge = difference(v.position, u.position);
        let both = together(u, v, edge);
        let middle = scaled(edge, 0.5);
        let errors = [both.here(), both.at(edge), both.at(middle)];
        let mut places = [(Place::U, errors[0]), (Place::V, errors[1]), (Place::Middle, errors[2])];
        places.sort_by(|a, b| a.1.total_cmp(&b.1));
        places.map(|(place, error)| Self::at(place, u, v, edge, &both, error))
    }

    #[inline]
    fn at(place: Place, u: &Point, v: &Point, edge: Vector, both: &Quadric, cost: f64) -> Self {
        let (position, offset) = match place {
            Place::U => (u.position, [0.0; 3]),
            Place::V => (v.position, edge),
            Place::Middle => {
                let halves = [u, v].map(|end| scaled(end.position, 0.5));
                (sum(halves[0], halves[1]), scaled(edge, 0.5))
            }
            Place::At(offset) => (sum(u.position, offset), offset),
        };
        Self { point: Point { position, quadric: both.seen_from(offset) }, cost }
    }
}

/// Offsets count from u.
#[derive(Clone, Copy)]
enum Place {
    U,
    V,
    Middle,
    At(Vector),
}

/// Both quadrics, counted from u.
#[inline]
fn together(u: &Point, v: &Point, edge: Vector) -> Quadric {
    u.quadric.plus(&v.quadric.seen_from(scaled(edge, -1.0)))
}
