//! Writing OBJ.
//!
//! The text is made in pieces, several at once if there are threads. One piece follows the other in
//! the file, so the bytes do not depend on the number of threads.

use std::io::{self, Write};
use std::ops::Range;

use crate::mesh::attributes::Attributes;
use crate::mesh::corner_indices::CornerIndices;
use crate::mesh::polygon_mesh::Mesh;
use crate::parallel::{beside, map, threads};

/// Lines in a piece: some 40 KB, which stay in the cache.
const LINES: usize = 1 << 10;

/// Writes an OBJ file, attributes included.
///
/// # Errors
/// Those of `out`.
pub(in crate::mesh) fn write(out: &mut dyn Write, mesh: &Mesh) -> io::Result<()> {
    match threads() {
        1 => write_pieces(out, mesh, LINES, 1),
        // Larger ones: threads that wait for each other lose much more than the cache saves.
        threads => write_pieces(out, mesh, 16 * LINES, (2 * threads).max(16)),
    }
}

/// Writes in pieces of so many `lines`, and makes so many pieces `at_once`.
///
/// While some are written, the next ones are made.
pub(super) fn write_pieces(
    out: &mut dyn Write,
    mesh: &Mesh,
    lines: usize,
    at_once: usize,
) -> io::Result<()> {
    let none = Attributes::default();
    let content = Content { mesh, attributes: mesh.attributes.as_deref().unwrap_or(&none) };
    let mut pieces = content.pieces(lines);
    let (mut texts, mut spare) = (Vec::<Text>::new(), Vec::<Text>::new());
    loop {
        let room = std::iter::repeat_with(|| spare.pop().unwrap_or_default());
        let batch: Vec<_> = pieces.by_ref().take(at_once).zip(room).collect();
        let make = || map(batch, |(piece, text)| content.text(piece, text));
        let write = || texts.iter().try_for_each(|text| out.write_all(&text.0));
        let (next, written) = beside(make, write);
        written?;
        if next.is_empty() {
            return Ok(());
        }
        spare.append(&mut texts);
        texts = next;
    }
}

/// Some lines of one kind.
struct Piece {
    kind: Kind,
    lines: Range<usize>,
}

#[derive(Clone, Copy)]
enum Kind {
    Libraries,
    Vertices,
    TextureCoordinates,
    Normals,
    /// Faces, each after the lines that hold from it on.
    Faces,
}

/// The content of a file.
#[derive(Clone, Copy)]
struct Content<'m> {
    mesh: &'m Mesh,
    attributes: &'m Attributes,
}

impl Content<'_> {
    /// Divides the file into pieces of so many lines, in order.
    fn pieces(self, lines: usize) -> impl Iterator<Item = Piece> {
        let Self { mesh, attributes } = self;
        let counts = [
            (Kind::Libraries, attributes.libraries.len()),
            (Kind::Vertices, mesh.positions.len()),
            (Kind::TextureCoordinates, attributes.texture_coordinates.len()),
            (Kind::Normals, attributes.normals.len()),
            (Kind::Faces, mesh.faces.len()),
        ];
        counts.into_iter().flat_map(move |(kind, count)| {
            let starts = (0..count).step_by(lines);
            starts.map(move |start| Piece { kind, lines: start..count.min(start + lines) })
        })
    }

    /// Makes the text of a piece in the room of `text`.
    fn text(self, Piece { kind, lines }: Piece, mut text: Text) -> Text {
        let Self { mesh, attributes } = self;
        text.0.clear();
        match kind {
            Kind::Libraries => {
                attributes.libraries[lines].iter().for_each(|line| text.line("", line.as_bytes()));
            }
            Kind::Vertices => mesh.positions[lines].iter().for_each(|point| text.vertex(point)),
            Kind::TextureCoordinates => {
                let listed = lines.filter_map(|line| attributes.texture_coordinates.get(line));
                listed.for_each(|line| text.line("vt ", line));
            }
            Kind::Normals => {
                let listed = lines.filter_map(|line| attributes.normals.get(line));
                listed.for_each(|line| text.line("vn ", line));
            }
            Kind::Faces => self.faces(lines, &mut text),
        }
        text
    }

    fn faces(self, range: Range<usize>, text: &mut Text) {
        let sections = &self.attributes.sections;
        let written = sections.count_before(range.start);
        let mut sections = sections.iter_from(written).peekable();
        for face in range {
            while let Some(section) = sections.next_if(|section| section.first_face <= face) {
                text.line("", section.line.as_bytes());
            }
            text.face(self.mesh, self.attributes, face);
        }
    }
}

/// Whole lines.
#[derive(Default)]
struct Text(Vec<u8>);

impl Text {
    fn vertex(&mut self, position: &[f64; 3]) {
        self.0.push(b'v');
        for &coordinate in position {
            self.0.push(b' ');
            self.0.extend_from_slice(zmij::Buffer::new().format(coordinate).as_bytes());
        }
        self.0.push(b'\n');
    }

    /// Writes a face in one form: what not all its corners have is left out.
    fn face(&mut self, mesh: &Mesh, attributes: &Attributes, face: usize) {
        let corners = mesh.faces.range(face);
        let is_whole = |indices: &CornerIndices| indices.has_all(corners.clone());
        let texture = Some(&attributes.corner_texture).filter(|indices| is_whole(indices));
        let normal = Some(&attributes.corner_normal).filter(|indices| is_whole(indices));
        self.0.push(b'f');
        for corner in corners {
            self.0.push(b' ');
            self.index(mesh.faces.corners()[corner]);
            if texture.is_some() || normal.is_some() {
                self.0.push(b'/');
            }
            if let Some(index) = texture.and_then(|indices| indices.get(corner)) {
                self.index(index);
            }
            if let Some(index) = normal.and_then(|indices| indices.get(corner)) {
                self.0.push(b'/');
                self.index(index);
            }
        }
        self.0.push(b'\n');
    }

    fn index(&mut self, from_zero: u32) {
        let from_one = u64::from(from_zero) + 1;
        self.0.extend_from_slice(itoa::Buffer::new().format(from_one).as_bytes());
    }

    /// Writes a line of text, in which line breaks become spaces.
    ///
    /// It never ends in a backslash: that would join the next line to it.
    fn line(&mut self, keyword: &str, line: &[u8]) {
        let is_break = |byte| matches!(byte, b'\n' | b'\r');
        self.0.extend_from_slice(keyword.as_bytes());
        self.0.extend(line.iter().map(|&byte| if is_break(byte) { b' ' } else { byte }));
        self.0.extend_from_slice(if line.ends_with(b"\\") { b" \n" } else { b"\n" });
    }
}
