//! Contracts edges until none can be contracted: `cargo run --release --example irreducible`.

use std::error::Error;

use triquad::irreducible::{Contractor, Order};
use triquad::{Mesh, Triangulation};
use triquad_generators::grids;

fn main() -> Result<(), Box<dyn Error>> {
    let torus = grids::torus(60, 40);
    let mesh = Mesh::from_triangles(torus.positions, torus.triangles);
    let triangulation = Triangulation::build(&mesh)?;
    let least = Contractor::RamaswamiSiqueira.reduce(triangulation, Order::File, 0);
    println!(
        "{} vertices are left of {}, after {} contractions and {} link condition tests",
        least.vertices.len(),
        mesh.positions().len(),
        least.contractions,
        least.counts.link_condition_tests
    );
    // Theorem 4 of Ramaswami and Siqueira: at most 26 g - 4 vertices.
    assert!(least.vertices.len() <= 22);
    least.mesh(&mesh).write("irreducible-torus.obj")?;
    Ok(())
}
