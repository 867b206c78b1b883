//! A mesh as it is drawn: view, lines, and faces coloured by their shape.

use triquad::Mesh;
use triquad::quadrangulation::quality::scaled_jacobian;
use triquad_lab::pictures::polygons;
use triquad_render::{Camera, Image, Lines, Picture, PictureError, Section};

/// Colours of quads by scaled Jacobian, told apart by colour-blind eyes; those between are mixed.
const SCALE: [(f64, [u8; 3]); 4] = [
    (0.0, [236, 112, 20]),
    (0.35, [250, 205, 110]),
    (0.7, [222, 228, 236]),
    (1.0, [150, 196, 226]),
];

/// Colour of quads of scaled Jacobian 0 and less.
const FOLDED: [u8; 3] = [178, 24, 43];

/// Colour of faces that are no quads, and of all faces without colours.
const PLAIN: [u8; 3] = [218, 225, 234];

/// Colour of the back sides of faces, which is none of the others.
const BACK: [u8; 3] = [140, 136, 148];

/// Settings that several pictures share.
pub struct Scene {
    pub width: usize,
    pub height: usize,
    pub camera: Camera,
    pub lines: Lines,
    /// The plane beyond which all is cut away.
    pub section: Option<Section>,
    pub by_quality: bool,
    /// None is transparent.
    pub background: Option<[u8; 3]>,
}

impl Scene {
    /// Draws one mesh.
    pub fn draw(&self, mesh: &Mesh) -> Result<Image, PictureError> {
        let exists = |&&v: &&u32| v as usize >= mesh.positions().len();
        if let Some(&vertex) = mesh.faces().corners().iter().find(exists) {
            return Err(PictureError::Vertex(vertex));
        }
        let colours: Vec<[u8; 3]> = if self.by_quality {
            mesh.faces().iter().map(|face| colour(mesh, face)).collect()
        } else {
            Vec::new()
        };
        let picture = Picture {
            face_colours: &colours,
            width: self.width,
            height: self.height,
            camera: self.camera.clone(),
            lines: self.lines.clone(),
            section: self.section.clone(),
            background: self.background,
            front: PLAIN,
            back: BACK,
            ..Picture::new(polygons(mesh))
        };
        picture.draw()
    }
}

/// Joins images of the same height, from left to right.
pub fn beside(images: &[Image]) -> Image {
    let width = images.iter().map(Image::width).sum();
    let row = |y: usize| {
        images.iter().flat_map(move |image| &image.pixels()[y * image.width()..][..image.width()])
    };
    Image::new(width, (0..images[0].height()).flat_map(row).copied().collect())
}

fn colour(mesh: &Mesh, face: &[u32]) -> [u8; 3] {
    let Ok(&quad) = <&[u32; 4]>::try_from(face) else { return PLAIN };
    let shape = scaled_jacobian(quad.map(|v| mesh.positions()[v as usize]));
    if shape <= 0.0 {
        return FOLDED;
    }
    let above = SCALE.iter().position(|&(end, _)| shape <= end).unwrap_or(SCALE.len() - 1).max(1);
    let [(low, from), (high, to)] = [SCALE[above - 1], SCALE[above]];
    let share = (shape - low) / (high - low);
    let mixed = |c: usize| f64::from(from[c]) + share * (f64::from(to[c]) - f64::from(from[c]));
    [0, 1, 2].map(|c| mixed(c).round() as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quads_are_coloured_by_their_shape_and_other_faces_are_not() {
        let positions =
            [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.2, 0.2]].map(|[x, y]| [x, y, 0.0]);
        let faces: [&[u32]; 3] = [&[0, 1, 2, 3], &[4, 1, 2, 3], &[0, 1, 2]];
        let mesh = Mesh::new(positions.to_vec(), faces.into_iter().collect());
        assert_eq!(colour(&mesh, faces[0]), SCALE[3].1);
        assert_eq!(colour(&mesh, &[4, 1, 2, 3]), colour(&mesh, &[1, 2, 3, 4]));
        assert_eq!(colour(&mesh, &[0, 1, 4, 3]), FOLDED);
        assert_eq!(colour(&mesh, faces[2]), PLAIN);
    }

    /// Orange and red are for nearly folded and folded quads.
    #[test]
    fn back_sides_are_grey() {
        let positions = [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.0, 0.0]];
        let mesh = Mesh::new(positions.to_vec(), [&[0, 1, 2, 3][..]].into_iter().collect());
        let scene = Scene {
            width: 9,
            height: 9,
            camera: Camera { direction: [0.0, 0.0, 1.0], ..Camera::default() },
            lines: Lines { edges: false, ..Lines::default() },
            section: None,
            by_quality: true,
            background: None,
        };
        let [red, green, blue, opacity] = scene.draw(&mesh).unwrap().pixels()[4 * 9 + 4];
        let (low, high) = (red.min(green).min(blue), red.max(green).max(blue));
        assert!(opacity == 255 && high - low < 32, "{red} {green} {blue} {opacity}");
    }

    #[test]
    fn images_are_joined_row_by_row() {
        let image = |width, first: u8| {
            Image::new(width, (0..2 * width as u8).map(|i| [first + i; 4]).collect())
        };
        let joined = beside(&[image(1, 10), image(2, 20)]);
        let expected = [10, 20, 21, 11, 22, 23].map(|value| [value; 4]);
        assert_eq!((joined.width(), joined.pixels()), (3, &expected[..]));
    }
}
