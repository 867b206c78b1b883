//! Picture of the box, as in Figure 14 of Ramaswami and Siqueira.

use super::polygons::polygons;
use super::record::View;
use crate::meshes::Recipe;
use triquad_generators::box_mesh::{PaperBox, Walls};
use triquad_render::{Camera, Image, Lines, Picture, Section};

/// Depth of the drawn cavities in cells; those of the papers' box are 128 deep.
pub const DRAWN_DEPTH: u32 = 14;

/// Row of shafts along which the box is cut, from 0.
const ROW: u32 = 31;

/// Draws the box of the papers with its 62 × 62 cavities, which are less deep here: all of it, or a
/// part of it cut open along a row of cavities. O(1).
pub fn box_picture(view: View) -> Image {
    let close_up = view == View::CloseUp;
    let shape = PaperBox { depth: DRAWN_DEPTH, ..PaperBox::PUBLISHED };
    let recipe = Recipe::PaperBox { shape, walls: Walls::default(), seed: 0 };
    let mesh = recipe.make().expect("there is such a box");
    let [length, _, height] = shape.cells().map(|cells| cells as f64);
    // Shafts are one cell wide and apart: row i goes from 2 i + 1 to 2 i + 2.
    let cut = f64::from(2 * ROW + 1) + 0.45;
    let picture = Picture {
        width: 900,
        height: if close_up { 500 } else { 560 },
        camera: Camera {
            direction: if close_up { [0.5, -1.0, 0.7] } else { [0.55, -1.0, 0.85] },
            up: [0.0, 0.0, 1.0],
            target: close_up.then_some([length / 2.0, cut, height / 2.0]),
            zoom: if close_up { 5.5 } else { 1.0 },
            ..Camera::default()
        },
        section: close_up.then_some(Section { point: [0.0, cut, 0.0], normal: [0.0, -1.0, 0.0] }),
        lines: Lines { edges: close_up, ..Lines::default() },
        ..Picture::new(polygons(&mesh))
    };
    picture.draw().expect("the box can be drawn")
}
