//! Missing parts of a results folder, damaged ones, and failures.

use std::collections::BTreeSet;
use std::fmt;

use triquad::counted::counted;

use super::summary::{Cell, Summary};
use crate::experiment::Results;
use crate::experiment::results::DamagedRow;

/// A gap in the records; cells are named by experiment, job and mesh.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Defect {
    /// A line of `runs.csv` is no record.
    Damaged(DamagedRow),
    /// So many planned runs of a cell have no row.
    Missing(String, usize),
    /// Runs of a cell did not end well: how its runs ended, and why the first of these failed.
    Failed(String, String, String),
    /// Rows of a cell are of so many machines or builds.
    Mixed(String, usize),
    /// There is no plan.
    NoPlan,
    /// A machine is not described.
    UnknownMachine(String),
}

impl Defect {
    /// Finds the defects of a folder. O(n).
    pub fn all(results: &Results, summary: &Summary) -> Vec<Self> {
        let mut defects: Vec<Self> = results.damaged.iter().cloned().map(Self::Damaged).collect();
        defects.extend(summary.cells().iter().flat_map(Self::of_cell));
        if results.planned.is_empty() {
            defects.push(Self::NoPlan);
        }
        let machines: BTreeSet<&String> = results.records.iter().map(|run| &run.machine).collect();
        let unknown = machines.into_iter().filter(|name| !results.machines.contains_key(*name));
        defects.extend(unknown.cloned().map(Self::UnknownMachine));
        defects
    }

    fn of_cell(cell: &Cell) -> Vec<Self> {
        let name = format!("{}: {} on {}", cell.id.mesh.experiment, cell.label(), cell.mesh());
        let mut defects = Vec::new();
        if cell.missing() > 0 {
            defects.push(Self::Missing(name.clone(), cell.missing()));
        }
        let machines: BTreeSet<&String> = cell.ok_runs().map(|run| &run.machine).collect();
        if machines.len() > 1 {
            defects.push(Self::Mixed(name.clone(), machines.len()));
        }
        if let Some(failed) = cell.runs.iter().find(|run| !run.is_ok()) {
            defects.push(Self::Failed(name, cell.outcome_text(), failed.reason.clone()));
        }
        defects
    }

    /// Returns whether numbers are lost by it that a repeated run would bring back.
    pub fn is_loss(&self) -> bool {
        matches!(self, Self::Damaged(_) | Self::Missing(..))
    }
}

impl fmt::Display for Defect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Damaged(DamagedRow { line, problem, .. }) => {
                write!(f, "runs.csv, line {line}: damaged and left out: {problem}")
            }
            Self::Missing(cell, runs) => {
                let runs = counted(*runs, "planned run has", "planned runs have");
                write!(f, "{cell}: {runs} no row")
            }
            Self::Failed(cell, outcomes, reason) if reason.is_empty() => {
                write!(f, "{cell}: {outcomes}")
            }
            Self::Failed(cell, outcomes, reason) => write!(f, "{cell}: {outcomes} ({reason})"),
            Self::Mixed(cell, machines) => {
                write!(f, "{cell}: rows of {machines} machines or builds, and means over all")
            }
            Self::NoPlan => write!(f, "plan.csv: not there, so that missing runs are unknown"),
            Self::UnknownMachine(name) => {
                write!(f, "machines.json: nothing about the machine {name}")
            }
        }
    }
}
