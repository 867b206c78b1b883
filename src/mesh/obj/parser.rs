//! The lines of an OBJ file, one after the other.

use super::blocks::Block;
use super::cursor::{Cursor, Fault};
use super::given::Given;
use super::left_out::{Absent, Skipped};
use crate::mesh::attributes::Attributes;
use crate::mesh::corner_indices::CornerIndices;
use crate::mesh::error::MeshError;
use crate::mesh::face_sections::FaceSection;
use crate::mesh::faces::MAX_CORNERS;
use crate::mesh::polygon_mesh::Mesh;

/// The mesh as far as it was read, or a chunk of it.
#[derive(Default)]
pub(super) struct Parser {
    /// Elements that come before the chunk.
    before: Given,
    list: Mesh,
    attributes: Attributes,
    absent_texture: Absent,
    absent_normals: Absent,
    has_weights: bool,
    has_colours: bool,
    skipped: Skipped,
}

impl Parser {
    /// Begins a chunk with so much `before` it.
    pub(super) fn after(before: Given) -> Self {
        Self { before, ..Self::default() }
    }

    /// Returns the elements given so far, those before the chunk included.
    pub(super) fn given(&self) -> Given {
        Given {
            vertices: self.before.vertices + self.list.positions.len(),
            texture: self.before.texture + self.attributes.texture_coordinates.len(),
            normals: self.before.normals + self.attributes.normals.len(),
        }
    }

    /// Returns the number of corners read.
    pub(super) fn corner_count(&self) -> usize {
        self.list.faces.corners().len()
    }

    /// Reads all lines, or up to the beginning of a fault.
    pub(super) fn lines(&mut self, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        while !cursor.rest.is_empty() {
            self.line(cursor)?;
            cursor.skip_line();
        }
        Ok(())
    }

    /// Adds the chunk that follows; `behind` bytes of the block come after that.
    pub(super) fn append(&mut self, chunk: Self, behind: usize) {
        let attributes = &mut self.attributes;
        let (faces, corners) = (self.list.faces.len(), self.list.faces.corners().len());
        self.list.positions.extend(chunk.list.positions);
        self.list.faces.append(&chunk.list.faces);
        attributes.texture_coordinates.append(&chunk.attributes.texture_coordinates);
        attributes.normals.append(&chunk.attributes.normals);
        attributes.corner_texture.append(corners, &chunk.attributes.corner_texture);
        attributes.corner_normal.append(corners, &chunk.attributes.corner_normal);
        for FaceSection { first_face, line } in chunk.attributes.sections.iter() {
            attributes.sections.push(FaceSection { first_face: faces + first_face, line });
        }
        attributes.libraries.extend(chunk.attributes.libraries);
        self.absent_texture.append(chunk.absent_texture, behind);
        self.absent_normals.append(chunk.absent_normals, behind);
        self.has_weights |= chunk.has_weights;
        self.has_colours |= chunk.has_colours;
        self.skipped.append(chunk.skipped, behind);
    }

    /// Reads a line.
    #[inline]
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
                self.other(cursor.line().trim_ascii(), cursor.rest.len());
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

    /// Reads one corner: `v`, `v/vt`, `v//vn` or `v/vt/vn`, where `vt` and `vn` may be missing.
    fn corner(&mut self, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        let vertex =
            resolve(cursor.integer()?, self.before.vertices + self.list.positions.len(), "vertex")?;
        let corner = self.list.faces.corners().len();
        self.list.faces.push_corner(vertex);
        if !cursor.take(b'/') {
            return cursor.end_of_word();
        }
        let attributes = &mut self.attributes;
        if !cursor.is_omitted() {
            let given = self.before.texture + attributes.texture_coordinates.len();
            let texture = (cursor.integer()?, given);
            let indices = &mut attributes.corner_texture;
            refer(texture, corner, indices, &mut self.absent_texture, cursor.rest.len());
        }
        if cursor.take(b'/') && !cursor.is_omitted() {
            let given = self.before.normals + attributes.normals.len();
            let normal = (cursor.integer()?, given);
            let indices = &mut attributes.corner_normal;
            refer(normal, corner, indices, &mut self.absent_normals, cursor.rest.len());
        }
        cursor.end_of_word()
    }

    /// Keeps texture coordinates, normals, and lines that name the group of the faces after them.
    fn other(&mut self, line: &[u8], left: usize) {
        let end = line.iter().position(u8::is_ascii_whitespace).unwrap_or(line.len());
        let (keyword, value) = line.split_at(end);
        let text = || String::from_utf8_lossy(line);
        match keyword {
            b"vt" => self.attributes.texture_coordinates.push(value.trim_ascii_start()),
            b"vn" => self.attributes.normals.push(value.trim_ascii_start()),
            b"o" | b"g" | b"s" | b"usemtl" => {
                let first_face = self.list.faces.len();
                self.attributes.sections.push(FaceSection { first_face, line: &text() });
            }
            b"mtllib" => self.attributes.libraries.push(text().into_owned()),
            [] | [b'#', ..] => {}
            _ => self.skipped.note(keyword, line, left),
        }
    }

    /// Finds the lines of what was noted in `block`.
    pub(super) fn settle(&mut self, block: &Block) {
        self.absent_texture.settle(block, self.attributes.texture_coordinates.len());
        self.absent_normals.settle(block, self.attributes.normals.len());
        self.skipped.settle(block);
    }

    /// Adds to an error the lines before it that are unknown: they may be its cause.
    pub(super) fn explain(&self, error: MeshError) -> MeshError {
        match (error, self.skipped.unknown()) {
            (MeshError::Malformed { place, problem }, Some(unknown)) => {
                MeshError::Malformed { place, problem: format!("{problem}, after {unknown}") }
            }
            (error, _) => error,
        }
    }

    /// Returns the mesh.
    pub(super) fn finish(mut self) -> Mesh {
        let corners = self.list.faces.corners().len();
        let attributes = &mut self.attributes;
        let notes = [
            (
                &mut attributes.corner_texture,
                attributes.texture_coordinates.len(),
                &self.absent_texture,
                "texture coordinate",
            ),
            (
                &mut attributes.corner_normal,
                attributes.normals.len(),
                &self.absent_normals,
                "normal",
            ),
        ]
        .map(|(indices, given, absent, kind)| {
            if !indices.is_empty() {
                indices.pad(corners);
            }
            absent.note_text(kind, indices.drop_beyond(given), given)
        });
        if !self.attributes.is_empty() {
            self.list.attributes = Some(Box::new(self.attributes));
        }
        let flags = [(self.has_weights, "vertex weights"), (self.has_colours, "vertex colours")];
        let flags = flags.into_iter().filter(|&(seen, _)| seen).map(|(_, what)| what.to_owned());
        self.list.unknown_lines = self.skipped.unknown();
        let unknown = self.list.unknown_lines.clone();
        let notes = notes.into_iter().flatten();
        self.list.left_out =
            flags.chain(notes).chain(self.skipped.kinds()).chain(unknown).collect();
        self.list
    }
}

/// Gives `corner` the element that an index means when `given` have been given so far.
///
/// `left` bytes of the block are left behind the index.
#[inline]
fn refer(
    (index, given): (i64, usize),
    corner: usize,
    indices: &mut CornerIndices,
    absent: &mut Absent,
    left: usize,
) {
    let from_zero = if index > 0 { index - 1 } else { given as i64 + index };
    indices.pad(corner);
    match u32::try_from(from_zero) {
        Ok(element) if index != 0 && element != u32::MAX => {
            if element as usize >= given {
                absent.note(element, left);
            }
            indices.push(Some(element));
        }
        _ => {
            absent.note_never(left);
            indices.push(None);
        }
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
