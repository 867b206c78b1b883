//! Runs that did not end well, named for the terminal.

use std::path::Path;

use triquad::counted::counted;
use triquad_lab::experiment::{Results, RunRecord};

use crate::failure::Failure;
use crate::stdio;

/// Names of bad runs that are printed at most.
const MOST_NAMED: usize = 20;

/// Names the runs that did not end well, but those that were named already.
///
/// # Errors
/// Exit code 1 if there are any.
pub fn refuse(
    out: &Path,
    results: &Results,
    is_named: impl Fn(&RunRecord) -> bool,
) -> Result<(), Failure> {
    let bad: Vec<&RunRecord> = results.records.iter().filter(|record| record.is_bad()).collect();
    if bad.is_empty() {
        return Ok(());
    }
    let unnamed: Vec<_> = bad.iter().filter(|record| !is_named(record)).collect();
    unnamed.iter().take(MOST_NAMED).for_each(|record| stdio::complain(&described(record)));
    let more = match unnamed.len().saturating_sub(MOST_NAMED) {
        0 => String::new(),
        more => format!(", {more} of them not named here"),
    };
    let (runs, path) = (counted(bad.len(), "run", "runs"), out.join("runs.csv"));
    Err(Failure::no(format!("{}: {runs} did not end well{more}", path.display())))
}

/// Names a run and how it ended.
pub fn described(record: &RunRecord) -> String {
    let RunRecord { id, repetition, reason, outcome, .. } = record;
    let (mesh, job) = (&id.mesh.name, id.job.name());
    format!("{mesh}, {job}, repetition {repetition}: {}: {reason}", outcome.id())
}
