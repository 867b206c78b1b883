//! Pictures of meshes, drawn without a graphics card and without a library: the same mesh and
//! settings give the same bytes on every machine.
//!
//! Faces go through a depth buffer of several samples a pixel; lines are drawn above them where they
//! are not hidden; hollows are darkened by what the depth buffer knows of their surroundings. Only
//! `+ - * /` and the square root act on coordinates.
//!
//! ```
//! use triquad_render::{Camera, Picture, Polygons};
//!
//! let positions = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
//! let mesh = Polygons::uniform(&positions, &[0, 1, 2], 3);
//! let camera = Camera { direction: [0.0, 0.0, 1.0], ..Camera::default() };
//! let image = Picture { camera, width: 60, height: 40, ..Picture::of(mesh) }.draw()?;
//! assert_eq!((image.width(), image.height()), (60, 40));
//! # Ok::<(), triquad_render::PictureError>(())
//! ```

mod camera;
mod canvas;
mod edges;
mod faces;
mod image;
mod light;
mod occlusion;
mod palette;
mod polygons;
mod resolve;
mod section;
mod vector;

pub use camera::Camera;
pub use image::Image;
pub use polygons::Polygons;
pub use section::Section;

use camera::Projection;
use canvas::Canvas;
use edges::Pen;
use resolve::Finish;
use section::Cut;

/// The most samples that an image may have, 8 bytes each.
const MOST_SAMPLES: usize = 1 << 28;

/// The most samples along a side of a pixel.
const MOST_SAMPLES_ALONG: usize = 16;

/// Why there is no picture.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PictureError {
    /// The mesh has no face.
    #[error("the mesh has no face to draw")]
    NoFaces,
    /// A size is zero, or there would be more than 2^28 samples.
    #[error("no image of {width} x {height} pixels of {samples} x {samples} samples can be drawn")]
    Size {
        /// Pixels in a row.
        width: usize,
        /// Rows.
        height: usize,
        /// Samples along a side of a pixel.
        samples: usize,
    },
    /// A face or highlighted edge has a vertex that does not exist.
    #[error("there is no vertex {0} (counted from 0)")]
    Vertex(u32),
    /// A coordinate of a vertex used is NaN or infinite.
    #[error("vertex {0} (counted from 0) has a coordinate that is not finite")]
    NotFinite(u32),
    /// The camera cannot look like that.
    #[error("camera: {0}")]
    Camera(&'static str),
    /// The plane of the section has no direction, or something is not finite.
    #[error("the plane of the section is not defined")]
    Section,
    /// Line widths and shares have to be finite and not negative.
    #[error("a width, opacity or shade is negative or not finite")]
    Style,
    /// Not one colour for each face.
    #[error("{colours} colours are given for {faces} faces")]
    Colours {
        /// Number of colours.
        colours: usize,
        /// Number of faces.
        faces: usize,
    },
}

/// Looks of the lines.
#[derive(Clone, Debug, PartialEq)]
pub struct Lines {
    /// Whether the edges of the faces are drawn.
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

/// What is to be drawn, and how.
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
    /// Where the mesh is seen from.
    pub camera: Camera,
    /// What is taken away.
    pub section: Option<Section>,
    /// Behind everything; None is transparent.
    pub background: Option<[u8; 3]>,
    /// Colour of faces whose corners are seen counter-clockwise.
    pub front: [u8; 3],
    /// Colour of faces seen from behind.
    pub back: [u8; 3],
    /// How much hollows are darkened, 0 to 1.
    pub depth_shade: f64,
    /// Looks of the lines.
    pub lines: Lines,
}

impl<'a> Picture<'a> {
    /// The usual picture of a mesh.
    pub fn of(mesh: Polygons<'a>) -> Self {
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

    /// Draws the picture. O(corners + samples) as long as few faces lie behind each other, and 8
    /// bytes a sample beside the mesh.
    ///
    /// # Errors
    /// The mesh, the camera or the settings cannot be drawn; see [`PictureError`].
    pub fn draw(&self) -> Result<Image, PictureError> {
        let size = self.size_in_samples()?;
        self.check_style()?;
        let used = self.vertices_used()?;
        let (projection, cut) = self.view(&used, size)?;
        let mut canvas = Canvas::new(size);
        faces::paint(self, &projection, cut.as_ref(), &mut canvas);
        self.draw_lines(&projection, cut.as_ref(), &mut canvas);
        let finish = Finish {
            samples: self.samples,
            background: self.background,
            inks: [self.lines.colour, self.lines.highlight_colour],
            depth_shade: self.depth_shade,
        };
        Ok(finish.image(&canvas))
    }

    /// The view of the vertices used, fitted to what the section leaves of the faces.
    fn view(
        &self,
        used: &[bool],
        size: [usize; 2],
    ) -> Result<(Projection, Option<Cut>), PictureError> {
        let positions = self.mesh.positions().iter().zip(used);
        let vertices = positions.filter(|&(_, &used)| used).map(|(&position, _)| position);
        let mut projection = Projection::new(&self.camera, vertices.clone())?;
        let Some(section) = &self.section else {
            let bounds = projection.screen_bounds(vertices.map(|vertex| projection.view(vertex)));
            projection.fit(&self.camera, bounds, size);
            return Ok((projection, None));
        };
        let cut = Cut::new(section, &projection)?;
        let sides = self.mesh.faces().flat_map(|face| {
            (0..face.len()).map(|i| [face[i], face[if i + 1 == face.len() { 0 } else { i + 1 }]])
        });
        let segments =
            sides.map(|side| side.map(|v| projection.view(self.mesh.positions()[v as usize])));
        let left = segments.filter_map(|segment| cut.clip_segment(segment)).flatten();
        let bounds = projection.screen_bounds(left);
        projection.fit(&self.camera, bounds, size);
        Ok((projection, Some(cut)))
    }

    fn draw_lines(&self, projection: &Projection, cut: Option<&Cut>, canvas: &mut Canvas) {
        let mut pen = Pen { projection, cut, canvas, samples: self.samples as f64 };
        if self.lines.edges {
            edges::draw(self, &self.lines, &mut pen);
        }
        edges::highlight(self, &self.lines, &mut pen);
    }

    fn size_in_samples(&self) -> Result<[usize; 2], PictureError> {
        let Self { width, height, samples, .. } = *self;
        let along = (1..=MOST_SAMPLES_ALONG).contains(&samples).then_some(samples);
        let size = along.and_then(|along| {
            let size = [width.checked_mul(along)?, height.checked_mul(along)?];
            let count = size[0].checked_mul(size[1])?;
            (1..=MOST_SAMPLES).contains(&count).then_some(size)
        });
        size.ok_or(PictureError::Size { width, height, samples })
    }

    fn check_style(&self) -> Result<(), PictureError> {
        let (colours, faces) = (self.face_colours.len(), self.mesh.face_count());
        if colours != 0 && colours != faces {
            return Err(PictureError::Colours { colours, faces });
        }
        let widths = [self.lines.width, self.lines.highlight_width];
        let shares = [self.lines.opacity, self.depth_shade];
        let widths_fit = widths.iter().all(|width| width.is_finite() && *width >= 0.0);
        let shares_fit = shares.iter().all(|share| (0.0..=1.0).contains(share));
        if widths_fit && shares_fit { Ok(()) } else { Err(PictureError::Style) }
    }

    /// For each vertex whether a face uses it, after a check that faces and lines can be drawn.
    fn vertices_used(&self) -> Result<Vec<bool>, PictureError> {
        if self.mesh.face_count() == 0 {
            return Err(PictureError::NoFaces);
        }
        let positions = self.mesh.positions();
        let mut used = vec![false; positions.len()];
        for &vertex in self.mesh.corners() {
            *used.get_mut(vertex as usize).ok_or(PictureError::Vertex(vertex))? = true;
        }
        let infinite = |v: usize| !positions[v].iter().all(|x| x.is_finite());
        if let Some(vertex) = (0..used.len()).find(|&v| used[v] && infinite(v)) {
            return Err(PictureError::NotFinite(vertex as u32));
        }
        for &vertex in self.highlights.as_flattened() {
            match positions.get(vertex as usize) {
                None => return Err(PictureError::Vertex(vertex)),
                Some(_) if infinite(vertex as usize) => {
                    return Err(PictureError::NotFinite(vertex));
                }
                Some(_) => {}
            }
        }
        Ok(used)
    }
}
