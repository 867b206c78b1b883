//! Contracts edges until none can be contracted:
//! `cargo run --release --example irreducible -- IN.obj OUT.obj`.

use std::error::Error;

use triquad::irreducible::{Contractor, Order};
use triquad::{Mesh, Triangulation};

fn main() -> Result<(), Box<dyn Error>> {
    let mut paths = std::env::args_os().skip(1);
    let (Some(input), Some(output)) = (paths.next(), paths.next()) else {
        return Err("usage: irreducible IN OUT".into());
    };
    let mesh = Mesh::read(input)?;
    let triangulation = Triangulation::build(&mesh)?;
    let least = Contractor::RamaswamiSiqueira.reduce(triangulation, Order::File, 0);
    println!(
        "{} vertices are left of {}, after {} contractions and {} link condition tests",
        least.vertices.len(),
        mesh.positions().len(),
        least.contractions,
        least.counts.link_condition_tests
    );
    least.mesh(&mesh).write(output)?;
    Ok(())
}
