//! Polygon File Format (`.ply`), as text and binary of both byte orders.
//!
//! The header describes the records that follow it. Of these the coordinates of `vertex`, the
//! corner lists of `face` and the strips of `tristrips` are kept. Everything else is skipped and
//! named.

mod binary;
mod header;
mod source;
mod strips;
#[cfg(test)]
mod tests;

use std::io::{self, Write};

use binary::Binary;
use header::{Element, Encoding, Header, Kind, Scalar};
use source::Source;
use strips::read_strips;

use super::error::MeshError;
use super::faces::{Faces, MAX_CORNERS};
use super::polygon_mesh::Mesh;
use super::tokens::{self, Tokens};

/// Reads a PLY file.
pub(super) fn read(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let mut tokens = Tokens::new(bytes);
    let header = Header::read(&mut tokens)?;
    let position = tokens.position();
    match header.encoding {
        Encoding::Ascii => read_elements(&header, &mut tokens),
        Encoding::Little => read_elements(&header, &mut Binary::<false>::new(bytes, position)),
        Encoding::Big => read_elements(&header, &mut Binary::<true>::new(bytes, position)),
    }
}

fn read_elements(header: &Header, source: &mut impl Source) -> Result<Mesh, MeshError> {
    let mut mesh = Mesh::default();
    for element in &header.elements {
        match element.name.as_str() {
            "vertex" => mesh.positions = read_vertices(element, source)?,
            "face" => read_faces(element, source, &mut mesh.faces)?,
            "tristrips" => read_strips(element, source, &mut mesh.faces)?,
            _ => skip_element(element, source)?,
        }
        mesh.left_out.extend(element.left_out());
    }
    if !source.rest().trim_ascii_start().is_empty() {
        mesh.left_out.push("data after the last element".into());
    }
    Ok(mesh)
}

fn read_vertices(element: &Element, source: &mut impl Source) -> Result<Vec<[f64; 3]>, MeshError> {
    let plan: Vec<_> =
        element.properties.iter().map(|property| (element.axis(property), property.kind)).collect();
    // A vertex takes three bytes at least, whatever the header states.
    let mut positions = Vec::with_capacity(element.count.min(source.rest().len() / 3));
    let done = source.whole_vertices(element, &mut positions);
    for_each_record(element, done, || {
        let mut position = [0.0; 3];
        for &(axis, kind) in &plan {
            match (axis, kind) {
                (Some(axis), Kind::Scalar(kind)) => position[axis] = source.coordinate(kind)?,
                _ => source.skip_property(kind)?,
            }
        }
        positions.push(position);
        Ok(())
    })?;
    Ok(positions)
}

fn read_faces(
    element: &Element,
    source: &mut impl Source,
    faces: &mut Faces,
) -> Result<(), MeshError> {
    let plan = element.plan();
    // A corner takes a byte at least.
    faces.reserve(element.count.saturating_mul(3).min(source.rest().len()));
    let done = source.whole_faces(element, faces);
    for_each_record(element, done, || {
        for &(is_corners, kind) in &plan {
            match kind {
                Kind::List { count, item } if is_corners => {
                    read_face(source, count, item, faces)?;
                }
                _ => source.skip_property(kind)?,
            }
        }
        Ok(())
    })
}

#[inline]
fn read_face(
    source: &mut impl Source,
    count: Scalar,
    item: Scalar,
    faces: &mut Faces,
) -> Result<(), MeshError> {
    let arity = source.index(count, "a number of corners")?;
    for _ in 0..arity {
        faces.push_corner(source.index(item, "a vertex index")?);
    }
    if faces.corners().len() > MAX_CORNERS {
        return Err(MeshError::TooLarge);
    }
    faces.close_face(arity as usize);
    Ok(())
}

fn skip_element(element: &Element, source: &mut impl Source) -> Result<(), MeshError> {
    if element.properties.is_empty() {
        return Ok(()); // However many there are, they take no room.
    }
    for_each_record(element, 0, || {
        element.properties.iter().try_for_each(|property| source.skip_property(property.kind))
    })
}

/// Calls `read` for every record of `element` but the first `done`.
///
/// The error of a file that ends early names the record.
fn for_each_record(
    element: &Element,
    done: usize,
    mut read: impl FnMut() -> Result<(), MeshError>,
) -> Result<(), MeshError> {
    for record in done..element.count {
        read().map_err(|error| match error {
            MeshError::Truncated { .. } => {
                let Element { name, count, .. } = element;
                tokens::truncated_record(name, record, *count)
            }
            other => other,
        })?;
    }
    Ok(())
}

/// Writes a binary PLY file that reads back exactly.
///
/// Coordinates are 32-bit numbers if that changes none of them.
pub(super) fn write(out: &mut dyn Write, positions: &[[f64; 3]], faces: &Faces) -> io::Result<()> {
    let is_single = |&value: &f64| f64::from(value as f32) == value;
    let single = positions.as_flattened().iter().all(is_single);
    let coordinate = if single { "float" } else { "double" };
    let short = faces.iter().all(|face| u8::try_from(face.len()).is_ok());
    let count = if short { "uchar" } else { "int" };
    write!(
        out,
        "ply\nformat binary_little_endian 1.0\ncomment made by triquad\n\
         element vertex {}\n\
         property {coordinate} x\nproperty {coordinate} y\nproperty {coordinate} z\n\
         element face {}\n\
         property list {count} int vertex_indices\n\
         end_header\n",
        positions.len(),
        faces.len()
    )?;
    if single {
        write_positions(out, positions, |value| (value as f32).to_le_bytes())?;
    } else {
        write_positions(out, positions, f64::to_le_bytes)?;
    }
    write_faces(out, faces, if short { 1 } else { 4 })
}

fn write_positions<const N: usize>(
    out: &mut dyn Write,
    positions: &[[f64; 3]],
    encode: impl Fn(f64) -> [u8; N],
) -> io::Result<()> {
    for position in positions {
        out.write_all(position.map(&encode).as_flattened())?;
    }
    Ok(())
}

fn write_faces(out: &mut dyn Write, faces: &Faces, count_bytes: usize) -> io::Result<()> {
    let mut record = Vec::new();
    for face in faces {
        record.clear();
        record.extend_from_slice(&(face.len() as u32).to_le_bytes()[..count_bytes]);
        for vertex in face {
            record.extend_from_slice(&vertex.to_le_bytes());
        }
        out.write_all(&record)?;
    }
    Ok(())
}
