//! `runs.csv` as it is written: row by row, each on the disk before the next run begins.

use std::collections::HashSet;
use std::fs::{File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::record::{Outcome, RunRecord};
use super::results::{Damaged, Facts, Planned, Results};
use triquad::atomic_file::AtomicFile;

/// The results folder of an experiment that is being run.
#[derive(Debug)]
pub struct Journal {
    folder: PathBuf,
    file: File,
    results: Results,
    keys: HashSet<String>,
}

impl Journal {
    /// Opens `folder` and reads what was done before.
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
        if !results.damaged.is_empty() {
            set_aside(&folder.join("damaged.csv"), &results.damaged)?;
        }
        if !path.exists() || !results.damaged.is_empty() {
            write_rows(&path, &results.records)?;
        }
        let file = OpenOptions::new().append(true).open(path)?;
        let keys = results.records.iter().map(|record| record.key.clone()).collect();
        Ok(Self { folder: folder.to_owned(), file, results, keys })
    }

    /// What is known so far.
    pub fn results(&self) -> &Results {
        &self.results
    }

    /// Whether a run of this key has a row.
    pub fn has(&self, key: &str) -> bool {
        self.keys.contains(key)
    }

    /// Whether an algorithm timed out on a smaller mesh of the group.
    pub fn timed_out_below(&self, run: &RunRecord, triangles: u64) -> Option<&RunRecord> {
        self.results.records.iter().find(|other| {
            other.outcome == Outcome::Timeout
                && other.triangles.is_some_and(|smaller| smaller < triangles)
                && (&other.experiment, &other.scale, &other.group)
                    == (&run.experiment, &run.scale, &run.group)
                && (&other.algorithm, &other.lrs_variant, &other.augmentation, &other.order)
                    == (&run.algorithm, &run.lrs_variant, &run.augmentation, &run.order)
        })
    }

    /// Appends a row and waits until it is on the disk.
    ///
    /// # Errors
    /// Those of the file system, a full disk for example; rows before are not touched. What was
    /// written of the row is taken back.
    pub fn append(&mut self, record: RunRecord) -> io::Result<()> {
        let row = row_of(&record)?;
        let length = self.file.metadata()?.len();
        let written = self.file.write_all(&row).and_then(|()| self.file.sync_data());
        if let Err(error) = written {
            let _ = self.file.set_len(length);
            return Err(error);
        }
        self.keys.insert(record.key.clone());
        self.results.push(record);
        Ok(())
    }

    /// Remembers a machine.
    ///
    /// # Errors
    /// Those of the file system.
    pub fn note_machine(&mut self, name: &str, facts: Facts) -> io::Result<()> {
        self.results.machines.insert(name.to_owned(), facts);
        write_machines(&self.folder, &self.results)
    }

    /// Remembers what is planned; other plans stay.
    ///
    /// # Errors
    /// Those of the file system.
    pub fn note_plan(&mut self, rows: Vec<Planned>) -> io::Result<()> {
        merge_plans(&mut self.results.planned, rows);
        write_plan(&self.folder, &self.results)
    }
}

/// Adds `rows` to `planned`; of the same job on the same mesh the newer number of repetitions counts.
pub(super) fn merge_plans(planned: &mut Vec<Planned>, rows: Vec<Planned>) {
    for row in rows {
        let same = |other: &&mut Planned| {
            Planned { repetitions: row.repetitions, ..(**other).clone() } == row
        };
        match planned.iter_mut().find(same) {
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
    if !results.damaged.is_empty() {
        set_aside(&folder.join("damaged.csv"), &results.damaged)?;
    }
    write_plan(folder, results)?;
    write_machines(folder, results)?;
    write_rows(&folder.join("runs.csv"), &results.records)
}

fn write_plan(folder: &Path, results: &Results) -> io::Result<()> {
    let mut file = AtomicFile::create(&folder.join("plan.csv"))?;
    {
        let mut writer = csv::Writer::from_writer(&mut file);
        results.planned.iter().try_for_each(|row| writer.serialize(row))?;
        writer.flush()?;
    }
    file.commit()
}

fn write_machines(folder: &Path, results: &Results) -> io::Result<()> {
    let mut file = AtomicFile::create(&folder.join("machines.json"))?;
    serde_json::to_writer_pretty(&mut file, &results.machines)?;
    writeln!(file)?;
    file.commit()
}

fn write_rows(path: &Path, records: &[RunRecord]) -> io::Result<()> {
    let mut file = AtomicFile::create(path)?;
    let with_header = with_header(&RunRecord::default())?;
    let end = with_header.iter().position(|&byte| byte == b'\n').map_or(0, |end| end + 1);
    file.write_all(&with_header[..end])?;
    for record in records {
        file.write_all(&row_of(record)?)?;
    }
    file.commit()
}

fn row_of(record: &RunRecord) -> io::Result<Vec<u8>> {
    let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
    writer.serialize(record)?;
    writer.into_inner().map_err(|error| io::Error::other(error.to_string()))
}

fn with_header(record: &RunRecord) -> io::Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.serialize(record)?;
    writer.into_inner().map_err(|error| io::Error::other(error.to_string()))
}

/// Appends damaged rows to a file of their own, so that nothing is lost.
fn set_aside(path: &Path, damaged: &[Damaged]) -> io::Result<()> {
    let mut file = OpenOptions::new().append(true).create(true).open(path)?;
    for row in damaged {
        writeln!(file, "{}", row.text)?;
    }
    file.sync_data()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiment::record::SCHEMA;

    fn record(key: &str) -> RunRecord {
        RunRecord {
            schema: SCHEMA.into(),
            key: key.into(),
            mesh: key.into(),
            reason: "one, \"two\"".into(),
            triangles: Some(8),
            pairing_seconds: Some(0.1 + 0.2),
            ..Default::default()
        }
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
            assert_eq!(journal.results().damaged.len(), 1);
            journal.append(record("c")).unwrap();
            let journal = Journal::open(folder.path()).unwrap();
            assert_eq!((keys(&journal), journal.results().damaged.len()), (vec!["a", "c"], 0));
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
        assert_eq!(journal.results().damaged[0].line, 3);
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
        assert!(journal.timed_out_below(&record("b"), 9).is_some());
        assert!(journal.timed_out_below(&record("b"), 8).is_none());
        let other = RunRecord { algorithm: "ps".into(), ..record("b") };
        assert!(journal.timed_out_below(&other, 9).is_none());
    }
}
