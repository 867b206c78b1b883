//! A mesh as the renderer takes it.

use triquad::Mesh;
use triquad_render::Polygons;

/// Borrows the arrays of a mesh for drawing.
pub fn polygons(list: &Mesh) -> Polygons<'_> {
    let corners = list.faces().corners();
    match (list.faces().arity(), list.faces().ends()) {
        (_, Some(ends)) => Polygons::mixed(list.positions(), corners, ends),
        (arity, None) => Polygons::uniform(list.positions(), corners, arity.unwrap_or(3)),
    }
}
