//! Texts read in chunks and written in pieces, against the same line by line.

use proptest::collection::vec;
use proptest::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

use super::blocks::BLOCK;
use super::read_blocks;
use super::write::write_pieces;
use crate::Mesh;

/// Lines of all kinds; those at the end have faults, or white space that hides their keyword.
const LINES: [&str; 36] = [
    "v 0 0 0",
    "v 1 0.5 -2",
    "  v 0 1 0",
    "v\t1 1 1 # far",
    "v 0 0 0 1",
    "v 0 0 0 0.1 0.2 0.3",
    "vt 0 0",
    "vt 0.5 1",
    "vn 0 0 1",
    " vn 1 0 0",
    "f 1 2 3",
    "f 1 2 3 4",
    "f -1 -2 -3",
    "f",
    "f 1/1 2/2 3/3",
    "f -1/-1 2 3/7",
    "f 1//1 2//2 3//9",
    "f 1/1/1 2/2/2 3/3/3",
    "f 1/0 2 3//0",
    "f 1 2 \\",
    "v 1 2 \\",
    "3",
    "o box",
    "g left v",
    "s off",
    "usemtl red",
    "mtllib a.mtl",
    "# v 1 2 3",
    "",
    "l 1 2",
    "lod 3",
    "unknown v 1 2",
    "vx 1",
    "\x0cvt 0 0",
    "v 1 2",
    "f 1 0 x",
];

const ENDS: [&str; 4] = ["\n", "\n", "\r\n", "\r"];

fn text() -> impl Strategy<Value = Vec<u8>> {
    // Those with faults are rare, so that most texts are read to the end.
    let line = prop_oneof![60 => 0..34_usize, 1 => 34..36_usize];
    let lines = vec((line, 0..ENDS.len()), 0..60);
    let damage =
        prop_oneof![3 => Just(None), 1 => any::<(prop::sample::Index, u8)>().prop_map(Some)];
    (lines, damage).prop_map(|(lines, damage)| {
        let line = |(line, end): (usize, usize)| [LINES[line], ENDS[end]].concat();
        let mut text = lines.into_iter().map(line).collect::<String>().into_bytes();
        if let Some((at, byte)) = damage.filter(|_| !text.is_empty()) {
            let at = at.index(text.len());
            text[at] = byte;
        }
        text
    })
}

/// Returns all that a reader of `text` finds, a mesh or an error.
fn found(text: &[u8], block: usize, chunk: usize) -> String {
    match read_blocks(&mut &text[..], block, chunk) {
        Ok(mesh) => format!("{mesh:?}"),
        Err(error) => format!("{error:?}"),
    }
}

fn pool(threads: usize) -> ThreadPool {
    ThreadPoolBuilder::new().num_threads(threads).build().unwrap()
}

/// Returns the file of a mesh, made in pieces of so many lines.
fn written(mesh: &Mesh, lines: usize, at_once: usize) -> Vec<u8> {
    let mut file = Vec::new();
    write_pieces(&mut file, mesh, lines, at_once).unwrap();
    file
}

fn threads() -> impl Strategy<Value = usize> {
    prop::sample::select(vec![1, 2, 3, 8])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]
    #[test]
    fn chunks_of_any_length_give_the_same_mesh_or_error(
        text in text(),
        block in 1..400_usize,
        chunk in prop_oneof![Just(0), 1..200_usize],
        threads in threads(),
    ) {
        let line_by_line = found(&text, BLOCK, BLOCK);
        let in_chunks = pool(threads).install(|| found(&text, block, chunk));
        prop_assert_eq!(in_chunks, line_by_line);
    }

    #[test]
    fn pieces_of_any_length_make_the_same_file(
        text in text(),
        lines in 1..9_usize,
        at_once in 1..9_usize,
        threads in threads(),
    ) {
        if let Ok(mesh) = read_blocks(&mut &text[..], BLOCK, BLOCK) {
            let in_pieces = pool(threads).install(|| written(&mesh, lines, at_once));
            prop_assert_eq!(in_pieces, pool(1).install(|| written(&mesh, usize::MAX, 1)));
        }
    }
}
