//! Any bytes as OBJ file.
#![no_main]

use libfuzzer_sys::fuzz_target;
use triquad::Mesh;
use triquad::mesh::Format;

fuzz_target!(|bytes: &[u8]| {
    let _ = Mesh::parse(bytes, Format::Obj);
});
