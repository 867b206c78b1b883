//! `runs.csv` as it is written: row by row, each on the disk before the next run begins.

use std::collections::HashSet;
use std::fs::{File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::record::{Outcome, RunRecord};
use super::results::{DamagedRow, MachineFacts, Planned, Results, RunIndex};
use super::run_id::RunId;
use crate::{csv_text, whole_file};

/// The results folder of an experiment that is being run.
#[derive(Debug)]
pub struct Journal {
    folder: PathBuf,
    file: File,
    results: Results,
    index: RunIndex,
    keys: HashSet<String>,
    set_aside: Vec<DamagedRow>,
}

impl Journal {
    /// Opens `folder` and reads the rows of earlier runs.
    ///
    /// Damaged rows are moved to `damaged.csv`: their runs count as not done.
    ///
    /// # Errors
    /// Those of the file system.
    pub fn open(folder: &Path) -> io::Result<Self> {
        std::fs::create_dir_all(folder)?;
        let path = folder.join("runs.csv");
        let mut results = Results::default();
        if path.exists() {
            results = Results::read(folder).map_err(|error| error.error)?;
        }
        let set_aside = std::mem::take(&mut results.damaged);
        append_damaged(folder, &set_aside)?;
        if !path.exists() || !set_aside.is_empty() {
            write_rows(&path, &results.records)?;
        }
        let file = OpenOptions::new().append(true).open(path)?;
        let keys = results.records.iter().map(|record| record.key.clone()).collect();
        let index = RunIndex::new(&results.records);
        Ok(Self { folder: folder.to_owned(), file, results, index, keys, set_aside })
    }

    /// Returns the results so far.
    pub fn results(&self) -> &Results {
        &self.results
    }

    /// Returns the damaged rows that were moved when the folder was opened.
    pub fn set_aside(&self) -> &[DamagedRow] {
        &self.set_aside
    }

    /// Returns whether a run of this key has a row. O(1).
    pub fn has(&self, key: &str) -> bool {
        self.keys.contains(key)
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

    /// Appends a row and waits until it is on the disk.
    ///
    /// # Errors
    /// Those of the file system, a full disk for example. Earlier rows are kept, and the part of
    /// the row that was written is removed.
    pub fn append(&mut self, record: RunRecord) -> io::Result<()> {
        let row = csv_text::without_header([record.to_row()])?;
        let length = self.file.metadata()?.len();
        let written = self.file.write_all(&row).and_then(|()| self.file.sync_data());
        if let Err(error) = written {
            let _ = self.file.set_len(length);
            return Err(error);
        }
        self.keys.insert(record.key.clone());
        self.index.put(&mut self.results.records, record);
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

/// Adds `rows` to `planned`; of the same job on the same mesh the newer number of repetitions
/// counts.
pub(super) fn merge_plans(planned: &mut Vec<Planned>, rows: Vec<Planned>) {
    for row in rows {
        match planned.iter_mut().find(|known| known.id == row.id) {
            Some(known) => known.repetitions = row.repetitions,
            None => planned.push(row),
        }
    }
}

/// Writes a whole results folder.
///
/// # Errors
/// Those of the file system.
pub(super) fn write_results(folder: &Path, results: &Results) -> io::Result<()> {
    std::fs::create_dir_all(folder)?;
    append_damaged(folder, &results.damaged)?;
    write_plan(folder, results)?;
    write_machines(folder, results)?;
    write_rows(&folder.join("runs.csv"), &results.records)
}

fn write_plan(folder: &Path, results: &Results) -> io::Result<()> {
    let rows = csv_text::with_header(results.planned.iter().map(Planned::to_row))?;
    whole_file::write(&folder.join("plan.csv"), &rows)
}

fn write_machines(folder: &Path, results: &Results) -> io::Result<()> {
    let mut text = serde_json::to_vec_pretty(&results.machines)?;
    text.push(b'\n');
    whole_file::write(&folder.join("machines.json"), &text)
}

/// Writes the names of the columns, which are there without any row too, and the rows.
fn write_rows(path: &Path, records: &[RunRecord]) -> io::Result<()> {
    let mut text = csv_text::with_header([RunRecord::default().to_row()])?;
    text.truncate(text.iter().position(|&byte| byte == b'\n').map_or(0, |end| end + 1));
    text.extend(csv_text::without_header(records.iter().map(RunRecord::to_row))?);
    whole_file::write(path, &text)
}

/// Appends damaged rows to a file of their own, so that nothing is lost.
fn append_damaged(folder: &Path, damaged: &[DamagedRow]) -> io::Result<()> {
    if damaged.is_empty() {
        return Ok(());
    }
    let path = folder.join("damaged.csv");
    let mut file = OpenOptions::new().append(true).create(true).open(path)?;
    for row in damaged {
        writeln!(file, "{}", row.text)?;
    }
    file.sync_data()
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

    fn keys(journal: &Journal) -> Vec<&str> {
        journal.results().records.iter().map(|record| &record.key[..]).collect()
    }

    #[test]
    fn what_was_appended_is_there_next_time() {
        let folder = tempfile::tempdir().unwrap();
        let mut journal = Journal::open(folder.path()).unwrap();
        journal.append(record("a")).unwrap();
        journal.append(record("b")).unwrap();
        let journal = Journal::open(folder.path()).unwrap();
        assert_eq!(journal.results().records, [record("a"), record("b")]);
        assert!(journal.has("a") && !journal.has("c"));
    }

    #[test]
    fn a_row_cut_off_anywhere_is_set_aside_and_no_other_lost() {
        let folder = tempfile::tempdir().unwrap();
        let mut journal = Journal::open(folder.path()).unwrap();
        journal.append(record("a")).unwrap();
        let path = folder.path().join("runs.csv");
        let before = std::fs::metadata(&path).unwrap().len() as usize;
        journal.append(record("b")).unwrap();
        let whole = std::fs::read(&path).unwrap();
        for end in before + 1..whole.len() {
            std::fs::write(&path, &whole[..end]).unwrap();
            let mut journal = Journal::open(folder.path()).unwrap();
            assert_eq!(keys(&journal), ["a"], "{end} bytes");
            assert_eq!(journal.set_aside().len(), 1);
            journal.append(record("c")).unwrap();
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
        assert_eq!(Journal::open(folder.path()).unwrap().results().records.len(), 2);
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
