//! Tests of the PLY reader and writer.

use super::*;

const PROPERTIES: &str = "\
    element edge 2\nproperty int8 a\nproperty list uint8 int16 b\n\
    element vertex 3\nproperty uchar red\nproperty double z\nproperty list int float w\n\
    property short x\nproperty float y\n\
    element face 2\nproperty list ushort uint vertex_index\nproperty char flags\n\
    element nothing 99999999999999\nelement none 0\nproperty float n\nend_header\n";

/// The values of the elements above, each with its type.
const VALUES: &str = "i8:1 u8:2 i16:-5 i16:6 i8:0 u8:0 \
    u8:9 f64:0.1 i32:0 i16:-7 f32:0.5 \
    u8:9 f64:-0.0 i32:1 f32:5 i16:300 f32:1 \
    u8:255 f64:1e-300 i32:0 i16:0 f32:-2.25 \
    u16:3 u32:0 u32:1 u32:2 i8:-1 u16:4 u32:4000000000 u32:1 u32:0 u32:2 i8:1 ";

fn expected() -> Mesh {
    let mut faces = Faces::default();
    faces.push(&[0, 1, 2]);
    faces.push(&[4_000_000_000, 1, 0, 2]);
    let left_out = ["element edge", "vertex property red", "vertex property w"];
    let left_out = [&left_out[..], &["face property flags", "element nothing"]].concat();
    let positions = vec![[-7.0, 0.5, 0.1], [300.0, 1.0, -0.0], [0.0, -2.25, 1e-300]];
    let mut mesh = Mesh::new(positions, faces);
    mesh.left_out = left_out.into_iter().map(String::from).collect();
    mesh
}

fn encode(value: &str, big: bool) -> Vec<u8> {
    let (kind, value) = value.split_once(':').unwrap();
    let mut bytes = match kind {
        "i8" => value.parse::<i8>().unwrap().to_le_bytes().to_vec(),
        "u8" => value.parse::<u8>().unwrap().to_le_bytes().to_vec(),
        "i16" => value.parse::<i16>().unwrap().to_le_bytes().to_vec(),
        "u16" => value.parse::<u16>().unwrap().to_le_bytes().to_vec(),
        "i32" => value.parse::<i32>().unwrap().to_le_bytes().to_vec(),
        "u32" => value.parse::<u32>().unwrap().to_le_bytes().to_vec(),
        "f32" => value.parse::<f32>().unwrap().to_le_bytes().to_vec(),
        _ => value.parse::<f64>().unwrap().to_le_bytes().to_vec(),
    };
    if big {
        bytes.reverse();
    }
    bytes
}

fn binary(properties: &str, values: &str, big: bool) -> Vec<u8> {
    let order = if big { "big" } else { "little" };
    let mut bytes = format!("ply\nformat binary_{order}_endian 1.0\n{properties}").into_bytes();
    bytes.extend(values.split_whitespace().flat_map(|value| encode(value, big)));
    bytes
}

fn ascii(properties: &str, values: &str) -> Vec<u8> {
    let values: Vec<_> =
        values.split_whitespace().map(|value| value.split_once(':').unwrap().1).collect();
    format!("ply\nformat ascii 1.0\n{properties}{}\n", values.join(" ")).into_bytes()
}

fn all_encodings(properties: &str, values: &str) -> [Vec<u8>; 3] {
    [ascii(properties, values), binary(properties, values, false), binary(properties, values, true)]
}

fn problem(bytes: &[u8]) -> String {
    read(bytes).unwrap_err().to_string()
}

#[test]
fn encodings_agree() {
    for bytes in all_encodings(PROPERTIES, VALUES) {
        let mesh = read(&bytes).unwrap();
        assert_eq!(mesh, expected());
        assert!(mesh.positions[1][2].is_sign_negative());
    }
    let header = format!("comment \u{e9} x\nobj_info y\n\n{PROPERTIES}").replace('\n', "\r\n");
    for bytes in all_encodings(&header, VALUES) {
        assert_eq!(read(&bytes).unwrap(), expected());
    }
}

#[test]
fn every_proper_prefix_is_truncated() {
    for bytes in all_encodings(PROPERTIES, VALUES) {
        let end = bytes.trim_ascii_end().len();
        for length in 0..end {
            assert!(read(&bytes[..length]).is_err(), "{length}");
        }
    }
    let bytes = binary(PROPERTIES, VALUES, false);
    let error = problem(&bytes[..bytes.len() - 1]);
    assert_eq!(error, "the file ends before face 2 of 2");
}

#[test]
fn no_changed_byte_panics() {
    for bytes in all_encodings(PROPERTIES, VALUES) {
        for position in 0..bytes.len() {
            for value in [0, 1, b'\n', b'-', b'9', b'l', 0x7f, 0x80, 0xff] {
                let mut changed = bytes.clone();
                changed[position] = value;
                let _ = read(&changed);
            }
        }
    }
}

/// A source that reads value by value only.
struct ByTheValue<S>(S);

impl<S: Source> Source for ByTheValue<S> {
    fn coordinate(&mut self, kind: Scalar) -> Result<f64, MeshError> {
        self.0.coordinate(kind)
    }

    fn index(&mut self, kind: Scalar, expected: &str) -> Result<u32, MeshError> {
        self.0.index(kind, expected)
    }

    fn index_or_restart(&mut self, kind: Scalar) -> Result<Option<u32>, MeshError> {
        self.0.index_or_restart(kind)
    }

    fn skip(&mut self, kind: Scalar, times: usize) -> Result<(), MeshError> {
        self.0.skip(kind, times)
    }

    fn least_size(&self, kind: Scalar) -> usize {
        self.0.least_size(kind)
    }

    fn rest(&self) -> &[u8] {
        self.0.rest()
    }
}

fn read_by_the_value(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let mut tokens = Tokens::new(bytes);
    let header = Header::read(&mut tokens)?;
    let at = tokens.position();
    match header.encoding {
        Encoding::Ascii => read_elements(&header, &mut ByTheValue(tokens)),
        Encoding::Little => {
            read_elements(&header, &mut ByTheValue(Binary::<false>::new(bytes, at)))
        }
        Encoding::Big => read_elements(&header, &mut ByTheValue(Binary::<true>::new(bytes, at))),
    }
}

/// Whole files, all beginnings of them, and files with a changed byte.
#[test]
fn whole_records_are_what_their_values_are() {
    for (real, item) in [("f32", "i32"), ("f64", "u32")] {
        let vertex = format!("element vertex 2\nproperty {real} z\nproperty uchar red\n");
        let vertex = vertex + &format!("property {real} x\nproperty {real} y\n");
        let properties =
            [("i32", "int32"), ("u32", "uint32"), ("f32", "float"), ("f64", "double")].iter().fold(
                vertex + &format!("element face 4\nproperty list uchar {item} vertex_index\n"),
                |text, (short, long)| text.replace(&format!(" {short} "), &format!(" {long} ")),
            ) + "end_header\n";
        let values = format!(
            "{real}:0.5 u8:9 {real}:-0.0 {real}:1e9 {real}:-7 u8:1 {real}:2 {real}:3 \
             u8:3 {item}:0 {item}:1 {item}:70000 u8:0 u8:4 {item}:9 {item}:8 {item}:7 {item}:6 \
             u8:3 {item}:2 {item}:1 {item}:0"
        );
        for big in [false, true] {
            let bytes = binary(&properties, &values, big);
            let whole = read(&bytes).unwrap();
            assert_eq!(whole.positions, [[-0.0, 1e9, 0.5], [2.0, 3.0, -7.0]]);
            assert_eq!(whole.faces.iter().map(<[u32]>::len).collect::<Vec<_>>(), [3, 0, 4, 3]);
            let same = |bytes: &[u8]| {
                let [one, other] = [read(bytes), read_by_the_value(bytes)];
                // NaN is not equal to itself.
                assert_eq!(format!("{one:?}"), format!("{other:?}"));
            };
            (0..=bytes.len()).for_each(|length| same(&bytes[..length]));
            for position in 0..bytes.len() {
                for value in [0, 2, 5, 0x80, 0xff] {
                    let mut changed = bytes.clone();
                    changed[position] = value;
                    same(&changed);
                }
            }
        }
    }
}

const TRIANGLE: &str = "element vertex 1\nproperty int x\nproperty int y\nproperty int z\n\
    element face 1\nproperty list float int vertex_indices\nend_header\n";

#[test]
fn lists_need_natural_numbers() {
    for (values, wrong, line, byte) in [
        ("f32:1 i32:-2", "-2 is not a vertex index", 10, 16),
        ("f32:1.5 i32:0", "1.5 is not a number of corners", 10, 12),
        ("f32:-1 i32:0", "-1 is not a number of corners", 10, 12),
        ("f32:NaN i32:0", "NaN is not a number of corners", 10, 12),
        ("f32:5e9 i32:0", "5000000000 is not a number of corners", 10, 12),
    ] {
        let values = format!("i32:0 i32:0 i32:0 {values}");
        let (text, data) = (ascii(TRIANGLE, &values), binary(TRIANGLE, &values, true));
        let wrong_word = wrong.replace("5000000000", "5e9").replacen(" is", "' is", 1);
        assert_eq!(problem(&text), format!("line {line}: '{wrong_word}"));
        let start = data.len() - 20;
        assert_eq!(problem(&data), format!("byte {}: {wrong}", start + byte));
    }
    let values = "i32:0 i32:0 i32:0 f32:1.0 i32:7";
    for bytes in all_encodings(TRIANGLE, values) {
        assert_eq!(read(&bytes).unwrap().faces.corners(), [7]);
    }
}

#[test]
fn lying_counts_are_truncated_files() {
    let vertices = TRIANGLE.replace("vertex 1", "vertex 18446744073709551615");
    let faces = TRIANGLE.replace("face 1", "face 18446744073709551615");
    let values = "i32:0 i32:0 i32:0 f32:2e9 i32:7";
    for properties in [vertices.as_str(), &faces, TRIANGLE] {
        for bytes in all_encodings(properties, values) {
            assert!(matches!(
                read(&bytes),
                Err(MeshError::Truncated { .. } | MeshError::Malformed { .. })
            ));
        }
    }
    let skipped = TRIANGLE.replace("face", "other");
    for bytes in all_encodings(&skipped, values) {
        assert_eq!(problem(&bytes), "the file ends before other 1 of 1");
    }
}

#[test]
fn header_errors_name_their_line() {
    let header = |lines: &str| problem(format!("ply\nformat ascii 1.0\n{lines}").as_bytes());
    let xyz = "property int x\nproperty int y\nproperty int z";
    assert_eq!(header("elephant\n"), "line 3: 'elephant' is not a word of a PLY header");
    assert_eq!(header("property int x\n"), "line 3: a property before any element");
    assert_eq!(header("element vertex -1\n"), "line 3: '-1' is not a number of elements");
    assert_eq!(header("element vertex 1\nproperty long x\n"), "line 4: 'long' is not a type");
    assert_eq!(
        header("element vertex 1\nproperty int x\nproperty list int int y\nend_header\n"),
        "line 6: element vertex has no number y; it ends here"
    );
    assert_eq!(
        header(&format!("element vertex 1\n{xyz}\nproperty int x\nend_header\n")),
        "line 8: element vertex has more than one number x; it ends here"
    );
    assert_eq!(
        header("element face 1\nproperty int vertex_index\nend_header\n"),
        "line 5: element face has no list vertex_indices; it ends here"
    );
    assert_eq!(
        header(&format!("element vertex 1\n{xyz}\nelement vertex 1\n{xyz}\nend_header\n")),
        "line 11: a second element vertex before"
    );
    assert_eq!(header("end_header\n"), "line 3: no element vertex before");
    assert_eq!(problem(b"ply\nend_header\n"), "line 2: no format line before");
    assert_eq!(problem(b"OFF\n"), "line 1: 'OFF' is not 'ply'");
    assert_eq!(header("comment"), "the file ends before end_header");
}

#[test]
fn a_header_that_is_cut_off_anywhere_is_truncated() {
    for bytes in all_encodings(TRIANGLE, "i32:0 i32:0 i32:0 f32:2e9 i32:7") {
        let end = memchr::memmem::find(&bytes, b"end_header").unwrap() + "end_header".len();
        for length in 0..end {
            let error = read(&bytes[..length]).unwrap_err();
            let cut = bytes[..length].escape_ascii();
            assert!(matches!(error, MeshError::Truncated { .. }), "{cut}: {error}");
        }
    }
    assert_eq!(problem(b"pl"), "the file ends before the end of the word 'ply'");
    assert_eq!(problem(b"pl\n"), "line 1: 'pl' is not 'ply'");
    assert_eq!(
        problem(b"ply\nformat ascii 1.0\nelement vertex 1\nproperty fl"),
        "the file ends before end_header"
    );
}

#[test]
fn trailing_data_is_named() {
    let mut bytes = binary(TRIANGLE, "i32:0 i32:0 i32:0 f32:0", false);
    bytes.extend(b"\r\n");
    assert!(read(&bytes).unwrap().left_out.is_empty());
    bytes.push(0);
    assert_eq!(read(&bytes).unwrap().left_out, ["data after the last element"]);
}

#[test]
fn written_files_read_back_exactly() {
    let single = [f64::from(0.1_f32), -0.0, f64::from(f32::MAX)];
    let long: Vec<u32> = (0..256).collect();
    for (position, kind) in [
        (single, "property float z"),
        ([0.1, 1e-300, -0.0], "property double z"),
        ([1e300, 0.0, 0.0], "property double z"),
    ] {
        for (face, count) in [(&long[..], "list int int"), (&long[..4], "list uchar int")] {
            let mut faces = Faces::default();
            faces.push(face);
            faces.push(&[]);
            let positions = vec![[1.0, 2.0, 3.0], position];
            let mut bytes = Vec::new();
            write(&mut bytes, &positions, &faces).unwrap();
            let mesh = Mesh::new(positions, faces);
            let back = read(&bytes).unwrap();
            assert_eq!(back, mesh);
            let signs = |list: &Mesh| list.positions[1].map(f64::is_sign_negative);
            assert_eq!(signs(&back), signs(&mesh));
            let text = String::from_utf8_lossy(&bytes);
            assert!(text.contains(kind) && text.contains(count));
        }
    }
}

const STRIPS: &str = "element vertex 0\nproperty int x\nproperty int y\nproperty int z\n\
    element tristrips 2\nproperty list int int vertex_indices\nend_header\n";

#[test]
fn strips_turn_every_other_triangle_and_begin_anew() {
    let values = "i32:9 i32:0 i32:1 i32:2 i32:3 i32:-1 i32:4 i32:5 i32:6 i32:7 \
                  i32:5 i32:0 i32:1 i32:1 i32:2 i32:3";
    for bytes in all_encodings(STRIPS, values) {
        let mesh = read(&bytes).unwrap();
        let expected = [[0, 1, 2], [2, 1, 3], [4, 5, 6], [6, 5, 7], [1, 2, 3]];
        assert!(mesh.faces.iter().eq(expected), "{:?}", mesh.faces);
        assert!(mesh.left_out.is_empty());
    }
    let lie = values.replacen("i32:9", "i32:2000000000", 1);
    for bytes in all_encodings(STRIPS, &lie) {
        assert!(read(&bytes).is_err());
    }
    assert!(problem(&ascii(STRIPS, &values.replace("-1", "-2"))).contains("'-2' is not a vertex"));
}

#[test]
fn line_ends_of_all_kinds_are_read() {
    let values = "i32:10 i32:13 i32:-3 f32:1.0 i32:0";
    let expected = read(&ascii(TRIANGLE, values)).unwrap();
    for bytes in all_encodings(TRIANGLE, values) {
        let end = memchr::memmem::find(&bytes, b"end_header\n").unwrap() + 11;
        for ending in ["\r", "\r\n", "\r\r\n", "\n"] {
            let header = String::from_utf8_lossy(&bytes[..end]).replace('\n', ending);
            let changed = [header.as_bytes(), &bytes[end..]].concat();
            assert_eq!(read(&changed).unwrap(), expected, "{ending:?}");
        }
    }
}

#[test]
fn very_many_elements_are_read_and_a_second_one_is_refused() {
    let names: String = (0..20_000).map(|i| format!("element e{i} 0\n")).collect();
    let properties = format!("{names}{TRIANGLE}");
    let values = "i32:0 i32:0 i32:0 f32:1.0 i32:0";
    assert_eq!(read(&ascii(&properties, values)).unwrap().faces.len(), 1);
    let twice = format!("element e7 0\n{properties}");
    assert!(problem(&ascii(&twice, values)).contains("a second element e7 before"));
}
