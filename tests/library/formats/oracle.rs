//! A reader by others as oracle.

use std::path::{Path, PathBuf};

use super::texts::{
    Given, assert_same, attributed_text, make_awkward, obj_text, parse_obj, quads_of, surfaces,
    unzip,
};
use crate::common::face_list;
use triquad::mesh::{Format, Mesh};
use triquad::random::Random;

/// A mesh as its faces show it: how many corners each has, and the bits of their coordinates. Says
/// nothing of the order of vertices, which the oracle changes, nor of those that no face uses,
/// which it drops.
#[derive(Debug, Default, PartialEq)]
struct Shown {
    arities: Vec<usize>,
    corners: Vec<[u64; 3]>,
}

impl Shown {
    fn push<'p>(&mut self, corners: impl ExactSizeIterator<Item = &'p [f64; 3]>) {
        self.arities.push(corners.len());
        self.corners.extend(corners.map(|position| position.map(f64::to_bits)));
    }
}

fn shown_by_us(mesh: &Mesh) -> Shown {
    let mut shown = Shown::default();
    for face in mesh.faces() {
        shown.push(face.iter().map(|&v| &mesh.positions()[v as usize]));
    }
    shown
}

fn shown_by_tobj(text: &[u8]) -> Shown {
    let options = tobj::LoadOptions::default();
    let no_materials = |_: &Path| Ok(Default::default());
    let (models, _) =
        tobj::load_obj_buf(&mut &*text, &options, no_materials).expect("tobj reads it");
    let mut shown = Shown::default();
    for tobj::Model { mesh, .. } in models {
        let (positions, _) = mesh.positions.as_chunks::<3>();
        let mut corners = mesh.indices.iter().map(|&v| &positions[v as usize]);
        // No list of arities means triangles only.
        let triangles =
            vec![3; if mesh.face_arities.is_empty() { mesh.indices.len() / 3 } else { 0 }];
        for arity in mesh.face_arities.into_iter().chain(triangles) {
            let face: Vec<_> = corners.by_ref().take(arity as usize).collect();
            shown.push(face.into_iter());
        }
    }
    shown
}

fn assert_oracle_agrees(text: &[u8], what: &str) {
    let ours =
        shown_by_us(&Mesh::parse(text, Format::Obj).unwrap_or_else(|e| panic!("{what}: {e}")));
    let theirs = shown_by_tobj(text);
    assert!(!ours.corners.is_empty(), "{what}");
    assert_eq!(ours.arities, theirs.arities, "{what}");
    // Not `assert_eq`, which would print millions of numbers.
    let differing =
        (0..ours.corners.len()).find(|&corner| ours.corners[corner] != theirs.corners[corner]);
    assert_eq!(differing, None, "{what}: first corner that differs");
}

/// The same text with every vertex index counted back from the end.
fn with_relative_indices(text: &str, vertices: usize) -> String {
    let relative = |word: &str| match word.parse::<usize>() {
        Ok(index) => format!("-{}", vertices + 1 - index),
        Err(_) => word.to_owned(),
    };
    let line = |line: &str| match line.starts_with("f ") {
        true => line.split(' ').map(relative).collect::<Vec<_>>().join(" "),
        false => line.to_owned(),
    };
    text.lines().map(line).collect::<Vec<_>>().join("\n")
}

#[test]
fn a_reader_by_others_finds_the_same_in_generated_texts() {
    for (name, surface) in surfaces() {
        let mut triangles = face_list(&surface);
        make_awkward(triangles.positions_mut(), &mut Random::stream(1, &[&name]));
        for mesh in [&triangles, &quads_of(&triangles)] {
            let text = obj_text(mesh);
            assert_oracle_agrees(text.as_bytes(), &name);
            let variants = [
                ("relative indices", with_relative_indices(&text, mesh.positions().len())),
                ("carriage returns", text.replace('\n', "\r\n")),
                ("blanks", text.replace(' ', " \t ").replace('\n', "  \n\n")),
                ("no last line end", text.trim_end().to_owned()),
            ];
            for (variant, text) in variants {
                assert_oracle_agrees(text.as_bytes(), &format!("{name} with {variant}"));
                assert_same(&parse_obj(&text), mesh, &format!("{name} with {variant}"));
            }
            for given in Given::ALL {
                let text = attributed_text(mesh, given);
                assert_oracle_agrees(text.as_bytes(), &format!("{name} with {given:?}"));
            }
        }
    }
}

#[test]
fn a_reader_by_others_finds_the_same_in_real_meshes() {
    let beside = concat!(env!("CARGO_MANIFEST_DIR"), "/../shared/meshes");
    let folder = std::env::var_os("TRIQUAD_MESHES").map_or_else(|| beside.into(), PathBuf::from);
    let Ok(entries) = std::fs::read_dir(folder.join("closed")) else {
        println!("skipped: no real meshes at {}", folder.display());
        return;
    };
    for path in entries.map(|entry| entry.unwrap().path()) {
        let text = unzip(&std::fs::read(&path).unwrap());
        assert_oracle_agrees(&text, &path.display().to_string());
    }
}
