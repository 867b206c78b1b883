//! Faults that `check` finds.

use super::meshes::{TETRAHEDRON, irregular_mesh, with_faces};
use crate::surfaces::face_list;
use crate::workshop::{Workshop, assert_contains};
use triquad::mesh::Mesh;
use triquad_generators::random::Mix;
use triquad_generators::testing::random_of;

#[test]
fn check_says_no_to_wrong_quads() {
    let workshop = Workshop::new();
    let mesh = random_of(1, 40, Mix::Balanced, 2);
    workshop.put_surface("in.obj", &mesh);
    workshop.succeed("convert in.obj -o quads.obj");
    let good = workshop.mesh("quads.obj");

    let mut moved = good.clone();
    let last_bit = &mut moved.positions_mut()[6][2];
    *last_bit = f64::from_bits(last_bit.to_bits() + 1);
    let more = [good.positions(), &[[5.0; 3]]].concat();
    let one_more = Mesh::new(more, good.faces().clone());
    // The same vertices in the same places, but numbered another way in the triangles.
    let mut other = mesh.clone();
    let vertices = other.positions.len() as u32;
    other
        .triangles
        .iter_mut()
        .for_each(|triangle| *triangle = triangle.map(|v| (v + 1) % vertices));
    workshop.put_surface("other.obj", &other);
    workshop.succeed("convert other.obj -o other_quads.obj");

    let table = [
        ("a vertex moved", moved, "vertex 7 has other coordinates"),
        ("a vertex more", one_more, "vertices"),
        ("corners of two quads swapped", with_faces(&good, |faces| swap_corners(faces)), ""),
        ("a quad with two corners swapped", with_faces(&good, |faces| faces[3].swap(0, 1)), ""),
        ("a quad turned over", with_faces(&good, |faces| faces[3].reverse()), ""),
        (
            "all quads turned over",
            with_faces(&good, |faces| faces.iter_mut().for_each(|face| face.reverse())),
            "",
        ),
        (
            "a quad missing",
            with_faces(&good, |faces| drop(faces.remove(4))),
            "one quad only (face ",
        ),
        (
            "a quad doubled",
            with_faces(&good, |faces| faces.push(faces[4].clone())),
            "twice in the same direction (faces ",
        ),
        ("a quad instead of another", with_faces(&good, |faces| faces[5] = faces[4].clone()), ""),
        ("a triangle among them", with_faces(&good, |faces| faces[2].truncate(3)), "face 3"),
        ("an index too high", with_faces(&good, |faces| faces[2][1] = vertices), "face 3"),
        ("a corner repeated", with_faces(&good, |faces| faces[2][1] = faces[2][0]), ""),
        ("the triangles themselves", face_list(&mesh), "face 1"),
        ("quads of another mesh", workshop.mesh("other_quads.obj"), ""),
    ];
    for (name, quads, expected) in table {
        workshop.put_mesh("wrong.obj", &quads);
        let line = workshop.fail("check wrong.obj --against in.obj", 1);
        assert_contains(&line, &["wrong.obj", expected], name);
    }
    workshop.succeed("check quads.obj --against in.obj");
}

/// Exchanges the first corners of two quads that share none.
fn swap_corners(faces: &mut [Vec<u32>]) {
    let far = (1..faces.len()).find(|&k| faces[k].iter().all(|v| !faces[0].contains(v)));
    let (first, others) = faces.split_at_mut(far.expect("more than a few quads"));
    std::mem::swap(&mut first[0][0], &mut others[0][0]);
}

#[test]
fn turned_quads_are_the_same_quads() {
    let workshop = Workshop::new();
    workshop.put_surface("in.obj", &irregular_mesh());
    workshop.succeed("convert in.obj -o quads.obj");
    let turned = with_faces(&workshop.mesh("quads.obj"), |faces| {
        faces.iter_mut().enumerate().for_each(|(k, face)| face.rotate_left(k % 4));
        faces.reverse();
    });
    workshop.put_mesh("turned.obj", &turned);
    workshop.succeed("check turned.obj --against in.obj");
}

#[test]
fn a_vertex_that_moved_is_told_from_one_that_was_rounded() {
    let workshop = Workshop::new();
    workshop.put("in.obj", TETRAHEDRON);
    workshop.succeed("convert in.obj -o quads.obj");
    let quads = String::from_utf8(workshop.get("quads.obj")).unwrap();
    for (x, remedy) in [("1.00000001", "same in single precision"), ("1.5", "; compare with")] {
        workshop.put("wrong.obj", quads.replace("v 1.0 0.0 0.0", &format!("v {x} 0 0")));
        let line = workshop.fail("check wrong.obj --against in.obj", 1);
        let places = format!("triangle mesh: ({x} 0 0) for (1 0 0); ");
        assert_contains(&line, &["vertex 2 has other", &places, remedy], x);
        assert_eq!(line.contains("single precision"), x != "1.5", "{line}");
    }
}
