//! Draws the picture of the README: a triangulation and the quadrangulation made from it, as SVG.
//!
//! `cargo run --release --example readme_svg > docs/convert.svg`

use triquad::Converter;
use triquad::mesh::{Faces, Mesh};
use triquad::random::Random;
use triquad_generators::grids;

const SIZE: f64 = 300.0;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let list = torus_with_random_diagonals();
    let quads = Converter::new().run(&list)?;
    println!(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {} {}' role='img'>",
        2.0 * SIZE,
        0.86 * SIZE
    );
    println!("<title>A triangulated torus and the all-quad mesh on the same vertices</title>");
    draw(list.positions(), list.faces(), 0.0, [150.0, 190.0, 235.0]);
    draw(list.positions(), quads.mesh().faces(), SIZE, [245.0, 190.0, 130.0]);
    println!("</svg>");
    Ok(())
}

/// A torus grid, each cell of which is cut along one of its diagonals at random.
fn torus_with_random_diagonals() -> Mesh {
    let mut random = Random::stream(1, &["picture"]);
    let mut surface = grids::torus(34, 16);
    for cell in surface.triangles.as_chunks_mut::<2>().0 {
        // The two triangles of a cell meet in two vertices; each has one of its own.
        let [one, other] = *cell;
        let own = (0..3).find(|&i| !other.contains(&one[i])).expect("neighbours are not the same");
        let (b, c, a) = (one[own], one[(own + 1) % 3], one[(own + 2) % 3]);
        let d = *other.iter().find(|v| !one.contains(v)).expect("neighbours are not the same");
        if random.below(2) == 1 {
            *cell = [[a, b, d], [b, c, d]];
        }
    }
    Mesh::from_triangles(surface.positions, surface.triangles)
}

/// Draws the faces from the farthest to the nearest, `left` points from the left, lit from above.
fn draw(positions: &[[f64; 3]], faces: &Faces, left: f64, colour: [f64; 3]) {
    let scale =
        SIZE * 0.48 / positions.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
    let seen: Vec<[f64; 3]> = positions.iter().map(|&position| tilt(position)).collect();
    let depth =
        |face: &[u32]| face.iter().map(|&v| seen[v as usize][2]).sum::<f64>() / face.len() as f64;
    let mut order: Vec<&[u32]> = faces.iter().filter(|face| facing(&seen, face) > 0.0).collect();
    order.sort_by(|a, b| depth(a).total_cmp(&depth(b)));
    println!("<g stroke='#333' stroke-width='0.6' stroke-linejoin='round'>");
    for face in order {
        let point = |&v: &u32| {
            let [x, y, _] = seen[v as usize];
            format!("{:.1},{:.1}", left + SIZE / 2.0 + scale * x, 0.43 * SIZE - scale * y)
        };
        let light = 0.62 + 0.38 * facing(&seen, face);
        let [red, green, blue] = colour.map(|part| (part * light) as u8);
        let outline = face.iter().map(point).collect::<Vec<_>>().join(" ");
        println!("<path fill='#{red:02x}{green:02x}{blue:02x}' d='M{outline}Z'/>");
    }
    println!("</g>");
}

/// How much a face turns to the eye: 1 fully, below 0 away.
fn facing(seen: &[[f64; 3]], face: &[u32]) -> f64 {
    let corner = |i: usize| seen[face[i % face.len()] as usize];
    let area = |i: usize| {
        let (p, q) = (corner(i), corner(i + 1));
        [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
    };
    let normal = (0..face.len()).map(area).fold([0.0; 3], |sum: [f64; 3], part| {
        [sum[0] + part[0], sum[1] + part[1], sum[2] + part[2]]
    });
    normal[2] / normal.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Looks at the point from above at an angle: x to the right, y up, z to the eye.
fn tilt([x, y, z]: [f64; 3]) -> [f64; 3] {
    let (sin, cos) = (0.8, 0.6);
    [x, sin * y + cos * z, sin * z - cos * y]
}
