//! `triquad report`.

use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use triquad::atomic_file::AtomicFile;
use triquad::counted::counted;
use triquad_lab::experiment::Results;
use triquad_lab::pictures;
use triquad_lab::report::{self, Extent, Report, documents};

use crate::failure::Failure;
use crate::{experiments, generate, own_program, results_folder, stdio};

/// Rebuild tables, verdicts, plots and page from the records of a results folder
///
/// Everything is made of runs.csv, plan.csv, machines.json and pictures/, nothing is run: the same
/// records give the same files. SHA256SUMS has the hashes of page, plots and pictures.
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  triquad report results/laptop\n  \
                        triquad report results/laptop --docs notes.md\n  \
                        triquad report results/laptop --pictures experiments/comparison.toml")]
pub struct Arguments {
    /// The results folder
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    /// Fill the tables of Markdown files from the records, too: the lines between
    /// '<!-- table: 4.3 -->' and '<!-- end -->' are replaced
    #[arg(long, value_name = "FILE", num_args = 1..)]
    docs: Vec<PathBuf>,
    /// Draw the pictures of these experiment files first, if the folder lacks any: a few seconds
    #[arg(long, value_name = "EXPERIMENT.toml", num_args = 1..)]
    pictures: Vec<PathBuf>,
    #[command(flatten)]
    cache: generate::CacheOption,
}

/// Writes the report and names the page, or else the folder.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let folder = &arguments.folder;
    let results = read(folder)?;
    draw_missing(arguments, &results)?;
    let report = write(folder, &results)?;
    arguments.docs.iter().try_for_each(|document| fill(document, &results))?;
    stdio::say(&report.page.unwrap_or_else(|| folder.clone()).display().to_string())
}

/// Draws the pictures if some are missing, of meshes of the size that the first record has.
fn draw_missing(arguments: &Arguments, results: &Results) -> Result<(), Failure> {
    let folder = &arguments.folder;
    if arguments.pictures.is_empty() || pictures::are_complete(folder) {
        return Ok(());
    }
    let scale = results.records[0].id.mesh.scale;
    let meshes = experiments::pictured(&arguments.pictures, scale)?;
    let program = own_program::hash()
        .map_err(|error| Failure::bad(format!("this program cannot be read: {error}")))?;
    let cache = arguments.cache.folder();
    meshes.iter().try_for_each(|pictured| {
        let failure =
            |error| Failure::bad(format!("{} cannot be drawn: {error}", pictured.mesh.name));
        pictures::draw(folder, pictured, cache.as_deref(), &program, || {}).map_err(failure)
    })
}

/// Reads the records of a results folder, of which there must be some.
pub fn read(folder: &Path) -> Result<Results, Failure> {
    let makers = "'triquad run' and 'triquad import' make such a folder";
    let read = Results::read(folder);
    let results = read.map_err(|error| results_folder::unreadable(&error, makers))?;
    if results.records.is_empty() {
        let damaged = match results.damaged.len() {
            0 => String::new(),
            rows => format!(" ({} damaged)", counted(rows, "row is", "rows are")),
        };
        return Err(Failure::bad(format!(
            "{}: runs.csv has no records{damaged}; 'triquad run' or 'triquad import' adds some",
            folder.display()
        )));
    }
    Ok(results)
}

/// Writes the whole report and prints what is lost.
pub fn write(folder: &Path, results: &Results) -> Result<Report, Failure> {
    let report = report::write(folder, results, Extent::Everything)
        .map_err(|error| results_folder::unwritable(&error.path, &error.error))?;
    let lost = report.defects.iter().filter(|defect| defect.is_loss());
    lost.for_each(|defect| stdio::complain(&defect.to_string()));
    Ok(report)
}

/// Fills the tables of a document; leaves a document alone that is as it should be.
fn fill(path: &Path, results: &Results) -> Result<(), Failure> {
    let failure = |error: io::Error| Failure::bad(format!("{}: {error}", path.display()));
    let document = std::fs::read_to_string(path).map_err(failure)?;
    let filled = documents::fill(&document, results)
        .map_err(|error| Failure::bad(format!("{}:{error}", path.display())))?;
    if filled == document {
        return Ok(());
    }
    let mut file = AtomicFile::create(path).map_err(failure)?;
    file.write_all(filled.as_bytes()).and_then(|()| file.commit()).map_err(failure)
}
