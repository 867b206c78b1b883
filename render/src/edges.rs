//! Edges: lines of constant width on the screen, hidden behind faces.

use super::camera::Projection;
use super::canvas::{Canvas, Slope, corner};
use super::polygons::Polygons;
use super::request::{Lines, Picture};
use super::resolve::FULL_INK;
use super::section::Cut;
use super::vector::{Vector, cross, dot, minus};

/// Lift of lines towards the eye, in pixels: half a line's width beside an edge the face may be
/// that much nearer. Walls thinner than this let lines through.
const LIFT: f64 = 1.5;

/// Heights of faces on the screen, in line widths, at which their edges begin to be seen and from
/// which on they are drawn in full.
const HEIGHTS: [f64; 2] = [1.0, 4.0];

/// The same for the typical height in the mesh: edges that are pale here and strong there, where a
/// mesh is nearly too dense, would look like stains.
const TYPICAL_HEIGHTS: [f64; 2] = [1.5, 3.0];

/// Draws the edges of all faces, paler where they lie so close that they would blacken the picture.
/// O(corners + samples covered).
pub fn draw(picture: &Picture, lines: &Lines, pen: &mut Pen) {
    let line_width = lines.width * pen.samples;
    let (mut weighted, mut sum) = (0.0, 0.0);
    pen.for_each_face(picture.mesh, |pen, face| {
        let (area, height) = pen.area_and_height(face);
        weighted += area * height;
        sum += area;
    });
    let opacity = lines.opacity * share(TYPICAL_HEIGHTS, weighted / sum / line_width);
    if opacity > 0.0 {
        pen.for_each_face(picture.mesh, |pen, face| {
            let (_, height) = pen.area_and_height(face);
            let strength = opacity * share(HEIGHTS, height / line_width) * f64::from(FULL_INK);
            pen.outline(face, lines.width, strength.round() as u8);
        });
    }
}

/// Returns the share of the way between two bounds at which `value` lies, 0 to 1.
fn share([low, high]: [f64; 2], value: f64) -> f64 {
    ((value - low) / (high - low)).clamp(0.0, 1.0)
}

/// Draws the highlighted edges, however close they lie.
pub fn highlight(picture: &Picture, lines: &Lines, pen: &mut Pen) {
    for edge in picture.highlights {
        let ends = edge.map(|v| pen.projection.view(picture.mesh.positions()[v as usize]));
        pen.line(ends, lines.highlight_width, 2 * FULL_INK);
    }
}

/// Draws lines on a canvas.
#[derive(Debug)]
pub struct Pen<'a> {
    pub projection: &'a Projection,
    pub cut: Option<&'a Cut>,
    pub canvas: &'a mut Canvas,
    /// Samples along each side of a pixel.
    pub samples: f64,
}

impl Pen<'_> {
    /// Visits the corners of each face in view coordinates.
    fn for_each_face(&mut self, mesh: Polygons<'_>, mut visit: impl FnMut(&mut Self, &[Vector])) {
        let mut view = Vec::new();
        for face in mesh.faces() {
            view.clear();
            view.extend(face.iter().map(|&v| self.projection.view(mesh.positions()[v as usize])));
            visit(self, &view);
        }
    }

    /// Draws all sides of a polygon.
    fn outline(&mut self, view: &[Vector], width: f64, strength: u8) {
        if strength > 0 {
            for (i, &from) in view.iter().enumerate() {
                let to = view[if i + 1 == view.len() { 0 } else { i + 1 }];
                self.line([from, to], width, strength);
            }
        }
    }

    /// Returns twice the area of a polygon on the screen and its height above its longest side, in
    /// samples.
    fn area_and_height(&self, view: &[Vector]) -> (f64, f64) {
        let Some(&last) = view.last() else { return (0.0, 0.0) };
        let flat = |point: Vector| {
            let [x, y, _] = self.projection.screen(point);
            [x, y, 0.0]
        };
        let first = flat(view[0]);
        let (mut area, mut longest, mut before) = (0.0, 0.0, flat(last));
        for &point in view {
            let here = flat(point);
            area += cross(minus(before, first), minus(here, first))[2];
            let side = minus(here, before);
            longest = f64::max(longest, dot(side, side));
            before = here;
        }
        let area = area.abs();
        (area, if longest > 0.0 { area / longest.sqrt() } else { 0.0 })
    }

    /// Draws a line between two points in view coordinates, `width` in pixels.
    fn line(&mut self, ends: [Vector; 2], width: f64, strength: u8) {
        let ends = match self.cut {
            Some(cut) => cut.clip_segment(ends),
            None => Some(ends),
        };
        let Some(ends) = ends else { return };
        let [a, b] = ends.map(|point| {
            let [x, y, near] = self.projection.screen(point);
            [x, y, near + self.projection.lift(point[2], LIFT * self.samples)]
        });
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let length = (dx * dx + dy * dy).sqrt();
        let Some(depth) = Slope::along(a, b) else { return };
        let half = width * self.samples / 2.0;
        let (dx, dy) = (dx / length * half, dy / length * half);
        // Half a width longer at both ends, so that lines join at a vertex.
        let mut corners = [
            corner(a[0] - dx + dy, a[1] - dy - dx),
            corner(b[0] + dx + dy, b[1] + dy - dx),
            corner(b[0] + dx - dy, b[1] + dy + dx),
            corner(a[0] - dx - dy, a[1] - dy + dx),
        ];
        self.canvas.ink(&mut corners, &depth, strength);
    }
}
