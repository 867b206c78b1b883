//! A pairing algorithm of one's own, completed and checked by the library:
//! `cargo run --release --example own_pairing -- IN.obj OUT.obj`.

use std::error::Error;
use std::ops::ControlFlow;

use triquad::triangulation::{HalfEdgeId, Surface as _};
use triquad::{
    Augmentation, DualGraph, Matching, Mesh, Quadrangulation, Triangulation, check, make_maximum,
};

/// Pairs each triangle, in file order, with its unpaired neighbour across the longest edge.
fn first_come(triangulation: &Triangulation, mesh: &Mesh) -> Matching {
    let squared_length = |side: HalfEdgeId| -> f64 {
        let [a, b] = triangulation.ends(side).map(|v| mesh.positions()[v.index()]);
        (0..3).map(|axis| (a[axis] - b[axis]).powi(2)).sum()
    };
    let mate = |side: HalfEdgeId| triangulation.twin(side).triangle();
    let mut matching = Matching::empty(triangulation.triangle_count());
    for triangle in triangulation.triangles() {
        if matching.is_paired(triangle) {
            continue;
        }
        let sides = triangle.half_edges().into_iter();
        let unpaired = sides.filter(|&side| !matching.is_paired(mate(side)));
        let longest = unpaired.max_by(|&a, &b| squared_length(a).total_cmp(&squared_length(b)));
        if let Some(side) = longest {
            matching.pair(triangle, mate(side));
        }
    }
    matching
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut paths = std::env::args_os().skip(1);
    let (Some(input), Some(output)) = (paths.next(), paths.next()) else {
        return Err("usage: own_pairing IN OUT".into());
    };
    let mesh = Mesh::read(input)?;
    let triangulation = Triangulation::build(&mesh)?;
    let dual = DualGraph::new(&triangulation);

    let initial = first_come(&triangulation, &mesh);
    println!("{} of {} triangles are left unpaired", initial.unpaired_count(), dual.len());
    let on_path = &mut || ControlFlow::Continue(());
    let (matching, stats) = make_maximum(&dual, initial, Augmentation::Local, on_path);
    let perfect = matching.certify(&dual).expect("Theorem 2.1: a perfect matching exists");

    let quads = Quadrangulation::new(&triangulation, &perfect);
    let quads = mesh.clone().with_faces(quads.to_faces());
    let report = check(&quads, &mesh)?;
    quads.write(output)?;
    println!("{} quads after {} augmenting paths", report.quads, stats.paths);
    Ok(())
}
