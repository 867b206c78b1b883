//! Files as other programs write them: white space, comments, line ends, order, encodings, padding
//! and old dialects change nothing about the mesh.

use std::io::Write as _;

use flate2::Compression;
use flate2::write::GzEncoder;
use proptest::prelude::*;
use triquad::Mesh;
use triquad::mesh::{Faces, Format, MeshError, Reader};

/// An octahedron with numbers of several forms.
const POINTS: [[&str; 3]; 6] = [
    ["1", "0", "-0"],
    ["-1.0", "0.0", "0"],
    ["0", "1.5", "1e-3"],
    ["+0", "-15e-1", ".5"],
    ["0.1", "0", "2."],
    ["0", "0", "-2"],
];
const TRIANGLES: [[u32; 3]; 8] =
    [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];

fn octahedron() -> Mesh {
    let positions = POINTS.map(|point| point.map(|x| x.parse().unwrap()));
    Mesh::from_triangles(positions.to_vec(), TRIANGLES.to_vec())
}

/// The corners of the triangles in order, as an STL file has them, welded again.
fn welded_octahedron() -> Mesh {
    let given = octahedron();
    let corners = given.faces().corners().iter().map(|&v| given.positions()[v as usize]);
    let faces = (0..24).collect();
    let mut mesh = Mesh::new(corners.collect(), Faces::uniform(3, faces));
    mesh.weld(0.0);
    mesh
}

type Lines = Vec<Vec<String>>;

fn words(line: impl AsRef<str>) -> Vec<String> {
    line.as_ref().split(' ').map(String::from).collect()
}

/// What the next place of a text looks like, as proptest chose it.
struct Choices<'c> {
    bytes: &'c [u8],
    next: usize,
}

impl<'c> Choices<'c> {
    fn new(bytes: &'c [u8]) -> Self {
        Self { bytes, next: 0 }
    }

    fn below(&mut self, count: usize) -> usize {
        let byte = self.bytes.get(self.next % self.bytes.len().max(1)).copied().unwrap_or(0);
        self.next += 1;
        byte as usize % count
    }

    fn of<'t>(&mut self, texts: &[&'t str]) -> &'t str {
        texts[self.below(texts.len())]
    }
}

const LINE_ENDS: [&str; 4] = ["\n", "\r\n", "\r", "\n\r\n"];

/// Writes lines with any white space between words, any line ends, and what `extra` has between.
fn render(lines: &Lines, choices: &mut Choices<'_>, between: &[&str], extra: &[&str]) -> String {
    let mut text = String::new();
    for line in lines {
        for _ in 0..choices.below(2) {
            text += choices.of(extra);
            text += choices.of(&LINE_ENDS);
        }
        text += choices.of(&["", " ", "\t"]);
        for (place, word) in line.iter().enumerate() {
            if place > 0 {
                text += choices.of(between);
            }
            text += word;
        }
        text += choices.of(&["", " ", "\t "]);
        text += choices.of(&LINE_ENDS);
    }
    text
}

/// The octahedron with attributes, faces in all forms, some of them before what they name.
fn obj(choices: &mut Choices<'_>) -> String {
    let points = POINTS.iter().map(|point| words(format!("v {}", point.join(" "))));
    let other: Lines =
        (0..6).flat_map(|i| [words(format!("vt 0.{i} 0")), words(format!("vn {i} 0 1"))]).collect();
    let faces = TRIANGLES.iter().map(|corners| {
        let form = choices.below(4);
        let corner = |&v: &u32| match (form, v + 1) {
            (0, v) => format!("{v}"),
            (1, v) => format!("{v}/{v}/"),
            (2, v) => format!("{v}//{v}"),
            (_, v) => format!("{v}/{v}/{v}"),
        };
        words(format!("f {}", corners.iter().map(corner).collect::<Vec<_>>().join(" ")))
    });
    let faces: Lines = faces.collect();
    let parts: [Lines; 3] = match choices.below(3) {
        0 => [points.collect(), other, faces],
        1 => [other, faces, points.collect()],
        _ => [faces, points.collect(), other],
    };
    let between = [" ", "  ", "\t", " \\\n", "\\\r\n ", " \\\r "];
    let extra =
        ["", "# a comment", "#\\", "s off", "g a#b \\", "usemtl C:\\a\\", "l 1 2", "p 1", "vp 0"];
    render(&parts.concat(), choices, &between, &extra)
}

fn off(choices: &mut Choices<'_>) -> String {
    let header = choices.of(&["OFF", "off", ""]);
    let counts = choices.of(&["6 8 12", "6 8"]);
    let mut lines = vec![words(header), words(counts)];
    lines.extend(POINTS.iter().map(|point| words(point.join(" "))));
    lines.extend(TRIANGLES.iter().map(|[a, b, c]| words(format!("3 {a} {b} {c}"))));
    let free_form = [" ", "\t", "\n", "\r", "\r\n", " # x\n"];
    let between: &[&str] = if choices.below(2) == 0 { &[" ", "\t", "  "] } else { &free_form };
    render(&lines, choices, between, &["", "# x", "  #y z"])
}

fn ascii_ply(choices: &mut Choices<'_>) -> String {
    let header = "ply|format ascii 1.0|element vertex 6|property float x|property double y|\
                  property float64 z|element face 8|property list uchar int vertex_indices|\
                  end_header";
    let header: Lines = header.split('|').map(words).collect();
    let mut lines: Lines = POINTS.iter().map(|point| words(point.join(" "))).collect();
    lines.extend(TRIANGLES.iter().map(|[a, b, c]| words(format!("3 {a} {b} {c}"))));
    let (first, rest) = header.split_at(1);
    let mut text = render(&first.to_vec(), choices, &[" "], &[""]).trim_start().to_owned();
    text += &render(&rest.to_vec(), choices, &[" ", "\t"], &["", "comment x y", "obj_info z"]);
    text + &render(&lines, choices, &[" ", "\t", "\n", "\r", "\r\n"], &[""])
}

fn ascii_stl(choices: &mut Choices<'_>) -> String {
    let mut words_of = |choice: &[&str]| words(choices.of(choice));
    let mut lines = vec![words_of(&["solid", "SOLID a b", "solid\tfacet"])];
    for triangle in TRIANGLES {
        lines.push(words("facet normal 0 nan 1"));
        lines.push(words_of(&["outer loop", "OUTER LOOP"]));
        for v in triangle {
            lines.push(words(format!("vertex {}", POINTS[v as usize].join(" "))));
        }
        lines.push(words_of(&["endloop", "end loop", "End Loop"]));
        lines.push(words_of(&["endfacet", "end facet", "ENDFACET"]));
    }
    lines.push(words_of(&["endsolid", "end solid", "endsolid a b"]));
    let body = render(&lines[1..].to_vec(), choices, &[" ", "\t"], &["", "color 1 0 0"]);
    format!("{}{}{body}", lines[0].join(" "), choices.of(&LINE_ENDS))
}

/// Encodes a text in one of the encodings with which texts begin that programs of Windows write.
fn encode(text: &str, choices: &mut Choices<'_>) -> Vec<u8> {
    let units = |text: &str| text.encode_utf16().collect::<Vec<_>>();
    let marked = format!("\u{feff}{text}");
    match choices.below(4) {
        0 => marked.into_bytes(),
        1 => units(&marked).into_iter().flat_map(u16::to_le_bytes).collect(),
        2 => units(&marked).into_iter().flat_map(u16::to_be_bytes).collect(),
        _ => text.as_bytes().to_vec(),
    }
}

/// Gzips in one or two members, with padding behind the last.
fn gzip(bytes: &[u8], choices: &mut Choices<'_>) -> Vec<u8> {
    let at = bytes.len() * choices.below(3) / 2;
    let mut zipped = Vec::new();
    for part in [&bytes[..at], &bytes[at..]] {
        let mut encoder = GzEncoder::new(&mut zipped, Compression::fast());
        encoder.write_all(part).unwrap();
        encoder.finish().unwrap();
    }
    let padding = choices.of(&["", "\n", "\0", "\0\0\0\0\0\0\0\0\0", "\r\n \x1a"]);
    zipped.extend(padding.as_bytes());
    zipped
}

fn assert_same(read: Result<Mesh, MeshError>, expected: &Mesh, text: &str) {
    let read = read.unwrap_or_else(|error| panic!("{error} in {text:?}"));
    assert_eq!(read.positions(), expected.positions(), "{text:?}");
    assert_eq!(read.faces(), expected.faces(), "{text:?}");
}

fn choices() -> impl Strategy<Value = Vec<u8>> {
    prop::collection::vec(any::<u8>(), 1..60)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    #[test]
    fn the_dialects_of_a_format_tell_the_same_mesh(bytes in choices()) {
        let mut choices = Choices::new(&bytes);
        let texts = [
            (Format::Obj, obj(&mut choices)),
            (Format::Off, off(&mut choices)),
            (Format::Ply, ascii_ply(&mut choices)),
            (Format::Stl, ascii_stl(&mut choices)),
        ];
        for (format, text) in texts {
            let expected =
                if format == Format::Stl { welded_octahedron() } else { octahedron() };
            let encoded = encode(&text, &mut choices);
            let zipped = gzip(&encoded, &mut choices);
            for bytes in [&encoded, &zipped] {
                assert_same(Mesh::parse(bytes, format), &expected, &text);
                assert_same(Reader::new().read_from(&bytes[..], None), &expected, &text);
            }
        }
    }

    #[test]
    fn padding_behind_binary_data_changes_nothing(bytes in choices()) {
        let mut choices = Choices::new(&bytes);
        let padding = choices.of(&["\n", "\r\n", "\0", "\0\0\0\0", " \x1a", "\n\n"]).repeat(1 + choices.below(90));
        let mut ply = Vec::new();
        octahedron().write_to(&mut ply, Format::Ply).unwrap();
        ply.extend(padding.as_bytes());
        assert_same(Mesh::parse(&ply, Format::Ply), &octahedron(), "ply");
        let mut stl = vec![b' '; 80];
        stl.extend(8_u32.to_le_bytes());
        let single = |mesh: Mesh| {
            let positions = mesh.positions().iter().map(|p| p.map(|x| f64::from(x as f32)));
            Mesh::new(positions.collect(), mesh.faces().clone())
        };
        for triangle in TRIANGLES {
            stl.extend([0; 12]);
            let corners = triangle.map(|v| octahedron().positions()[v as usize]);
            stl.extend(corners.as_flattened().iter().flat_map(|&x| (x as f32).to_le_bytes()));
            stl.extend([0; 2]);
        }
        stl.extend(padding.as_bytes());
        let mesh = Mesh::parse(&stl, Format::Stl);
        prop_assert_eq!(mesh.as_ref().unwrap().left_out(), ["data after the last triangle"]);
        assert_same(mesh, &single(welded_octahedron()), "stl");
    }
}

// What a file is, whatever its name says.

#[test]
fn other_content_is_named_by_its_first_bytes() {
    let html = "\n<!DOCTYPE HTML><html>v 0 0 0\n";
    let pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:ab\nsize 4\n";
    let zip = "PK\x03\x04\0\0\0\0";
    let table = [
        (Format::Obj, "ply\rformat ascii 1.0\r", "a PLY file"),
        (Format::Obj, "solid a\nfacet normal 0 0 0\n", "an STL file"),
        (Format::Obj, "# c\nCOFF\n1 0 0\n", "an OFF file"),
        (Format::Obj, html, "an HTML page"),
        (Format::Ply, html, "an HTML page"),
        (Format::Off, pointer, "a git-lfs pointer"),
        (Format::Stl, pointer, "a git-lfs pointer"),
        (Format::Stl, zip, "a zip archive"),
        (Format::Obj, zip, "a zip archive"),
        (Format::Ply, "# c\nv 0 0 0\n", "an OBJ file"),
        (Format::Off, "mtllib a\nv 0 0 0\n", "an OBJ file"),
        (Format::Stl, "ply\nformat ascii 1.0\n", "a PLY file"),
        (Format::Obj, "a\0b\0\0\0\0", "binary data"),
        (Format::Obj, "<?xml version='1.0'?>", "an XML file"),
    ];
    for (format, text, what) in table {
        let error = Mesh::parse(text.as_bytes(), format).unwrap_err();
        assert!(matches!(error, MeshError::Foreign { .. }), "{format} {text:?}: {error}");
        assert!(error.to_string().contains(what), "{format} {text:?}: {error}");
    }
    let once = gzip(obj(&mut Choices::new(&[])).as_bytes(), &mut Choices::new(&[]));
    let twice = gzip(&once, &mut Choices::new(&[]));
    let error = Mesh::parse(&twice, Format::Obj).unwrap_err();
    assert!(error.to_string().contains("a gzip file within a gzip file"), "{error}");
}

#[test]
fn gzip_files_expand_to_a_limit() {
    let text = obj(&mut Choices::new(&[0]));
    let zipped = gzip(text.as_bytes(), &mut Choices::new(&[]));
    let read =
        |limit: u64| Reader::new().max_expanded(limit).read_from(&zipped[..], Some(Format::Obj));
    let length = text.len() as u64;
    assert_same(read(length), &octahedron(), &text);
    let error = read(length - 1).unwrap_err();
    assert!(matches!(error, MeshError::Expanded(limit) if limit == length - 1), "{error}");
    assert!(error.remedy().contains("Reader::max_expanded"));
    // 300 MB of spaces in 300 kB.
    let mut encoder = GzEncoder::new(Vec::new(), Compression::fast());
    let line = [&[b' '; (1 << 20) - 1][..], b"\n"].concat();
    (0..300).for_each(|_| encoder.write_all(&line).unwrap());
    let bomb = encoder.finish().unwrap();
    let error = Mesh::parse(&bomb, Format::Obj).unwrap_err();
    assert!(matches!(error, MeshError::Expanded(_)), "{error}");
}

#[test]
fn something_behind_the_padding_of_a_gzip_file_is_refused() {
    let mut zipped = gzip(obj(&mut Choices::new(&[0])).as_bytes(), &mut Choices::new(&[]));
    zipped.extend(b"\0\0\0x");
    let error = Mesh::parse(&zipped, Format::Obj).unwrap_err();
    assert!(error.to_string().contains("damaged gzip stream"), "{error}");
}
