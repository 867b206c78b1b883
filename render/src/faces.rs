//! Faces: shaded, cut by the section, painted.

use super::camera::Projection;
use super::canvas::{Canvas, Corner, Slope, corner};
use super::light::{lit, mixed};
use super::request::Picture;
use super::section::Cut;
use super::vector::{Vector, cross, dot, minus, unit};

/// Within this sine of edge-on, a back face takes its own tone little by little: a bent quad may
/// well show a sliver of its back at the outline.
const TURN: f64 = 0.25;

/// Paints all faces. O(corners + samples covered).
pub fn paint(picture: &Picture, projection: &Projection, cut: Option<&Cut>, canvas: &mut Canvas) {
    let mesh = picture.mesh;
    let mut view = Vec::new();
    for (index, face) in mesh.faces().enumerate() {
        view.clear();
        view.extend(face.iter().map(|&v| projection.view(mesh.positions()[v as usize])));
        let Some(normal) = normal(&view) else { continue };
        let to_eye = unit(projection.to_eye(view[0])).expect("the eye is outside the mesh");
        let facing = dot(normal, to_eye);
        let front = picture.face_colours.get(index).copied().unwrap_or(picture.front);
        let back = mixed(front, picture.back, (-facing / TURN).clamp(0.0, 1.0));
        let colour = lit(back, if facing < 0.0 { normal.map(|x| -x) } else { normal });
        for triangle in triangles(&view, normal) {
            let cut = cut.filter(|cut| !cut.keeps(&triangle));
            paint_triangle(projection, cut, canvas, triangle, colour);
        }
    }
}

fn paint_triangle(
    projection: &Projection,
    cut: Option<&Cut>,
    canvas: &mut Canvas,
    triangle: [Vector; 3],
    colour: [u8; 3],
) {
    let screen = triangle.map(|point| projection.screen(point));
    let Some(depth) = Slope::through(screen) else { return };
    let on_grid = |[x, y, _]: Vector| corner(x, y);
    let Some(cut) = cut else {
        canvas.paint(&mut screen.map(on_grid), &depth, colour);
        return;
    };
    // A plane leaves at most four corners of a triangle.
    let mut corners = [Corner::default(); 4];
    let mut count = 0;
    cut.clip(&triangle, |point| {
        corners[count] = on_grid(projection.screen(point));
        count += 1;
    });
    canvas.paint(&mut corners[..count], &depth, colour);
}

/// Returns the unit normal of a face by Newell's method, if it has an area.
pub fn normal(corners: &[Vector]) -> Option<Vector> {
    let [first, rest @ ..] = corners else { return None };
    let fan = rest.windows(2).map(|pair| cross(minus(pair[0], *first), minus(pair[1], *first)));
    unit(fan.fold([0.0; 3], |sum, part| [0, 1, 2].map(|i| sum[i] + part[i])))
}

/// Iterates over the triangles of a face: a fan at its first corner, of a quad with a dent at its
/// second at the corner that sees the whole of it.
fn triangles(corners: &[Vector], normal: Vector) -> impl Iterator<Item = [Vector; 3]> {
    let turned = |[a, b, c]: [Vector; 3]| dot(cross(minus(b, a), minus(c, a)), normal) < 0.0;
    let shift = match *corners {
        [a, b, c, d] => usize::from(turned([a, b, c]) || turned([a, c, d])),
        _ => 0,
    };
    let at = move |i: usize| corners[(i + shift) % corners.len()];
    (2..corners.len()).map(move |i| [at(0), at(i - 1), at(i)])
}
