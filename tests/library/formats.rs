//! Mesh files: what is written reads back to the last bit, what others write is understood, texture
//! coordinates and groups survive, and no content makes a reader panic.

use std::fmt::Write as _;
use std::io::Read as _;
use std::path::{Path, PathBuf};

use crate::common::{face_list, random_of, special_surfaces};
use flate2::read::MultiGzDecoder;
use proptest::prelude::*;
use triquad::mesh::{self, Attributes, FaceSection, Faces, Format, Mesh, Output};
use triquad::random::Random;
use triquad::{Algorithm, Converter, Survey, Triangulation};
use triquad_generators::random::Mix;
use triquad_generators::{Surface, classic, grids};

// What is written reads back.

/// Small surfaces of several genera, regular and random.
fn surfaces() -> Vec<(String, Surface)> {
    let special = special_surfaces().into_iter().map(|(name, surface)| (name.to_owned(), surface));
    let kinds = [0, 1, 2, 5].into_iter().flat_map(|genus| Mix::ALL.map(|mix| (genus, mix)));
    let random = kinds.map(|(genus, mix)| {
        (format!("{mix:?} of genus {genus}"), random_of(genus, 150, mix, genus as u64))
    });
    special.chain(random).collect()
}

/// The vertices of `triangles` with the quads that the default settings make.
fn quads_of(triangles: &Mesh) -> Mesh {
    Converter::new().run(triangles).expect("a closed surface").into_mesh()
}

/// Numbers that are easily lost on the way through a text or through 32 bits.
const AWKWARD: [f64; 12] = [
    0.1,
    1e-300,
    -0.0,
    5e-324,
    -f64::MIN_POSITIVE,
    f64::MAX,
    1.0 / 3.0,
    1e22,
    9_007_199_254_740_993.0,
    16_777_217.0,
    f64::MIN,
    1.000_000_000_000_000_2,
];

/// Replaces coordinates by awkward numbers and by any other finite ones.
fn make_awkward(positions: &mut [[f64; 3]], random: &mut Random) {
    for coordinate in positions.as_flattened_mut() {
        *coordinate = match random.below(3) {
            0 => AWKWARD[random.below(AWKWARD.len() as u32) as usize],
            1 => any_finite(random),
            _ => *coordinate + 1e-17 * f64::from(random.below(1 << 20)),
        };
    }
}

fn any_finite(random: &mut Random) -> f64 {
    loop {
        let halves = [random.below(u32::MAX), random.below(u32::MAX)].map(u64::from);
        let number = f64::from_bits(halves[0] << 32 | halves[1]);
        if number.is_finite() {
            return number;
        }
    }
}

/// Writes `mesh` to a file of that name and reads the file.
fn through_file(mesh: &Mesh, folder: &Path, name: &str) -> Mesh {
    let path = folder.join(name);
    Output::create(&path).unwrap().write(mesh).unwrap();
    Mesh::read(&path).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// Coordinates as bits, which tell -0 from 0.
fn bits(positions: &[[f64; 3]]) -> Vec<[u64; 3]> {
    positions.iter().map(|position| position.map(f64::to_bits)).collect()
}

fn assert_same(read: &Mesh, written: &Mesh, what: &str) {
    assert_eq!(bits(read.positions()), bits(written.positions()), "positions of {what}");
    assert_eq!(read.faces(), written.faces(), "faces of {what}");
}

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

fn unzip(bytes: &[u8]) -> Vec<u8> {
    let mut plain = Vec::new();
    MultiGzDecoder::new(bytes).read_to_end(&mut plain).unwrap();
    plain
}

// Attributes of OBJ files.

/// Sections of a mesh, as line and the share of faces before it in percent.
const SECTIONS: [(usize, &str); 7] = [
    (0, "o thing"),
    (0, "usemtl red"),
    (20, "s 1"),
    (20, "g left hand"),
    (50, "usemtl green paint"),
    (51, "g right"),
    (80, "s off"),
];

/// What every corner of the text made by [`attributed_text`] is given.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Given {
    Texture,
    Normal,
    Both,
    /// Nothing to one face, everything to the next, and so on.
    Changing,
}

impl Given {
    const ALL: [Self; 4] = [Self::Texture, Self::Normal, Self::Both, Self::Changing];

    /// Texture and normal index (from 1) of a corner.
    fn at(self, mesh: &Mesh, corner: usize) -> (Option<usize>, Option<usize>) {
        let (texture, normal) =
            (texture_of(mesh, corner), mesh.faces().corners()[corner] as usize + 1);
        match self {
            Self::Texture => (Some(texture), None),
            Self::Normal => (None, Some(normal)),
            Self::Both => (Some(texture), Some(normal)),
            Self::Changing => match corner / 3 % 4 {
                0 => (None, None),
                1 => (Some(texture), None),
                2 => (None, Some(normal)),
                _ => (Some(texture), Some(normal)),
            },
        }
    }
}

/// Every corner has a texture coordinate (from 1) of its own, so that it can be told where a corner
/// of a quad comes from. They are given in the opposite order.
fn texture_of(mesh: &Mesh, corner: usize) -> usize {
    mesh.faces().corners().len() - corner
}

/// An OBJ text with everything that is carried along.
fn attributed_text(mesh: &Mesh, given: Given) -> String {
    let mut text = String::from("# made by hand\nmtllib a.mtl\nmtllib b c.mtl\n");
    for [x, y, z] in mesh.positions() {
        writeln!(text, "v {x:e} {y:e} {z:e}").unwrap();
    }
    for corner in 0..mesh.faces().corners().len() {
        writeln!(text, "vt 0.{corner} 1e-{corner} 0").unwrap();
    }
    for vertex in 0..mesh.positions().len() {
        writeln!(text, "vn {vertex} -0.0 0.50").unwrap();
    }
    for face in 0..mesh.faces().len() {
        for section in sections(mesh).iter().filter(|section| section.first_face == face) {
            writeln!(text, "{}", section.line).unwrap();
        }
        text.push('f');
        for corner in mesh.faces().range(face) {
            write!(text, " {}", mesh.faces().corners()[corner] + 1).unwrap();
            match given.at(mesh, corner) {
                (None, None) => {}
                (Some(texture), None) => write!(text, "/{texture}").unwrap(),
                (None, Some(normal)) => write!(text, "//{normal}").unwrap(),
                (Some(texture), Some(normal)) => write!(text, "/{texture}/{normal}").unwrap(),
            }
        }
        text.push('\n');
    }
    text
}

fn sections(mesh: &Mesh) -> Vec<FaceSection> {
    let at = |(percent, line): &(usize, &str)| FaceSection {
        first_face: mesh.faces().len() * percent / 100,
        line: (*line).to_owned(),
    };
    SECTIONS.iter().map(at).collect()
}

fn parse_obj(text: &str) -> Mesh {
    Mesh::parse(text.as_bytes(), Format::Obj).unwrap()
}

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
            let index = |indices: &mesh::CornerIndices| indices.get(corner).map(|i| i as usize + 1);
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
    let lines =
        |sections: &[FaceSection]| sections.iter().map(|s| s.line.clone()).collect::<Vec<_>>();
    assert_eq!(lines(of_quads), lines(of_triangles), "{what}");
    let begun = |sections: &[FaceSection], face: usize| {
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

// What others write.

/// A surface whose coordinates all are 32-bit numbers, no two vertices at the same place.
fn single_precision_mesh() -> Mesh {
    let mut mesh = face_list(&random_of(2, 120, Mix::Balanced, 7));
    for (v, position) in mesh.positions_mut().iter_mut().enumerate() {
        let v = v as f32;
        *position = [v * 0.1, -v, 1.0 / (v + 1.0)].map(f64::from);
    }
    mesh
}

fn ply_header(mesh: &Mesh, encoding: &str) -> String {
    format!(
        "ply\nformat {encoding} 1.0\ncomment not by triquad\nelement vertex {}\nproperty double x\n\
         property double y\nproperty double z\nelement face {}\nproperty list uchar uint vertex_index\nend_header\n",
        mesh.positions().len(),
        mesh.faces().len()
    )
}

fn ascii_ply(mesh: &Mesh) -> Vec<u8> {
    let mut text = ply_header(mesh, "ascii");
    for [x, y, z] in mesh.positions() {
        writeln!(text, "{x} {y:e} {z}").unwrap();
    }
    for face in mesh.faces() {
        write!(text, "{}", face.len()).unwrap();
        face.iter().for_each(|v| write!(text, " {v}").unwrap());
        text.push('\n');
    }
    text.into_bytes()
}

fn big_endian_ply(mesh: &Mesh) -> Vec<u8> {
    let mut bytes = ply_header(mesh, "binary_big_endian").into_bytes();
    bytes.extend(mesh.positions().as_flattened().iter().flat_map(|x| x.to_be_bytes()));
    for face in mesh.faces() {
        bytes.push(face.len() as u8);
        bytes.extend(face.iter().flat_map(|v| v.to_be_bytes()));
    }
    bytes
}

fn ascii_stl(mesh: &Mesh) -> Vec<u8> {
    let mut text = String::from("solid thing\n");
    for face in mesh.faces() {
        text += "  facet normal 0 0 0\n    outer loop\n";
        for [x, y, z] in face.iter().map(|&v| mesh.positions()[v as usize]) {
            writeln!(text, "      vertex {x:e} {y} {z:e}").unwrap();
        }
        text += "    endloop\n  endfacet\n";
    }
    (text + "endsolid thing\n").into_bytes()
}

fn binary_stl(mesh: &Mesh) -> Vec<u8> {
    let mut bytes = vec![b' '; 80];
    bytes.extend((mesh.faces().len() as u32).to_le_bytes());
    for face in mesh.faces() {
        bytes.extend([0; 12]);
        let coordinates = face.iter().flat_map(|&v| mesh.positions()[v as usize]);
        bytes.extend(coordinates.flat_map(|x| (x as f32).to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

/// The same mesh with its vertices numbered as faces name them first.
fn in_order_of_occurrence(mesh: &Mesh) -> Mesh {
    let mut number = vec![None; mesh.positions().len()];
    let (mut positions, mut faces) = (Vec::new(), Faces::default());
    for face in mesh.faces() {
        let corners = face.iter().map(|&v| {
            *number[v as usize].get_or_insert_with(|| {
                positions.push(mesh.positions()[v as usize]);
                positions.len() as u32 - 1
            })
        });
        let corners: Vec<u32> = corners.collect();
        faces.push(&corners);
    }
    Mesh::new(positions, faces)
}

#[test]
fn every_format_tells_the_same_mesh() {
    let mesh = single_precision_mesh();
    let welded = in_order_of_occurrence(&mesh);
    let table = [
        ("ascii PLY", ascii_ply(&mesh), Format::Ply, &mesh),
        ("big-endian PLY", big_endian_ply(&mesh), Format::Ply, &mesh),
        ("ascii STL", ascii_stl(&mesh), Format::Stl, &welded),
        ("binary STL", binary_stl(&mesh), Format::Stl, &welded),
    ];
    for (name, bytes, format, expected) in table {
        let read = Mesh::parse(&bytes, format).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_same(&read, expected, name);
    }
}

#[test]
fn ply_files_keep_awkward_numbers_and_quads() {
    let mut mesh = quads_of(&face_list(&grids::torus(6, 7)));
    make_awkward(mesh.positions_mut(), &mut Random::stream(0, &["awkward"]));
    for (name, bytes) in [("ascii", ascii_ply(&mesh)), ("big-endian", big_endian_ply(&mesh))] {
        assert_same(&Mesh::parse(&bytes, Format::Ply).unwrap(), &mesh, name);
    }
}

/// Ways to write a number that programs use.
const SPELLINGS: [&str; 16] = [
    "1",
    "-1",
    "+1",
    "1.",
    ".5",
    "-.5",
    "1E5",
    "1e+05",
    "-0",
    "-0.0e7",
    "1e-400",
    "2.2250738585072011e-308",
    "0.1000000000000000055511151231257827",
    "00012.50",
    "123456789012345678901234567890",
    "1.7976931348623157e308",
];

#[test]
fn numbers_are_read_as_the_nearest_ones() {
    for spelling in SPELLINGS {
        let ply = ply_header(&Mesh::new(vec![[0.0; 3]], Faces::default()), "ascii");
        let table = [
            (Format::Obj, format!("v {spelling} {spelling}\t{spelling}\r\n")),
            (Format::Ply, format!("{ply}{spelling} {spelling} {spelling}\n")),
            (Format::Off, format!("OFF\n1 0 0\n{spelling} {spelling} {spelling}\n")),
        ];
        let nearest: f64 = spelling.parse().unwrap();
        for (format, text) in table {
            let read = Mesh::parse(text.as_bytes(), format).unwrap();
            assert_eq!(bits(read.positions()), bits(&[[nearest; 3]]), "{format:?}: {spelling}");
        }
    }
}

#[test]
fn indices_of_any_length_are_read_whatever_follows() {
    for digits in 1..=10 {
        let lowest = 10u64.pow(digits - 1);
        for index in [lowest, lowest * 123 / 100, lowest * 4 + 29_496_729 % lowest, 10 * lowest - 1]
        {
            for spelling in [format!("{index}"), format!("{index:010}")] {
                for after in ["", "\n", "\r\n", " \n", "\t7", " #1", " 12345678", "\nv 1 2 3\n"] {
                    let text = format!("f {spelling}{after}");
                    let read = Mesh::parse(text.as_bytes(), Format::Obj).ok();
                    let corner = read.map(|list| u64::from(list.faces().corners()[0]) + 1);
                    let fits = index <= u64::from(u32::MAX);
                    assert_eq!(corner, fits.then_some(index), "{text:?}");
                }
            }
        }
    }
}

#[test]
fn a_byte_order_mark_is_no_part_of_the_text() {
    let mesh = face_list(&classic::octahedron());
    let text = format!("\u{feff}{}", obj_text(&mesh));
    assert_same(&parse_obj(&text), &mesh, "with a byte order mark");
}

/// A megabyte is where a reader may well take a breath: whatever piece of text lies across it must
/// be read as anywhere else, and lines behind it be counted right.
#[test]
fn long_texts_are_read_like_short_ones() {
    const MEGABYTE: usize = 1 << 20;
    let mesh = face_list(&classic::tetrahedron());
    let text = attributed_text(&mesh, Given::Both).replace('\n', "\r\n");
    // Every face on two lines.
    let (before, faces) = text.split_at(text.find("f ").unwrap());
    let text = format!("{before}{}", faces.replace("f ", "f \\\r\n "));
    let expected = parse_obj(&text);
    assert_same(&expected, &mesh, "continued lines");
    let lines = text.lines().count();
    for overhang in 0..text.len() {
        let padding = "#".repeat(MEGABYTE - 1 - overhang);
        let long = format!("{padding}\n{text}");
        assert_eq!(parse_obj(&long), expected, "{overhang} bytes before the mark");
        let wrong = Mesh::parse(format!("{long}f 1 2 x\n").as_bytes(), Format::Obj).unwrap_err();
        let message = format!("line {}: 'x' is not an index", lines + 2);
        assert_eq!(wrong.to_string(), message, "{overhang} bytes before the mark");
    }
}

// A reader by others as oracle.

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

fn obj_text(mesh: &Mesh) -> String {
    let mut text = Vec::new();
    mesh.write_to(&mut text, Format::Obj).unwrap();
    String::from_utf8(text).unwrap()
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

// Nothing makes a reader panic.

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
    let _ = mesh.triangulate();
    let _ = Triangulation::build_oriented(&mut mesh, true);
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
