//! What two runs of the same have in common.

use triquad_lab::experiment::{Measured, RunRecord};

/// A record without what may differ between two runs of the same: times, memory, machine.
pub fn repeatable(record: &RunRecord) -> RunRecord {
    let measured = Measured {
        read_seconds: None,
        build_seconds: None,
        pairing_seconds: None,
        augmentation_seconds: None,
        total_seconds: None,
        seconds: None,
        check_seconds: None,
        shuffle_seconds: None,
        peak_memory_bytes: None,
        ..record.measured.clone()
    };
    RunRecord { machine: String::new(), process_seconds: None, measured, ..record.clone() }
}
