//! Any bytes as experiment file.
#![no_main]

use libfuzzer_sys::fuzz_target;
use triquad_lab::experiment::spec::Experiment;

fuzz_target!(|bytes: &[u8]| {
    let file = tempfile::NamedTempFile::new().unwrap();
    std::fs::write(file.path(), bytes).unwrap();
    let _ = Experiment::read(file.path());
});
