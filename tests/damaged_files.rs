//! Thousands of damaged files for every reader: none panics, none takes much memory, and what is
//! refused is refused with its place in the file.
//!
//! A program of its own, because its allocator counts, and its tests take turns.

use std::io::{Read as _, Write as _};
use std::sync::{Mutex, MutexGuard};
use std::time::{Duration, Instant};

use flate2::Compression;
use flate2::read::MultiGzDecoder;
use flate2::write::GzEncoder;
use peak_alloc::PeakAlloc;
use triquad::Mesh;
use triquad::mesh::{Format, MeshError};
use triquad_generators::testing::{damaged, draws};

#[global_allocator]
static ALLOCATOR: PeakAlloc = PeakAlloc;

/// Held by the test that measures memory.
static TURN: Mutex<()> = Mutex::new(());

/// Waits until no other test runs. The first call of every test: what a test allocates while it
/// prepares its files would be counted by the one that measures.
fn take_turn() -> MutexGuard<'static, ()> {
    TURN.lock().unwrap_or_else(|poisoned| poisoned.into_inner())
}

/// Damaged files of each kind; `TRIQUAD_MUTANTS` is another number.
const FILES: u64 = 6000;

/// Memory that a reader may take whatever the file: its first bytes, messages, small tables.
const BUFFERS: usize = 16 << 10;
/// Memory that the decoder of a gzip file may take: 64 kB of the file, the window with tables, and
/// a field of the header, which is up to 64 kB long.
const DECODER: usize = 192 << 10;
/// Memory that a reader may take for each byte of the file, or of its content if it is gzipped.
const MEMORY_PER_BYTE: usize = 20;
/// A file that takes longer is read again: the machine may have been busy.
const LONG: Duration = Duration::from_secs(1);

const OBJ: &str = "mtllib a.mtl\nv 0 0 0\nv 1 0.5 -1e-3\nv .5 1 0\nv 0 0 1 # fourth\n\
                   vt 0 1\nvt 1 1\nvn 0 0 1\no thing\ng left\nusemtl red\ns 1\n\
                   f 1/1/1 3/2/1 2/1/1\nf 1//1 2//1 4//1\nusemtl blue\nf 2 3 \\\n -1\nf -4 -1 -2\n";
const OFF: &str = "OFF\n# a tetrahedron\n4 4 6\n0 0 0\n1 0.5 -1e-3\n.5 1 0\n0 0 1\n3 0 2 1\n\
                   3 0 1 3\n3 1 2 3 255 0 0\n3 0 3 2\n";
const PLY: &str = "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 4\nproperty float x\n\
                   property double y\nproperty float z\nproperty uchar red\nelement face 4\n\
                   property list uchar int vertex_indices\nproperty list uint8 float texcoord\n\
                   element edge 1\nproperty int a\nend_header\n0 0 0 1\n1 0.5 -1e-3 2\n\
                   .5 1 0 3\n0 0 1 255\n3 0 2 1 0\n3 0 1 3 2 .5 .5\n3 1 2 3 0\n3 0 3 2 0\n7\n";
const STL: &str = "solid thing\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n\
                   vertex 1 0.5 -1e-3\nvertex .5 1 0\nendloop\nendfacet\nfacet normal 0 0 0\n\
                   outer loop\nvertex 0 0 0\nvertex .5 1 0\nvertex 0 0 1\nendloop\nendfacet\n\
                   endsolid thing\n";

/// The faces of a tetrahedron.
const FACES: [[u8; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];

fn coordinates() -> impl Iterator<Item = f32> {
    FACES.into_iter().flatten().flat_map(|v| [0, 1, 2].map(|axis| f32::from(v * axis)))
}

fn binary_ply(encoding: &str, bytes_of: fn(f32) -> [u8; 4]) -> Vec<u8> {
    let header = format!(
        "ply\nformat {encoding} 1.0\nelement vertex 4\nproperty float x\nproperty float y\n\
         property float z\nelement face 4\nproperty list uchar uchar vertex_indices\nend_header\n"
    );
    let mut bytes = header.into_bytes();
    bytes.extend(coordinates().take(12).flat_map(bytes_of));
    bytes.extend(FACES.iter().flat_map(|&[a, b, c]| [3, a, b, c]));
    bytes
}

fn binary_stl() -> Vec<u8> {
    let mut bytes = vec![b' '; 80];
    bytes.extend(4u32.to_le_bytes());
    let coordinates: Vec<_> = coordinates().collect();
    for corners in coordinates.chunks(9) {
        bytes.extend([0; 12]);
        bytes.extend(corners.iter().flat_map(|x| x.to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

/// One member for each half of `text`.
fn gzipped(text: &[u8]) -> Vec<u8> {
    let (first, second) = text.split_at(text.len() / 2);
    let member = |bytes: &[u8]| {
        let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
        encoder.write_all(bytes).unwrap();
        encoder.finish().unwrap()
    };
    [member(first), member(second)].concat()
}

/// Reads `bytes` and returns the error, if there is one, and the memory that this took at most.
fn read(bytes: &[u8], format: Format) -> (Option<MeshError>, usize) {
    let before = ALLOCATOR.current_usage();
    ALLOCATOR.reset_peak_usage();
    let error = Mesh::parse(bytes, format).err();
    (error, ALLOCATOR.peak_usage().saturating_sub(before))
}

fn assert_is_explained(error: &MeshError) {
    let has_place = match error {
        MeshError::Malformed { problem, .. } => !problem.is_empty(),
        MeshError::Truncated { missing, .. } => !missing.is_empty(),
        MeshError::Foreign { content, .. } => !content.is_empty(),
        MeshError::Expanded(_) | MeshError::TooLarge => true,
        _ => false,
    };
    let message = error.to_string();
    assert!(has_place && !error.remedy().is_empty(), "{message}");
    assert_eq!(message.lines().count(), 1, "{message:?}");
}

/// Returns the memory that a reader may take for `bytes`.
fn most_memory_for(bytes: &[u8], is_gzipped: bool) -> usize {
    if !is_gzipped {
        return BUFFERS + MEMORY_PER_BYTE * bytes.len();
    }
    let mut content = Vec::new();
    // What comes before the damage is read, too.
    let _ = MultiGzDecoder::new(bytes).read_to_end(&mut content);
    BUFFERS + DECODER + MEMORY_PER_BYTE * content.len().max(bytes.len())
}

/// Damages `valid`, which is read, and reads what comes of it.
fn assert_survived(valid: &[u8], format: Format) {
    assert!(read(valid, format).0.is_none(), "the file is valid before it is damaged");
    let is_gzipped = valid.starts_with(b"\x1f\x8b");
    let others = [OBJ, OFF, PLY, STL].map(str::as_bytes);
    let files = std::env::var("TRIQUAD_MUTANTS").map_or(FILES, |files| files.parse().unwrap());
    let mut below = draws(valid.len() as u64);
    let (mut refused, mut most_memory, mut slowest) = (0, 0, Duration::ZERO);
    for _ in 0..files {
        let other = others[below(4) as usize];
        let bytes = damaged(valid, other, &mut below);
        let most = most_memory_for(&bytes, is_gzipped);
        let mut start = Instant::now();
        let (error, mut memory) = read(&bytes, format);
        // What the program that runs the tests does is counted, too, but not twice.
        if memory > most || start.elapsed() > LONG {
            start = Instant::now();
            memory = read(&bytes, format).1;
        }
        slowest = slowest.max(start.elapsed());
        assert!(memory <= most, "{memory} bytes for {:?}", String::from_utf8_lossy(&bytes));
        error.iter().for_each(assert_is_explained);
        refused += u64::from(error.is_some());
        most_memory = most_memory.max(memory);
    }
    assert!((files / 10..files).contains(&refused), "{refused} of {files} were refused");
    println!(
        "{format:?}: {files} files, {refused} refused, {slowest:?}, {most_memory} bytes at most"
    );
}

#[test]
fn damaged_obj_files_are_survived() {
    let _turn = take_turn();
    assert_survived(OBJ.as_bytes(), Format::Obj);
}

#[test]
fn damaged_off_files_are_survived() {
    let _turn = take_turn();
    assert_survived(OFF.as_bytes(), Format::Off);
}

#[test]
fn damaged_ply_files_are_survived() {
    let _turn = take_turn();
    assert_survived(PLY.as_bytes(), Format::Ply);
    assert_survived(&binary_ply("binary_little_endian", f32::to_le_bytes), Format::Ply);
    assert_survived(&binary_ply("binary_big_endian", f32::to_be_bytes), Format::Ply);
}

#[test]
fn damaged_stl_files_are_survived() {
    let _turn = take_turn();
    assert_survived(STL.as_bytes(), Format::Stl);
    assert_survived(&binary_stl(), Format::Stl);
}

#[test]
fn damaged_gzip_files_are_survived() {
    let _turn = take_turn();
    assert_survived(&gzipped(OFF.as_bytes()), Format::Off);
    assert_survived(&gzipped(OBJ.as_bytes()), Format::Obj);
}

/// Lines of a long file. Lists that double are largest, compared with what they hold, when they
/// have just doubled.
const MANY: usize = (1 << 17) + 1;

/// Returns a PLY header that ends with `element`.
fn ply_header(encoding: &str, element: &str) -> String {
    format!(
        "ply\nformat {encoding} 1.0\nelement vertex 0\nproperty int x\nproperty int y\n\
         property int z\nelement {element} vertex_indices\nend_header\n"
    )
}

/// A file that is mostly one line again and again. `N` stands for [`MANY`], `K` for the number of
/// the line.
struct LongFile {
    format: Format,
    before: String,
    line: &'static str,
    after: &'static str,
}

impl LongFile {
    fn bytes(&self) -> Vec<u8> {
        let before = self.before.replace('N', &MANY.to_string());
        let lines: String = (0..MANY).map(|k| self.line.replace('K', &k.to_string())).collect();
        [&before, &lines, self.after].concat().into_bytes()
    }
}

/// Returns files that need much memory for their length.
fn long_files() -> Vec<LongFile> {
    let file = |format, before: &str, line, after| {
        let before = before.into();
        LongFile { format, before, line, after }
    };
    let obj = |before, line| file(Format::Obj, before, line, "\nf 1\n");
    let off = |counts: &str, line| file(Format::Off, &format!("OFF {counts} 0\n"), line, "");
    let text = |element, line| file(Format::Ply, &ply_header("ascii", element), line, "\n");
    let bytes =
        |element, line| file(Format::Ply, &ply_header("binary_little_endian", element), line, "");
    let vertices = "ply\nformat ascii 1.0\nelement vertex N\nproperty int x\nproperty int y\n\
                  property int z\nend_header\n";
    let obj_lines = [
        "v 0 0 0\n",
        "vt\n",
        "vn\n",
        "f\n",
        "f 1\n",
        "f 1/1/1\n",
        "f 1/K/K\n",
        "s\n",
        "g K\n",
        "s\nf\n",
        "mtllib\n",
        "x\n",
        "l 1 2\n",
        "\\\n",
        "#\\\n",
    ];
    let obj_words = [" 1", " 1/1/1", " 1/K/K", " 1 \\\n"];
    let mut files: Vec<_> = obj_lines.into_iter().map(|line| obj("", line)).collect();
    files.extend(obj_words.map(|word| obj("f", word)));
    files.extend([
        off("N 0", "0 0 0\n"),
        off("0 N", "0\n"),
        off("0 N", "1 0\n"),
        off("0 N", "3 0 0 0 "),
        file(Format::Ply, "ply\n", "comment\n", "end_header"),
        file(Format::Ply, "ply\n", "element K 0\n", "end_header"),
        file(Format::Ply, "ply\nelement e 1\n", "property int K\n", "end_header"),
        file(Format::Ply, vertices, "0 0 0\n", ""),
        text("face N\nproperty list int int", "0\n"),
        bytes("face N\nproperty list uchar uchar", "\0"),
        bytes("face N\nproperty list uchar uchar", "\x01\0"),
        bytes("face N\nproperty list uchar uint", "\0"),
        bytes(
            "tristrips N\nproperty list uchar uchar",
            "\x0f\0\x01\x02\x03\x04\x05\x06\x07\x08\t\n\x0b\x0c\r\x0e",
        ),
    ]);
    files
}

#[test]
fn long_files_take_little_memory() {
    let _turn = take_turn();
    let mut largest = 0.0_f64;
    for file in long_files() {
        let bytes = file.bytes();
        let zipped = gzipped(&bytes);
        for (given, buffers) in [(&bytes, BUFFERS), (&zipped, BUFFERS + DECODER)] {
            let (_, memory) = read(given, file.format);
            let per_byte = memory.saturating_sub(buffers) as f64 / bytes.len() as f64;
            assert!(
                per_byte <= MEMORY_PER_BYTE as f64,
                "{:?} {:?}: {per_byte:.1} bytes a byte",
                file.format,
                file.line
            );
            largest = largest.max(per_byte);
        }
    }
    println!("{largest:.1} bytes for each of the file at most");
}
