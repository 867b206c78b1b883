//! Wavefront OBJ.
//!
//! Reads `v`, `vt`, `vn` and `f` in all their forms, negative indices, continued lines, CRLF; keeps
//! objects, groups, smoothing groups and materials as the lines they are. Everything else is skipped.
//! Four million triangles take a fraction of a second: this is what users wait for.

use std::borrow::Cow;
use std::io::{self, Write};

use super::{Attributes, FaceList, Lines, MeshError, NO_INDEX, Place, Section};

/// Reads an OBJ file.
///
/// # Errors
/// The line and what is wrong there.
pub(super) fn read(bytes: &[u8]) -> Result<FaceList, MeshError> {
    let text = join_continued_lines(bytes);
    let mut parser = Parser::default();
    let mut start = 0;
    while start < text.len() {
        let end = memchr::memchr(b'\n', &text[start..]).map_or(text.len(), |length| start + length);
        if let Err(fault) = parser.line(&text[start..end]) {
            return Err(fault.at(line_number(bytes, start)));
        }
        start = end + 1;
    }
    parser.finish()
}

/// Replaces each backslash at the end of a line, and the line break, by as many spaces: positions in
/// the text stay what they are in the file.
fn join_continued_lines(bytes: &[u8]) -> Cow<'_, [u8]> {
    let break_after = |slash: usize| match bytes[slash + 1..] {
        [b'\n', ..] => 2,
        [b'\r', b'\n', ..] => 3,
        _ => 0,
    };
    let mut text = Cow::Borrowed(bytes);
    for slash in memchr::memchr_iter(b'\\', bytes) {
        let length = break_after(slash);
        if length > 0 {
            text.to_mut()[slash..slash + length].fill(b' ');
        }
    }
    text
}

fn line_number(bytes: &[u8], position: usize) -> usize {
    memchr::memchr_iter(b'\n', &bytes[..position]).count() + 1
}

/// What is wrong with a line.
enum Fault {
    Malformed(String),
    TooLarge,
}

impl Fault {
    fn at(self, line: usize) -> MeshError {
        match self {
            Self::Malformed(problem) => MeshError::malformed(Place::Line(line), problem),
            Self::TooLarge => MeshError::TooLarge,
        }
    }
}

impl From<&str> for Fault {
    fn from(problem: &str) -> Self {
        Self::Malformed(problem.to_owned())
    }
}

#[derive(Default)]
struct Parser {
    list: FaceList,
    attributes: Attributes,
    has_weights: bool,
    has_colours: bool,
}

impl Parser {
    fn line(&mut self, line: &[u8]) -> Result<(), Fault> {
        let line = line.trim_ascii_start();
        match line {
            [b'v', b' ' | b'\t', rest @ ..] => self.vertex(rest),
            [b'f', b' ' | b'\t', rest @ ..] => self.face(rest),
            [b'v', b't', b' ' | b'\t', rest @ ..] => {
                self.attributes.texture_coordinates.push(rest.trim_ascii());
                Ok(())
            }
            [b'v', b'n', b' ' | b'\t', rest @ ..] => {
                self.attributes.normals.push(rest.trim_ascii());
                Ok(())
            }
            _ => {
                self.other(line);
                Ok(())
            }
        }
    }

    fn vertex(&mut self, line: &[u8]) -> Result<(), Fault> {
        let mut cursor = Cursor { rest: line };
        let mut position = [0.0; 3];
        for coordinate in &mut position {
            *coordinate = cursor.number()?;
        }
        self.list.positions.push(position);
        cursor.skip_blanks();
        if !cursor.at_end() {
            match cursor.rest.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty()).count()
            {
                1 => self.has_weights = true,
                _ => self.has_colours = true,
            }
        }
        Ok(())
    }

    fn face(&mut self, line: &[u8]) -> Result<(), Fault> {
        let mut cursor = Cursor { rest: line };
        let mut arity = 0;
        loop {
            cursor.skip_blanks();
            if cursor.at_end() {
                break;
            }
            self.corner(&mut cursor)?;
            arity += 1;
        }
        if self.list.faces.corners().len() > crate::triangulation::MAX_HALF_EDGES {
            return Err(Fault::TooLarge);
        }
        self.list.faces.close_face(arity);
        Ok(())
    }

    /// One corner: `v`, `v/vt`, `v//vn` or `v/vt/vn`.
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
            attributes.corner_texture.resize(corner, NO_INDEX);
            attributes.corner_texture.push(texture);
        }
        if cursor.take(b'/') {
            let normal = resolve(cursor.integer()?, attributes.normals.len(), "normal")?;
            attributes.corner_normal.resize(corner, NO_INDEX);
            attributes.corner_normal.push(normal);
        }
        cursor.end_of_word()
    }

    /// Keeps the lines that say what the faces after them belong to.
    fn other(&mut self, line: &[u8]) {
        let line = line.trim_ascii_end();
        let keyword = line.split(u8::is_ascii_whitespace).next().unwrap_or_default();
        let text = || String::from_utf8_lossy(line).into_owned();
        match keyword {
            b"o" | b"g" | b"s" | b"usemtl" => {
                let first_face = self.list.faces.len();
                self.attributes.sections.push(Section { first_face, line: text() });
            }
            b"mtllib" => self.attributes.libraries.push(text()),
            _ => {}
        }
    }

    fn finish(mut self) -> Result<FaceList, MeshError> {
        let corners = self.list.faces.corners().len();
        let attributes = &mut self.attributes;
        for (indices, given, kind) in [
            (&mut attributes.corner_texture, attributes.texture_coordinates.len(), "texture"),
            (&mut attributes.corner_normal, attributes.normals.len(), "normal"),
        ] {
            if !indices.is_empty() {
                indices.resize(corners, NO_INDEX);
            }
            let missing = |&&index: &&u32| index != NO_INDEX && index as usize >= given;
            if let Some(&index) = indices.iter().find(missing) {
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

/// The index from 0 that `index` means when `count` elements have been given so far.
fn resolve(index: i64, count: usize, kind: &str) -> Result<u32, Fault> {
    let from_zero = match index {
        0 => return Err(Fault::Malformed(format!("{kind} index 0: indices start at 1"))),
        1.. => index - 1,
        _ => count as i64 + index,
    };
    match u32::try_from(from_zero) {
        Ok(resolved) if resolved != NO_INDEX => Ok(resolved),
        _ => Err(Fault::Malformed(format!("{kind} index {index} is out of range"))),
    }
}

/// What is left of a line.
struct Cursor<'l> {
    rest: &'l [u8],
}

impl Cursor<'_> {
    fn skip_blanks(&mut self) {
        while let [b' ' | b'\t' | b'\r', rest @ ..] = self.rest {
            self.rest = rest;
        }
    }

    /// Whether only a comment is left, or nothing.
    fn at_end(&self) -> bool {
        matches!(self.rest, [] | [b'#', ..])
    }

    fn take(&mut self, byte: u8) -> bool {
        let found = self.rest.first() == Some(&byte);
        if found {
            self.rest = &self.rest[1..];
        }
        found
    }

    fn end_of_word(&self) -> Result<(), Fault> {
        match self.rest {
            [] | [b' ' | b'\t' | b'\r' | b'#', ..] => Ok(()),
            _ => Err(format!("unexpected '{}' in a face", word(self.rest)).into()),
        }
    }

    fn number(&mut self) -> Result<f64, Fault> {
        self.skip_blanks();
        if self.at_end() {
            return Err("a vertex needs three coordinates".into());
        }
        let (value, length) = fast_float2::parse_partial(self.rest)
            .map_err(|_| Fault::from(format!("'{}' is not a number", word(self.rest))))?;
        match self.rest[length..] {
            [] | [b' ' | b'\t' | b'\r' | b'#', ..] => {
                self.rest = &self.rest[length..];
                Ok(value)
            }
            _ => Err(format!("'{}' is not a number", word(self.rest)).into()),
        }
    }

    /// A whole number of at most ten digits, with or without a sign.
    fn integer(&mut self) -> Result<i64, Fault> {
        let start = self.rest;
        let negative = self.take(b'-');
        let mut value = 0;
        let mut digits = 0;
        while let [digit @ b'0'..=b'9', rest @ ..] = self.rest
            && digits < 11
        {
            value = value * 10 + i64::from(digit - b'0');
            digits += 1;
            self.rest = rest;
        }
        match digits {
            1..=10 => Ok(if negative { -value } else { value }),
            _ => Err(format!("'{}' is not an index", word(start)).into()),
        }
    }
}

impl From<String> for Fault {
    fn from(problem: String) -> Self {
        Self::Malformed(problem)
    }
}

/// The first word of `text`, shortened, for messages.
fn word(text: &[u8]) -> String {
    let end = text.iter().position(u8::is_ascii_whitespace).unwrap_or(text.len());
    String::from_utf8_lossy(&text[..end.min(40)]).into_owned()
}

/// Writes an OBJ file, attributes included; `out` should be buffered.
///
/// # Errors
/// Those of `out`.
pub(super) fn write(out: &mut dyn Write, mesh: &FaceList) -> io::Result<()> {
    let mut text = Text { out, buffer: Vec::with_capacity(FLUSH_AT + 1024) };
    let none = Attributes::default();
    let attributes = mesh.attributes.as_deref().unwrap_or(&none);
    for library in &attributes.libraries {
        text.line(&[], library.as_bytes())?;
    }
    for position in &mesh.positions {
        text.vertex(position)?;
    }
    for (keyword, lines) in [("vt ", &attributes.texture_coordinates), ("vn ", &attributes.normals)]
    {
        write_lines(&mut text, keyword, lines)?;
    }
    let mut sections = attributes.sections.iter().peekable();
    for face in 0..mesh.faces.len() {
        while let Some(section) = sections.next_if(|section| section.first_face <= face) {
            text.line(&[], section.line.as_bytes())?;
        }
        text.face(mesh, attributes, face)?;
    }
    text.flush()
}

fn write_lines(text: &mut Text<'_>, keyword: &str, lines: &Lines) -> io::Result<()> {
    lines.iter().try_for_each(|line| text.line(keyword.as_bytes(), line))
}

const FLUSH_AT: usize = 1 << 15;

/// Text on its way out, handed over in large pieces.
struct Text<'o> {
    out: &'o mut dyn Write,
    buffer: Vec<u8>,
}

impl Text<'_> {
    fn vertex(&mut self, position: &[f64; 3]) -> io::Result<()> {
        self.buffer.push(b'v');
        for &coordinate in position {
            self.buffer.push(b' ');
            self.buffer.extend_from_slice(zmij::Buffer::new().format(coordinate).as_bytes());
        }
        self.end_line()
    }

    fn face(&mut self, mesh: &FaceList, attributes: &Attributes, face: usize) -> io::Result<()> {
        self.buffer.push(b'f');
        for corner in mesh.faces.range(face) {
            self.buffer.push(b' ');
            self.index(mesh.faces.corners()[corner]);
            let given = |indices: &Vec<u32>| {
                indices.get(corner).copied().filter(|&index| index != NO_INDEX)
            };
            match (given(&attributes.corner_texture), given(&attributes.corner_normal)) {
                (None, None) => {}
                (texture, normal) => {
                    self.buffer.push(b'/');
                    texture.into_iter().for_each(|index| self.index(index));
                    if let Some(index) = normal {
                        self.buffer.push(b'/');
                        self.index(index);
                    }
                }
            }
        }
        self.end_line()
    }

    fn index(&mut self, from_zero: u32) {
        let from_one = u64::from(from_zero) + 1;
        self.buffer.extend_from_slice(itoa::Buffer::new().format(from_one).as_bytes());
    }

    fn line(&mut self, keyword: &[u8], text: &[u8]) -> io::Result<()> {
        self.buffer.extend_from_slice(keyword);
        self.buffer.extend_from_slice(text);
        self.end_line()
    }

    fn end_line(&mut self) -> io::Result<()> {
        self.buffer.push(b'\n');
        if self.buffer.len() >= FLUSH_AT { self.flush() } else { Ok(()) }
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.write_all(&self.buffer)?;
        self.buffer.clear();
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
            "mtllib a.mtl\n{POINTS}o box\ng left side\nusemtl red\nf 1/1/1 2/2/1 3/3/1\ns off\nf 3 2 1\nf 1//1 2//1 3//1\n"
        );
        let list = read(text.as_bytes()).unwrap();
        let mut written = Vec::new();
        write(&mut written, &list).unwrap();
        assert_eq!(read(&written).unwrap(), list);
        let attributes = list.attributes.unwrap();
        assert_eq!(attributes.corner_texture[..4], [0, 1, 2, NO_INDEX]);
        assert_eq!(attributes.sections[3], Section { first_face: 1, line: "s off".into() });
    }

    #[test]
    fn what_is_left_out_is_named() {
        let list = read(b"v 0 0 0 1\nv 0 0 0 0.5 0.5 0.5\nvp 1 2\nl 1 2\ncurv 0 1 1 2\n").unwrap();
        assert_eq!(list.left_out, ["vertex weights", "vertex colours"]);
        assert!(list.faces.is_empty() && list.attributes.is_none());
    }

    #[test]
    fn no_prefix_of_a_file_makes_the_reader_panic() {
        let text = format!("{POINTS}o x\nf 1/1/1 2/2/1 \\\n3/3/1\nf -1 -2 -3\n");
        for end in 0..text.len() {
            let _ = read(&text.as_bytes()[..end]);
        }
    }
}
