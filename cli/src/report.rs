//! `triquad report`.

use std::path::PathBuf;

use triquad_lab::report::write;

use crate::failure::Failure;
use crate::stdio;

/// Rebuild tables and verdicts from the records of a results folder
///
/// Everything is made of runs.csv, plan.csv and machines.json, nothing is run: the same records give the
/// same files.
#[derive(clap::Args)]
#[command(after_help = "Example: triquad report results/laptop")]
pub struct Arguments {
    /// The results folder
    #[arg(value_name = "DIR")]
    folder: PathBuf,
}

/// Writes the report and names the page, or else the folder.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let report = write::write(&arguments.folder)
        .map_err(|error| Failure::bad(format!("{error}; 'triquad run' makes such a folder")))?;
    report.defects.iter().for_each(|defect| stdio::complain(defect));
    let page = report.files.iter().find(|path| path.extension().is_some_and(|e| e == "html"));
    stdio::say(&page.unwrap_or(&arguments.folder).display().to_string())
}
