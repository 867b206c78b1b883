//! `triquad compare`.

use std::path::PathBuf;

use triquad_lab::report::{Judged, Summary, Verdict, compare};

use crate::failure::Failure;
use crate::{report, stdio};

/// Judge every claim of the two papers on the records of a results folder
///
/// A line a claim: verdict, name, our number, the paper's; why, where it is not reproduced. Counts
/// of verdicts at the end. Claims that differ are no failure.
#[derive(clap::Args)]
#[command(after_help = "Example: triquad compare results/laptop")]
pub struct Arguments {
    /// The results folder
    #[arg(value_name = "DIR")]
    folder: PathBuf,
}

/// Prints the verdicts.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let folder = arguments.folder.display();
    let results = report::read(&arguments.folder)?;
    if results.records.is_empty() {
        return Err(Failure::bad(format!(
            "{folder}: runs.csv has no records; 'triquad run' adds some"
        )));
    }
    let comparison = compare::judge(&Summary::new(&results));
    let width = comparison.verdicts.iter().map(|judged| judged.id.len()).max().unwrap_or(0);
    for judged in &comparison.verdicts {
        stdio::say(&line(judged, width))?;
    }
    let counts = Verdict::ALL.map(|v| format!("{} {}", comparison.count(v), v.name()));
    stdio::say(&format!("{} claims: {}", comparison.verdicts.len(), counts.join(", ")))
}

/// Writes one claim in columns.
fn line(judged: &Judged, width: usize) -> String {
    let number = |number: &String| if number.is_empty() { "-".into() } else { number.clone() };
    let (ours, paper) = (number(&judged.ours), number(&judged.paper));
    let why = match judged.verdict {
        Verdict::Reproduced => String::new(),
        _ => format!("  ({})", judged.reason),
    };
    format!(
        "{:<18}  {:<width$}  ours {ours} | paper {paper}{why}",
        judged.verdict.name(),
        judged.id
    )
}
