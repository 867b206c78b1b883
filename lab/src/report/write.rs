//! Everything that is made of a folder of records, written beside them.

use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use super::compare::{self, Comparison};
use super::page::{self, Parts, Pictured};
use super::summary::Summary;
use super::{gallery, plots, tables};
use crate::experiment::Results;
use crate::experiment::results::ResultsError;
use triquad::atomic_file::AtomicFile;

/// A file of a report.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReportFile {
    /// Its path within the results folder, parts separated by `/`.
    pub name: String,
    /// What is in it.
    pub bytes: Vec<u8>,
}

/// What was written, and what could not be said.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    /// The files, in the results folder.
    pub files: Vec<PathBuf>,
    /// The verdicts.
    pub comparison: Comparison,
    /// What is missing or damaged, in lines.
    pub defects: Vec<String>,
}

/// Why no report was written.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// The records cannot be read.
    #[error(transparent)]
    Results(#[from] ResultsError),
    /// A file cannot be written.
    #[error("{}: {error}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// Why.
        error: io::Error,
    },
}

/// Writes tables, verdicts, plots and the page of the records in `folder` into it. The same records and
/// pictures give the same bytes.
///
/// # Errors
/// The records cannot be read, or a file cannot be written; then none of the files is half written, and
/// none is replaced unless all of them could be written.
pub fn write(folder: &Path) -> Result<Report, ReportError> {
    write_with(folder, true)
}

/// Like [`write()`], without plots and page: soon done.
///
/// # Errors
/// See [`write()`].
pub fn write_tables(folder: &Path) -> Result<Report, ReportError> {
    write_with(folder, false)
}

fn write_with(folder: &Path, page: bool) -> Result<Report, ReportError> {
    let results = Results::read(folder)?;
    let summary = Summary::of(&results);
    let comparison = compare::judge(&summary);
    let mut files = files(&summary, &comparison);
    if page {
        files.extend(page_files(&results, &summary, &comparison, &pictures_in(folder)));
    }
    let paths = write_all(folder, &files)?;
    Ok(Report { files: paths, comparison, defects: defects(&results, &summary) })
}

/// The tables and verdicts, in the order in which they are written.
pub fn files(summary: &Summary, comparison: &Comparison) -> Vec<ReportFile> {
    let mut files: Vec<ReportFile> = tables::all(summary)
        .into_iter()
        .map(|table| ReportFile { name: table.file.into(), bytes: table.csv().into_bytes() })
        .collect();
    files.push(ReportFile { name: "compare.csv".into(), bytes: comparison.csv().into_bytes() });
    files
}

/// The plots, and the page with everything in it.
pub fn page_files(
    results: &Results,
    summary: &Summary,
    comparison: &Comparison,
    pictures: &[Pictured],
) -> Vec<ReportFile> {
    let (tables, plots) = (tables::all(summary), plots::all(summary));
    let tables = &tables;
    let parts = Parts { results, summary, tables, comparison, plots: &plots, pictures };
    let page = ReportFile { name: "index.html".into(), bytes: page::render(&parts).into_bytes() };
    let of_plot = |plot: plots::Plot| {
        let file = |ending: &str, bytes| ReportFile {
            name: format!("plots/{}.{ending}", plot.stem),
            bytes,
        };
        let (svg, csv) = (plot.svg.into_bytes(), plot.csv.into_bytes());
        [file("svg", svg), file("png", plot.png), file("csv", csv)]
    };
    let mut files = vec![page];
    files.extend(plots.into_iter().flat_map(of_plot));
    files
}

/// The pictures beside the records whose files can be read.
fn pictures_in(folder: &Path) -> Vec<Pictured> {
    let folder = folder.join("pictures");
    let read = |shown: gallery::Shown| {
        let png = std::fs::read(folder.join(&shown.file)).ok()?;
        Some(Pictured { shown, png })
    };
    gallery::read(&folder).into_iter().filter_map(read).collect()
}

/// Writes all files before any of them takes the place of an older one.
fn write_all(folder: &Path, files: &[ReportFile]) -> Result<Vec<PathBuf>, ReportError> {
    let mut pending = Vec::new();
    for file in files {
        let path = folder.join(&file.name);
        let failure = |error| ReportError::Write { path: path.clone(), error };
        let parent = path.parent().expect("a file within the folder");
        std::fs::create_dir_all(parent).map_err(failure)?;
        let mut out = AtomicFile::create(&path).map_err(failure)?;
        out.write_all(&file.bytes).and_then(|()| out.flush()).map_err(failure)?;
        pending.push((path, out));
    }
    let commit = |(path, out): (PathBuf, AtomicFile)| match out.commit() {
        Ok(()) => Ok(path),
        Err(error) => Err(ReportError::Write { path, error }),
    };
    pending.into_iter().map(commit).collect()
}

/// What a reader of the report must be told is not in it.
fn defects(results: &Results, summary: &Summary) -> Vec<String> {
    let damaged = results
        .damaged
        .iter()
        .map(|row| format!("runs.csv, line {}: damaged and left out: {}", row.line, row.problem));
    let missing = summary.cells().iter().filter(|cell| cell.missing() > 0).map(|cell| {
        let (mesh, label, runs) = (&cell.mesh, cell.label(), cell.missing());
        format!("{}: {label} on {mesh}: {runs} planned runs have no row", cell.experiment)
    });
    damaged.chain(missing).collect()
}
