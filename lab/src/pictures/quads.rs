//! Pictures of quad meshes, as in Figures 5.11 to 5.14 of Lemos et al.

use super::polygons::polygons;
use super::record::View;
use triquad::Mesh;
use triquad::quadrangulation::quality::scaled_jacobian;
use triquad_render::{Camera, Image, Lines, Picture, PictureError};

/// Quads whose scaled Jacobian is below this are tinted: 11.5 degrees from having a straight
/// corner.
pub const POOR: f64 = 0.2;

/// Colours that no common colour blindness confounds with each other: sound quads, and those of
/// scaled Jacobian -1; flipped edges.
const SOUND: [u8; 3] = [222, 228, 236];
const WORST: [u8; 3] = [240, 132, 10];
const FLIPPED: [u8; 3] = [0, 84, 200];

/// A quad mesh ready to be drawn, with counts of what is marked in it.
#[derive(Clone, Debug)]
pub struct QuadScene<'a> {
    quads: &'a Mesh,
    edges: usize,
    flipped: Vec<[u32; 2]>,
    colours: Vec<[u8; 3]>,
    poor: usize,
}

impl<'a> QuadScene<'a> {
    /// Finds the edges of `quads` that `input`, the triangles it was made from, does not have, and
    /// the quads that are badly shaped. O(n log n).
    pub fn new(quads: &'a Mesh, input: &Mesh) -> Self {
        let mut flipped = edges(quads);
        let all = flipped.len();
        let given = edges(input);
        flipped.retain(|edge| given.binary_search(edge).is_err());
        let shapes: Vec<f64> = quads.faces().iter().map(|face| shape(quads, face)).collect();
        let poor = shapes.iter().filter(|&&shape| shape < POOR).count();
        let colours = shapes.into_iter().map(tint).collect();
        Self { quads, edges: all, flipped, colours, poor }
    }

    /// Returns the number of quads.
    pub fn quad_count(&self) -> usize {
        self.quads.faces().len()
    }

    /// Returns the number of edges of the quads.
    pub fn edge_count(&self) -> usize {
        self.edges
    }

    /// Returns the number of edges of the quads that are no edges of the input.
    pub fn flipped_count(&self) -> usize {
        self.flipped.len()
    }

    /// Returns the number of quads whose scaled Jacobian is below [`POOR`].
    pub fn poor_count(&self) -> usize {
        self.poor
    }

    /// Draws the quads with their edges: flipped ones wider and blue; badly shaped quads the more
    /// orange the worse they are. Cost as [`Picture::draw`].
    ///
    /// # Errors
    /// The mesh cannot be drawn.
    pub fn draw(&self, view: View) -> Result<Image, PictureError> {
        let (zoom, line, highlight) = match view {
            View::Whole => (1.0, 0.8, 1.6),
            View::CloseUp => (6.0, 1.4, 3.4),
        };
        let usual = Camera::default();
        let target = match view {
            View::Whole => None,
            View::CloseUp => middle_vertex(self.quads, usual.direction),
        };
        let lines = Lines {
            width: line,
            highlight_width: highlight,
            highlight_colour: FLIPPED,
            ..Lines::default()
        };
        let picture = Picture {
            face_colours: &self.colours,
            highlights: &self.flipped,
            width: 840,
            height: 660,
            camera: Camera { target, zoom, ..usual },
            lines,
            ..Picture::new(polygons(self.quads))
        };
        picture.draw()
    }
}

/// Returns the edges of all faces, each once, sorted.
fn edges(mesh: &Mesh) -> Vec<[u32; 2]> {
    let mut edges = Vec::with_capacity(mesh.faces().corners().len());
    for face in mesh.faces() {
        for (i, &from) in face.iter().enumerate() {
            let to = face[if i + 1 == face.len() { 0 } else { i + 1 }];
            edges.push([from.min(to), from.max(to)]);
        }
    }
    edges.sort_unstable();
    edges.dedup();
    edges
}

/// Returns the scaled Jacobian of a quad; of another face, that of the best.
fn shape(mesh: &Mesh, face: &[u32]) -> f64 {
    match *face {
        [a, b, c, d] => scaled_jacobian([a, b, c, d].map(|v| mesh.positions()[v as usize])),
        _ => 1.0,
    }
}

/// Returns the colour of a quad of that scaled Jacobian.
fn tint(shape: f64) -> [u8; 3] {
    // A step at the threshold, so that what is counted is what is seen.
    let share = if shape < POOR { 0.2 + 0.8 * (POOR - shape) / (POOR + 1.0) } else { 0.0 };
    let between =
        |c: usize| f64::from(SOUND[c]) + share * (f64::from(WORST[c]) - f64::from(SOUND[c]));
    [0, 1, 2].map(|c| between(c).round() as u8)
}

/// Returns the vertex that is seen nearest to the middle of the bounding box.
fn middle_vertex(mesh: &Mesh, direction: [f64; 3]) -> Option<[f64; 3]> {
    let used = mesh.faces().corners().iter().map(|&v| mesh.positions()[v as usize]);
    let bounds =
        used.clone().fold(([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]), |(low, high), p| {
            ([0, 1, 2].map(|i| low[i].min(p[i])), [0, 1, 2].map(|i| high[i].max(p[i])))
        });
    let middle = [0, 1, 2].map(|i| bounds.0[i] / 2.0 + bounds.1[i] / 2.0);
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let aside = |p: [f64; 3]| {
        let from_middle = [0, 1, 2].map(|i| p[i] - middle[i]);
        let along = dot(from_middle, direction);
        dot(from_middle, from_middle) - along * along / dot(direction, direction)
    };
    used.min_by(|&p, &q| aside(p).total_cmp(&aside(q)))
}
