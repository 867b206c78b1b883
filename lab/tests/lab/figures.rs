//! Pictures of quads and of the box: what is marked is what is there.

use std::collections::HashSet;

use triquad::mesh::{Faces, Mesh};
use triquad::quadrangulation::quality::scaled_jacobian;
use triquad::{Algorithm, Converter};
use triquad_generators::grids;
use triquad_lab::pictures::{POOR, QuadScene, View, box_picture};

fn torus() -> Mesh {
    let surface = grids::torus(12, 9);
    Mesh::from_triangles(surface.positions, surface.triangles)
}

fn quads_of(input: &Mesh, algorithm: Algorithm) -> Mesh {
    Converter::new().algorithm(algorithm).run(input).unwrap().into_mesh()
}

fn sides(mesh: &Mesh) -> HashSet<[u32; 2]> {
    let of_face = |face: &[u32]| {
        let next = face.iter().cycle().skip(1);
        face.iter().zip(next).map(|(&a, &b)| [a.min(b), a.max(b)]).collect::<Vec<_>>()
    };
    mesh.faces().iter().flat_map(of_face).collect()
}

#[test]
fn counts_are_those_of_a_plain_search() {
    let input = torus();
    for algorithm in Algorithm::ALL {
        let quads = quads_of(&input, algorithm);
        let scene = QuadScene::new(&quads, &input);
        let all = sides(&quads);
        let flipped = all.difference(&sides(&input)).count();
        let jacobian = |face: &[u32]| {
            let corners: [u32; 4] = face.try_into().unwrap();
            scaled_jacobian(corners.map(|v| quads.positions()[v as usize]))
        };
        let poor = quads.faces().iter().filter(|face| jacobian(face) < POOR).count();
        assert_eq!(scene.quad_count(), input.faces().len() / 2);
        assert_eq!((scene.edge_count(), scene.flipped_count()), (all.len(), flipped));
        assert_eq!(scene.poor_count(), poor);
        let flips_edges = matches!(algorithm, Algorithm::Lrs(_));
        assert!(flips_edges || flipped == 0, "{algorithm:?} flips {flipped} edges");
    }
}

/// A quad with a dent between triangles that share its diagonal, and the same without the diagonal
/// and one side.
#[test]
fn flips_are_blue_and_darts_are_orange_and_nothing_else_is() {
    let positions = vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 4.0, 0.0]];
    let quads = Mesh::new(positions, Faces::uniform(4, vec![0, 1, 2, 3]));
    let with_sides = quads.clone().with_faces(Faces::uniform(3, vec![0, 1, 2, 0, 2, 3]));
    let without = quads.clone().with_faces(Faces::uniform(3, vec![0, 1, 3]));
    let corners = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    let square = Mesh::new(corners.clone(), quads.faces().clone());
    let colours = |quads: &Mesh, input: &Mesh| {
        let image = QuadScene::new(quads, input).draw(View::Whole).unwrap();
        let count = |hue: fn(&&[u8; 4]) -> bool| image.pixels().iter().filter(hue).count();
        (
            count(|p| p[2] > p[0].saturating_add(80)) > 0,
            count(|p| p[0] > p[2].saturating_add(80)) > 0,
        )
    };
    assert_eq!(colours(&quads, &with_sides), (false, true));
    assert_eq!(colours(&quads, &without), (true, true));
    assert_eq!(colours(&square, &Mesh::new(corners, with_sides.faces().clone())), (false, false));
}

#[test]
fn pictures_are_small_and_the_same_again() {
    let input = torus();
    let quads = quads_of(&input, Algorithm::EagerRescue);
    let scene = QuadScene::new(&quads, &input);
    for view in [View::Whole, View::CloseUp] {
        let file = scene.draw(view).unwrap().small_png();
        assert_eq!(file, scene.draw(view).unwrap().small_png());
        let size = file.len().max(box_picture(view).small_png().len());
        assert!(size < 250_000, "{size} bytes");
    }
}

#[test]
fn an_empty_mesh_is_refused() {
    let nothing = Mesh::default();
    assert!(QuadScene::new(&nothing, &nothing).draw(View::CloseUp).is_err());
}
