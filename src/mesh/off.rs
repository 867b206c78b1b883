//! Object File Format (`.off`) of Geomview, as text and in three dimensions.
//!
//! Stricter than Geomview in one thing: every vertex and every face has its own line. That
//! separates colours from what follows them, and a missing number does not shift all others.

use std::io::{self, Write};

use super::error::MeshError;
use super::faces::{Faces, MAX_CORNERS};
use super::polygon_mesh::Mesh;
use super::tokens::{self, Tokens};

/// Reads an OFF file.
pub(super) fn read(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let mut tokens = Tokens::with_comments(bytes);
    let announced = read_header_word(&mut tokens)?;
    let vertices = tokens.read("the number of vertices", tokens::count)?;
    let faces = tokens.read("the number of faces", tokens::count)?;
    tokens.skip_line(); // The number of edges, which is not used.

    let mut mesh = Mesh::default();
    if read_positions(&mut tokens, vertices, &mut mesh.positions)? {
        mesh.left_out = announced;
    }
    if read_faces(&mut tokens, faces, &mut mesh.faces)? {
        mesh.left_out.push("face colours".into());
    }
    if tokens.next_word().is_some() {
        mesh.left_out.push("text after the last face".into());
    }
    Ok(mesh)
}

/// Reads `OFF` and the letters before it; returns the names of the numbers behind coordinates.
fn read_header_word(tokens: &mut Tokens) -> Result<Vec<String>, MeshError> {
    let word = tokens.next_word().ok_or_else(|| tokens::truncated("the header"))?;
    let Some(letters) = memchr::memmem::find(word, b"OFF") else {
        // The header word may be missing; then this is the number of vertices already.
        tokens::count(word).ok_or_else(|| tokens.unexpected("an OFF header"))?;
        tokens.split_word(0);
        return Ok(unnamed_numbers());
    };
    let extra = vertex_extra(&word[..letters]).map_err(|problem| tokens.malformed(problem))?;
    // Some files continue with the number of vertices without a space.
    tokens.split_word(letters + b"OFF".len());
    refuse_binary(tokens)?;
    Ok(if extra.is_empty() { unnamed_numbers() } else { extra })
}

fn unnamed_numbers() -> Vec<String> {
    vec!["numbers behind vertex coordinates".into()]
}

fn refuse_binary(tokens: &mut Tokens) -> Result<(), MeshError> {
    match tokens.next_in_line() {
        Some(b"BINARY") => Err(tokens.malformed("binary OFF files are not read, only text")),
        _ => {
            tokens.split_word(0);
            Ok(())
        }
    }
}

/// Returns the names of what every vertex has besides coordinates, by the letters before `OFF`.
fn vertex_extra(mut letters: &[u8]) -> Result<Vec<String>, String> {
    let mut extra = Vec::new();
    while !letters.is_empty() {
        let (name, rest) = match letters {
            [b'S', b'T', rest @ ..] => ("vertex texture coordinates", rest),
            [b'C', rest @ ..] => ("vertex colours", rest),
            [b'N', rest @ ..] => ("vertex normals", rest),
            [b'4', ..] => return Err("4OFF files are not read: vertices have 4 coordinates".into()),
            [b'n', ..] => return Err("nOFF files are not read: vertices need 3 coordinates".into()),
            _ => return Err(format!("'{}OFF' is not an OFF header", letters.escape_ascii())),
        };
        extra.push(name.into());
        letters = rest;
    }
    Ok(extra)
}

/// Reads one vertex a line; returns whether anything followed its coordinates.
fn read_positions(
    tokens: &mut Tokens,
    count: usize,
    positions: &mut Vec<[f64; 3]>,
) -> Result<bool, MeshError> {
    // A vertex takes six bytes at least, whatever the header states.
    positions.reserve(count.min(tokens.rest().len() / 6));
    let mut any_extra = false;
    for vertex in 0..count {
        let Some(word) = tokens.next_word() else {
            return Err(tokens::truncated(format_args!("vertex {} of {count}", vertex + 1)));
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
            return Err(tokens::truncated(format_args!("face {} of {count}", face + 1)));
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

#[cfg(test)]
mod tests {
    use super::*;

    const PLAIN: &[u8] = b"OFF\n4 2 0\n0 0 0\n1 0 0\n1 1.5 0\n0 1 -2\n3 0 1 2\n4 0 1 2 3\n";

    fn plain() -> Mesh {
        let mut faces = Faces::default();
        faces.push(&[0, 1, 2]);
        faces.push(&[0, 1, 2, 3]);
        let positions = vec![[0., 0., 0.], [1., 0., 0.], [1., 1.5, 0.], [0., 1., -2.]];
        Mesh::new(positions, faces)
    }

    fn problem(bytes: &[u8]) -> String {
        read(bytes).unwrap_err().to_string()
    }

    #[test]
    fn header_and_comments_may_stand_anywhere() {
        assert_eq!(read(PLAIN).unwrap(), plain());
        let body = "0 0 0\r\n1 0 0 # x\r\n\r\n# y\r\n1 1.5 0\r\n0 1 -2\r\n3 0 1 2#z\r\n4 0 1 2 3";
        for header in ["OFF 4 2 0", "OFF4 2 0", "4 2", "#\r\nOFF # a\r\n\r\n# b\r\n4 2 0 # c"] {
            let text = format!("{header}\r\n{body}");
            assert_eq!(read(text.as_bytes()).unwrap(), plain(), "{header}");
        }
    }

    #[test]
    fn numbers_behind_coordinates_are_named() {
        let names = ["vertex texture coordinates", "vertex colours", "vertex normals"];
        for (header, expected) in [
            ("COFF", &names[1..2]),
            ("NOFF", &names[2..]),
            ("CNOFF", &names[1..]),
            ("STOFF", &names[..1]),
            ("STCNOFF", &names),
            ("OFF", &["numbers behind vertex coordinates"]),
        ] {
            let text = format!("{header}\n1 2 0\n0 0 0 1 1 1 0.5\n1 0 0.5 0.5 1\n1 0 255 0 0\n0");
            let mesh = read(text.as_bytes()).unwrap();
            assert_eq!(
                mesh.left_out,
                [expected, &["face colours", "text after the last face"]].concat()
            );
            assert_eq!(mesh.positions, [[0.0; 3]]);
            assert_eq!(mesh.faces.corners(), [0, 0]);
        }
    }

    #[test]
    fn unknown_headers_are_refused() {
        assert_eq!(problem(b"OFF BINARY\n"), "line 1: binary OFF files are not read, only text");
        assert_eq!(
            problem(b"#\n4OFF 1"),
            "line 2: 4OFF files are not read: vertices have 4 coordinates"
        );
        assert_eq!(
            problem(b"CnOFF 3"),
            "line 1: nOFF files are not read: vertices need 3 coordinates"
        );
        assert_eq!(problem(b"XOFF"), "line 1: 'XOFF' is not an OFF header");
        assert_eq!(problem(b"ply\n"), "line 1: 'ply' is not an OFF header");
        assert_eq!(problem(b""), "end of file: truncated file: the header");
    }

    #[test]
    fn errors_name_their_place() {
        let faces = |line: &str| problem(format!("OFF\n1 2 0\n0 0 0\n{line}\n1 0\n").as_bytes());
        assert_eq!(faces("2 0 -1"), "line 4: '-1' is not a vertex index");
        assert_eq!(faces("1 4294967296"), "line 4: '4294967296' is not a vertex index");
        assert_eq!(faces("2 0"), "line 4: the line ends before a vertex index");
        assert_eq!(faces("-3 0"), "line 4: '-3' is not a number of corners");
        assert_eq!(problem(b"OFF 1 0 0\n0 0\n0\n"), "line 2: the line ends before a coordinate");
        assert_eq!(problem(b"OFF 9 0 0\n0 0 0"), "end of file: truncated file: vertex 2 of 9");
        assert_eq!(problem(b"OFF 0 2\n0\n"), "end of file: truncated file: face 2 of 2");
        let lie = "18446744073709551615";
        assert!(problem(format!("OFF {lie} {lie} 0\n0 0 0").as_bytes()).contains("vertex 2 of"));
        assert!(problem(format!("OFF 0 {lie} 0\n{lie} 0 0").as_bytes()).contains("a vertex index"));
    }

    #[test]
    fn far_indices_and_small_faces_are_passed_on() {
        let mesh = read(b"OFF 0 3 0\n0\n1 7\n2 4294967295 0\n").unwrap();
        let faces: Vec<_> = mesh.faces.iter().collect();
        assert_eq!(faces, [&[][..], &[7], &[u32::MAX, 0]]);
    }

    #[test]
    fn no_prefix_panics() {
        for length in 0..PLAIN.len() {
            // Without its line feed, or with a shorter last index, the last face is still one.
            assert_eq!(read(&PLAIN[..length]).is_ok(), length == PLAIN.len() - 1);
        }
    }

    #[test]
    fn written_files_read_back_exactly() {
        let mut mesh = plain();
        mesh.positions[0] = [0.1, 1e-300, -0.0];
        mesh.positions[1] = [f64::MAX, f64::MIN_POSITIVE / 3.0, -1.0 / 3.0];
        mesh.faces.push(&[]);
        let mut bytes = Vec::new();
        write(&mut bytes, &mesh.positions, &mesh.faces).unwrap();
        let back = read(&bytes).unwrap();
        assert_eq!(back, mesh);
        assert!(back.positions[0][2].is_sign_negative());
    }
}
