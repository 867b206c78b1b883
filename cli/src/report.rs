//! `triquad report`.

use std::path::{Path, PathBuf};

use triquad_lab::experiment::Results;
use triquad_lab::report::{self, Extent, Report};

use crate::failure::Failure;
use crate::stdio;

/// Rebuild tables, verdicts, plots and page from the records of a results folder
///
/// Everything is made of runs.csv, plan.csv, machines.json and pictures/, nothing is run: the same
/// records give the same files.
#[derive(clap::Args)]
#[command(after_help = "Example: triquad report results/laptop")]
pub struct Arguments {
    /// The results folder
    #[arg(value_name = "DIR")]
    folder: PathBuf,
}

/// Writes the report and names the page, or else the folder.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let folder = &arguments.folder;
    let results = read(folder)?;
    let report = write(folder, &results)?;
    stdio::say(&report.page.unwrap_or_else(|| folder.clone()).display().to_string())
}

/// Reads the records of a results folder, of which there must be some.
pub fn read(folder: &Path) -> Result<Results, Failure> {
    let results = Results::read(folder).map_err(|error| {
        Failure::bad(format!("{error}; 'triquad run' and 'triquad import' make such a folder"))
    })?;
    if results.records.is_empty() {
        let damaged = match results.damaged.len() {
            0 => String::new(),
            rows => format!(" ({rows} rows are damaged)"),
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
        .map_err(|error| Failure::bad(error.to_string()))?;
    let lost = report.defects.iter().filter(|defect| defect.is_loss());
    lost.for_each(|defect| stdio::complain(&defect.to_string()));
    Ok(report)
}
