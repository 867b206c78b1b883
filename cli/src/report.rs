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

/// Reads the records of a results folder.
pub fn read(folder: &Path) -> Result<Results, Failure> {
    Results::read(folder)
        .map_err(|error| Failure::bad(format!("{error}; 'triquad run' makes such a folder")))
}

/// Writes the whole report and prints what is lost.
pub fn write(folder: &Path, results: &Results) -> Result<Report, Failure> {
    let report = report::write(folder, results, Extent::Everything)
        .map_err(|error| Failure::bad(error.to_string()))?;
    let lost = report.defects.iter().filter(|defect| defect.is_loss());
    lost.for_each(|defect| stdio::complain(&defect.to_string()));
    Ok(report)
}
