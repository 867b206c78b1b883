//! Faults of experiment files.

use std::io;
use std::path::PathBuf;

use super::job::UnknownNameError;
use super::program_spec::ProgramSpecError;

/// Fault of an experiment file.
#[derive(Debug, thiserror::Error)]
#[error("{}: {error}", path.display())]
pub struct SpecFileError {
    /// The file.
    pub path: PathBuf,
    /// Its fault.
    pub error: SpecError,
}

/// Fault of an experiment.
#[derive(Debug, thiserror::Error)]
pub enum SpecError {
    /// The file cannot be read.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// The text is not what an experiment file is.
    #[error("line {line}: {message}")]
    Syntax {
        /// Line, from 1.
        line: usize,
        /// Message of the TOML parser.
        message: String,
    },
    /// A name is not known.
    #[error("{}{error}", line.map_or(String::new(), |line| format!("line {line}: ")))]
    UnknownName {
        /// Line, from 1, where it is known.
        line: Option<usize>,
        /// The list that has it.
        list: &'static str,
        /// The fault.
        error: Box<UnknownNameError>,
    },
    /// A program is described badly.
    #[error(transparent)]
    Program(#[from] ProgramSpecError),
    /// A number leaves no room for a run, or for too many.
    #[error("{name} = {value}: must be from 1 to {most}")]
    Limit {
        /// The limit.
        name: &'static str,
        /// Its value.
        value: u64,
        /// The greatest value.
        most: u64,
    },
    /// A name would break the lines of `runs.csv`.
    #[error("the name {0:?} is empty or has a line break or another control character")]
    Name(String),
    /// A job is named twice for the same meshes: its runs would have the same rows.
    #[error("group {group:?} names {job} twice; name it once, with the repetitions that you want")]
    Twice {
        /// The group of meshes.
        group: String,
        /// The job.
        job: String,
    },
    /// A key changes nothing of what is run.
    #[error("line {line}: {key} has no effect: {why}")]
    NoEffect {
        /// Line, from 1.
        line: usize,
        /// The key.
        key: String,
        /// Reason and remedy.
        why: String,
    },
    /// A run has nothing to do.
    #[error("a run of {algorithms:?} needs algorithms and {list}")]
    NothingToRun {
        /// The algorithms that it names.
        algorithms: Vec<String>,
        /// The list that is missing if the algorithms are not.
        list: &'static str,
    },
}
