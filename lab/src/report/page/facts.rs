//! What a reader has to know beside the numbers: limits, gaps, machines, commands.

use serde::Serialize;

use super::Parts;
use crate::experiment::Results;
use crate::report::summary::{Cell, Summary};

/// A machine and its runs.
#[derive(Serialize)]
pub struct Machine<'a> {
    name: &'a str,
    runs: usize,
    facts: Vec<(&'a str, &'a str)>,
}

/// The commands of a group of meshes.
#[derive(Serialize)]
pub struct Commands<'a> {
    id: String,
    name: String,
    cells: Vec<Command<'a>>,
}

#[derive(Serialize)]
struct Command<'a> {
    name: String,
    outcomes: String,
    command: &'a str,
}

/// What must be known before anything is read.
pub fn warnings(parts: &Parts) -> Vec<String> {
    let mut warnings = Vec::new();
    if parts.results.records.is_empty() {
        warnings.push("there is no record of any run; everything below is empty.".into());
    }
    for scale in ["small", "demo"] {
        if parts.summary.cells().iter().any(|cell| cell.scale == scale) {
            warnings.push(format!(
                "some meshes are of scale “{scale}”: smaller than the papers' meshes of the same \
                 names. Their counts and times are not to be compared with the printed ones."
            ));
        }
    }
    let gaps = defects(parts).len();
    if gaps > 0 && !parts.results.records.is_empty() {
        warnings.push(format!("{gaps} things are missing or damaged; they are listed below."));
    }
    warnings
}

/// What cannot be concluded.
pub fn limits(summary: &Summary) -> Vec<String> {
    let mut limits = vec![
        "Seconds of different machines are shown beside each other and not compared: counts are, and \
         ratios of times within one machine."
            .into(),
        "DS follows the idea of Diks and Stanczyk; their full text was not at hand.".into(),
        "The box has the papers' numbers of vertices, cavities and holes; its proportions, and the \
         simplification that makes smaller ones, are ours."
            .into(),
        "A difference between two means is as certain as the spread of their runs is small: the files \
         have medians and quartiles."
            .into(),
    ];
    let any = |test: fn(&Cell) -> bool| summary.cells().iter().any(test);
    if any(Cell::is_stand_in) {
        limits.push(
            "† A stand-in has the vertex count and genus of a scan of the paper, not its shape: \
             times, flips and unpaired triangles on it are comparable in kind, not in their digits."
                .into(),
        );
    }
    if any(Cell::is_extrapolated) {
        limits.push(
            "* The augmentation was stopped after some paths; its time is that of the paths made, by \
             rule of three for all of them."
                .into(),
        );
    }
    if any(Cell::is_parallel) {
        limits.push(
            "Some runs went on beside others on the same machine: their times are neither ranked nor \
             divided by each other."
                .into(),
        );
    }
    limits
}

/// What is not there, or not as it should be.
pub fn defects(parts: &Parts) -> Vec<String> {
    let mut defects = Vec::new();
    for row in &parts.results.damaged {
        defects.push(format!("runs.csv, line {}: damaged and left out: {}", row.line, row.problem));
    }
    for cell in parts.summary.cells() {
        let went_wrong = cell.runs.iter().find(|run| !run.is_ok());
        if cell.missing() == 0 && went_wrong.is_none() {
            continue;
        }
        let reason = went_wrong.map(|run| run.reason.as_str()).filter(|reason| !reason.is_empty());
        let reason = reason.map(|reason| format!(" ({reason})")).unwrap_or_default();
        defects.push(format!("{}: {}{reason}", name_of(cell), cell.outcome_text()));
    }
    if parts.results.planned.is_empty() {
        defects.push("plan.csv: not there, so that nothing tells which runs are missing.".into());
    }
    for run in &parts.results.records {
        let line = format!("machines.json: nothing about the machine {}.", run.machine);
        if !parts.results.machines.contains_key(&run.machine) && !defects.contains(&line) {
            defects.push(line);
        }
    }
    if parts.pictures.is_empty() {
        defects.push("pictures/: no picture is there.".into());
    }
    defects
}

/// The machines that are described.
pub fn machines(results: &Results) -> Vec<Machine<'_>> {
    results
        .machines
        .iter()
        .map(|(name, facts)| Machine {
            name,
            runs: results.records.iter().filter(|run| run.machine == *name).count(),
            facts: facts.iter().map(|(name, fact)| (name.as_str(), fact.as_str())).collect(),
        })
        .collect()
}

/// The commands of all cells with a run, group by group.
pub fn commands(summary: &Summary) -> Vec<Commands<'_>> {
    let mut groups: Vec<Commands> = Vec::new();
    for cell in summary.cells() {
        let id = format!("commands-{}-{}", cell.experiment, cell.group);
        if groups.last().is_none_or(|group| group.id != id) {
            let name = format!("{}, group {}", cell.experiment, cell.group);
            groups.push(Commands { id, name, cells: Vec::new() });
        }
        let command = cell.runs.first().map_or("", |run| run.command.as_str());
        let group = groups.last_mut().expect("one was pushed if there was none");
        group.cells.push(Command { name: name_of(cell), outcomes: cell.outcome_text(), command });
    }
    groups
}

fn name_of(cell: &Cell) -> String {
    let mark = if cell.is_stand_in() { "†" } else { "" };
    let scale = if cell.scale == "full" { String::new() } else { format!(", {}", cell.scale) };
    format!("{} on {}{mark}{scale}", cell.label(), cell.mesh)
}

/// Where the commands of a table's cells are, if there are any.
pub fn commands_id(summary: &Summary, number: &str, file: &str) -> Option<String> {
    let group = match number {
        "4.3" => "comparison-scans",
        "4.4(i)" => "comparison-A",
        "4.4(ii)" => "comparison-B",
        "6" | "7" => "irreducible-B",
        "8" | "9" => "irreducible-C",
        "10" | "11" => "irreducible-D",
        _ if file == "table_data.csv" => "comparison-data",
        _ => return (number.is_empty()).then(|| "commands".into()),
    };
    let of_group = |cell: &Cell| format!("{}-{}", cell.experiment, cell.group) == group;
    summary.cells().iter().any(of_group).then(|| format!("commands-{group}"))
}
