//! The files of a results folder as they are written: each complete, or as it was before.

use std::fs::OpenOptions;
use std::io::{self, Write};
use std::path::Path;

use super::record::RunRecord;
use super::results::{DamagedRow, Planned, Results, column_names};
use crate::{csv_text, whole_file};

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
    write_rows(&folder.join("runs.csv"), results)
}

pub(super) fn write_plan(folder: &Path, results: &Results) -> io::Result<()> {
    let rows = csv_text::with_header(results.planned.iter().map(Planned::to_row))?;
    whole_file::write(&folder.join("plan.csv"), &rows)
}

pub(super) fn write_machines(folder: &Path, results: &Results) -> io::Result<()> {
    let mut text = serde_json::to_vec_pretty(&results.machines)?;
    text.push(b'\n');
    whole_file::write(&folder.join("machines.json"), &text)
}

/// Writes the names of the columns, which are there without any row too, and the rows. Those that
/// are superseded come first, so that the others count.
pub(super) fn write_rows(path: &Path, results: &Results) -> io::Result<()> {
    let mut text = column_names()?.into_bytes();
    text.push(b'\n');
    let rows = results.superseded.iter().chain(&results.records);
    text.extend(csv_text::without_header(rows.map(RunRecord::to_row))?);
    whole_file::write(path, &text)
}

/// Appends damaged rows to a file of their own, so that nothing is lost.
pub(super) fn append_damaged(folder: &Path, damaged: &[DamagedRow]) -> io::Result<()> {
    if damaged.is_empty() {
        return Ok(());
    }
    let path = folder.join("damaged.csv");
    whole_file::refuse_link(&path)?;
    let mut file = OpenOptions::new().append(true).create(true).open(path)?;
    for row in damaged {
        writeln!(file, "{}", row.text)?;
    }
    file.sync_data()
}
