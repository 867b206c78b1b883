//! Attributes of OBJ files.

use super::texts::{
    Given, assert_same, attributed_text, parse_obj, sections, surfaces, through_file,
};
use crate::common::face_list;
use triquad::mesh::{Attributes, CornerIndices, FaceSections, Mesh};
use triquad::{Algorithm, Converter};
use triquad_generators::grids;

fn attributes(mesh: &Mesh) -> &Attributes {
    mesh.attributes().expect("attributes were given")
}

#[test]
fn obj_attributes_are_read_as_given_and_read_back() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = face_list(&grids::torus(5, 6));
    for given in Given::ALL {
        let read = parse_obj(&attributed_text(&mesh, given));
        assert_same(&read, &mesh, &format!("{given:?}"));
        let all = attributes(&read);
        assert_eq!(all.libraries, ["mtllib a.mtl", "mtllib b c.mtl"]);
        assert_eq!(all.sections, sections(&mesh));
        assert_eq!(all.texture_coordinates.len(), mesh.faces().corners().len());
        assert!(
            all.normals
                .iter()
                .eq((0..mesh.positions().len()).map(|v| format!("{v} -0.0 0.50").into_bytes()))
        );
        for corner in 0..mesh.faces().corners().len() {
            let index = |indices: &CornerIndices| indices.get(corner).map(|i| i as usize + 1);
            let read = (index(&all.corner_texture), index(&all.corner_normal));
            assert_eq!(read, given.at(&mesh, corner), "{given:?}: corner {corner}");
        }
        for extension in ["obj", "obj.gz"] {
            let again = through_file(&read, folder.path(), &format!("mesh.{extension}"));
            assert_eq!(again, read, "{given:?}: {extension}");
        }
    }
}

#[test]
fn quads_take_attributes_from_their_triangles() {
    let folder = tempfile::tempdir().unwrap();
    for (name, surface) in surfaces() {
        let triangles = parse_obj(&attributed_text(&face_list(&surface), Given::Both));
        for algorithm in Algorithm::ALL {
            let converted = Converter::new().algorithm(algorithm).run(&triangles).unwrap();
            let quads = converted.mesh();
            let what = format!("{name} by {algorithm}");
            if converted.report().edge_flips > 0 {
                // Its quads are no unions of the input's triangles; their vertices still agree.
                assert_corners_follow(quads, &triangles, &what);
                continue;
            }
            let sources = quad_sources(quads, &triangles, &what);
            assert_sections_follow(quads, &triangles, &sources, &what);
            assert_eq!(attributes(quads).libraries, attributes(&triangles).libraries, "{what}");
            assert_eq!(attributes(quads).normals, attributes(&triangles).normals, "{what}");
            let texture = [quads, &triangles].map(|mesh| &attributes(mesh).texture_coordinates);
            assert_eq!(texture[0], texture[1], "{what}");
            let again = through_file(quads, folder.path(), "quads.obj");
            assert_eq!(
                attributes(&again).corner_texture,
                attributes(quads).corner_texture,
                "{what}"
            );
            assert_eq!(attributes(&again).corner_normal, attributes(quads).corner_normal, "{what}");
        }
    }
}

/// Every corner of a quad has the indices of some corner of the input at the same vertex.
fn assert_corners_follow(quads: &Mesh, triangles: &Mesh, what: &str) {
    let corners = triangles.faces().corners();
    for (corner, &vertex) in quads.faces().corners().iter().enumerate() {
        let source =
            corners.len() - 1 - attributes(quads).corner_texture.get(corner).unwrap() as usize;
        assert_eq!(corners[source], vertex, "{what}: texture index of corner {corner}");
        assert_eq!(
            attributes(quads).corner_normal.get(corner),
            Some(vertex),
            "{what}: normal of {corner}"
        );
    }
}

/// The two triangles of every quad, lower first, found by where its texture indices come from.
fn quad_sources(quads: &Mesh, triangles: &Mesh, what: &str) -> Vec<[usize; 2]> {
    let corners = triangles.faces().corners();
    let sources_of = |quad: usize| {
        let mut sources: Vec<usize> = Vec::new();
        for corner in quads.faces().range(quad) {
            let vertex = quads.faces().corners()[corner];
            let source =
                corners.len() - 1 - attributes(quads).corner_texture.get(corner).unwrap() as usize;
            assert_eq!(corners[source], vertex, "{what}: texture index of quad {quad}");
            assert_eq!(
                attributes(quads).corner_normal.get(corner),
                Some(vertex),
                "{what}: normal of quad {quad}"
            );
            sources.push(source / 3);
        }
        sources.sort_unstable();
        sources.dedup();
        let pair: [usize; 2] = sources.try_into().unwrap_or_else(|sources| {
            panic!("{what}: corners of quad {quad} come from the triangles {sources:?}")
        });
        for vertex in pair.iter().flat_map(|&triangle| &triangles.faces()[triangle]) {
            assert!(quads.faces()[quad].contains(vertex), "{what}: quad {quad} is not of {pair:?}");
        }
        pair
    };
    (0..quads.faces().len()).map(sources_of).collect()
}

/// Each quad lies in the sections of its lower triangle, and these come in the order of the file.
fn assert_sections_follow(quads: &Mesh, triangles: &Mesh, sources: &[[usize; 2]], what: &str) {
    let (of_quads, of_triangles) = (&attributes(quads).sections, &attributes(triangles).sections);
    let lines = |sections: &FaceSections| -> Vec<String> {
        sections.iter().map(|section| section.line.to_owned()).collect()
    };
    assert_eq!(lines(of_quads), lines(of_triangles), "{what}");
    let begun = |sections: &FaceSections, face: usize| {
        sections.iter().filter(|s| s.first_face <= face).count()
    };
    for (quad, [lower, _]) in sources.iter().enumerate() {
        assert_eq!(
            begun(of_quads, quad),
            begun(of_triangles, *lower),
            "{what}: sections of quad {quad}"
        );
    }
}
