//! One run of a program that is not ours: found, run, checked.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use triquad::clock::{Clock, to_nanoseconds};

use super::machine::{hash_of_file, hash_of_words};
use super::measured::Measured;
use super::process::{self, Ending};
use super::program_spec::{Places, ProgramSpec};
use super::record::{Outcome, RunRecord};
use super::result_file::{confirmed, measure};
use super::spec::Limits;
use super::task::Task;

/// A program as it is on this machine.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Installed {
    /// First line that its version command prints, after its name.
    pub version: String,
    /// Hash of command, version and of the files that the command names.
    pub hash: String,
}

/// Reason why a program cannot be run on this machine.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NotInstalledError {
    /// Its file is not there.
    #[error("{name} is not installed: {program:?} was not found")]
    NotFound {
        /// The program.
        name: String,
        /// First word of a command.
        program: String,
    },
    /// The command for its version fails.
    #[error("{name} is not installed: its version command fails: {reason}")]
    NoVersion {
        /// The program.
        name: String,
        /// The failure.
        reason: String,
    },
}

/// Limits of a version command.
const VERSION_LIMITS: Limits = Limits { timeout_seconds: 60, memory_gigabytes: 64 };

impl Installed {
    /// Finds a program and its version; `ours` is the `triquad` that starts it.
    ///
    /// # Errors
    /// It cannot be found, or its version command fails.
    pub fn find(spec: &ProgramSpec, ours: &Path) -> Result<Self, NotInstalledError> {
        let nowhere = Path::new("");
        let command =
            spec.command(Places { mesh: nowhere, result: nowhere, stats: nowhere, seed: 0 });
        require_file(spec, &command)?;
        let mut version = spec.name.clone();
        if let Some(words) = spec.version_command() {
            require_file(spec, &words)?;
            let line = version_line(&words, ours).map_err(|reason| {
                NotInstalledError::NoVersion { name: spec.name.clone(), reason }
            })?;
            version = format!("{version} {line}");
        }
        let files = command.iter().filter_map(|word| hash_of_file(&find_file(word)?).ok());
        let mut words: Vec<String> = files.collect();
        words.extend(command.iter().cloned());
        words.extend([version.clone(), format!("{spec:?}")]);
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        Ok(Self { version, hash: hash_of_words(&words) })
    }
}

fn require_file(spec: &ProgramSpec, command: &[String]) -> Result<(), NotInstalledError> {
    let program = command.first().cloned().unwrap_or_default();
    find_file(&program).map_or_else(
        || Err(NotInstalledError::NotFound { name: spec.name.clone(), program }),
        |_| Ok(()),
    )
}

/// Returns the file that a word of a command names: a path, or a program in `PATH`.
fn find_file(word: &str) -> Option<PathBuf> {
    let path = Path::new(word);
    if path.components().count() != 1 {
        return path.is_file().then(|| path.to_owned());
    }
    let folders = std::env::var_os("PATH").unwrap_or_default();
    let endings = ["", std::env::consts::EXE_SUFFIX];
    let files = std::env::split_paths(&folders)
        .flat_map(|folder| endings.map(|ending| folder.join(format!("{word}{ending}"))));
    files.chain([path.to_owned()]).find(|file| file.is_file())
}

/// Returns the first line that a version command prints.
fn version_line(words: &[String], ours: &Path) -> Result<String, String> {
    let ending = process::run_foreign(ours, words, VERSION_LIMITS);
    let Ending { outcome, reason, output, .. } = ending.map_err(|error| error.to_string())?;
    if outcome != Outcome::Ok {
        return Err(reason);
    }
    let text = String::from_utf8_lossy(&output);
    let line = text.lines().map(str::trim).find(|line| !line.is_empty()).unwrap_or_default();
    Ok(line.chars().filter(|letter| !letter.is_control()).take(80).collect())
}

/// Inputs of a run of a program.
pub(super) struct ProgramRun<'a> {
    pub spec: &'a ProgramSpec,
    /// The `triquad` that starts it.
    pub ours: &'a Path,
    /// The mesh, in the format of the program.
    pub mesh: &'a Path,
    /// Folder for its files.
    pub workshop: &'a Path,
    pub limits: Limits,
}

impl ProgramRun<'_> {
    /// Runs the program, checks its result and completes the record.
    ///
    /// # Errors
    /// The process cannot be started or waited for.
    pub fn execute(&self, record: RunRecord, clock: &impl Clock) -> io::Result<RunRecord> {
        let result = self.file(&record, self.spec.format.extension());
        let stats = self.file(&record, "json");
        let seed = record.seed;
        let places = Places { mesh: self.mesh, result: &result, stats: &stats, seed };
        let words = self.spec.command(places);
        let (ending, process_seconds) =
            clock.time(|| process::run_foreign(self.ours, &words, self.limits));
        let record = RunRecord { process_seconds: Some(process_seconds), ..record };
        let completed = ending.map(|ending| self.complete(record, ending, places, process_seconds));
        for file in [&result, &stats] {
            let _ = fs::remove_file(file);
        }
        completed
    }

    fn file(&self, record: &RunRecord, extension: &str) -> PathBuf {
        self.workshop.join(format!("{}.{extension}", record.key))
    }

    fn complete(
        &self,
        record: RunRecord,
        ending: Ending,
        places: Places<'_>,
        wall: f64,
    ) -> RunRecord {
        if ending.outcome != Outcome::Ok {
            // The codes of `triquad` are not those of others.
            let outcome = match ending.outcome {
                Outcome::Invalid => Outcome::Crash,
                outcome => outcome,
            };
            return RunRecord { outcome, reason: ending.reason, ..record };
        }
        let planned = record.measured.clone();
        let own = match self.own_numbers(&ending, places) {
            Ok(own) => own,
            Err(reason) => return RunRecord { outcome: Outcome::Crash, reason, ..record },
        };
        let invalid = |reason| RunRecord { outcome: Outcome::Invalid, reason, ..record.clone() };
        let verified = match measure(self.spec.task, places.mesh, places.result) {
            Ok(verified) => verified,
            Err(reason) => return invalid(reason),
        };
        let counts = |of: &Measured| [of.vertices, of.triangles, of.genus];
        if counts(&verified) != counts(&planned) {
            return invalid("its mesh has other counts than were planned".into());
        }
        let measured = self.numbers(own, verified, &ending, wall);
        RunRecord { measured, ..record }
    }

    /// Reads the numbers that the program has of itself.
    fn own_numbers(&self, ending: &Ending, places: Places<'_>) -> Result<Measured, String> {
        let bytes = match self.spec.stats_file(places) {
            Some(file) => fs::read(&file)
                .map_err(|error| format!("its statistics in {}: {error}", file.display()))?,
            None if self.spec.prints_stats() => ending.output.clone(),
            None => return Ok(Measured::default()),
        };
        let own = serde_json::from_slice(&bytes);
        own.map_err(|error| format!("its statistics cannot be read: {error}"))
    }

    /// Puts together what the program has of itself, what the check has counted and what was
    /// measured from outside.
    fn numbers(&self, own: Measured, verified: Measured, ending: &Ending, wall: f64) -> Measured {
        // A stage without a time is one that the program does not have.
        let parts = [own.pairing_seconds, own.augmentation_seconds].into_iter().flatten();
        let parts = parts.reduce(|pairing, augmentation| to_nanoseconds(pairing + augmentation));
        let mut numbers = confirmed(&own, &verified);
        match self.spec.task {
            Task::Convert => {
                let total = own.total_seconds.or(parts).or(own.seconds);
                numbers.total_seconds = total.or(Some(wall));
            }
            Task::Irreducible => {
                numbers.seconds = own.seconds.or(own.total_seconds).or(Some(wall));
            }
        }
        numbers.peak_memory_bytes = own.peak_memory_bytes.or(ending.peak_memory_bytes);
        numbers
    }
}
