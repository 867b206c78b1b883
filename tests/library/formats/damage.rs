//! Nothing makes a reader panic.

use super::texts::{
    Given, ascii_ply, ascii_stl, assert_same, attributed_text, big_endian_ply, binary_stl,
};
use crate::common::face_list;
use proptest::prelude::*;
use triquad::mesh::{Format, Mesh, Output};
use triquad::{Survey, Triangulation};
use triquad_generators::classic;

/// A small valid file of each kind, to be damaged.
fn small_files() -> Vec<(Format, Vec<u8>)> {
    let mesh = face_list(&classic::seven_vertex_torus());
    let written = |format| {
        let mut bytes = Vec::new();
        mesh.write_to(&mut bytes, format).unwrap();
        bytes
    };
    let attributed = |given| attributed_text(&mesh, given).into_bytes();
    vec![
        (Format::Obj, written(Format::Obj)),
        (Format::Obj, attributed(Given::Both)),
        (Format::Obj, attributed(Given::Changing)),
        (Format::Ply, written(Format::Ply)),
        (Format::Ply, ascii_ply(&mesh)),
        (Format::Ply, big_endian_ply(&mesh)),
        (Format::Off, written(Format::Off)),
        (Format::Stl, ascii_stl(&mesh)),
        (Format::Stl, binary_stl(&mesh)),
    ]
}

/// Reads `bytes` and does everything with the result that is done with any mesh.
fn use_content(bytes: &[u8], format: Format) {
    let Ok(mut mesh) = Mesh::parse(bytes, format) else { return };
    let survey = Survey::new(&mesh);
    assert_eq!(Triangulation::build(&mesh).is_ok(), survey.violations.is_empty());
    survey.orient(&mut mesh);
    mesh.clean();
    let _ = mesh.triangulate();
    let _ = Triangulation::build_oriented(&mut mesh);
    let mut text = Vec::new();
    mesh.write_to(&mut text, Format::Obj).unwrap();
    // No OBJ file can name the largest number of all, zeros make it no text, and the sign of what
    // is no number is lost.
    let is_finite = mesh.positions().as_flattened().iter().all(|x| x.is_finite());
    if is_finite && !mesh.faces().corners().contains(&u32::MAX) && !text.contains(&0) {
        assert_same(&Mesh::parse(&text, Format::Obj).unwrap(), &mesh, "what was written");
    }
}

/// One damage; places are shares of the length.
#[derive(Clone, Debug)]
enum Damage {
    Delete(prop::sample::Index, usize),
    Insert(prop::sample::Index, Vec<u8>),
    Replace(prop::sample::Index, Vec<u8>),
    /// Copies a piece to another place.
    Copy(prop::sample::Index, prop::sample::Index, usize),
}

impl Damage {
    fn apply(&self, bytes: &mut Vec<u8>) {
        let place = |at: &prop::sample::Index| at.index(bytes.len() + 1);
        let until = |start: usize, length: usize| (start + length).min(bytes.len());
        match self {
            Self::Delete(at, length) => drop(bytes.drain(place(at)..until(place(at), *length))),
            Self::Insert(at, new) => drop(bytes.splice(place(at)..place(at), new.iter().copied())),
            Self::Replace(at, new) => {
                let end = until(place(at), new.len());
                drop(bytes.splice(place(at)..end, new.iter().copied()));
            }
            Self::Copy(from, to, length) => {
                let piece = bytes[place(from)..until(place(from), *length)].to_vec();
                drop(bytes.splice(place(to)..place(to), piece));
            }
        }
    }
}

/// Bytes that mean something in one of the formats, or any.
fn few_bytes() -> impl Strategy<Value = Vec<u8>> {
    prop_oneof![
        prop::collection::vec(any::<u8>(), 1..5),
        prop::collection::vec(prop::sample::select(&b"0123456789-+.e/# \\\r\n\t"[..]), 1..12),
        prop::sample::select(vec![
            "nan",
            "inf",
            "1e999",
            "4294967295",
            "2147483648",
            "99999999999",
            "f 1 2 3\n",
            "f\n",
            "v ",
            "vt 0\n",
            "usemtl x\n",
            "property list uchar int a\n",
            "element vertex 9\n",
            "OFF",
            "solid ",
            "endsolid\n",
        ])
        .prop_map(|text| text.as_bytes().to_vec()),
    ]
}

fn damage() -> impl Strategy<Value = Damage> {
    let at = any::<prop::sample::Index>;
    prop_oneof![
        (at(), 1..40usize).prop_map(|(place, length)| Damage::Delete(place, length)),
        (at(), few_bytes()).prop_map(|(place, new)| Damage::Insert(place, new)),
        (at(), few_bytes()).prop_map(|(place, new)| Damage::Replace(place, new)),
        (at(), at(), 1..60usize).prop_map(|(from, to, length)| Damage::Copy(from, to, length)),
    ]
}

#[test]
fn damaged_gzip_files_never_make_a_reader_panic() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mesh.off.gz");
    Output::create(&path).unwrap().write(&face_list(&classic::octahedron())).unwrap();
    let whole = std::fs::read(&path).unwrap();
    for length in 0..whole.len() {
        std::fs::write(&path, &whole[..length]).unwrap();
        assert!(Mesh::read(&path).is_err(), "the first {length} of {} bytes", whole.len());
        let mut damaged = whole.clone();
        damaged[length] ^= 0x55;
        std::fs::write(&path, damaged).unwrap();
        let _ = Mesh::read(&path);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn damaged_files_never_make_a_reader_panic(
        file in prop::sample::select(small_files()),
        damages in prop::collection::vec(damage(), 1..5),
    ) {
        let (format, mut bytes) = file;
        damages.iter().for_each(|damage| damage.apply(&mut bytes));
        use_content(&bytes, format);
    }

    #[test]
    fn random_bytes_never_make_a_reader_panic(
        file in prop::sample::select(small_files()),
        kept in any::<prop::sample::Index>(),
        bytes in prop::collection::vec(any::<u8>(), 0..300),
    ) {
        use_content(&bytes, file.0);
        let after_valid_beginning = [&file.1[..kept.index(file.1.len())], &bytes].concat();
        use_content(&after_valid_beginning, file.0);
    }
}
