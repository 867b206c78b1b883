//! Meshes, and the texts and bytes that hold them.

use std::fmt::Write as _;
use std::io::Read as _;
use std::path::Path;

use crate::common::{face_list, random_of, special_surfaces};
use flate2::read::MultiGzDecoder;
use triquad::Converter;
use triquad::mesh::{FaceSection, FaceSections, Format, Mesh, Output};
use triquad::random::Random;
use triquad_generators::Surface;
use triquad_generators::random::Mix;

/// Small surfaces of several genera, regular and random.
pub fn surfaces() -> Vec<(String, Surface)> {
    let special = special_surfaces().into_iter().map(|(name, surface)| (name.to_owned(), surface));
    let kinds = [0, 1, 2, 5].into_iter().flat_map(|genus| Mix::ALL.map(|mix| (genus, mix)));
    let random = kinds.map(|(genus, mix)| {
        (format!("{mix:?} of genus {genus}"), random_of(genus, 150, mix, genus as u64))
    });
    special.chain(random).collect()
}

/// The vertices of `triangles` with the quads that the default settings make.
pub fn quads_of(triangles: &Mesh) -> Mesh {
    Converter::new().run(triangles).expect("a closed surface").into_mesh()
}

/// Numbers that are easily lost on the way through a text or through 32 bits.
pub const AWKWARD: [f64; 12] = [
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
pub fn make_awkward(positions: &mut [[f64; 3]], random: &mut Random) {
    for coordinate in positions.as_flattened_mut() {
        *coordinate = match random.below(3) {
            0 => AWKWARD[random.below(AWKWARD.len() as u32) as usize],
            1 => any_finite(random),
            _ => *coordinate + 1e-17 * f64::from(random.below(1 << 20)),
        };
    }
}

pub fn any_finite(random: &mut Random) -> f64 {
    loop {
        let halves = [random.below(u32::MAX), random.below(u32::MAX)].map(u64::from);
        let number = f64::from_bits(halves[0] << 32 | halves[1]);
        if number.is_finite() {
            return number;
        }
    }
}

/// Writes `mesh` to a file of that name and reads the file.
pub fn through_file(mesh: &Mesh, folder: &Path, name: &str) -> Mesh {
    let path = folder.join(name);
    Output::create(&path).unwrap().write(mesh).unwrap();
    Mesh::read(&path).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// Coordinates as bits, which tell -0 from 0.
pub fn bits(positions: &[[f64; 3]]) -> Vec<[u64; 3]> {
    positions.iter().map(|position| position.map(f64::to_bits)).collect()
}

pub fn assert_same(read: &Mesh, written: &Mesh, what: &str) {
    assert_eq!(bits(read.positions()), bits(written.positions()), "positions of {what}");
    assert_eq!(read.faces(), written.faces(), "faces of {what}");
}

pub fn unzip(bytes: &[u8]) -> Vec<u8> {
    let mut plain = Vec::new();
    MultiGzDecoder::new(bytes).read_to_end(&mut plain).unwrap();
    plain
}

/// Sections of a mesh, as line and the share of faces before it in percent.
pub const SECTIONS: [(usize, &str); 7] = [
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
pub enum Given {
    Texture,
    Normal,
    Both,
    /// Nothing to one face, everything to the next, and so on.
    Changing,
}

impl Given {
    pub const ALL: [Self; 4] = [Self::Texture, Self::Normal, Self::Both, Self::Changing];

    /// Texture and normal index (from 1) of a corner.
    pub fn at(self, mesh: &Mesh, corner: usize) -> (Option<usize>, Option<usize>) {
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
pub fn texture_of(mesh: &Mesh, corner: usize) -> usize {
    mesh.faces().corners().len() - corner
}

/// An OBJ text with everything that is carried along.
pub fn attributed_text(mesh: &Mesh, given: Given) -> String {
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

pub fn parse_obj(text: &str) -> Mesh {
    Mesh::parse(text.as_bytes(), Format::Obj).unwrap()
}

/// A surface whose coordinates all are 32-bit numbers, no two vertices at the same place.
pub fn single_precision_mesh() -> Mesh {
    let mut mesh = face_list(&random_of(2, 120, Mix::Balanced, 7));
    for (v, position) in mesh.positions_mut().iter_mut().enumerate() {
        let v = v as f32;
        *position = [v * 0.1, -v, 1.0 / (v + 1.0)].map(f64::from);
    }
    mesh
}

pub fn ply_header(mesh: &Mesh, encoding: &str) -> String {
    format!(
        "ply\nformat {encoding} 1.0\ncomment not by triquad\nelement vertex {}\nproperty double x\n\
         property double y\nproperty double z\nelement face {}\nproperty list uchar uint vertex_index\nend_header\n",
        mesh.positions().len(),
        mesh.faces().len()
    )
}

pub fn ascii_ply(mesh: &Mesh) -> Vec<u8> {
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

pub fn big_endian_ply(mesh: &Mesh) -> Vec<u8> {
    let mut bytes = ply_header(mesh, "binary_big_endian").into_bytes();
    bytes.extend(mesh.positions().as_flattened().iter().flat_map(|x| x.to_be_bytes()));
    for face in mesh.faces() {
        bytes.push(face.len() as u8);
        bytes.extend(face.iter().flat_map(|v| v.to_be_bytes()));
    }
    bytes
}

pub fn ascii_stl(mesh: &Mesh) -> Vec<u8> {
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

pub fn binary_stl(mesh: &Mesh) -> Vec<u8> {
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

pub fn obj_text(mesh: &Mesh) -> String {
    let mut text = Vec::new();
    mesh.write_to(&mut text, Format::Obj).unwrap();
    String::from_utf8(text).unwrap()
}

/// Returns the sections of [`attributed_text`].
pub fn sections(mesh: &Mesh) -> FaceSections {
    let at = |&(percent, line): &(usize, &'static str)| FaceSection {
        first_face: mesh.faces().len() * percent / 100,
        line,
    };
    SECTIONS.iter().map(at).collect()
}
