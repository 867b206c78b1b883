//! A pairing algorithm of one's own, completed and checked by the library:
//! `cargo run --release --example own_pairing`.

use std::error::Error;
use std::ops::ControlFlow;

use triquad::{
    Augmentation, DualGraph, Matching, Mesh, Quadrangulation, Triangulation, check, make_maximum,
};
use triquad_generators::grids;

/// Pairs each triangle, in file order, with its first unpaired neighbour.
fn first_come(dual: &DualGraph) -> Matching {
    let mut matching = Matching::empty(dual.len());
    for triangle in dual.triangles() {
        if matching.is_paired(triangle) {
            continue;
        }
        let unpaired = dual.neighbours(triangle).find(|&mate| !matching.is_paired(mate));
        if let Some(mate) = unpaired {
            matching.pair(triangle, mate);
        }
    }
    matching
}

fn main() -> Result<(), Box<dyn Error>> {
    let sphere = grids::sphere(40);
    let mesh = Mesh::from_triangles(sphere.positions, sphere.triangles);
    let triangulation = Triangulation::build(&mesh)?;
    let dual = DualGraph::new(&triangulation);

    let initial = first_come(&dual);
    println!("{} of {} triangles are left unpaired", initial.unpaired_count(), dual.len());
    let on_path = &mut || ControlFlow::Continue(());
    let (matching, paths) = make_maximum(&dual, initial, Augmentation::Local, on_path);
    let perfect = matching.certify(&dual).expect("Theorem 2.1: a perfect matching exists");

    let quads = Quadrangulation::new(&triangulation, &perfect);
    let quads = mesh.clone().with_faces(quads.to_faces());
    let report = check(&quads, &mesh)?;
    println!("{} quads after {} augmenting paths", report.quads, paths.paths);
    Ok(())
}
