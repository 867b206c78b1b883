//! Converts arrays in memory: `cargo run --release --example convert_arrays`.

use triquad::{Algorithm, ConvertError, Converter, Mesh};

fn main() -> Result<(), ConvertError> {
    // An octahedron, its faces counter-clockwise seen from outside.
    let positions = vec![
        [1.0, 0.0, 0.0],
        [-1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, -1.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.0, 0.0, -1.0],
    ];
    let triangles = vec![
        [0, 2, 4],
        [2, 1, 4],
        [1, 3, 4],
        [3, 0, 4],
        [2, 0, 5],
        [1, 2, 5],
        [3, 1, 5],
        [0, 3, 5],
    ];
    let mesh = Mesh::from_triangles(positions, triangles);
    let quads = Converter::new().algorithm(Algorithm::PulliSegal).run(mesh)?;
    for quad in quads.mesh().faces() {
        println!("{quad:?}");
    }
    assert_eq!(quads.report().quads, 4);
    Ok(())
}
