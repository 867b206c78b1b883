//! Object File Format (`.off`) of Geomview, as text and in three dimensions.
//!
//! With a line for every vertex and every face, what follows the numbers of each is told apart from
//! them. Where a file has no such lines, it is read as one list of numbers, which must come out
//! even. `header.rs` reads the first word and the counts, `free_form.rs` such lists.

mod free_form;
mod header;
#[cfg(test)]
mod tests;

use std::io::{self, Write};

use header::Header;

use super::error::MeshError;
use super::faces::{Faces, MAX_CORNERS};
use super::polygon_mesh::Mesh;
use super::tokens::{self, Tokens};

/// Reads an OFF file.
pub(super) fn read(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let mut tokens = Tokens::with_comments(bytes);
    let header = Header::read(&mut tokens)?;
    let by_line = read_lines(tokens, &header);
    let Err(error) = by_line else { return by_line };
    match free_form::read(tokens, &header) {
        Ok(mesh) => Ok(mesh),
        // A wrong word in a file without lines is its defect, not that the lines end.
        Err(Some(wrong @ MeshError::Malformed { .. })) if is_of_lines(&error) => Err(wrong),
        Err(_) => Err(error),
    }
}

fn is_of_lines(error: &MeshError) -> bool {
    matches!(error, MeshError::Malformed { problem, .. } if problem.starts_with(tokens::LINE_ENDS))
}

/// Reads a file in which every vertex and every face has its own line.
fn read_lines(mut tokens: Tokens<'_>, header: &Header) -> Result<Mesh, MeshError> {
    tokens.skip_line(); // The number of edges, which is not used.
    let mut mesh = Mesh::default();
    if read_positions(&mut tokens, header.vertices, &mut mesh.positions)? {
        mesh.left_out = header.extra_names();
    }
    if read_faces(&mut tokens, header.faces, &mut mesh.faces)? {
        mesh.left_out.push("face colours".into());
    }
    if tokens.next_word().is_some() {
        mesh.left_out.push("text after the last face".into());
    }
    Ok(mesh)
}

/// Reads one vertex a line; returns whether anything followed its coordinates.
fn read_positions(
    tokens: &mut Tokens,
    count: usize,
    positions: &mut Vec<[f64; 3]>,
) -> Result<bool, MeshError> {
    // A vertex takes six bytes at least, whatever the header says.
    positions.reserve(count.min(tokens.rest().len() / 6));
    let mut any_extra = false;
    for vertex in 0..count {
        let Some(word) = tokens.next_word() else {
            return Err(tokens::truncated_record("vertex", vertex, count));
        };
        let x = tokens::float(word).ok_or_else(|| tokens.unexpected("a coordinate"))?;
        let y = tokens.read_in_line("a coordinate", tokens::float)?;
        let z = tokens.read_in_line("a coordinate", tokens::float)?;
        positions.push([x, y, z]);
        any_extra |= tokens.next_in_line().is_some();
        tokens.skip_line();
    }
    Ok(any_extra)
}

/// Reads one face a line; returns whether anything followed its corners.
fn read_faces(tokens: &mut Tokens, count: usize, faces: &mut Faces) -> Result<bool, MeshError> {
    // A corner takes two bytes at least.
    *faces = Faces::with_capacity(count.saturating_mul(3).min(tokens.rest().len() / 2));
    let mut any_extra = false;
    for face in 0..count {
        let Some(word) = tokens.next_word() else {
            return Err(tokens::truncated_record("face", face, count));
        };
        let arity = tokens::count(word).ok_or_else(|| tokens.unexpected("a number of corners"))?;
        for _ in 0..arity {
            faces.push_corner(tokens.read_in_line("a vertex index", tokens::index)?);
        }
        if faces.corners().len() > MAX_CORNERS {
            return Err(MeshError::TooLarge);
        }
        faces.close_face(arity);
        any_extra |= tokens.next_in_line().is_some();
        tokens.skip_line();
    }
    Ok(any_extra)
}

/// Writes an OFF file that reads back exactly.
pub(super) fn write(out: &mut dyn Write, positions: &[[f64; 3]], faces: &Faces) -> io::Result<()> {
    writeln!(out, "OFF\n{} {} 0", positions.len(), faces.len())?;
    let mut line = Vec::new();
    let mut float = zmij::Buffer::new();
    for position in positions {
        line.clear();
        for &coordinate in position {
            line.extend_from_slice(float.format(coordinate).as_bytes());
            line.push(b' ');
        }
        write_line(out, &mut line)?;
    }
    let mut integer = itoa::Buffer::new();
    for face in faces {
        line.clear();
        line.extend_from_slice(integer.format(face.len()).as_bytes());
        line.push(b' ');
        for &vertex in face {
            line.extend_from_slice(integer.format(vertex).as_bytes());
            line.push(b' ');
        }
        write_line(out, &mut line)?;
    }
    Ok(())
}

/// Writes `line` with a line feed in place of its last space.
fn write_line(out: &mut dyn Write, line: &mut [u8]) -> io::Result<()> {
    if let Some(last) = line.last_mut() {
        *last = b'\n';
    }
    out.write_all(line)
}
