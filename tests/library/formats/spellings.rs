//! What others write.

use super::texts::{
    Given, ascii_ply, ascii_stl, assert_same, attributed_text, big_endian_ply, binary_stl, bits,
    make_awkward, obj_text, parse_obj, ply_header, quads_of, single_precision_mesh,
};
use crate::common::face_list;
use triquad::mesh::{Faces, Format, Mesh};
use triquad::random::Random;
use triquad_generators::{classic, grids};

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
