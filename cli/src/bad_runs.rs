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
    let mut alike = Alike::default();
    for record in unnamed {
        alike.add(record);
    }
    let shown = alike.0.iter().take(MOST_NAMED);
    shown
        .for_each(|group| stdio::complain(&format!("{}{}", described(&group.first), group.more())));
    let more = match alike.0.iter().skip(MOST_NAMED).map(|group| group.runs).sum::<usize>() {
        0 => String::new(),
        more => format!(", {more} of them not named here"),
    };
    let (runs, path) = (counted(bad.len(), "run", "runs"), out.join("runs.csv"));
    Err(Failure::no(format!("{}: {runs} did not end well{more}", path.display())))
}

/// Runs that ended alike: those of one job, with the same outcome for the same reason.
#[derive(Default)]
pub struct Alike(Vec<Group>);

struct Group {
    first: RunRecord,
    runs: usize,
}

impl Alike {
    /// Adds a run; returns whether none was like it.
    pub fn add(&mut self, record: &RunRecord) -> bool {
        let key = |record: &RunRecord| (record.id.job, record.outcome, record.reason.clone());
        match self.0.iter_mut().find(|group| key(&group.first) == key(record)) {
            Some(group) => group.runs += 1,
            None => {
                self.0.push(Group { first: record.clone(), runs: 1 });
                return true;
            }
        }
        false
    }

    /// Names each run that others were like, without the reason, with their number.
    pub fn repeated(&self) -> impl Iterator<Item = String> {
        let groups = self.0.iter().filter(|group| group.runs > 1);
        groups.map(|group| {
            let RunRecord { id, outcome, .. } = &group.first;
            let (mesh, job, outcome) = (&id.mesh.name, id.job.name(), outcome.id());
            format!("{mesh}, {job}: {outcome}, as above{}", group.more())
        })
    }
}

impl Group {
    fn more(&self) -> String {
        if self.runs == 1 { String::new() } else { format!(" (and {} more)", self.runs - 1) }
    }
}

/// Names a run and how it ended.
pub fn described(record: &RunRecord) -> String {
    let RunRecord { id, repetition, reason, outcome, .. } = record;
    let (mesh, job) = (&id.mesh.name, id.job.name());
    format!("{mesh}, {job}, repetition {repetition}: {}: {reason}", outcome.id())
}
