//! Tests of the OFF reader and writer.

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
    let body = "0 0 0\r\n1 0 0 # x\r\n\r\n# y\r\n1 1.5 0\r\n0 1 -2\r\n3 0 1 2 #z\r\n4 0 1 2 3";
    for header in [
        "OFF 4 2 0",
        "off 4 2",
        "\u{feff}OFF 4 2 0",
        "OFF4 2 0",
        "4 2",
        "#\r\nOFF # a\r\n\r\n# b\r\n4 2 0 # c",
    ] {
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
    assert_eq!(problem(b"STO"), "the file ends before the end of the word 'STOFF'");
    assert_eq!(problem(b"of"), "the file ends before the end of the word 'OFF'");
    assert_eq!(problem(b"OFF BINARY\n"), "line 1: binary OFF files are not read, only text");
    assert_eq!(
        problem(b"#\n4OFF 1"),
        "line 2: 4OFF files are not read: vertices have 4 coordinates"
    );
    assert_eq!(problem(b"CnOFF 3"), "line 1: nOFF files are not read: vertices need 3 coordinates");
    assert_eq!(problem(b"XOFF"), "line 1: 'XOFF' is not an OFF header");
    assert_eq!(problem(b"ply\n"), "line 1: 'ply' is not an OFF header");
    assert_eq!(problem(b""), "the file ends before the header");
}

#[test]
fn errors_name_their_place() {
    let faces = |line: &str| problem(format!("OFF\n1 2 0\n0 0 0\n{line}\n1 0\n").as_bytes());
    assert_eq!(faces("2 0 -1"), "line 4: '-1' is not a vertex index");
    assert_eq!(faces("1 4294967296"), "line 4: '4294967296' is not a vertex index");
    assert_eq!(faces("2 0"), "line 4: the line ends before a vertex index");
    assert_eq!(faces("-3 0"), "line 4: '-3' is not a number of corners");
    assert_eq!(problem(b"OFF 1 0 0\n0 0\n"), "line 2: the line ends before a coordinate");
    assert_eq!(problem(b"OFF 9 0 0\n0 0 0"), "the file ends before vertex 2 of 9");
    assert_eq!(problem(b"OFF 0 2\n0\n"), "the file ends before face 2 of 2");
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

#[test]
fn files_without_lines_are_read_as_one_list() {
    let mut words: Vec<_> = str::from_utf8(PLAIN).unwrap().split_whitespace().collect();
    for separator in ["\n", " ", "\r", "\n\n# x\n", "\t\r\n"] {
        assert_eq!(read(words.join(separator).as_bytes()).unwrap(), plain(), "{separator:?}");
    }
    words.remove(3); // The number of edges.
    assert_eq!(read(words.join("\n").as_bytes()).unwrap(), plain());
    let pairs = "OFF 4 2 0\n0 0 0 1 0 0\n1 1.5 0 0 1 -2\n3 0 1 2 4 0 1 2 3\n";
    assert_eq!(read(pairs.as_bytes()).unwrap(), plain());
    let parted = "OFF 4 2 0\n0 0 0\n1 0 0\n1 1.5 0\n0 1 -2\n3 0\n1\n2\n4\n0 1 2 3\n";
    assert_eq!(read(parted.as_bytes()).unwrap(), plain());
    assert_eq!(
        problem(parted.replace("\n1\n2", "\nx\n2").as_bytes()),
        "line 7: 'x' is not a vertex index"
    );
}

#[test]
fn lists_may_have_normals_and_colours_of_vertices() {
    for (header, extra) in [
        ("NOFF", "7 8 9"),
        ("COFF", "1 0 0"),
        ("COFF", "1 0 0 1"),
        ("STOFF", "0 1"),
        ("STCNOFF", "0 1 1 0 0 7 8 9"),
    ] {
        let vertices = ["0 0 0", "1 0 0", "1 1.5 0", "0 1 -2"].map(|v| format!("{v} {extra}"));
        let text = format!("{header} 4 2 0 {} 3 0 1 2 4 0 1 2 3", vertices.join(" "));
        let mesh = read(text.replace(' ', "\n").as_bytes()).unwrap();
        assert_eq!((&mesh.positions, &mesh.faces), (&plain().positions, &plain().faces), "{text}");
        assert!(!mesh.left_out.is_empty());
    }
}
