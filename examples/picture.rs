//! Draws the picture of the README: a triangulation and the quadrangulation made from it, as SVG.
//!
//! `cargo run --release --example picture > docs/convert.svg`

use triquad::mesh::{FaceList, Faces};
use triquad::random::Random;
use triquad::{Settings, Triangulation, convert};
use triquad_generators::{grids, random};

const SIZE: f64 = 300.0;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut random = Random::stream(4, &["picture"]);
    let surface = random::irregular(&grids::torus(26, 14), 1, &mut |bound| random.below(bound));
    let list = FaceList::from_triangles(surface.positions, surface.triangles);
    let triangulation = Triangulation::build(&list)?;
    let quads = convert(&triangulation, &Settings::default()).faces();
    println!(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {} {SIZE}' role='img'>",
        2.0 * SIZE
    );
    println!("<title>A triangulated torus and the all-quad mesh on the same vertices</title>");
    draw(&list.positions, &list.faces, 0.0, "#d7e3f4");
    draw(&list.positions, &quads, SIZE, "#f7dfc4");
    println!("</svg>");
    Ok(())
}

/// Draws the faces from the farthest to the nearest, `left` points from the left.
fn draw(positions: &[[f64; 3]], faces: &Faces, left: f64, fill: &str) {
    let scale =
        SIZE * 0.48 / positions.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
    let seen: Vec<[f64; 3]> = positions.iter().map(|&position| tilt(position)).collect();
    let depth =
        |face: &[u32]| face.iter().map(|&v| seen[v as usize][2]).sum::<f64>() / face.len() as f64;
    let mut order: Vec<&[u32]> = faces.iter().collect();
    order.sort_by(|a, b| depth(a).total_cmp(&depth(b)));
    println!("<g fill='{fill}' stroke='#333' stroke-width='0.7' stroke-linejoin='round'>");
    for face in order {
        let point = |&v: &u32| {
            let [x, y, _] = seen[v as usize];
            format!("{:.1},{:.1}", left + SIZE / 2.0 + scale * x, SIZE / 2.0 - scale * y)
        };
        println!("<path d='M{}Z'/>", face.iter().map(point).collect::<Vec<_>>().join(" "));
    }
    println!("</g>");
}

/// Looks at the point from above at an angle: x to the right, y up, z to the eye.
fn tilt([x, y, z]: [f64; 3]) -> [f64; 3] {
    let (sin, cos) = (0.8, 0.6);
    [x, cos * z + sin * y, sin * z - cos * y]
}
