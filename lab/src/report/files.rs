//! The files of a report, written beside the records.

use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use super::baseline::BaselineTable;
use super::compare::{self, Comparison};
use super::defects::Defect;
use super::page::{self, Parts, PictureFile};
use super::summary::Summary;
use super::tables::{self, ReportTable};
use super::{plots, plots::Plot};
use crate::experiment::Results;
use crate::file_hash::hash_of_bytes;
use crate::pictures::PictureRecord;
use crate::whole_file::refuse_link;
use triquad::atomic_file::AtomicFile;

/// Extent of a written report.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    /// Tables and verdicts: soon done.
    Tables,
    /// Plots and the page too.
    Everything,
}

/// A file of a report.
struct ReportFile {
    /// Path within the results folder, parts separated by `/`.
    name: String,
    bytes: Vec<u8>,
}

/// Outcome of writing a report.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    /// The page, if it was written.
    pub page: Option<PathBuf>,
    /// Missing and damaged parts.
    pub defects: Vec<Defect>,
}

/// A file of a report that cannot be written.
#[derive(Debug, thiserror::Error)]
#[error("{}: {error}", path.display())]
pub struct ReportError {
    /// The file.
    pub path: PathBuf,
    /// The reason of the file system.
    pub error: io::Error,
}

/// Name of the page's file.
const PAGE: &str = "index.html";
/// Name of the file with the hashes of page, plots and pictures: these are not kept in git.
const HASHES: &str = "SHA256SUMS";
/// Length of a SHA-256 in digits.
const HEXADECIMAL_DIGITS: usize = 64;

/// Writes the report on `results` into `folder`. The same records and pictures give the same bytes.
///
/// # Errors
/// A file cannot be written; then none of the files is half written, and none is replaced unless
/// all of them could be written.
pub fn write(folder: &Path, results: &Results, extent: Extent) -> Result<Report, ReportError> {
    let summary = Summary::new(results);
    let (tables, comparison) = (tables::all(&summary), compare::judge(&summary));
    let defects = Defect::all(results, &summary);
    let mut files = table_files(&tables, &comparison);
    if extent == Extent::Everything {
        let (plots, pictures) = (plots::all(&summary), pictures_in(folder));
        let tolerances = compare::tolerances(&summary);
        let text = compare::tolerances_csv(&tolerances).into();
        files.push(ReportFile { name: "tolerances.csv".into(), bytes: text });
        let parts = Parts {
            results,
            summary: &summary,
            tables: &tables,
            comparison: &comparison,
            tolerances: &tolerances,
            plots: &plots,
            pictures: &pictures,
            defects: &defects,
        };
        let page = ReportFile { name: PAGE.into(), bytes: page::render(&parts).into_bytes() };
        let shown: Vec<ReportFile> =
            std::iter::once(page).chain(plots.into_iter().flat_map(plot_files)).collect();
        files.push(hashes(&shown, &pictures));
        files.extend(shown);
    }
    write_all(folder, &files)?;
    let page = (extent == Extent::Everything).then(|| folder.join(PAGE));
    Ok(Report { page, defects })
}

/// Name of the folder for comparisons with a baseline.
const BASELINE: &str = "baseline";

/// Writes tables against a baseline into the folder `baseline` in `folder`, and returns that.
///
/// # Errors
/// A file cannot be written.
pub fn write_baseline(folder: &Path, tables: &[BaselineTable]) -> Result<PathBuf, ReportError> {
    let file = |table: &BaselineTable| ReportFile {
        name: format!("{BASELINE}/{}", table.file),
        bytes: table.csv().into(),
    };
    let files: Vec<ReportFile> = tables.iter().map(file).collect();
    write_all(folder, &files)?;
    Ok(folder.join(BASELINE))
}

fn table_files(tables: &[ReportTable], comparison: &Comparison) -> Vec<ReportFile> {
    let table =
        |table: &ReportTable| ReportFile { name: table.file.into(), bytes: table.csv().into() };
    let mut files: Vec<ReportFile> = tables.iter().map(table).collect();
    files.push(ReportFile { name: "compare.csv".into(), bytes: comparison.csv().into() });
    files
}

fn plot_files(plot: Plot) -> [ReportFile; 3] {
    let file =
        |ending: &str, bytes| ReportFile { name: format!("plots/{}.{ending}", plot.stem), bytes };
    [file("svg", plot.svg.into()), file("png", plot.png), file("csv", plot.csv.into())]
}

/// Lists page, plots and pictures with their SHA-256, as `sha256sum --check` reads it.
fn hashes(shown: &[ReportFile], pictures: &[PictureFile]) -> ReportFile {
    let line = |name: &str, bytes: &[u8]| format!("{}  {name}\n", hash_of_bytes(bytes));
    let pictures = pictures
        .iter()
        .map(|picture| line(&format!("pictures/{}", picture.record.file), &picture.png));
    let mut lines: Vec<String> =
        shown.iter().map(|file| line(&file.name, &file.bytes)).chain(pictures).collect();
    lines.sort_by(|one, other| one[HEXADECIMAL_DIGITS..].cmp(&other[HEXADECIMAL_DIGITS..]));
    ReportFile { name: HASHES.into(), bytes: lines.concat().into_bytes() }
}

/// Reads the pictures beside the records; those without a file are left out.
fn pictures_in(folder: &Path) -> Vec<PictureFile> {
    let folder = folder.join("pictures");
    // A name that leads out of the folder is no picture of ours.
    let is_plain = |name: &str| Path::new(name).file_name().is_some_and(|file| file == name);
    let read = |record: PictureRecord| {
        if !is_plain(&record.file) || folder.join(&record.file).is_symlink() {
            return None;
        }
        let png = std::fs::read(folder.join(&record.file)).ok()?;
        Some(PictureFile { record, png })
    };
    PictureRecord::read_all(&folder).into_iter().filter_map(read).collect()
}

/// Writes all files before any of them takes the place of an older one.
fn write_all(folder: &Path, files: &[ReportFile]) -> Result<(), ReportError> {
    let mut pending = Vec::new();
    for file in files {
        let path = folder.join(&file.name);
        let failure = |error| ReportError { path: path.clone(), error };
        let parent = path.parent().expect("a file within the folder");
        std::fs::create_dir_all(parent).map_err(failure)?;
        refuse_link(&path).map_err(failure)?;
        let mut out = AtomicFile::create(&path).map_err(failure)?;
        out.write_all(&file.bytes).and_then(|()| out.flush()).map_err(failure)?;
        pending.push((path, out));
    }
    let commit = |(path, out): (PathBuf, AtomicFile)| {
        out.commit().map_err(|error| ReportError { path, error })
    };
    pending.into_iter().try_for_each(commit)
}
