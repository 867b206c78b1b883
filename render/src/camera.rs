//! The camera, and the map from its coordinates to the screen.

use super::error::PictureError;
use super::vector::{Vector, cross, dot, minus, unit};

/// Position and direction of the eye. The mesh, or what a section leaves of it, is fitted to the
/// image whatever its size.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    /// From the mesh to the eye; the length does not matter.
    pub direction: [f64; 3],
    /// The direction that is up in the image; another axis takes its place where it is parallel to
    /// `direction`.
    pub up: [f64; 3],
    /// Distance of the eye from the middle of the bounding box in half diagonals of the box, more
    /// than 1; None is a view from infinity: parallel lines stay parallel.
    pub distance: Option<f64>,
    /// The point in the middle of the image; None is the middle of what is seen.
    pub target: Option<[f64; 3]>,
    /// Enlargement; at 1 the whole mesh fits.
    pub zoom: f64,
    /// Share of the image that stays free on each side at zoom 1, below one half.
    pub margin: f64,
}

impl Default for Camera {
    fn default() -> Self {
        Self {
            direction: [0.45, 0.35, 1.0],
            up: [0.0, 1.0, 0.0],
            distance: Some(4.0),
            target: None,
            zoom: 1.0,
            margin: 0.03,
        }
    }
}

impl Camera {
    fn check(&self) -> Result<(), PictureError> {
        let vectors = [Some(self.direction), Some(self.up), self.target];
        let finite = vectors.iter().flatten().flatten().all(|x| x.is_finite());
        let wrong = if !finite {
            "a coordinate is not finite"
        } else if self.direction == [0.0; 3] {
            "the direction is zero"
        } else if self.distance.is_some_and(|distance| !(distance > 1.0 && distance.is_finite())) {
            "the distance is not above 1"
        } else if !(self.zoom > 0.0 && self.zoom.is_finite()) {
            "the zoom is not positive"
        } else if !(0.0..0.5).contains(&self.margin) {
            "the margin is not from 0 to 1/2"
        } else {
            return Ok(());
        };
        Err(PictureError::Camera(wrong))
    }

    /// Returns the axes of the view: to the right, up, to the eye.
    fn axes(&self) -> Option<[Vector; 3]> {
        let back = unit(self.direction)?;
        let sideways = |up: Vector| {
            let right = cross(unit(up)?, back);
            // Nearly parallel vectors give an axis that is mostly rounding.
            if dot(right, right) > 1e-12 { unit(right) } else { None }
        };
        let ups = [self.up, [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let right = ups.into_iter().find_map(sideways)?;
        Some([right, cross(back, right), back])
    }
}

/// The map from mesh to view coordinates (the mesh fits in [-1, 1]³ before it is turned; x to the
/// right, y up, z to the eye) and on to the screen.
///
/// Screen coordinates are x to the right and y down, in samples, and nearness: greater is nearer,
/// in samples too at the middle of the mesh. All three are affine on the image of a plane.
#[derive(Debug)]
pub struct Projection {
    centre: Vector,
    half_extent: f64,
    axes: [Vector; 3],
    /// Distance of the eye in view units; infinity is a parallel projection.
    distance: f64,
    /// Samples per view unit at distance 0.
    scale: f64,
    /// Screen coordinates of the view's origin.
    origin: [f64; 2],
}

impl Projection {
    /// Makes the view of a mesh with the given vertices, not yet fitted to a screen. O(n).
    pub fn new(
        camera: &Camera,
        vertices: impl Iterator<Item = Vector>,
    ) -> Result<Self, PictureError> {
        camera.check()?;
        let axes = camera.axes().ok_or(PictureError::Camera("the direction is zero"))?;
        let (low, high) = bounds(vertices);
        let half = [0, 1, 2].map(|i| high[i] / 2.0 - low[i] / 2.0);
        // A mesh that is a single point has no extent to be divided by.
        let most = half.iter().fold(0.0, |most: f64, &x| most.max(x));
        let half_extent = if most > 0.0 { most } else { 1.0 };
        let shape = half.map(|x| x / half_extent);
        let radius = dot(shape, shape).sqrt();
        Ok(Self {
            centre: [0, 1, 2].map(|i| low[i] / 2.0 + high[i] / 2.0),
            half_extent,
            axes,
            distance: camera.distance.map_or(f64::INFINITY, |distance| distance * radius),
            scale: 1.0,
            origin: [0.0; 2],
        })
    }

    /// Returns the least and greatest screen coordinates of points in view coordinates. O(n).
    pub fn screen_bounds(&self, points: impl Iterator<Item = Vector>) -> (Vector, Vector) {
        bounds(points.map(|point| self.screen(point)))
    }

    /// Fits what has the given bounds, unfitted, to a screen of `size` samples.
    pub fn fit(&mut self, camera: &Camera, (low, high): (Vector, Vector), size: [usize; 2]) {
        let target = camera.target.map(|target| self.screen(self.view(target)));
        let middle = target.unwrap_or([0, 1, 2].map(|i| (low[i] + high[i]) / 2.0));
        let free = 1.0 - 2.0 * camera.margin;
        let fits = |i: usize| size[i] as f64 * free / (high[i] - low[i]);
        let scale = camera.zoom * fits(0).min(fits(1));
        // Nothing to be fitted is shown in any scale.
        self.scale = if scale.is_finite() { scale } else { 1.0 };
        self.origin = [0, 1].map(|i| size[i] as f64 / 2.0 - self.scale * middle[i]);
    }

    /// Returns the view coordinates of a point of the mesh.
    pub fn view(&self, point: Vector) -> Vector {
        let from_centre = minus(point, self.centre).map(|x| x / self.half_extent);
        self.turn(from_centre)
    }

    /// Returns a direction in view coordinates.
    pub fn turn(&self, direction: Vector) -> Vector {
        self.axes.map(|axis| dot(axis, direction))
    }

    /// Returns the screen coordinates of a point in view coordinates.
    pub fn screen(&self, [x, y, z]: Vector) -> Vector {
        let closer = self.enlargement(z);
        let [right, down, near] = if self.distance == f64::INFINITY {
            [x, -y, z]
        } else {
            [x * closer, -y * closer, self.distance * closer]
        };
        [self.origin[0] + self.scale * right, self.origin[1] + self.scale * down, self.scale * near]
    }

    /// Returns the enlargement at depth `z`, relative to the middle of the mesh.
    fn enlargement(&self, z: f64) -> f64 {
        if self.distance == f64::INFINITY { 1.0 } else { self.distance / (self.distance - z) }
    }

    /// Returns the nearness that `samples` towards the eye add at depth `z`. On a line in space it
    /// is affine on the screen, like the nearness itself.
    pub fn lift(&self, z: f64, samples: f64) -> f64 {
        samples * self.enlargement(z)
    }

    /// Returns a vector from a point to the eye, in view coordinates, of any length.
    pub fn to_eye(&self, point: Vector) -> Vector {
        if self.distance == f64::INFINITY {
            [0.0, 0.0, 1.0]
        } else {
            minus([0.0, 0.0, self.distance], point)
        }
    }
}

/// Returns the least and greatest coordinates.
fn bounds(points: impl Iterator<Item = Vector>) -> (Vector, Vector) {
    let none = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    points.fold(none, |(low, high), p| {
        ([0, 1, 2].map(|i| low[i].min(p[i])), [0, 1, 2].map(|i| high[i].max(p[i])))
    })
}
