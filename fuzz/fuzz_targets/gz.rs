//! Any bytes after the two that gzip files begin with, as OFF file.
#![no_main]

use libfuzzer_sys::fuzz_target;
use triquad::Mesh;
use triquad::mesh::Format;

fuzz_target!(|bytes: &[u8]| {
    let _ = Mesh::parse(&[&[0x1f, 0x8b], bytes].concat(), Format::Off);
});
