//! One run of an algorithm of ours: a process, then its numbers, as it prints them or as its file
//! has them.

use std::fs;
use std::io;
use std::path::Path;

use triquad::clock::Clock;

use super::command_line::arguments;
use super::completion::complete;
use super::plan::{Block, PlannedRun};
use super::process;
use super::program_spec::ProgramFormat;
use super::record::{Outcome, RunRecord};
use super::result_file::{confirmed, measure};

/// Inputs of a run of an algorithm of ours.
pub(super) struct OwnRun<'a> {
    /// The `triquad` that is run.
    pub ours: &'a Path,
    pub block: &'a Block,
    pub run: &'a PlannedRun,
    /// The mesh.
    pub mesh: &'a Path,
    /// Folder for its result.
    pub workshop: &'a Path,
}

impl OwnRun<'_> {
    /// Runs the algorithm and completes the record.
    ///
    /// # Errors
    /// The process cannot be started or waited for.
    pub fn execute(&self, record: RunRecord, clock: &impl Clock) -> io::Result<RunRecord> {
        let ending = ProgramFormat::default().extension();
        let result = self.block.leaves_file(self.run);
        let result = result.then(|| self.workshop.join(format!("{}.{ending}", record.key)));
        let arguments = arguments(self.mesh, self.run, result.as_deref());
        let (ending, process_seconds) =
            clock.time(|| process::run(self.ours, &arguments, self.block.limits));
        let record = RunRecord { process_seconds: Some(process_seconds), ..record };
        let completed = ending.map(|ending| complete(record, ending, &self.block.mesh));
        let Some(file) = result else { return completed };
        let measured = completed.map(|record| self.measured_from(&file, record));
        let _ = fs::remove_file(&file);
        measured
    }

    /// Puts what the file shows in place of what the run has printed.
    fn measured_from(&self, file: &Path, record: RunRecord) -> RunRecord {
        if !record.is_ok() {
            return record;
        }
        match measure(self.run.job.task(), self.mesh, file) {
            Ok(found) => RunRecord { measured: confirmed(&record.measured, &found), ..record },
            Err(reason) => RunRecord { outcome: Outcome::Invalid, reason, ..record },
        }
    }
}
