//! A plane that takes away a part of the mesh, so that one sees inside.

use super::camera::Projection;
use super::error::PictureError;
use super::vector::{Vector, between, dot, unit};

/// Takes away everything on the side of a plane to which its normal points, cutting faces exactly.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// A point of the plane, in the coordinates of the mesh.
    pub point: [f64; 3],
    /// Normal of the plane; the length does not matter.
    pub normal: [f64; 3],
}

/// The section in view coordinates.
#[derive(Debug)]
pub struct Cut {
    normal: Vector,
    offset: f64,
}

impl Cut {
    /// Turns the section to view coordinates as `projection` shows it.
    pub fn new(section: &Section, projection: &Projection) -> Result<Self, PictureError> {
        let normal = unit(section.normal).ok_or(PictureError::Section)?;
        let (normal, point) = (projection.turn(normal), projection.view(section.point));
        let offset = dot(normal, point);
        if offset.is_finite() { Ok(Self { normal, offset }) } else { Err(PictureError::Section) }
    }

    /// Returns the distance of a point on the side that is taken away; negative on the other.
    fn beyond(&self, point: Vector) -> f64 {
        dot(self.normal, point) - self.offset
    }

    /// Returns whether nothing of a triangle is taken away.
    pub fn keeps(&self, triangle: &[Vector; 3]) -> bool {
        triangle.iter().all(|&point| self.beyond(point) <= 0.0)
    }

    /// Passes the corners of the rest of a convex polygon to `keep`, in order.
    pub fn clip(&self, polygon: &[Vector], mut keep: impl FnMut(Vector)) {
        for (i, &from) in polygon.iter().enumerate() {
            let to = polygon[if i + 1 == polygon.len() { 0 } else { i + 1 }];
            let (here, there) = (self.beyond(from), self.beyond(to));
            if here <= 0.0 {
                keep(from);
            }
            if (here <= 0.0) != (there <= 0.0) {
                keep(self.crossing(from, to));
            }
        }
    }

    /// Returns the rest of a segment.
    pub fn clip_segment(&self, [from, to]: [Vector; 2]) -> Option<[Vector; 2]> {
        match [from, to].map(|point| self.beyond(point) <= 0.0) {
            [true, true] => Some([from, to]),
            [true, false] => Some([from, self.crossing(from, to)]),
            [false, true] => Some([self.crossing(from, to), to]),
            [false, false] => None,
        }
    }

    /// Returns the point where a segment crosses the plane, the same point to the last bit in both
    /// directions, so that the faces on both sides of an edge still meet.
    fn crossing(&self, from: Vector, to: Vector) -> Vector {
        let (kept, lost) = if self.beyond(from) <= 0.0 { (from, to) } else { (to, from) };
        let (here, there) = (self.beyond(kept), self.beyond(lost));
        debug_assert!(here <= 0.0 && there > 0.0);
        between(kept, lost, here / (here - there))
    }
}
