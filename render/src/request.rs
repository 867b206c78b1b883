//! The picture that is wanted: mesh, size, camera, section, colours and lines.

use super::camera::Camera;
use super::polygons::Polygons;
use super::section::Section;

/// Looks of the lines.
#[derive(Clone, Debug, PartialEq)]
pub struct Lines {
    /// True if the edges of the faces are drawn.
    pub edges: bool,
    /// Width of an edge in pixels.
    pub width: f64,
    /// Opacity of an edge, 0 to 1.
    pub opacity: f64,
    /// Colour of the edges.
    pub colour: [u8; 3],
    /// Width of a highlighted edge in pixels.
    pub highlight_width: f64,
    /// Colour of the highlighted edges.
    pub highlight_colour: [u8; 3],
}

impl Default for Lines {
    fn default() -> Self {
        Self {
            edges: true,
            width: 1.0,
            opacity: 0.8,
            colour: [38, 46, 62],
            highlight_width: 2.2,
            highlight_colour: [214, 40, 57],
        }
    }
}

/// A picture to be drawn.
#[derive(Clone, Debug)]
pub struct Picture<'a> {
    /// Faces of any number of corners; degenerate ones are skipped.
    pub mesh: Polygons<'a>,
    /// Colour of each face; empty if all look the same.
    pub face_colours: &'a [[u8; 3]],
    /// Edges or other pairs of vertices to be drawn in another colour.
    pub highlights: &'a [[u32; 2]],
    /// Pixels in a row.
    pub width: usize,
    /// Number of rows.
    pub height: usize,
    /// Samples along each side of a pixel; more give smoother edges.
    pub samples: usize,
    /// The camera.
    pub camera: Camera,
    /// The part that is cut away.
    pub section: Option<Section>,
    /// Behind everything; None is transparent.
    pub background: Option<[u8; 3]>,
    /// Colour of faces whose corners are seen counter-clockwise.
    pub front: [u8; 3],
    /// Colour of faces seen from behind.
    pub back: [u8; 3],
    /// Darkening of hollows, 0 to 1.
    pub depth_shade: f64,
    /// Looks of the lines.
    pub lines: Lines,
}

impl<'a> Picture<'a> {
    /// Makes the usual picture of a mesh.
    pub fn new(mesh: Polygons<'a>) -> Self {
        Self {
            mesh,
            face_colours: &[],
            highlights: &[],
            width: 1600,
            height: 1200,
            samples: 4,
            camera: Camera::default(),
            section: None,
            background: Some([255; 3]),
            front: [218, 225, 234],
            back: [230, 150, 96],
            depth_shade: 0.85,
            lines: Lines::default(),
        }
    }
}
