//! Machines and commands: what a reader needs to run it again.

use serde::Serialize;

use crate::experiment::{Results, RunRecord};
use crate::paper::Paper;
use crate::report::summary::{Cell, Summary};

/// A machine and its runs.
#[derive(Serialize)]
pub struct MachineView<'a> {
    name: &'a str,
    runs: usize,
    facts: Vec<(&'a str, &'a str)>,
}

/// The commands of a group of meshes.
#[derive(Serialize)]
pub struct GroupCommands<'a> {
    id: String,
    name: String,
    cells: Vec<CellCommand<'a>>,
}

#[derive(Serialize)]
struct CellCommand<'a> {
    name: String,
    outcomes: String,
    command: &'a str,
}

/// Returns the machines that are described.
pub fn machines(results: &Results) -> Vec<MachineView<'_>> {
    let machines = results.machines.iter().map(|(name, facts)| MachineView {
        name,
        runs: results.records.iter().filter(|run| run.machine == *name).count(),
        facts: facts.iter().map(|(name, fact)| (name.as_str(), fact.as_str())).collect(),
    });
    machines.collect()
}

/// Returns the commands of all cells with a run, group by group.
pub fn commands(summary: &Summary) -> Vec<GroupCommands<'_>> {
    let mut groups: Vec<GroupCommands> = Vec::new();
    for cell in summary.cells() {
        let mesh = &cell.id.mesh;
        let id = group_id(&mesh.experiment, &mesh.group);
        if groups.iter().all(|group| group.id != id) {
            let name = format!("{}, group {}", mesh.experiment, mesh.group);
            groups.push(GroupCommands { id: id.clone(), name, cells: Vec::new() });
        }
        let command = cell.runs.first().map_or("", command_of);
        let group = groups.iter_mut().find(|group| group.id == id);
        let group = group.expect("one was pushed if there was none");
        let outcomes = cell.outcome_text();
        group.cells.push(CellCommand { name: name_of(cell), outcomes, command });
    }
    groups
}

/// Returns the command of a run. What was imported without one was run elsewhere.
fn command_of(run: &RunRecord) -> &str {
    if run.is_imported() && run.command.is_empty() { "imported" } else { &run.command }
}

fn group_id(experiment: &str, group: &str) -> String {
    format!("commands-{experiment}-{group}")
}

fn name_of(cell: &Cell) -> String {
    let scale = match cell.is_full_scale() {
        true => String::new(),
        false => format!(", {}", cell.id.mesh.scale.id()),
    };
    format!("{} on {}{scale}", cell.label(), cell.marked_mesh())
}

/// Returns where the commands of a group's cells are, if there are any.
pub fn commands_id(summary: &Summary, paper: Paper, group: &str) -> Option<String> {
    let first = &summary.of_group(paper, group).next()?.id.mesh;
    Some(group_id(&first.experiment, &first.group))
}
