//! Files as other programs write them, one of each kind of trouble that users have met: read to the
//! same mesh, or refused with the line, the fault and the remedy.

use std::io::Write as _;

use flate2::Compression;
use flate2::write::GzEncoder;

use crate::workshop::{Workshop, assert_contains};

const VERTICES: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
const FACES: &str = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
const OFF: &str = "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
const PLY_HEAD: &str = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n\
                        property float y\nproperty float z\n";
const PLY_VERTICES: &str = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";

/// What is to happen to a file.
enum Ending {
    /// It is converted to two quads. The words are in a note.
    Read(&'static [&'static str]),
    /// One line with these words, and exit code 2.
    Refused(&'static [&'static str]),
}
use Ending::{Read, Refused};

struct Case {
    kind: &'static str,
    file: &'static str,
    content: Vec<u8>,
    ending: Ending,
}

fn case(
    kind: &'static str,
    file: &'static str,
    content: impl Into<Vec<u8>>,
    ending: Ending,
) -> Case {
    Case { kind, file, content: content.into(), ending }
}

fn obj() -> String {
    format!("{VERTICES}{FACES}")
}

fn ply() -> String {
    let list = "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
    format!("{PLY_HEAD}{list}{PLY_VERTICES}3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n")
}

const CORNERS: [[[u8; 3]; 3]; 4] = [
    [[0, 0, 0], [0, 1, 0], [1, 0, 0]],
    [[0, 0, 0], [1, 0, 0], [0, 0, 1]],
    [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
    [[0, 1, 0], [0, 0, 0], [0, 0, 1]],
];

fn stl(end_of_facet: &str, end: &str) -> String {
    let vertex = |[x, y, z]: [u8; 3]| format!("vertex {x} {y} {z}\n");
    let facet = |corners: [[u8; 3]; 3]| {
        let vertices: String = corners.map(vertex).concat();
        format!("facet normal 0 0 0\nouter loop\n{vertices}{end_of_facet}\n")
    };
    format!("solid thing\n{}{end}\n", CORNERS.map(facet).concat())
}

fn binary_stl(tail: &[u8]) -> Vec<u8> {
    let mut bytes = vec![b' '; 80];
    bytes.extend(4u32.to_le_bytes());
    for corners in CORNERS {
        bytes.extend([0; 12]);
        bytes.extend(corners.as_flattened().iter().flat_map(|&x| f32::from(x).to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes.extend(tail);
    bytes
}

fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

fn utf16(text: &str, bytes_of: fn(u16) -> [u8; 2]) -> Vec<u8> {
    "\u{feff}".encode_utf16().chain(text.encode_utf16()).flat_map(bytes_of).collect()
}

/// Words that are no numbers.
fn numbers() -> Vec<Case> {
    let with = |vertex: &str| obj().replace("v 0 1 0", vertex);
    let off = |vertex: &str| OFF.replace("0 1 0", vertex);
    let none = Refused(&["line 3: '1.#QNAN' is not a number", "correct the file there"]);
    vec![
        case("not a number, first", "a.obj", with("v 1.#QNAN 1 0"), none),
        case("not a number, last", "b.obj", with("v 0 1 -1.#IND00"), Refused(&["'-1.#IND00'"])),
        case("infinite", "c.obj", with("v 0 1 1.#INF"), Refused(&["line 3: '1.#INF' is not"])),
        case("not a number", "d.off", off("0 1 1.#QNAN"), Refused(&["line 5: '1.#QNAN'"])),
        case("a comment behind a number", "e.obj", with("v 0 1 0 #third"), Read(&[])),
    ]
}

/// References between parts of an OBJ file.
fn references() -> Vec<Case> {
    let faces = |first: &str| format!("{VERTICES}{first}\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    let vt = |first: &str| format!("vt 0 0\nvt 1 0\nvt 1 1\n{}", faces(first));
    let named = format!("{VERTICES}usemtl C:\\mat\\ \n{FACES}");
    let absent: &[&str] = &["3 references to absent normals (the first in line 5)"];
    vec![
        case("normals that are not there", "a.obj", faces("f 1//1 3//2 2//3"), Read(absent)),
        case("empty normals", "b.obj", vt("f 1/1/ 3/2/ 2/3/"), Read(&[])),
        case("empty references", "c.obj", faces("f 1// 3// 2//"), Read(&[])),
        case("mixed forms of corners", "d.obj", vt("f 1/1 3 2/3"), Read(&[])),
        case("elements that are no faces", "e.obj", obj() + "l 1 2\np 1\n", Read(&["points"])),
        case("a no-break space", "f.obj", obj().replace("v ", "v\u{a0}"), {
            Refused(&["4 lines that begin with no keyword", "line 1: 'v\\u{a0}0 0 0'"])
        }),
        case("a path that ends in \\", "g.obj", format!("mtllib C:\\temp\\\n{}", obj()), Read(&[])),
        case("a name before a blank", "h.obj", named, Read(&[])),
        case("a path before a tab", "i.obj", format!("mtllib C:\\lib\\\t\n{}", obj()), Read(&[])),
    ]
}

/// Line ends, encodings, what stands behind the end.
fn bytes() -> Vec<Case> {
    let cr = |text: &str| text.replace('\n', "\r");
    let stl_text = stl("endloop\nendfacet", "endsolid thing");
    let bom = |text: &str| format!("\u{feff}{text}");
    let zeros = [gzip(obj().as_bytes()), vec![0; 700]].concat();
    vec![
        case("carriage returns", "a.ply", cr(&ply()), Read(&[])),
        case("carriage returns", "b.off", cr(OFF), Read(&[])),
        case("carriage returns", "c.stl", cr(&stl_text), Read(&[])),
        case("one other line end", "d.obj", format!("# a\n{}", cr(&obj())), Read(&[])),
        case("byte-order mark", "e.off", bom(OFF), Read(&[])),
        case("byte-order mark", "f.ply", bom(&ply()), Read(&[])),
        case("byte-order mark", "g.stl", bom(&stl_text), Read(&[])),
        case("byte-order mark", "h.obj", bom(&obj()), Read(&[])),
        case("UTF-16, little", "i.obj", utf16(&obj(), u16::to_le_bytes), Read(&[])),
        case("UTF-16, big", "j.off", utf16(OFF, u16::to_be_bytes), Read(&[])),
        case("zeros behind the stream", "k.obj.gz", zeros, Read(&[])),
        case(
            "a newline behind the end",
            "l.stl",
            binary_stl(b"\n"),
            Read(&["data after the last triangle"]),
        ),
        case(
            "zeros behind the end",
            "m.stl",
            binary_stl(&[0; 33]),
            Read(&["data after the last triangle"]),
        ),
        case("a line without end", "n.obj.gz", gzip(&vec![b'v'; 17 << 20]), {
            Refused(&["n.obj.gz: line 1: a line of more than", "export it again"])
        }),
    ]
}

/// Dialects of the formats.
fn dialects() -> Vec<Case> {
    let free = OFF.replace("4 4 6\n", "4\n4 6 ").replace("3 0 2 1\n", "3\n0\n2\n1\n");
    let strips = format!(
        "{PLY_HEAD}element tristrips 1\nproperty list int int vertex_indices\nend_header\n\
         {PLY_VERTICES}12 0 2 1 3 -1 3 2 0 -1 0 1 3\n"
    );
    let coloured = stl("endloop\nendfacet\ncolor 0.5 0.5 0.5", "endsolid");
    vec![
        case("free line breaks", "a.off", free, Read(&[])),
        case("triangle strips", "b.ply", strips, Read(&[])),
        case("two words", "c.stl", stl("end loop\nend facet", "end solid"), Read(&[])),
        case("colours between facets", "d.stl", coloured, Read(&["colours"])),
    ]
}

/// Files that are not what their names say.
fn contents() -> Vec<Case> {
    let pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 9\n";
    let page = "<!DOCTYPE html>\n<html><body>Not found</body></html>\n";
    vec![
        case("PLY", "a.obj", ply(), Refused(&["PLY", "give it the ending .ply"])),
        case("pointer", "b.obj", pointer, Refused(&["git-lfs pointer", "git lfs pull"])),
        case("page", "c.stl", page, Refused(&["HTML", "download the file itself"])),
        case("archive", "d.off", *b"PK\x03\x04rest of it", Refused(&["zip", "unpack it"])),
        case("twice", "e.obj.gz", gzip(&gzip(b"v 0 0 0\n")), Refused(&["gzip", "once"])),
    ]
}

#[test]
fn files_of_other_programs_are_read_or_refused_with_a_reason() {
    let rooms = [numbers(), references(), bytes(), dialects(), contents()];
    for Case { kind, file, content, ending } in rooms.into_iter().flatten() {
        let workshop = Workshop::new();
        workshop.put(file, content);
        let (what, convert) = (format!("{kind}: {file}"), format!("convert {file} -o quads.obj"));
        match ending {
            Read(parts) => {
                let run = workshop.run(&convert);
                assert_eq!(run.code, Some(0), "{what}: {run:?}");
                assert_contains(&run.stderr, parts, &what);
                assert_eq!(run.stderr.is_empty(), parts.is_empty(), "{what}: {run:?}");
                let check = workshop.run(&format!("check quads.obj --against {file}"));
                assert_eq!(check.code, Some(0), "{what}: {check:?}");
                assert_eq!(workshop.mesh("quads.obj").faces().len(), 2, "{what}");
            }
            Refused(parts) => assert_contains(&workshop.fail(&convert, 2), parts, &what),
        }
    }
}

#[test]
fn standard_input_is_any_format() {
    let workshop = Workshop::new();
    let files: [Vec<u8>; 5] = [
        obj().into(),
        ply().into(),
        OFF.into(),
        stl("endloop\nendfacet", "endsolid").into(),
        binary_stl(&[]),
    ];
    let convert = |bytes: &[u8]| workshop.run_with_input("convert - -o -", bytes).stdout;
    let expected = convert(&files[0]);
    assert!(!expected.is_empty());
    for bytes in files {
        let (plain, packed) = (convert(&bytes), convert(&gzip(&bytes)));
        assert_eq!(plain, packed);
        assert_eq!(plain.len(), expected.len(), "{}", String::from_utf8_lossy(&plain));
    }
}

/// Two quads back to back: cut alike, they would make the same two triangles twice.
#[test]
fn polygons_are_cut_so_that_no_triangle_comes_twice() {
    let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    let workshop = Workshop::new();
    workshop.put("pillow.obj", format!("{square}f 1 2 3 4\nf 4 3 2 1\n"));
    workshop.succeed("convert pillow.obj --triangulate -o quads.obj");
    assert_eq!(workshop.mesh("quads.obj").faces().len(), 2);
    // Every cut of the quad has a triangle that is there already.
    workshop.put("full.obj", format!("{square}f 1 2 3 4\nf 1 3 2\nf 1 4 3\nf 2 4 1\nf 2 3 4\n"));
    let line = workshop.fail("convert full.obj --triangulate -o quads.obj", 2);
    assert_contains(&line, &["full.obj: face 1", "cut"], "a polygon without a cut");
}

/// Angles, quality and folds do not depend on the unit of length.
#[test]
fn meshes_of_any_size_have_the_same_quality() {
    let workshop = Workshop::new();
    let quality = |unit: &str| {
        let vertices = format!("v 0 0 0\nv {unit} 0 0\nv 0 {unit} 0\nv 0 0 {unit}\n");
        workshop.put("in.obj", vertices + FACES);
        let stats = workshop.json("convert in.obj -q --stats -", 0);
        ["quality_minimum", "quality_mean", "total_cost", "folded_quads", "sharp_edges_kept"]
            .map(|field| stats[field].clone())
    };
    let expected = quality("1");
    for unit in ["1e-300", "1e-160", "1e160", "1e300"] {
        assert_eq!(quality(unit), expected, "{unit}");
    }
}

#[test]
fn what_a_format_cannot_hold_is_named() {
    let workshop = Workshop::new();
    let corners = "f 1/1/1 3/1/1 2/1/1\nf 1/1/1 2/1/1 4/1/1\nf 2/1/1 3/1/1 4/1/1\n";
    let parts = "mtllib a.mtl\nvt 0 0\nvn 0 0 1\ng left\nusemtl red\n";
    workshop.put("in.obj", format!("{VERTICES}{parts}{corners}f 3/1/1 1/1/1 4/1/1\n"));
    let stats = workshop.json("convert in.obj -o out.ply --stats -", 0);
    let left_out = stats["left_out"].to_string();
    let losses = ["texture coordinates", "normals", "materials", "groups"];
    assert_contains(&left_out, &losses, "PLY");
}

#[test]
fn info_takes_quads_and_convert_says_that_it_wrote_nothing() {
    let workshop = Workshop::new();
    workshop.put("in.obj", obj());
    let said = workshop.succeed("convert in.obj");
    assert!(said.contains("nothing written: no -o"), "{said}");
    assert_eq!(workshop.names().len(), 1);
}
