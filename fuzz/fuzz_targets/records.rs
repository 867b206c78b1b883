//! Any bytes as `runs.csv` of a results folder.
#![no_main]

use libfuzzer_sys::fuzz_target;
use triquad_lab::experiment::Results;

fuzz_target!(|bytes: &[u8]| {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("runs.csv"), bytes).unwrap();
    let _ = Results::read(folder.path());
});
