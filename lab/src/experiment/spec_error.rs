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

/// Writes the line of a fault, where it is known.
fn at(line: Option<usize>) -> String {
    line.map_or(String::new(), |line| format!("line {line}: "))
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
    #[error("{}{error}", at(*line))]
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
    /// Two groups have one name: runs on a mesh of both would have the same rows.
    #[error("two groups are named {0:?}; rename one, or make them one")]
    TwoGroups(String),
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
    /// An algorithm of ours lacks a list that it needs.
    #[error("{}{algorithm} needs {list}; add a line {list} = [\"{example}\"]", at(*line))]
    NoList {
        /// Line of the algorithms, from 1.
        line: Option<usize>,
        /// The algorithm.
        algorithm: String,
        /// Key of the list.
        list: &'static str,
        /// Name that it may have.
        example: &'static str,
    },
    /// A run names no algorithms.
    #[error("{}algorithms is empty; name at least one", at(*line))]
    NoAlgorithms {
        /// Line, from 1.
        line: Option<usize>,
    },
}
