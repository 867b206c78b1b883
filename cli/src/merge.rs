//! `triquad merge`.

use std::path::PathBuf;

use triquad_lab::experiment::merge::merge;

use crate::failure::Failure;
use crate::stdio;

/// Put the results of several machines together
///
/// Of a run that was done twice the last that ended well counts.
#[derive(clap::Args)]
#[command(after_help = "Example: triquad merge results/part-1 results/part-2 --out results/whole")]
pub struct Arguments {
    /// Folders with results
    #[arg(value_name = "DIR", required = true)]
    folders: Vec<PathBuf>,
    /// Where all of them go
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

/// Merges the folders and prints what came of it.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let merged = merge(&arguments.folders, &arguments.out).map_err(|error| {
        Failure::bad(format!("{error}; name folders that 'triquad run' has written"))
    })?;
    let (rows, damaged) = (merged.records.len(), merged.damaged.len());
    let out = arguments.out.display();
    let aside = match damaged {
        0 => String::new(),
        _ => format!("; {damaged} damaged rows are set aside in damaged.csv"),
    };
    stdio::say(&format!("{out}: {rows} runs of {} machines{aside}", merged.machines.len()))
}
