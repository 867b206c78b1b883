//! Picture of the box, as in Figure 14 of Ramaswami and Siqueira.

use super::polygons::polygons;
use super::record::View;
use crate::meshes::{BoxShape, Recipe};
use triquad_render::{Camera, Image, Lines, Picture, Section};

/// Draws the box of both papers with its 62 × 62 cavities: all of it, or a corner of it cut open
/// along a row of cavities. The proportions are ours, see [`BoxShape`]. O(1).
pub fn box_picture(view: View) -> Image {
    let close_up = view == View::CloseUp;
    let vertices = if close_up { 220_000 } else { 60_000 };
    let shape = BoxShape { cavities: 62 * 62, holes: 0, vertices };
    let mesh = Recipe::Box(shape).make().expect("so many vertices suffice");
    // Shafts are 1 wide and 1/2 apart: the first of row i begins at 1/2 + 3 i / 2.
    let row = 0.5 + 1.5 * 31.0 + 0.45;
    let picture = Picture {
        width: 900,
        height: if close_up { 500 } else { 560 },
        camera: Camera {
            direction: if close_up { [0.5, -1.0, 0.7] } else { [0.55, -1.0, 0.85] },
            up: [0.0, 0.0, 1.0],
            target: close_up.then_some([46.0, row + 2.2, 0.5]),
            zoom: if close_up { 9.0 } else { 1.0 },
            ..Camera::default()
        },
        section: close_up.then_some(Section { point: [0.0, row, 0.0], normal: [0.0, -1.0, 0.0] }),
        lines: Lines { edges: close_up, ..Lines::default() },
        ..Picture::new(polygons(&mesh))
    };
    picture.draw().expect("the box can be drawn")
}
