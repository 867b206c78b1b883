//! A folder of results: `runs.csv`, one row a run, and `machines.json`, where they ran.

use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::record::{RunRecord, SCHEMA};

/// Facts about a machine and a build, by name: processor, cores, memory, system, compiler …
pub type Facts = BTreeMap<String, String>;

/// What a results folder holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Results {
    /// The rows that can be read, in the order of the file.
    pub records: Vec<RunRecord>,
    /// The rows that cannot.
    pub damaged: Vec<Damaged>,
    /// The runs that were planned, where that is known: what has no row is missing.
    pub planned: Vec<Planned>,
    /// Machines by the name that rows use.
    pub machines: BTreeMap<String, Facts>,
}

/// A line of `runs.csv` that is no record.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Damaged {
    /// Line, from 1.
    pub line: u64,
    /// The line as it is.
    pub text: String,
    /// What is wrong with it.
    pub problem: String,
}

/// A run that was planned: a row of `plan.csv`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Planned {
    /// Name of the experiment file.
    pub experiment: String,
    /// `full`, `small` or `demo`.
    pub scale: String,
    /// Group of meshes within the experiment.
    pub group: String,
    /// Name of the mesh.
    pub mesh: String,
    /// `sg ps ds gw lrs tq`, or `rs schipper brute-force`.
    pub algorithm: String,
    /// For `lrs`: `printed` or `few-flips`.
    pub lrs_variant: Option<String>,
    /// For conversions: `tarjan` or `local`.
    pub augmentation: Option<String>,
    /// For irreducible triangulations: `file` or `random`.
    pub order: Option<String>,
    /// Number of repetitions, fixed before anything ran.
    pub repetitions: u32,
}

/// Why a results folder cannot be read.
#[derive(Debug, thiserror::Error)]
#[error("{}: {error}", path.display())]
pub struct ResultsError {
    /// The file.
    pub path: PathBuf,
    /// What is wrong.
    pub error: io::Error,
}

impl Results {
    /// Reads `runs.csv`, `plan.csv` and `machines.json` in `folder`; the latter two may be absent.
    ///
    /// # Errors
    /// A file cannot be read. Rows that are damaged are no error: see [`Results::damaged`].
    pub fn read(folder: &Path) -> Result<Self, ResultsError> {
        let mut results = Self::default();
        let path = folder.join("runs.csv");
        let text = std::fs::read(&path).map_err(|error| ResultsError { path, error })?;
        results.take_rows(&String::from_utf8_lossy(&text));
        results.planned = read_plan(&folder.join("plan.csv"))?;
        results.machines = read_machines(&folder.join("machines.json"))?;
        Ok(results)
    }

    /// Adds a row; of a run that was done before, by another program perhaps, it takes the place.
    pub fn push(&mut self, record: RunRecord) {
        match self.records.iter_mut().find(|other| other.is_same_run(&record)) {
            Some(before) => *before = record,
            None => self.records.push(record),
        }
    }

    /// Takes each line for itself, so that a damaged one spoils no other. No field holds a line break.
    fn take_rows(&mut self, text: &str) {
        let mut lines = text.lines();
        let Some(header) = lines.next() else { return };
        let count = text.lines().count();
        for (i, line) in lines.enumerate() {
            // A row cut off within its last number would look complete.
            let cut_off = i + 2 == count && !text.ends_with('\n');
            let row = if cut_off { Err("it is cut off".into()) } else { parse_row(header, line) };
            match row {
                Ok(record) => self.push(record),
                Err(problem) => {
                    self.damaged.push(Damaged { line: i as u64 + 2, text: line.into(), problem });
                }
            }
        }
    }
}

fn parse_row(header: &str, line: &str) -> Result<RunRecord, String> {
    let text = format!("{header}\n{line}\n");
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let record: RunRecord = match reader.deserialize().next() {
        Some(row) => row.map_err(|error| error.to_string())?,
        None => return Err("an empty line".into()),
    };
    if record.schema != SCHEMA {
        return Err(format!("its schema is {:?} instead of {SCHEMA:?}", record.schema));
    }
    Ok(record)
}

fn read_plan(path: &Path) -> Result<Vec<Planned>, ResultsError> {
    let failure = |error| ResultsError { path: path.to_owned(), error };
    match std::fs::read(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(Vec::new()),
        Err(error) => Err(failure(error)),
        Ok(bytes) => {
            let rows: Result<_, _> = csv::Reader::from_reader(&bytes[..]).deserialize().collect();
            rows.map_err(|error| failure(io::Error::new(io::ErrorKind::InvalidData, error)))
        }
    }
}

fn read_machines(path: &Path) -> Result<BTreeMap<String, Facts>, ResultsError> {
    let failure = |error| ResultsError { path: path.to_owned(), error };
    match std::fs::read(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(BTreeMap::new()),
        Err(error) => Err(failure(error)),
        Ok(bytes) => serde_json::from_slice(&bytes)
            .map_err(|error| failure(io::Error::new(io::ErrorKind::InvalidData, error))),
    }
}
