//! OFF files as one list of numbers, whatever their lines.
//!
//! Faces have no colours then, and the list must end with the last face. So a file is hardly ever
//! taken for such a list that is none.

use super::super::error::MeshError;
use super::super::faces::{Faces, MAX_CORNERS};
use super::super::polygon_mesh::Mesh;
use super::super::tokens::{self, Tokens};
use super::header::Header;

/// Reads what follows the number of faces: the number of edges, if there is one, and the list.
///
/// # Errors
/// That of the first way to read the list; none where it is only that it does not come out even.
pub(super) fn read(tokens: Tokens<'_>, header: &Header) -> Result<Mesh, Option<MeshError>> {
    let mut first_error = None;
    let has_more_counts = { tokens }.next_in_line().is_some();
    for extra in header.extra_counts() {
        for &has_edge_count in if has_more_counts { &[true][..] } else { &[true, false] } {
            match read_list(tokens, header, extra, has_edge_count) {
                Ok(mesh) => return Ok(mesh),
                Err(error) => first_error = first_error.or(Some(error)),
            }
        }
    }
    Err(first_error.flatten())
}

fn read_list(
    mut tokens: Tokens<'_>,
    header: &Header,
    extra: usize,
    has_edge_count: bool,
) -> Result<Mesh, Option<MeshError>> {
    if has_edge_count {
        tokens.read("the number of edges", tokens::count)?;
    }
    let mut mesh = Mesh::default();
    mesh.positions.reserve(header.vertices.min(tokens.rest().len() / 6));
    for _ in 0..header.vertices {
        let mut position = [0.0; 3];
        for coordinate in &mut position {
            *coordinate = tokens.read("a coordinate", tokens::float)?;
        }
        mesh.positions.push(position);
        for _ in 0..extra {
            tokens.read("a number of a vertex", tokens::float)?;
        }
    }
    read_faces(&mut tokens, header.faces, &mut mesh.faces)?;
    if tokens.next_word().is_some() {
        return Err(None);
    }
    if extra > 0 {
        mesh.left_out = header.extra_names();
    }
    Ok(mesh)
}

fn read_faces(
    tokens: &mut Tokens<'_>,
    count: usize,
    faces: &mut Faces,
) -> Result<(), Option<MeshError>> {
    for _ in 0..count {
        let arity = tokens.read("a number of corners", tokens::count)?;
        if arity < 3 {
            return Err(None);
        }
        for _ in 0..arity {
            faces.push_corner(tokens.read("a vertex index", tokens::index)?);
        }
        if faces.corners().len() > MAX_CORNERS {
            return Err(Some(MeshError::TooLarge));
        }
        faces.close_face(arity);
    }
    Ok(())
}
