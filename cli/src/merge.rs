//! `triquad merge`.

use std::path::PathBuf;

use triquad::counted::counted;
use triquad_lab::experiment::command_line::quoted;
use triquad_lab::experiment::merge::{MergeError, merge};

use crate::failure::Failure;
use crate::{bad_runs, results_folder, stdio};

/// Join the results of several machines
///
/// Writes runs.csv, plan.csv, machines.json and the pictures; 'triquad report DIR' makes tables,
/// plots and page.
///
/// Of a run that was done twice, the last one that ended well counts. Exit code 1 if a run did not
/// end well; each is named, and the folders are joined all the same.
#[derive(clap::Args)]
#[command(after_help = "Example: triquad merge results/part-1 results/part-2 --out results/whole")]
pub struct Arguments {
    /// Folders with results
    #[arg(value_name = "DIR", required = true)]
    folders: Vec<PathBuf>,
    /// The folder for the joined results
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

/// Merges the folders and prints what came of it.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let merged = merge(&arguments.folders, &arguments.out).map_err(|error| match error {
        MergeError::Results(error) => {
            results_folder::unreadable(&error, "name folders that 'triquad run' has written")
        }
        MergeError::Lock(error) => results_folder::unlockable(&error),
        MergeError::Write { out, error } => results_folder::unwritable(&out, &error),
    })?;
    let aside = match merged.damaged.len() {
        0 => String::new(),
        damaged => {
            let rows = counted(damaged, "damaged row is", "damaged rows are");
            format!("; {rows} set aside in damaged.csv")
        }
    };
    let out = arguments.out.display();
    let rows = counted(merged.records.len(), "run", "runs");
    let machines = counted(merged.machines.len(), "machine", "machines");
    stdio::say(&format!("{out}: {rows} of {machines}{aside}"))?;
    let folder = quoted(&out.to_string());
    stdio::say(&format!("for tables, plots and page: triquad report {folder}"))?;
    bad_runs::refuse(&arguments.out, &merged, |_| false)
}
