//! `runs.csv` as it is written: row by row, each on the disk before the next run begins.

use std::collections::HashMap;
use std::fs::{File, OpenOptions};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::time::Duration;

use super::folder_lock::{FolderLock, FolderLockError};
use super::record::{Outcome, RunRecord};
use super::results::{DamagedRow, MachineFacts, Planned, Results, ResultsError, RunIndex};
use super::results_files::{append_damaged, merge_plans, write_machines, write_plan, write_rows};
use super::run_id::RunId;
use crate::{csv_text, whole_file};

/// The results folder of an experiment that is being run: locked until this is dropped.
#[derive(Debug)]
pub struct Journal {
    folder: PathBuf,
    file: File,
    results: Results,
    index: RunIndex,
    ends: HashMap<String, End>,
    set_aside: Vec<DamagedRow>,
    lock: FolderLock,
}

/// Outcome of a run with a row.
#[derive(Debug, PartialEq)]
enum End {
    /// After its process had begun.
    Begun,
    /// Before that: how, and why.
    NotBegun(Outcome, String),
}

/// Reason why a results folder cannot be written into.
#[derive(Debug, thiserror::Error)]
pub enum JournalError {
    /// It is another process's, or no folder.
    #[error(transparent)]
    Lock(#[from] FolderLockError),
    /// What is there cannot be read.
    #[error(transparent)]
    Read(#[from] ResultsError),
    /// A file cannot be written.
    #[error("{}: {error}", folder.display())]
    Write {
        /// The folder.
        folder: PathBuf,
        /// The reason of the file system.
        error: io::Error,
    },
}

impl Journal {
    /// Locks `folder` and reads the rows of earlier runs. Removes what killed processes have left.
    ///
    /// Damaged rows are moved to `damaged.csv`: their runs count as not done. Lost names of columns
    /// are written again.
    ///
    /// # Errors
    /// Another process writes there, `runs.csv` is another program's and stays as it is, or those
    /// of the file system.
    pub fn open(folder: &Path) -> Result<Self, JournalError> {
        let lock = FolderLock::take(folder)?;
        let path = folder.join("runs.csv");
        let mut results = Results::default();
        if path.exists() {
            results = Results::read(folder)?;
        }
        Self::with(folder, results, lock)
            .map_err(|error| JournalError::Write { folder: folder.to_owned(), error })
    }

    fn with(folder: &Path, mut results: Results, lock: FolderLock) -> io::Result<Self> {
        for part in ["", "plots", "pictures", "meshes"] {
            whole_file::remove_leftovers(&folder.join(part), Duration::ZERO);
        }
        let path = folder.join("runs.csv");
        whole_file::refuse_link(&path)?;
        let set_aside = std::mem::take(&mut results.damaged);
        append_damaged(folder, &set_aside)?;
        if !path.exists() || !set_aside.is_empty() || results.has_lost_names {
            write_rows(&path, &results)?;
        }
        let file = OpenOptions::new().append(true).open(path)?;
        let rows = results.superseded.iter().chain(&results.records);
        let ends = rows.map(|record| (record.key.clone(), End::of(record))).collect();
        let index = RunIndex::new(&results.records);
        Ok(Self { folder: folder.to_owned(), file, results, index, ends, set_aside, lock })
    }

    /// Returns the results so far.
    pub fn results(&self) -> &Results {
        &self.results
    }

    /// Returns the damaged rows that were moved when the folder was opened.
    pub fn set_aside(&self) -> &[DamagedRow] {
        &self.set_aside
    }

    /// Returns whether the names of the columns were lost and have been written again.
    pub fn has_lost_names(&self) -> bool {
        self.results.has_lost_names
    }

    /// Returns whether the file system has locks, so that no other process writes here.
    pub fn is_locked(&self) -> bool {
        self.lock.is_locked
    }

    /// Returns whether a run is not to be tried again: its process had begun, or it was skipped
    /// because its job timed out on a smaller mesh, which still holds.
    pub fn is_done(&self, key: &str, id: &RunId, triangles: u64) -> bool {
        match self.ends.get(key) {
            None | Some(End::NotBegun(Outcome::Crash | Outcome::Invalid, _)) => false,
            Some(End::NotBegun(..)) => self.timed_out_below(id, triangles).is_some(),
            Some(End::Begun) => true,
        }
    }

    /// Returns a row of the same job that timed out on a smaller mesh of the group.
    pub fn timed_out_below(&self, id: &RunId, triangles: u64) -> Option<&RunRecord> {
        let place = |id: &RunId| {
            let mesh = &id.mesh;
            (mesh.experiment.clone(), mesh.scale, mesh.group.clone(), id.job)
        };
        self.results.records.iter().find(|other| {
            other.outcome == Outcome::Timeout
                && other.measured.triangles.is_some_and(|smaller| smaller < triangles)
                && place(&other.id) == place(id)
        })
    }

    /// Appends a row and waits until it is on the disk. The same failure before the process began,
    /// once more, is not written again.
    ///
    /// # Errors
    /// Those of the file system, a full disk for example. Earlier rows are kept, and the part of
    /// the row that was written is removed.
    pub fn append(&mut self, record: RunRecord) -> io::Result<()> {
        let end = End::of(&record);
        if end != End::Begun && self.ends.get(&record.key) == Some(&end) {
            return Ok(());
        }
        let row = csv_text::without_header([record.to_row()])?;
        let length = self.file.metadata()?.len();
        let written = self.file.write_all(&row).and_then(|()| self.file.sync_data());
        if let Err(error) = written {
            let _ = self.file.set_len(length);
            return Err(error);
        }
        self.ends.insert(record.key.clone(), end);
        let lost = self.index.put(&mut self.results.records, record);
        self.results.superseded.extend(lost.filter(|lost| !lost.is_ok()));
        Ok(())
    }

    /// Adds a machine.
    ///
    /// # Errors
    /// Those of the file system.
    pub fn note_machine(&mut self, name: &str, facts: MachineFacts) -> io::Result<()> {
        self.results.machines.insert(name.to_owned(), facts);
        write_machines(&self.folder, &self.results)
    }

    /// Adds planned runs to those of other plans.
    ///
    /// # Errors
    /// Those of the file system.
    pub fn note_plan(&mut self, rows: Vec<Planned>) -> io::Result<()> {
        merge_plans(&mut self.results.planned, rows);
        write_plan(&self.folder, &self.results)
    }
}

impl End {
    fn of(record: &RunRecord) -> Self {
        if record.has_begun() {
            Self::Begun
        } else {
            Self::NotBegun(record.outcome, record.reason.clone())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiment::job::Job;
    use triquad::pairing::Algorithm;

    fn record(key: &str) -> RunRecord {
        let mut record =
            RunRecord { key: key.into(), reason: "one, \"two\"".into(), ..RunRecord::default() };
        record.id.mesh.name = key.into();
        record.measured.triangles = Some(8);
        record.measured.pairing_seconds = Some(0.1 + 0.2);
        record
    }

    fn is_done(journal: &Journal, key: &str) -> bool {
        journal.is_done(key, &record(key).id, 8)
    }

    fn keys(journal: &Journal) -> Vec<&str> {
        journal.results().records.iter().map(|record| &record.key[..]).collect()
    }

    #[test]
    fn what_was_appended_is_there_next_time() {
        let folder = tempfile::tempdir().unwrap();
        let mut journal = Journal::open(folder.path()).unwrap();
        journal.append(record("a")).unwrap();
        journal.append(record("b")).unwrap();
        drop(journal);
        let journal = Journal::open(folder.path()).unwrap();
        assert_eq!(journal.results().records, [record("a"), record("b")]);
        assert!(is_done(&journal, "a") && !is_done(&journal, "c"));
    }

    #[test]
    fn a_row_cut_off_anywhere_is_set_aside_and_no_other_lost() {
        let folder = tempfile::tempdir().unwrap();
        let mut journal = Journal::open(folder.path()).unwrap();
        journal.append(record("a")).unwrap();
        let path = folder.path().join("runs.csv");
        let before = std::fs::metadata(&path).unwrap().len() as usize;
        journal.append(record("b")).unwrap();
        drop(journal);
        let whole = std::fs::read(&path).unwrap();
        for end in before + 1..whole.len() {
            std::fs::write(&path, &whole[..end]).unwrap();
            let mut journal = Journal::open(folder.path()).unwrap();
            assert_eq!(keys(&journal), ["a"], "{end} bytes");
            assert_eq!(journal.set_aside().len(), 1);
            journal.append(record("c")).unwrap();
            drop(journal);
            let journal = Journal::open(folder.path()).unwrap();
            assert_eq!((keys(&journal), journal.set_aside().len()), (vec!["a", "c"], 0));
        }
        let aside = std::fs::read_to_string(folder.path().join("damaged.csv")).unwrap();
        assert_eq!(aside.lines().count(), whole.len() - before - 1);
    }

    #[test]
    fn a_row_of_rubbish_in_the_middle_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let mut journal = Journal::open(folder.path()).unwrap();
        for key in ["a", "b", "c"] {
            journal.append(record(key)).unwrap();
        }
        drop(journal);
        let path = folder.path().join("runs.csv");
        let text = std::fs::read_to_string(&path).unwrap();
        let mut lines: Vec<&str> = text.lines().collect();
        lines[2] = "rubbish";
        std::fs::write(&path, lines.join("\n") + "\n").unwrap();
        let journal = Journal::open(folder.path()).unwrap();
        assert_eq!(keys(&journal), ["a", "c"]);
        assert_eq!(journal.set_aside()[0].line, 3);
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_full_disk_is_told_and_loses_no_row() {
        let folder = tempfile::tempdir().unwrap();
        let mut journal = Journal::open(folder.path()).unwrap();
        journal.append(record("a")).unwrap();
        let disk = std::mem::replace(
            &mut journal.file,
            OpenOptions::new().append(true).open("/dev/full").unwrap(),
        );
        let error = journal.append(record("b")).unwrap_err();
        assert_eq!(error.kind(), io::ErrorKind::StorageFull);
        assert_eq!(keys(&journal), ["a"]);
        journal.file = disk;
        journal.append(record("b")).unwrap();
        drop(journal);
        assert_eq!(Journal::open(folder.path()).unwrap().results().records.len(), 2);
    }

    #[test]
    fn lost_names_are_written_again_and_no_row_is_lost() {
        let folder = tempfile::tempdir().unwrap();
        let mut journal = Journal::open(folder.path()).unwrap();
        journal.append(record("a")).unwrap();
        journal.append(record("b")).unwrap();
        drop(journal);
        let path = folder.path().join("runs.csv");
        let whole = std::fs::read_to_string(&path).unwrap();
        let (_, rows) = whole.split_once('\n').unwrap();
        std::fs::write(&path, rows).unwrap();
        let journal = Journal::open(folder.path()).unwrap();
        assert!(journal.has_lost_names() && journal.set_aside().is_empty());
        assert_eq!(keys(&journal), ["a", "b"]);
        drop(journal);
        assert_eq!(std::fs::read_to_string(&path).unwrap(), whole);
        std::fs::write(&path, "").unwrap();
        let mut journal = Journal::open(folder.path()).unwrap();
        journal.append(record("c")).unwrap();
        drop(journal);
        assert_eq!(keys(&Journal::open(folder.path()).unwrap()), ["c"]);
    }

    #[test]
    fn a_foreign_file_is_refused_and_stays() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("runs.csv");
        for text in ["date,runner,km\n2020,me,5\n", "\n", "no table"] {
            std::fs::write(&path, text).unwrap();
            let error = Journal::open(folder.path()).unwrap_err().to_string();
            assert!(error.contains("names no column 'schema'"), "{error}");
            assert_eq!(std::fs::read_to_string(&path).unwrap(), text);
            assert!(!folder.path().join("damaged.csv").exists());
        }
    }

    #[test]
    fn a_good_row_is_never_replaced_by_a_bad_one() {
        let folder = tempfile::tempdir().unwrap();
        let bad = |key: &str| RunRecord {
            key: key.into(),
            outcome: Outcome::Invalid,
            process_seconds: Some(1.0),
            ..record("a")
        };
        let mut journal = Journal::open(folder.path()).unwrap();
        journal.append(bad("first")).unwrap();
        journal.append(record("a")).unwrap();
        journal.append(bad("last")).unwrap();
        for _ in 0..2 {
            assert_eq!(journal.results().records, [record("a")]);
            assert!(is_done(&journal, "last"), "a row that does not count is there all the same");
            drop(journal);
            journal = Journal::open(folder.path()).unwrap();
        }
    }

    #[test]
    fn what_failed_before_it_began_is_tried_again_and_written_once() {
        let folder = tempfile::tempdir().unwrap();
        let failed = RunRecord { outcome: Outcome::Crash, ..record("a") };
        let mut journal = Journal::open(folder.path()).unwrap();
        journal.append(failed.clone()).unwrap();
        journal.append(failed.clone()).unwrap();
        assert!(!is_done(&journal, "a"));
        drop(journal);
        let rows = std::fs::read_to_string(folder.path().join("runs.csv")).unwrap();
        assert_eq!(rows.lines().count(), 2);
        let mut journal = Journal::open(folder.path()).unwrap();
        journal.append(RunRecord { process_seconds: Some(2.0), ..failed }).unwrap();
        assert!(is_done(&journal, "a"));
        journal.append(RunRecord { outcome: Outcome::Skipped, ..record("b") }).unwrap();
        assert!(!is_done(&journal, "b"), "the program may be installed by now");
    }

    #[test]
    fn only_a_timeout_on_a_smaller_mesh_counts() {
        let folder = tempfile::tempdir().unwrap();
        let mut journal = Journal::open(folder.path()).unwrap();
        journal.append(RunRecord { outcome: Outcome::Timeout, ..record("a") }).unwrap();
        let mut id = record("b").id;
        assert!(journal.timed_out_below(&id, 9).is_some());
        assert!(journal.timed_out_below(&id, 8).is_none());
        id.job = Job::published(Algorithm::PulliSegal);
        assert!(journal.timed_out_below(&id, 9).is_none());
    }
}
