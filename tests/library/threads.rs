//! Results on several threads, against those on one.

use rayon::ThreadPoolBuilder;
use triquad::pairing::Algorithm;
use triquad::quadrangulation::edge_costs;
use triquad::random::Random;
use triquad::{Converter, DefaultCost, DualGraph, Mesh, Triangulation};

/// A surface large enough to be divided among threads.
fn large() -> Mesh {
    let mut random = Random::stream(1, &["threads"]);
    let surface = triquad_generators::organic::surface(3, 40_000, &mut |n| random.below(n));
    Mesh::from_triangles(surface.positions, surface.triangles)
}

#[test]
fn every_stage_gives_the_same_on_any_number_of_threads() {
    let mesh = large();
    let on = |threads: usize| {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let triangulation = Triangulation::build(&mesh).unwrap();
            let costs = edge_costs(&triangulation, mesh.positions(), &DefaultCost);
            let quads = |algorithm| Converter::new().algorithm(algorithm).run(&mesh).unwrap();
            let faces = [Algorithm::Best, Algorithm::EagerRescue, Algorithm::PulliSegal]
                .map(|algorithm| quads(algorithm).mesh().faces().clone());
            (DualGraph::new(&triangulation), costs, faces, triangulation)
        })
    };
    let alone = on(1);
    for threads in [2, 3, 8] {
        assert!(on(threads) == alone, "{threads} threads");
    }
}

#[test]
fn defects_are_found_on_any_number_of_threads() {
    let mesh = large();
    let faces = mesh.faces().len();
    for lost in [0, faces / 2, faces - 1] {
        let mut corners = mesh.faces().corners().to_vec();
        corners.drain(3 * lost..3 * lost + 3);
        let open = mesh.clone().with_faces(triquad::mesh::Faces::uniform(3, corners));
        for threads in [1, 3] {
            let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let survey = pool.install(|| Triangulation::build(&open)).unwrap_err();
            assert_eq!(survey.boundary_loops, 1, "{threads} threads, face {lost}");
        }
    }
}
