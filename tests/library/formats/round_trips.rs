//! What is written reads back.

use super::texts::{assert_same, make_awkward, quads_of, surfaces, through_file, unzip};
use crate::common::face_list;
use triquad::mesh::Output;
use triquad::random::Random;
use triquad_generators::grids;

#[test]
fn what_is_written_reads_back_to_the_last_bit() {
    let folder = tempfile::tempdir().unwrap();
    for (name, surface) in surfaces() {
        let mut triangles = face_list(&surface);
        // As they are, some meshes fit the 32-bit numbers of a PLY file; made awkward, none does.
        for awkward in [false, true] {
            if awkward {
                make_awkward(triangles.positions_mut(), &mut Random::stream(0, &[&name]));
            }
            for (kind, mesh) in [("triangles", &triangles), ("quads", &quads_of(&triangles))] {
                for extension in ["obj", "ply", "off", "obj.gz", "ply.gz", "OFF.GZ"] {
                    let read = through_file(mesh, folder.path(), &format!("mesh.{extension}"));
                    assert_same(&read, mesh, &format!("{kind} of {name} as {extension}"));
                    assert_eq!(read.left_out(), [""; 0], "{kind} of {name} as {extension}");
                }
            }
        }
    }
}

#[test]
fn gzipped_files_hold_the_plain_ones() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = face_list(&grids::torus(6, 7));
    for extension in ["obj", "ply", "off"] {
        let [plain, zipped] = ["", ".gz"].map(|gz| {
            let path = folder.path().join(format!("mesh.{extension}{gz}"));
            Output::create(&path).unwrap().write(&mesh).unwrap();
            std::fs::read(path).unwrap()
        });
        assert_eq!(zipped[..2], [0x1f, 0x8b], "{extension}");
        assert_eq!(unzip(&zipped), plain, "{extension}");
    }
}
