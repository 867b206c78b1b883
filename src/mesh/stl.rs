//! Stereolithography (`.stl`), text and binary.
//!
//! Triangles have no common vertices in such a file: corners at equal coordinates are made one
//! vertex. Normals and attribute bytes hold nothing that a surface needs and are not read.

use super::error::{MeshError, Place};
use super::faces::MAX_CORNERS;
use super::polygon_mesh::Mesh;
use super::text::is_padding;
use super::tokens::{self, Tokens};
use super::weld::ExactWelder;
use crate::counted::counted;

const HEADER_BYTES: usize = 84;
const TRIANGLE_BYTES: usize = 50;

/// Reads an STL file.
///
/// The word `solid` at the beginning proves nothing, as binary headers may hold it too. A file is
/// binary if it is as long as a binary file should be, padding aside. It is also binary if it does
/// not read as text and has a zero byte, as no text has.
pub(super) fn read(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let binary = read_binary(bytes);
    if binary.is_ok() || matches!(binary, Err(MeshError::TooLarge)) {
        return binary;
    }
    let text = Text { tokens: Tokens::new(bytes), has_colours: false }.read();
    if text.is_err() && memchr::memchr(0, bytes).is_some() { binary } else { text }
}

fn read_binary(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let Some((header, body)) = bytes.split_first_chunk::<HEADER_BYTES>() else {
        return Err(tokens::truncated("the header"));
    };
    let count = u32::from_le_bytes([header[80], header[81], header[82], header[83]]) as usize;
    let (records, _) = body.as_chunks::<TRIANGLE_BYTES>();
    let Some(records) = records.get(..count) else {
        return Err(tokens::truncated_record("triangle", records.len(), count));
    };
    let surplus = &body[records.as_flattened().len()..];
    if !is_padding(surplus) {
        let place = Place::Byte(bytes.len() - surplus.len());
        let problem = format!(
            "{} after the last of {}",
            counted(surplus.len(), "byte", "bytes"),
            counted(count, "triangle", "triangles")
        );
        return Err(MeshError::malformed(place, problem));
    }
    let mut welder = Triangles::with_capacity(count)?;
    for record in records {
        let (values, _) = record.as_chunks::<4>();
        let value = |k: usize| f64::from(f32::from_le_bytes(values[k]));
        // The first three are the normal.
        welder.push([3, 6, 9].map(|k| [value(k), value(k + 1), value(k + 2)]))?;
    }
    let mut mesh = welder.finish();
    if !surplus.is_empty() {
        mesh.left_out.push("data after the last triangle".into());
    }
    Ok(mesh)
}

/// A text file.
struct Text<'a> {
    tokens: Tokens<'a>,
    has_colours: bool,
}

impl Text<'_> {
    fn read(mut self) -> Result<Mesh, MeshError> {
        let mut triangles = Triangles::with_capacity(0)?;
        self.expect(&["solid"])?;
        loop {
            self.tokens.skip_line(); // The name of the solid, behind `solid` or `endsolid`.
            while self.next_is(&["facet", "endsolid"])? == 0 {
                triangles.push(self.read_facet()?)?;
            }
            self.tokens.skip_line();
            if is_padding(self.tokens.rest()) {
                break;
            }
            self.expect(&["solid"])?;
        }
        let mut mesh = triangles.finish();
        if self.has_colours {
            mesh.left_out.push("colours".into());
        }
        Ok(mesh)
    }

    /// Reads one triangle behind the word `facet`.
    fn read_facet(&mut self) -> Result<[[f64; 3]; 3], MeshError> {
        self.expect(&["normal"])?;
        for _ in 0..3 {
            // Often not even a number, for a triangle without area.
            self.tokens.read("a component of the normal", |_| Some(()))?;
        }
        self.expect(&["outer", "loop"])?;
        let mut corners = [[0.0; 3]; 3];
        for corner in &mut corners {
            self.expect(&["vertex"])?;
            for coordinate in corner {
                *coordinate = self.tokens.read("a coordinate", tokens::float)?;
            }
        }
        self.expect(&["endloop", "endfacet"])?;
        Ok(corners)
    }

    /// Reads the given words, in whatever case they are written.
    fn expect(&mut self, words: &[&str]) -> Result<(), MeshError> {
        words.iter().try_for_each(|word| self.next_is(&[word]).map(|_| ()))
    }

    /// Reads a word; returns which of `choices` it is. Passes over lines with colours.
    ///
    /// Words that begin with `end` may be written as two.
    fn next_is(&mut self, choices: &[&str]) -> Result<usize, MeshError> {
        while let Some(word) = self.tokens.next_word() {
            let is = |text: &str| word.eq_ignore_ascii_case(text.as_bytes());
            if let Some(choice) = choices.iter().position(|choice| is(choice)) {
                return Ok(choice);
            }
            if is("color") || is("colour") {
                self.has_colours = true;
                self.tokens.skip_line();
                continue;
            }
            let first = self.tokens;
            if is("end")
                && let Some(second) = self.tokens.next_in_line()
                && let Some(choice) = choices.iter().position(|choice| is_end_of(choice, second))
            {
                return Ok(choice);
            }
            let cut_off = choices.iter().find_map(|choice| first.cut_off_within(choice));
            return Err(cut_off.unwrap_or_else(|| first.unexpected(&listed(choices))));
        }
        Err(tokens::truncated(listed(choices)))
    }
}

/// Returns whether `word` is what follows `end` in `choice`.
fn is_end_of(choice: &str, word: &[u8]) -> bool {
    choice.strip_prefix("end").is_some_and(|end| word.eq_ignore_ascii_case(end.as_bytes()))
}

fn listed(choices: &[&str]) -> String {
    format!("'{}'", choices.join("' or '"))
}

/// Triangles whose corners at equal coordinates are one vertex.
struct Triangles {
    welder: ExactWelder,
    triangles: Vec<[u32; 3]>,
}

impl Triangles {
    fn with_capacity(triangles: usize) -> Result<Self, MeshError> {
        if triangles > MAX_CORNERS / 3 {
            return Err(MeshError::TooLarge);
        }
        // A closed surface has about half as many vertices as triangles.
        let welder = ExactWelder::with_capacity(triangles / 2);
        Ok(Self { welder, triangles: Vec::with_capacity(triangles) })
    }

    fn push(&mut self, corners: [[f64; 3]; 3]) -> Result<(), MeshError> {
        if self.triangles.len() == MAX_CORNERS / 3 {
            return Err(MeshError::TooLarge);
        }
        self.triangles.push(corners.map(|position| self.welder.vertex(position)));
        Ok(())
    }

    fn finish(self) -> Mesh {
        Mesh::from_triangles(self.welder.positions, self.triangles)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const A: [f32; 3] = [0.0, 0.0, 0.1];
    const B: [f32; 3] = [1.0, 0.0, 0.0];
    const C: [f32; 3] = [0.0, 1.0, 0.0];
    const D: [f32; 3] = [-0.0, 1.0, -0.0];

    fn binary(header: &[u8], triangles: &[[[f32; 3]; 3]]) -> Vec<u8> {
        let mut bytes = header.to_vec();
        bytes.resize(80, b' ');
        bytes.extend((triangles.len() as u32).to_le_bytes());
        for triangle in triangles {
            bytes.extend([7; 12]);
            bytes.extend(triangle.as_flattened().iter().flat_map(|value| value.to_le_bytes()));
            bytes.extend([1, 2]);
        }
        bytes
    }

    fn text(triangles: &[[[f32; 3]; 3]]) -> String {
        let mut text = String::from("solid two words\r\n");
        for triangle in triangles {
            text += "facet normal nan 0 -nan(ind)\r\n outer loop\r\n";
            for [x, y, z] in triangle {
                text += &format!("  vertex {x} {y:e} {z}\r\n");
            }
            text += " endloop\r\nEndFacet\r\n";
        }
        text + "endsolid two words"
    }

    fn problem(bytes: &[u8]) -> String {
        read(bytes).unwrap_err().to_string()
    }

    #[test]
    fn equal_corners_become_one_vertex() {
        let triangles = [[A, B, C], [B, A, D]];
        let mesh = read(&binary(b"solid but binary", &triangles)).unwrap();
        assert_eq!(mesh.positions, [A, B, C].map(|p| p.map(f64::from)));
        assert_eq!(mesh.faces.corners(), [0, 1, 2, 1, 0, 2]);
        assert!(mesh.left_out.is_empty());
        let mesh = read(text(&triangles).as_bytes()).unwrap();
        assert_eq!(mesh.positions, [[0.0, 0.0, 0.1], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
        assert_eq!(mesh.faces.corners(), [0, 1, 2, 1, 0, 2]);
    }

    #[test]
    fn not_a_number_is_passed_on() {
        let nan = [f32::NAN, 0.0, 0.0];
        for bytes in [binary(b"", &[[A, nan, nan]]), text(&[[A, nan, nan]]).into_bytes()] {
            let mesh = read(&bytes).unwrap();
            assert!(mesh.positions[1][0].is_nan());
            assert_eq!(mesh.faces.len(), 1);
        }
    }

    #[test]
    fn solids_are_joined() {
        let two = [text(&[[A, B, C]]), text(&[]), text(&[[A, C, B]])].join("\n");
        let mesh = read((two + "\n\n").as_bytes()).unwrap();
        assert_eq!(mesh.faces.corners(), [0, 1, 2, 0, 2, 1]);
        assert!(read(b"solid\nendsolid\n").unwrap().faces.is_empty());
    }

    #[test]
    fn a_wrong_length_is_told_in_binary_terms() {
        let mut bytes = binary(b"solid", &[[A, B, C], [C, B, A]]);
        bytes.push(7);
        assert_eq!(problem(&bytes), "byte 184: 1 byte after the last of 2 triangles");
        assert_eq!(problem(&bytes[..183]), "the file ends before triangle 2 of 2");
        bytes[80..84].fill(255);
        assert!(problem(&bytes).contains("the file ends before triangle 3 of 4294967295"));
        assert_eq!(problem(&[0; 83]), "the file ends before the header");
    }

    #[test]
    fn wrong_text_is_told_in_lines() {
        let good = text(&[[A, B, C]]);
        let wrong = |from, to| problem(good.replacen(from, to, 1).as_bytes());
        assert_eq!(wrong("solid", "mesh"), "line 1: 'mesh' is not 'solid'");
        assert_eq!(wrong("1e0", "one"), "line 6: 'one' is not a coordinate");
        assert_eq!(wrong(" endloop", "  vertex"), "line 7: 'vertex' is not 'endloop'");
        assert_eq!(wrong("\nendsolid", "\nend"), "line 9: 'end' is not 'facet' or 'endsolid'");
        assert_eq!(problem(b""), "the file ends before 'solid'");
        assert_eq!(problem(b"Soli"), "the file ends before the end of the word 'solid'");
        let cut_off = &good.as_bytes()[..good.find("loop").unwrap() + 2];
        assert_eq!(problem(cut_off), "the file ends before the end of the word 'loop'");
    }

    #[test]
    fn padding_behind_the_last_triangle_is_noted() {
        let bytes = binary(b"", &[[A, B, C], [C, B, A]]);
        for padding in [&b"\n"[..], b"\r\n", b"\0", &[0; 50], &[0; 1000], b" \x1a"] {
            let mesh = read(&[&bytes, padding].concat()).unwrap();
            assert_eq!(mesh.faces.len(), 2);
            assert_eq!(mesh.left_out, ["data after the last triangle"]);
        }
        let text = text(&[[A, B, C]]);
        assert!(read(&[text.as_bytes(), b"\n\0\0\x1a"].concat()).is_ok());
    }

    #[test]
    fn dialects_of_text_are_read() {
        let plain = text(&[[A, B, C], [B, A, D]]);
        let expected = read(plain.as_bytes()).unwrap();
        for (from, to) in [
            ("endsolid", "End Solid"),
            ("endloop", "end loop"),
            ("EndFacet", "end  facet"),
            ("\r\n", "\r"),
            ("\r\n", "\n"),
            ("solid two words\r\nfacet", "\u{feff}solid two words\r\nfacet"),
        ] {
            assert_eq!(read(plain.replace(from, to).as_bytes()).unwrap(), expected, "{to}");
        }
        let coloured = plain.replace("facet normal", "color 1 0 0\rfacet normal");
        let mesh = read(coloured.as_bytes()).unwrap();
        assert_eq!((mesh.left_out, mesh.faces), (vec!["colours".into()], expected.faces));
    }

    #[test]
    fn every_proper_prefix_is_refused() {
        let bytes = binary(b"solid\nendsolid\n", &[[A, B, C], [C, B, A]]);
        // Up to its 15th byte this is a text, and so it would be with nothing but spaces behind.
        assert!((84..bytes.len()).all(|length| read(&bytes[..length]).is_err()));
        let bytes = text(&[[A, B, C]]).into_bytes();
        let whole = bytes.len() - " two words".len();
        assert!((0..whole).all(|length| read(&bytes[..length]).is_err()));
    }
}
