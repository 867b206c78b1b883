//! Writing OBJ.

use std::io::{self, Write};

use crate::mesh::attributes::Attributes;
use crate::mesh::corner_indices::CornerIndices;
use crate::mesh::polygon_mesh::Mesh;
use crate::mesh::text_list::TextList;

/// Writes an OBJ file, attributes included; `out` should be buffered.
///
/// # Errors
/// Those of `out`.
pub(in crate::mesh) fn write(out: &mut dyn Write, mesh: &Mesh) -> io::Result<()> {
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

fn write_lines(text: &mut Text<'_>, keyword: &str, lines: &TextList) -> io::Result<()> {
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

    /// Writes a face in one form: what not all its corners have is left out.
    fn face(&mut self, mesh: &Mesh, attributes: &Attributes, face: usize) -> io::Result<()> {
        let corners = mesh.faces.range(face);
        let is_whole = |indices: &CornerIndices| indices.has_all(corners.clone());
        let texture = Some(&attributes.corner_texture).filter(|indices| is_whole(indices));
        let normal = Some(&attributes.corner_normal).filter(|indices| is_whole(indices));
        self.buffer.push(b'f');
        for corner in corners {
            self.buffer.push(b' ');
            self.index(mesh.faces.corners()[corner]);
            if texture.is_some() || normal.is_some() {
                self.buffer.push(b'/');
            }
            if let Some(index) = texture.and_then(|indices| indices.get(corner)) {
                self.index(index);
            }
            if let Some(index) = normal.and_then(|indices| indices.get(corner)) {
                self.buffer.push(b'/');
                self.index(index);
            }
        }
        self.end_line()
    }

    fn index(&mut self, from_zero: u32) {
        let from_one = u64::from(from_zero) + 1;
        self.buffer.extend_from_slice(itoa::Buffer::new().format(from_one).as_bytes());
    }

    /// Writes a line of text; line breaks in it become spaces.
    fn line(&mut self, keyword: &[u8], text: &[u8]) -> io::Result<()> {
        let is_break = |byte| matches!(byte, b'\n' | b'\r');
        self.buffer.extend_from_slice(keyword);
        self.buffer.extend(text.iter().map(|&byte| if is_break(byte) { b' ' } else { byte }));
        self.end_line()
    }

    /// Ends a line, never behind a backslash: that would join the next line to it.
    fn end_line(&mut self) -> io::Result<()> {
        if self.buffer.ends_with(b"\\") {
            self.buffer.push(b' ');
        }
        self.buffer.push(b'\n');
        if self.buffer.len() >= FLUSH_AT { self.flush() } else { Ok(()) }
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.write_all(&self.buffer)?;
        self.buffer.clear();
        Ok(())
    }
}
