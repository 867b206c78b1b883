//! Wavefront OBJ.
//!
//! Reads `v`, `vt`, `vn` and `f` in all their forms, negative indices, continued lines and CRLF.
//! Objects, groups, smoothing groups and materials are kept as lines; everything else is skipped.
//! Reading is most of what users wait for, so numbers are parsed in place and in blocks.

mod blocks;
mod cursor;
mod write;

use std::io::Read;

use blocks::Blocks;
use cursor::{Cursor, Fault};
pub(super) use write::write;

use super::attributes::{Attributes, FaceSection};
use super::error::{MeshError, Place};
use super::faces::MAX_CORNERS;
use super::polygon_mesh::Mesh;

/// Reads an OBJ file, a block at a time: the text is never held as a whole.
///
/// # Errors
/// The first defect with its line, or an error of `input`.
pub(super) fn read(input: &mut dyn Read) -> Result<Mesh, MeshError> {
    let mut parser = Parser::default();
    let mut blocks = Blocks::default();
    while let Some(block) = blocks.next(input)? {
        if block.lines_before == 0 && has_lone_returns(block.text) {
            let problem = "lines end with carriage returns alone, as on old Macintoshes";
            return Err(MeshError::malformed(Place::Line(1), problem));
        }
        let mut cursor = Cursor { rest: block.text };
        if block.lines_before == 0 {
            cursor.skip_byte_order_mark();
        }
        while !cursor.rest.is_empty() {
            if let Err(fault) = parser.line(&mut cursor) {
                return Err(fault.at(block.line_at(block.text.len() - cursor.rest.len())));
            }
            cursor.skip_line();
        }
    }
    parser.finish()
}

/// Returns whether `text` has carriage returns inside and no line breaks.
fn has_lone_returns(text: &[u8]) -> bool {
    let first_return = memchr::memchr(b'\r', text);
    first_return.is_some_and(|at| at + 1 < text.len()) && memchr::memchr(b'\n', text).is_none()
}

#[derive(Default)]
struct Parser {
    list: Mesh,
    attributes: Attributes,
    has_weights: bool,
    has_colours: bool,
}

impl Parser {
    fn line(&mut self, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        cursor.skip_blanks();
        match cursor.rest {
            [b'v', rest @ ..] if ends_word(rest) => {
                cursor.rest = rest;
                self.vertex(cursor)
            }
            [b'f', rest @ ..] if ends_word(rest) => {
                cursor.rest = rest;
                self.face(cursor)
            }
            _ => {
                self.other(cursor.line().trim_ascii());
                Ok(())
            }
        }
    }

    fn vertex(&mut self, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        let position = [cursor.number()?, cursor.number()?, cursor.number()?];
        self.list.positions.push(position);
        cursor.skip_blanks();
        if !cursor.at_end() {
            match cursor
                .line()
                .split(u8::is_ascii_whitespace)
                .filter(|word| !word.is_empty())
                .count()
            {
                1 => self.has_weights = true,
                _ => self.has_colours = true,
            }
        }
        Ok(())
    }

    fn face(&mut self, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        let mut arity = 0;
        loop {
            cursor.skip_blanks();
            if cursor.at_end() {
                break;
            }
            self.corner(cursor)?;
            arity += 1;
        }
        if self.list.faces.corners().len() > MAX_CORNERS {
            return Err(Fault::too_large());
        }
        self.list.faces.close_face(arity);
        Ok(())
    }

    /// Reads one corner: `v`, `v/vt`, `v//vn` or `v/vt/vn`.
    fn corner(&mut self, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        let vertex = resolve(cursor.integer()?, self.list.positions.len(), "vertex")?;
        let corner = self.list.faces.corners().len();
        self.list.faces.push_corner(vertex);
        if !cursor.take(b'/') {
            return cursor.end_of_word();
        }
        let attributes = &mut self.attributes;
        if !cursor.rest.starts_with(b"/") {
            let texture =
                resolve(cursor.integer()?, attributes.texture_coordinates.len(), "texture")?;
            attributes.corner_texture.pad(corner);
            attributes.corner_texture.push(Some(texture));
        }
        if cursor.take(b'/') {
            let normal = resolve(cursor.integer()?, attributes.normals.len(), "normal")?;
            attributes.corner_normal.pad(corner);
            attributes.corner_normal.push(Some(normal));
        }
        cursor.end_of_word()
    }

    /// Keeps texture coordinates, normals, and lines that name the group of the faces after them.
    fn other(&mut self, line: &[u8]) {
        let end = line.iter().position(u8::is_ascii_whitespace).unwrap_or(line.len());
        let (keyword, value) = line.split_at(end);
        let text = || String::from_utf8_lossy(line).into_owned();
        match keyword {
            b"vt" => self.attributes.texture_coordinates.push(value.trim_ascii_start()),
            b"vn" => self.attributes.normals.push(value.trim_ascii_start()),
            b"o" | b"g" | b"s" | b"usemtl" => {
                let first_face = self.list.faces.len();
                self.attributes.sections.push(FaceSection { first_face, line: text() });
            }
            b"mtllib" => self.attributes.libraries.push(text()),
            _ => {}
        }
    }

    fn finish(mut self) -> Result<Mesh, MeshError> {
        let corners = self.list.faces.corners().len();
        let attributes = &mut self.attributes;
        for (indices, given, kind) in [
            (&mut attributes.corner_texture, attributes.texture_coordinates.len(), "texture"),
            (&mut attributes.corner_normal, attributes.normals.len(), "normal"),
        ] {
            if !indices.is_empty() {
                indices.pad(corners);
            }
            if let Some((_, index)) = indices.first_beyond(given) {
                let problem =
                    format!("a face names {kind} coordinate {}, there are {given}", index + 1);
                return Err(MeshError::malformed(Place::End, problem));
            }
        }
        if !self.attributes.is_empty() {
            self.list.attributes = Some(Box::new(self.attributes));
        }
        for (seen, what) in
            [(self.has_weights, "vertex weights"), (self.has_colours, "vertex colours")]
        {
            if seen {
                self.list.left_out.push(what.into());
            }
        }
        Ok(self.list)
    }
}

/// Returns the index from 0 that `index` means when `count` elements have been given so far.
fn resolve(index: i64, count: usize, kind: &str) -> Result<u32, Fault> {
    let from_zero = match index {
        0 => return Err(format!("{kind} index 0: indices start at 1").into()),
        1.. => index - 1,
        _ => count as i64 + index,
    };
    match u32::try_from(from_zero) {
        Ok(resolved) if resolved != u32::MAX => Ok(resolved),
        _ => Err(format!("{kind} index {index} is out of range").into()),
    }
}

/// Returns whether the keyword before `rest` is whole: no more letters follow.
fn ends_word(rest: &[u8]) -> bool {
    matches!(rest, [] | [b' ' | b'\t' | b'\r' | b'\n', ..])
}

#[cfg(test)]
mod tests {
    use super::blocks::BLOCK;
    use super::cursor::leading_digits;
    use super::*;

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
    fn lone_carriage_returns_are_named() {
        assert!(problem("v 0 0 0\rv 1 0 0\rf 1 2 1\r").starts_with("line 1: lines end with"));
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
            ("v 1 2 3,5\n", "line 1: '3,5' is not a number"),
            ("v 1 2 3\n\nf 1 0 1\n", "line 3: vertex index 0: indices start at 1"),
            ("v 1 2 3\nf -1 -2 -1\n", "line 2: vertex index -2 is out of range"),
            ("f 1 2 \\\n 3\nf 1 2 99999999999\n", "line 3: '99999999999' is not an index"),
            ("f 1 2 9999999999\n", "line 1: vertex index 9999999999 is out of range"),
            ("f 1 2 3x\n", "line 1: unexpected 'x' in a face"),
            ("f 1/ 2 3\n", "line 1: '' is not an index"),
            (
                "v 0 0 0\nf 1/1 1/1 1/1\n",
                "end of file: a face names texture coordinate 1, there are 0",
            ),
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
        assert_eq!(attributes.sections[3], FaceSection { first_face: 1, line: "s off".into() });
    }

    #[test]
    fn what_is_left_out_is_named() {
        let list = read(b"v 0 0 0 1\nv 0 0 0 0.5 0.5 0.5\nvp 1 2\nl 1 2\ncurv 0 1 1 2\n").unwrap();
        assert_eq!(list.left_out, ["vertex weights", "vertex colours"]);
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
}
