//! Wavefront OBJ.
//!
//! Reads `v`, `vt`, `vn` and `f` in all their forms, negative indices, continued lines, CRLF; keeps
//! objects, groups, smoothing groups and materials as the lines they are. Everything else is skipped.
//! Four million triangles take a fraction of a second: this is what users wait for.

use std::io::{self, Read, Write};

use super::{Attributes, FaceList, Lines, MeshError, NO_INDEX, Place, Section};

/// Reads an OBJ file, a block at a time: the text is never held as a whole.
///
/// # Errors
/// The line and what is wrong there, or what `input` complains of.
pub(super) fn read(input: &mut dyn Read) -> Result<FaceList, MeshError> {
    let mut parser = Parser::default();
    let mut blocks = Blocks::default();
    while let Some(block) = blocks.next(input)? {
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

/// Number of bytes asked for at a time.
const BLOCK: usize = 1 << 20;

/// The text in blocks of whole lines, continued ones joined.
#[derive(Default)]
struct Blocks {
    buffer: Vec<u8>,
    /// Length of the last block given out, at the front of `buffer`.
    given: usize,
    lines_given: usize,
    /// Where in the block line breaks have been replaced to join lines.
    joined: Vec<usize>,
}

/// Some whole lines.
struct Block<'b> {
    text: &'b [u8],
    lines_before: usize,
    joined: &'b [usize],
}

impl Block<'_> {
    /// The number in the file of the line at `position`.
    fn line_at(&self, position: usize) -> usize {
        let breaks = memchr::memchr_iter(b'\n', &self.text[..position]).count();
        let joined = self.joined.iter().filter(|&&at| at < position).count();
        self.lines_before + breaks + joined + 1
    }
}

impl Blocks {
    fn next(&mut self, input: &mut dyn Read) -> Result<Option<Block<'_>>, MeshError> {
        self.drop_given();
        let mut end;
        loop {
            let before = self.buffer.len();
            input.take(BLOCK as u64).read_to_end(&mut self.buffer)?;
            let at_end = self.buffer.len() == before;
            end = if at_end { self.buffer.len() } else { end_of_whole_lines(&self.buffer) };
            if end > 0 || at_end {
                break;
            }
        }
        self.given = end;
        self.join_continued_lines();
        let text = &self.buffer[..end];
        let block = Block { text, lines_before: self.lines_given, joined: &self.joined };
        Ok((end > 0).then_some(block))
    }

    fn drop_given(&mut self) {
        let given = &self.buffer[..self.given];
        self.lines_given += memchr::memchr_iter(b'\n', given).count() + self.joined.len();
        self.joined.clear();
        self.buffer.drain(..self.given);
    }

    /// Replaces each backslash at the end of a line, and the line break, by as many spaces.
    fn join_continued_lines(&mut self) {
        let mut from = 0;
        while let Some(found) = memchr::memchr(b'\\', &self.buffer[from..self.given]) {
            let slash = from + found;
            let length = match self.buffer[slash + 1..self.given] {
                [b'\n', ..] => 2,
                [b'\r', b'\n', ..] => 3,
                _ => 0,
            };
            if length > 0 {
                self.buffer[slash..slash + length].fill(b' ');
                self.joined.push(slash + length - 1);
            }
            from = slash + 1;
        }
    }
}

/// Where the last line ends that is whole and not continued; 0 if none does.
fn end_of_whole_lines(text: &[u8]) -> usize {
    let mut end = text.len();
    while let Some(at) = memchr::memrchr(b'\n', &text[..end]) {
        match text[..at] {
            [.., b'\\'] | [.., b'\\', b'\r'] => end = at,
            _ => return at + 1,
        }
    }
    0
}

/// What is wrong with a line. Boxed, so that results fit in registers where nothing is wrong.
struct Fault(Box<Problem>);

enum Problem {
    Malformed(String),
    TooLarge,
}

impl Fault {
    fn at(self, line: usize) -> MeshError {
        match *self.0 {
            Problem::Malformed(problem) => MeshError::malformed(Place::Line(line), problem),
            Problem::TooLarge => MeshError::TooLarge,
        }
    }
}

impl From<String> for Fault {
    #[cold]
    fn from(problem: String) -> Self {
        Self(Box::new(Problem::Malformed(problem)))
    }
}

impl From<&str> for Fault {
    #[cold]
    fn from(problem: &str) -> Self {
        problem.to_owned().into()
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
        if self.list.faces.corners().len() > crate::triangulation::MAX_HALF_EDGES {
            return Err(Fault(Box::new(Problem::TooLarge)));
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

    /// Keeps texture coordinates and normals, and the lines that say what the faces after them belong
    /// to.
    fn other(&mut self, line: &[u8]) {
        let end = line.iter().position(u8::is_ascii_whitespace).unwrap_or(line.len());
        let (keyword, value) = line.split_at(end);
        let text = || String::from_utf8_lossy(line).into_owned();
        match keyword {
            b"vt" => self.attributes.texture_coordinates.push(value.trim_ascii_start()),
            b"vn" => self.attributes.normals.push(value.trim_ascii_start()),
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
        0 => return Err(format!("{kind} index 0: indices start at 1").into()),
        1.. => index - 1,
        _ => count as i64 + index,
    };
    match u32::try_from(from_zero) {
        Ok(resolved) if resolved != NO_INDEX => Ok(resolved),
        _ => Err(format!("{kind} index {index} is out of range").into()),
    }
}

/// Whether no more letters follow: the keyword before `rest` is whole.
fn ends_word(rest: &[u8]) -> bool {
    matches!(rest, [] | [b' ' | b'\t' | b'\r' | b'\n', ..])
}

/// What is left of the text.
struct Cursor<'t> {
    rest: &'t [u8],
}

impl<'t> Cursor<'t> {
    /// Some programs begin a UTF-8 text so; left there, it would hide the first keyword.
    fn skip_byte_order_mark(&mut self) {
        self.rest = self.rest.strip_prefix(b"\xef\xbb\xbf").unwrap_or(self.rest);
    }

    #[inline]
    fn skip_blanks(&mut self) {
        while let [b' ' | b'\t' | b'\r', rest @ ..] = self.rest {
            self.rest = rest;
        }
    }

    /// Whether only a comment is left of the line, or nothing.
    #[inline]
    fn at_end(&self) -> bool {
        matches!(self.rest, [] | [b'\n' | b'#', ..])
    }

    /// What is left of the line.
    fn line(&self) -> &'t [u8] {
        &self.rest[..memchr::memchr(b'\n', self.rest).unwrap_or(self.rest.len())]
    }

    #[inline]
    fn skip_line(&mut self) {
        self.rest = match self.rest {
            [b'\n', rest @ ..] => rest,
            rest => rest.get(self.line().len() + 1..).unwrap_or_default(),
        };
    }

    #[inline]
    fn take(&mut self, byte: u8) -> bool {
        let found = self.rest.first() == Some(&byte);
        if found {
            self.rest = &self.rest[1..];
        }
        found
    }

    #[inline]
    fn end_of_word(&self) -> Result<(), Fault> {
        match self.rest {
            [] | [b' ' | b'\t' | b'\r' | b'\n' | b'#', ..] => Ok(()),
            _ => Err(format!("unexpected '{}' in a face", word(self.rest)).into()),
        }
    }

    #[inline]
    fn number(&mut self) -> Result<f64, Fault> {
        self.skip_blanks();
        if self.at_end() {
            return Err("a vertex needs three coordinates".into());
        }
        let (value, length) = fast_float2::parse_partial(self.rest)
            .map_err(|_| Fault::from(format!("'{}' is not a number", word(self.rest))))?;
        match self.rest[length..] {
            [] | [b' ' | b'\t' | b'\r' | b'\n' | b'#', ..] => {
                self.rest = &self.rest[length..];
                Ok(value)
            }
            _ => Err(format!("'{}' is not a number", word(self.rest)).into()),
        }
    }

    /// A whole number of at most ten digits, with or without a sign.
    #[inline]
    fn integer(&mut self) -> Result<i64, Fault> {
        let start = self.rest;
        let negative = self.take(b'-');
        let (mut value, mut digits) = leading_digits(self.rest);
        self.rest = &self.rest[digits..];
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

/// The value and number of the digits among the first eight bytes up to the first other one, all
/// eight at once; none if there are fewer than eight bytes.
#[inline]
fn leading_digits(text: &[u8]) -> (i64, usize) {
    let Some(&bytes) = text.first_chunk::<8>() else { return (0, 0) };
    // Digits become 0 to 9; of any other byte the top bit is set in `others`.
    let word = u64::from_le_bytes(bytes) ^ 0x3030_3030_3030_3030;
    let others =
        (word | (word & 0x7f7f_7f7f_7f7f_7f7f) + 0x7676_7676_7676_7676) & 0x8080_8080_8080_8080;
    let digits = others.trailing_zeros() as usize / 8;
    if digits == 0 {
        return (0, 0);
    }
    // As if zeros stood in front; then neighbouring digits are joined, pairs, and fours.
    let ones = word << (64 - 8 * digits);
    let pairs = (ones.wrapping_mul(10) + (ones >> 8)) & 0x00ff_00ff_00ff_00ff;
    let fours = (pairs.wrapping_mul(100) + (pairs >> 16)) & 0x0000_ffff_0000_ffff;
    ((fours.wrapping_mul(10_000) + (fours >> 32)) as u32 as i64, digits)
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

    fn read(text: &[u8]) -> Result<FaceList, MeshError> {
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
