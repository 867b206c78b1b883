//! Tests of the OBJ reader and writer.

use super::blocks::BLOCK;
use super::cursor::leading_digits;
use super::*;
use crate::mesh::face_sections::FaceSection;

fn read(text: &[u8]) -> Result<Mesh, MeshError> {
    super::read(&mut &text[..])
}

fn faces(text: &str) -> Vec<Vec<u32>> {
    read(text.as_bytes()).unwrap().faces.iter().map(<[u32]>::to_vec).collect()
}

fn problem(text: &str) -> String {
    read(text.as_bytes()).unwrap_err().to_string()
}

const POINTS: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\n";

#[test]
fn every_form_of_a_face_is_read() {
    for face in
        ["f 1 2 3", "f 1/1 2/2 3/3", "f 1//1 2//1 3//1", "f 1/1/1 2/2/1 3/3/1", "f -3 -2 -1"]
    {
        for ending in ["\n", "\r\n", " \n", " # comment\n", ""] {
            assert_eq!(faces(&format!("{POINTS}{face}{ending}")), [[0, 1, 2]], "{face:?}");
        }
    }
    assert_eq!(faces("f 3\t2  1\n"), [[2, 1, 0]], "vertices may come later");
    assert_eq!(faces("f 1 2 \\\n 3 \\\r\n4\nf 1 2 3\n"), [vec![0, 1, 2, 3], vec![0, 1, 2]]);
}

#[test]
fn a_backslash_does_not_continue_a_comment() {
    let list = read(b"# C:\\models\\\nv 1 2 3\n  #\\\r\nv 4 5 \\\n6\n").unwrap();
    assert_eq!(list.positions, [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]);
}

#[test]
fn line_ends_of_all_kinds_are_read_and_counted() {
    let text = format!("{POINTS}o x\n\nf 1/1 2/2 \\\n 3/3\nf 3 2 1\n");
    let expected = read(text.as_bytes()).unwrap();
    for (feed, ending) in [("\n", "\r"), ("\n", "\r\n"), ("\n", "\r\r\n"), ("v", "\rv")] {
        let changed = text.replace(feed, ending);
        assert_eq!(read(changed.as_bytes()).unwrap(), expected, "{changed:?}");
        let fault = format!("{changed}f 1 2 x\n");
        let line = if feed == "v" { 20 } else { 13 };
        assert_eq!(problem(&fault), format!("line {line}: 'x' is not an index"), "{fault:?}");
    }
    let first_only = text.replace('\n', "\r").replacen('\r', "\n", 1);
    assert_eq!(read(first_only.as_bytes()).unwrap(), expected);
}

#[test]
fn a_long_line_is_refused_before_memory_is_full() {
    let mut long = b"v 1 2 3\n# ".to_vec();
    long.resize(40 << 20, b'x');
    let problem = read(&long).unwrap_err().to_string();
    assert_eq!(problem, "line 2: a line of more than 16777216 bytes");
}

#[test]
fn backslashes_take_linear_time() {
    let one = "\\".repeat(1 << 20);
    let continued = "o a\\\n".to_owned() + &" \\\n".repeat(1 << 18);
    for text in [format!("#{one}\nv 1 2 3\n"), format!("o {one}\nv 1 2 3\n"), continued + "b\n"] {
        read(text.as_bytes()).unwrap();
    }
}

#[test]
fn names_that_end_in_a_backslash_swallow_no_statement() {
    for keyword in ["mtllib", "usemtl", "o", "g"] {
        let text = format!("{keyword} C:\\temp\\\nv 1 2 3\n{keyword} a \\\n b\nv 4 5 6\n");
        let mesh = read(text.as_bytes()).unwrap();
        assert_eq!(mesh.positions, [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]);
        let attributes = mesh.attributes.unwrap();
        let mut lines: Vec<_> = attributes.sections.iter().map(|s| s.line.to_owned()).collect();
        lines.extend(attributes.libraries);
        let joined = lines[1].split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(
            (&lines[0], joined),
            (&format!("{keyword} C:\\temp\\"), format!("{keyword} a b"))
        );
    }
}

#[test]
fn what_is_written_never_goes_on_behind_a_backslash() {
    for end in ["\\ ", "\\\t", "\\\x0c", "\\ \\ ", "\\\r\r"] {
        for keyword in ["usemtl", "mtllib", "g", "o", "s", "vt 0", "vn 0"] {
            let text = format!("v 0 0 0\n{keyword} a{end}\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
            let mesh = read(text.as_bytes()).unwrap();
            assert_eq!((mesh.positions.len(), mesh.faces.len()), (3, 1), "{text:?}");
            let mut written = Vec::new();
            write(&mut written, &mesh).unwrap();
            assert_eq!(read(&written).unwrap(), mesh, "{text:?}");
            assert!(written.split(|&b| b == b'\n').all(|line| !line.ends_with(b"\\")));
        }
    }
}

#[test]
fn a_comment_begins_at_the_start_of_a_word() {
    for (line, wrong) in [
        ("v 0 0 1.#QNAN", "'1.#QNAN' is not a number"),
        ("v -1.#IND00 0 0", "'-1.#IND00' is not a number"),
        ("v 0 1.#INF 0", "'1.#INF' is not a number"),
        ("v 1 2 3#", "'3#' is not a number"),
        ("f 1 1 1#x", "unexpected '#x' in a face"),
    ] {
        assert_eq!(problem(&format!("v 0 0 0\n{line}\n")), format!("line 2: {wrong}"));
    }
    assert_eq!(read(b"v 1 2 3 #4\n#v\n").unwrap().positions, [[1.0, 2.0, 3.0]]);
}

#[test]
fn references_to_what_is_absent_are_dropped_and_noted() {
    let points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (rest, note) in [
        ("f 1//1 2//2 3//3\n", "3 references to absent normals (the first in line 4)"),
        ("\nf 1//1 2//2 3//3\nvn 0 0 1\nvn 0 0 1\n", "1 reference to an absent normal (line 5)"),
        ("f 1/0 2 3\n", "1 reference to an absent texture coordinate (line 4)"),
        ("vt 0 0\nf 1/-1 2/-2 3\n", "1 reference to an absent texture coordinate (line 5)"),
        (
            "f 1/1 2/2 3/3\nvt 0 0\nf 1/1 2/9 \\\n3/9\nvt 0 0\nvt 0 0\n",
            "2 references to absent texture coordinates (the first in line 6)",
        ),
        ("f 1//9999999999 2 3\n", "1 reference to an absent normal (line 4)"),
    ] {
        let mesh = read(format!("{points}{rest}").as_bytes()).unwrap();
        assert_eq!(mesh.left_out, [note], "{rest:?}");
        assert_eq!(mesh.faces[0], [0, 1, 2]);
    }
    let text = format!("{points}{}vt 0 0\nf 1/2 2 3\n", "# long\n".repeat(BLOCK / 4));
    let line = BLOCK / 4 + 5;
    let note = format!("1 reference to an absent texture coordinate (line {line})");
    assert_eq!(read(text.as_bytes()).unwrap().left_out, [note]);
}

#[test]
fn omitted_references_are_read_as_none() {
    let plain = faces(&format!("{POINTS}f 1/1 2/2 3/3\n"));
    for face in ["f 1/1/ 2/2/ 3/3/", "f 1// 2// 3//", "f 1/ 2/ 3/", "f 1//1 2//1 3//"] {
        let mesh = read(format!("{POINTS}{face}\n").as_bytes()).unwrap();
        assert!(mesh.faces.iter().eq(plain.iter().map(Vec::as_slice)), "{face}");
        assert!(mesh.left_out.is_empty());
    }
}

#[test]
fn unknown_lines_are_counted_and_the_first_is_shown() {
    let unknown = "v\u{a0} 0 0 0\nv-1 0 0\nV 0 0 0\n";
    let note = "3 lines that begin with no keyword (the first is line 2: 'v\\u{a0} 0 0 0')";
    let mesh = read(format!("v 0 0 0\n{unknown}f 1 1 1\n").as_bytes()).unwrap();
    assert_eq!((mesh.unknown_lines(), &mesh.left_out[..]), (Some(note), &[note.to_owned()][..]));
    let error = problem(&format!("v 0 0 0\n{unknown}f 0 1 2\n"));
    assert_eq!(error, format!("line 5: vertex index 0: indices start at 1, after {note}"));
}

#[test]
fn indices_of_every_length_are_read() {
    for number in [
        0,
        7,
        10,
        99,
        100,
        1234,
        99_999,
        123_456,
        7_654_321,
        98_765_432,
        987_654_321,
        4_294_967_295,
    ] {
        for text in [
            format!("{number}"),
            format!("{number} 12345678"),
            format!("{number}/9"),
            format!("{number}a"),
        ] {
            let mut cursor = Cursor { rest: text.as_bytes() };
            assert_eq!(cursor.integer().ok(), Some(number), "{text}");
            assert!(!cursor.rest.first().is_some_and(u8::is_ascii_digit), "{text}");
        }
    }
    for byte in (0..=255u8).filter(|byte| !byte.is_ascii_digit()) {
        let text = [b'4', b'2', byte, byte, b'1', byte, b'3', b'5', b'6'];
        assert_eq!(leading_digits(&text), (42, 2), "{byte}");
    }
}

#[test]
fn values_are_exact() {
    let list = read(b"  v +0.1 -0 1e-300\n\tv\t.5 5. 12345678901234567890 # far\r\n").unwrap();
    assert_eq!(list.positions, [[0.1, -0.0, 1e-300], [0.5, 5.0, 12_345_678_901_234_567_890.0]]);
    assert!(list.positions[0][1].is_sign_negative());
}

#[test]
fn faults_name_their_line() {
    let cases = [
        ("v 1 2\n", "line 1: a vertex needs three coordinates"),
        ("v 1 2 3\nv 1 2 x3\n", "line 2: 'x3' is not a number"),
        ("v 1 2 3,5\n", "line 1: '3,5' is not a number: it has a decimal comma for a point"),
        ("v 1 2 3\n\nf 1 0 1\n", "line 3: vertex index 0: indices start at 1"),
        ("v 1 2 3\nf -1 -2 -1\n", "line 2: vertex index -2 is out of range"),
        ("f 1 2 \\\n 3\nf 1 2 99999999999\n", "line 3: '99999999999' is not an index"),
        ("f 1 2 9999999999\n", "line 1: vertex index 9999999999 is out of range"),
        ("f 1 2 3x\n", "line 1: unexpected 'x' in a face"),
        ("f 1/x 2 3\n", "line 1: 'x' is not an index"),
    ];
    for (text, expected) in cases {
        assert_eq!(problem(text), expected, "{text:?}");
    }
}

#[test]
fn attributes_survive_a_round_trip() {
    let text = format!(
        "mtllib a.mtl\n{POINTS}o box\ng left side\nusemtl red\nf 1/1/1 2/2/1 3/3/1\n\
         s off\nf 3 2 1\nf 1//1 2//1 3//1\n"
    );
    let list = read(text.as_bytes()).unwrap();
    let mut written = Vec::new();
    write(&mut written, &list).unwrap();
    assert_eq!(read(&written).unwrap(), list);
    let attributes = list.attributes.unwrap();
    assert!(attributes.corner_texture.iter().take(4).eq([Some(0), Some(1), Some(2), None]));
    let fourth = FaceSection { first_face: 1, line: "s off" };
    assert_eq!(attributes.sections.iter().nth(3), Some(fourth));
}

#[test]
fn what_is_left_out_is_named() {
    let text = b"v 0 0 0 1\nv 0 0 0 0.5 0.5 0.5\nvp 1 2\nl 1 2\np 1\ncurv 0 1 1 2\nlod 3\n";
    let list = read(text).unwrap();
    let left_out = ["points", "lines", "curves and surfaces", "rendering settings"];
    assert_eq!(list.left_out, [&["vertex weights", "vertex colours"][..], &left_out].concat());
    assert!(list.faces.is_empty() && list.attributes.is_none());
}

#[test]
fn lines_may_lie_across_blocks() {
    let mut text = String::new();
    let count = 3 * BLOCK / 40;
    for i in 0..count {
        text += &format!("v {i}.5 \\\n  0.25 {:>20}\r\n", i % 1000);
    }
    text += &format!("# {}\n", "long ".repeat(BLOCK / 3));
    let list = read(text.as_bytes()).unwrap();
    assert_eq!(list.positions.len(), count);
    assert!(
        list.positions
            .iter()
            .enumerate()
            .all(|(i, p)| *p == [i as f64 + 0.5, 0.25, (i % 1000) as f64])
    );
    text += "f 1 2 x\n";
    assert_eq!(problem(&text), format!("line {}: 'x' is not an index", 2 * count + 2));
}

#[test]
fn no_prefix_of_a_file_makes_the_reader_panic() {
    let text = format!("{POINTS}o x\nf 1/1/1 2/2/1 \\\n3/3/1\nf -1 -2 -3\n");
    for end in 0..text.len() {
        let _ = read(&text.as_bytes()[..end]);
    }
}

#[test]
fn a_fault_in_a_last_line_without_an_end_may_be_that_of_a_file_cut_off() {
    let hint = ", where the file ends: it may be cut off";
    for line in ["v 1 2", "v 1 2 3.5e", "v", "f 1 2 -"] {
        let cut = problem(&format!("{POINTS}{line}"));
        assert!(cut.starts_with("line 8: ") && cut.ends_with(hint), "{cut}");
        let whole = problem(&format!("{POINTS}{line}\n"));
        assert_eq!(format!("{whole}{hint}"), cut);
    }
}
