//! A folder of results: `runs.csv`, one row a run; `plan.csv`, the planned runs; `machines.json`,
//! where they ran.

use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};
use std::io;
use std::path::{Path, PathBuf};

use csv::StringRecord;
use serde::{Deserialize, Serialize};

use super::record::{RowError, RunRecord, SCHEMA};
use super::run_id::RunId;
use crate::csv_text;

/// Facts about a machine and a build, by name: processor, cores, memory, system, compiler …
pub type MachineFacts = BTreeMap<String, String>;

/// Content of a results folder.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Results {
    /// The readable rows, in the order of the file.
    pub records: Vec<RunRecord>,
    /// The rows that cannot be read.
    pub damaged: Vec<DamagedRow>,
    /// Bad rows of runs that ended well at another time: kept, and never counted.
    pub superseded: Vec<RunRecord>,
    /// True if the names of the columns were lost: those that we write are taken.
    pub has_lost_names: bool,
    /// The planned runs, where they are known: a planned run without a row is missing.
    pub planned: Vec<Planned>,
    /// Machines by the name that rows use.
    pub machines: BTreeMap<String, MachineFacts>,
}

/// A line of `runs.csv` that is no record.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DamagedRow {
    /// Line, from 1.
    pub line: u64,
    /// The line as it is.
    pub text: String,
    /// Fault of it.
    pub problem: String,
}

/// Planned repetitions: a row of `plan.csv`.
#[derive(Clone, Debug, PartialEq)]
pub struct Planned {
    /// The job that is repeated.
    pub id: RunId,
    /// Number of repetitions, fixed before anything ran.
    pub repetitions: u32,
}

/// The last column of `plan.csv`.
#[derive(Serialize, Deserialize)]
struct PlanTail {
    repetitions: u32,
}

impl Planned {
    /// Returns the columns of `plan.csv`.
    pub fn to_row(&self) -> impl Serialize {
        (&self.id.mesh, self.id.job, PlanTail { repetitions: self.repetitions })
    }

    fn from_row(row: &StringRecord, names: &StringRecord) -> csv::Result<Self> {
        let names = Some(names);
        let id = RunId { mesh: row.deserialize(names)?, job: row.deserialize(names)? };
        let PlanTail { repetitions } = row.deserialize(names)?;
        Ok(Self { id, repetitions })
    }
}

/// Reason why a results folder cannot be read.
#[derive(Debug, thiserror::Error)]
#[error("{}: {error}", path.display())]
pub struct ResultsError {
    /// The file.
    pub path: PathBuf,
    /// The fault.
    pub error: io::Error,
}

/// Places of runs in a list of records, so that no run has two rows.
#[derive(Debug, Default)]
pub(super) struct RunIndex(HashMap<(RunId, u32), usize>);

impl RunIndex {
    /// Indexes `records`. O(n).
    pub fn new(records: &[RunRecord]) -> Self {
        let run = |record: &RunRecord| (record.id.clone(), record.repetition);
        Self(records.iter().enumerate().map(|(place, record)| (run(record), place)).collect())
    }

    /// Appends a row, or replaces that of the same run, which another program may have done. Of
    /// the same run an `ok` row is never replaced by another one. Returns the row that does not
    /// count, if there is one. O(1).
    pub fn put(&mut self, records: &mut Vec<RunRecord>, record: RunRecord) -> Option<RunRecord> {
        let place = *self.0.entry((record.id.clone(), record.repetition)).or_insert(records.len());
        if place == records.len() {
            records.push(record);
            None
        } else if records[place].is_ok() && !record.is_ok() {
            Some(record)
        } else {
            Some(std::mem::replace(&mut records[place], record))
        }
    }
}

impl Results {
    /// Returns the names of the experiments whose runs are planned or done here, in order. Imported
    /// rows belong to none. O(n).
    pub fn experiments(&self) -> BTreeSet<&str> {
        let (imported, run): (Vec<_>, Vec<_>) =
            self.records.iter().partition(|record| record.is_imported());
        let imported: HashSet<&RunId> = imported.into_iter().map(|record| &record.id).collect();
        let planned = self.planned.iter().map(|row| &row.id).filter(|id| !imported.contains(id));
        let run = run.into_iter().map(|record| &record.id);
        planned.chain(run).map(|id| id.mesh.experiment.as_str()).collect()
    }

    /// Reads `runs.csv`, `plan.csv` and `machines.json` in `folder`; the latter two may be absent.
    /// O(n).
    ///
    /// # Errors
    /// A file cannot be read, or `runs.csv` is another program's. Damaged rows are no error: see
    /// [`Results::damaged`].
    pub fn read(folder: &Path) -> Result<Self, ResultsError> {
        let mut results = Self::default();
        let path = folder.join("runs.csv");
        let read = std::fs::read(&path)
            .and_then(|text| results.read_rows(&String::from_utf8_lossy(&text)));
        read.map_err(|error| ResultsError { path, error })?;
        results.planned = read_if_there(folder.join("plan.csv"), read_plan)?;
        results.machines = read_if_there(folder.join("machines.json"), |bytes| {
            Ok(serde_json::from_slice(bytes)?)
        })?;
        Ok(results)
    }

    /// Reads each line by itself, so that a damaged one spoils no other. No field has a line break.
    fn read_rows(&mut self, text: &str) -> io::Result<()> {
        let text = text.trim_start_matches('\u{feff}');
        let Some(first) = text.lines().next() else {
            self.has_lost_names = true;
            return Ok(());
        };
        let names = match fields(first) {
            Ok(names) if names.iter().any(|name| name == "schema") => names,
            _ if text.lines().any(|line| line.starts_with(SCHEMA)) => {
                self.has_lost_names = true;
                fields(&column_names()?).map_err(io::Error::other)?
            }
            _ => return Err(io::Error::other(FOREIGN)),
        };
        let count = text.lines().count();
        let mut index = RunIndex::default();
        for (i, line) in text.lines().enumerate().skip(usize::from(!self.has_lost_names)) {
            // A row cut off within its last number would look complete.
            let is_cut_off = i + 1 == count && !text.ends_with('\n');
            let row = if is_cut_off { Err(RowError::CutOff) } else { fields(line) };
            match row.and_then(|row| RunRecord::from_row(&row, &names)) {
                Ok(record) => {
                    let lost = index.put(&mut self.records, record);
                    self.superseded.extend(lost.filter(|lost| !lost.is_ok()));
                }
                Err(error) => self.damaged.push(DamagedRow {
                    line: i as u64 + 1,
                    text: line.into(),
                    problem: error.to_string(),
                }),
            }
        }
        Ok(())
    }
}

/// Fault of a file that `triquad` has not written.
const FOREIGN: &str = "this is no list of runs of triquad: its first line names no column 'schema'. \
                       It is left as it is";

/// Returns the first line of `runs.csv`.
pub(super) fn column_names() -> io::Result<String> {
    let text = csv_text::with_header([RunRecord::default().to_row()])?;
    let text = String::from_utf8_lossy(&text);
    Ok(text.lines().next().unwrap_or_default().to_owned())
}

/// Splits one line of comma-separated values.
fn fields(line: &str) -> Result<StringRecord, RowError> {
    let mut reader = csv::ReaderBuilder::new();
    let mut reader =
        reader.has_headers(false).buffer_capacity(1 << 10).from_reader(line.as_bytes());
    reader.records().next().ok_or(RowError::Empty)?.map_err(RowError::from)
}

fn read_plan(bytes: &[u8]) -> io::Result<Vec<Planned>> {
    let mut reader = csv::Reader::from_reader(bytes);
    let names = reader.headers()?.clone();
    let row = |row: csv::Result<StringRecord>| Ok(Planned::from_row(&row?, &names)?);
    reader.records().map(row).collect()
}

/// Reads a file; one that is not there is empty.
fn read_if_there<T: Default>(
    path: PathBuf,
    parse: impl FnOnce(&[u8]) -> io::Result<T>,
) -> Result<T, ResultsError> {
    let parsed = match std::fs::read(&path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(T::default()),
        bytes => bytes.and_then(|bytes| parse(&bytes)),
    };
    parsed.map_err(|error| ResultsError { path, error })
}
