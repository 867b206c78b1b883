//! The steps from a request to an image: checks, view, faces, lines, pixels.

use super::camera::Projection;
use super::canvas::Canvas;
use super::edges::{self, Pen};
use super::error::PictureError;
use super::faces;
use super::image::Image;
use super::request::Picture;
use super::resolve::Finish;
use super::section::Cut;

/// The most samples that an image may have, 8 bytes each.
const MOST_SAMPLES: usize = 1 << 28;

/// The most samples along a side of a pixel.
const MOST_SAMPLES_ALONG: usize = 16;

impl Picture<'_> {
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

    /// Makes the view of the vertices used, fitted to what the section leaves of the faces.
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

    /// Checks that faces and lines can be drawn. Returns for each vertex whether a face uses it.
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
