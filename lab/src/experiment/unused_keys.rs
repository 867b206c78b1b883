//! Keys of an experiment file that have no effect on what is run.

use std::collections::BTreeMap;

use super::data_folder::name_of;
use super::places::{Step, item, line_of};
use super::program_spec::ProgramSpec;
use super::spec::{Experiment, MeshGroup, RunSpec};
use super::spec_error::SpecError;
use super::task::Task;
use crate::nearest::slip_of;

/// Refuses the first key of `experiment`, whose file is `text`, that can have no effect. Returns
/// remarks on those that have none as the lists of algorithms are.
pub(super) fn check(experiment: &Experiment, text: &str) -> Result<Vec<String>, SpecError> {
    let mut remarks = Vec::new();
    for Unused { path, why, is_fault } in all(experiment) {
        let line = line_of(text, &path);
        let key = path.iter().rev().find_map(Step::key).unwrap_or_default().to_owned();
        let found = SpecError::NoEffect { line, key, why };
        if is_fault {
            return Err(found);
        }
        remarks.push(found.to_string());
    }
    Ok(remarks)
}

/// A key without effect.
struct Unused {
    path: Vec<Step>,
    /// Reason and remedy.
    why: String,
    /// False if another list of algorithms would give it an effect: such lists are edited to and
    /// fro.
    is_fault: bool,
}

/// Returns the keys without effect.
fn all(experiment: &Experiment) -> Vec<Unused> {
    let mut found = Vec::new();
    for (at, group) in experiment.groups.iter().enumerate() {
        if group.meshes.is_empty() && group.files.is_empty() && !group.other_data {
            let why = format!(
                "group {:?} has no meshes; name some in meshes or files, or set other_data",
                group.name
            );
            found.push(Unused { path: item("group", at).into(), why, is_fault: true });
        }
        for (place, run) in group.runs.iter().enumerate() {
            found.extend(in_run(experiment, group, run).into_iter().map(|unused| {
                let place = [item("group", at), item("run", place)].into_iter().flatten();
                Unused { path: place.chain(unused.path).collect(), ..unused }
            }));
        }
    }
    found.extend(in_programs(experiment));
    found
}

/// Returns programs that no run names, and those whose statistics nobody reads.
fn in_programs(experiment: &Experiment) -> impl Iterator<Item = Unused> {
    let runs = || experiment.groups.iter().flat_map(|group| &group.runs);
    let is_named =
        move |program: &ProgramSpec| runs().any(|run| run.algorithms.contains(&program.name));
    experiment.programs.iter().enumerate().filter_map(move |(at, program)| {
        let mut path = Vec::from(item("program", at));
        if !is_named(program) {
            let why = format!(
                "no run names {:?} among its algorithms; name it there, or take the program out",
                program.name
            );
            return Some(Unused { path, why, is_fault: false });
        }
        if program.stats.is_none() && program.has_place("{stats}") {
            path.push(Step::Key("command".into()));
            let why = "its {stats} is written and not read; add stats = \"{stats}\"".into();
            return Some(Unused { path, why, is_fault: true });
        }
        None
    })
}

/// Returns the keys of a run without effect; paths begin at the run.
fn in_run(experiment: &Experiment, group: &MeshGroup, run: &RunSpec) -> Vec<Unused> {
    let is_program =
        |name: &String| experiment.programs.iter().any(|program| program.name == *name);
    let only_programs = run.algorithms.iter().all(is_program);
    let lists = [
        ("augmentations", Task::Convert, !run.augmentations.is_empty()),
        ("orders", Task::Irreducible, !run.orders.is_empty()),
        ("stop_after_paths", Task::Convert, !run.stop_after_paths.is_empty()),
    ];
    let mut found = Vec::new();
    for (key, task, _) in lists.into_iter().filter(|&(.., is_there)| is_there) {
        let path = vec![Step::Key(key.into())];
        if task != experiment.task {
            let why = format!("it is for task {:?}; take it out", task.id());
            found.push(Unused { path, why, is_fault: true });
        } else if only_programs {
            let why = "the run has programs alone, which do not heed it; take it out".into();
            found.push(Unused { path, why, is_fault: false });
        }
    }
    found.extend(unknown_meshes("fewer", &run.fewer, group));
    found.extend(unknown_meshes("stop_after_paths", &run.stop_after_paths, group));
    found
}

/// Returns the meshes of `table` that are none of the group.
fn unknown_meshes<V>(key: &str, table: &BTreeMap<String, V>, group: &MeshGroup) -> Vec<Unused> {
    // Those in data folders are not known yet.
    if group.other_data {
        return Vec::new();
    }
    let files: Vec<String> = group.files.iter().map(|path| name_of(path)).collect();
    let known = || group.meshes.iter().chain(&files).map(String::as_str);
    let unknown = table.keys().filter(|name| known().all(|mesh| mesh != *name));
    let unused = |name: &String| {
        let meant = slip_of(name, known());
        let remedy =
            meant.map_or("take it out".into(), |mesh| format!("take it out, or {mesh:?} is meant"));
        let why = format!("no mesh of group {:?} is called so; {remedy}", group.name);
        let path = vec![Step::Key(key.into()), Step::Key(name.clone())];
        Unused { path, why, is_fault: true }
    };
    unknown.map(unused).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = r#"name = "a"
task = "convert"
seed = 1
[limits]
timeout_seconds = 9
memory_gigabytes = 2
[[program]]
name = "mine"
task = "convert"
command = "run {mesh} {quads}"
[[group]]
name = "g"
meshes = ["A1"]
files = ["x/own.obj.gz"]
[[group.run]]
algorithms = ["ps", "mine"]
augmentations = ["local"]
repetitions = { full = 3, small = 3, demo = 3 }
[[group.run]]
algorithms = ["tq"]
augmentations = ["local"]
repetitions = { full = 3, small = 3, demo = 3 }
fewer = { A1 = 2, own = 1 }
[group.run.stop_after_paths]
A1 = 7
"#;

    fn checked(from: &str, to: &str) -> Result<Vec<String>, SpecError> {
        assert!(TEXT.contains(from), "{from}");
        let text = TEXT.replace(from, to);
        let experiment: Experiment = toml::from_str(&text).unwrap();
        check(&experiment, &text)
    }

    fn fault(from: &str, to: &str) -> String {
        checked(from, to).expect_err(to).to_string()
    }

    #[test]
    fn keys_with_an_effect_are_accepted() {
        assert!(checked("seed", "seed").unwrap().is_empty());
        // The meshes of data folders are not known here.
        assert!(checked("meshes = [\"A1\"]", "other_data = true").unwrap().is_empty());
    }

    /// Lists of algorithms are edited to and fro; what they leave idle is told.
    #[test]
    fn what_a_list_of_algorithms_leaves_idle_is_remarked() {
        let alone = checked("\"ps\", ", "").unwrap();
        let expected = "line 17: augmentations has no effect: the run has programs alone, which do \
                        not heed it; take it out";
        assert_eq!(alone, [expected]);
        let expected = "line 7: program has no effect: no run names \"mine\" among its \
                        algorithms; name it there, or take the program out";
        assert_eq!(checked(", \"mine\"]", "]").unwrap(), [expected]);
    }

    #[test]
    fn a_key_without_effect_is_refused_with_its_line() {
        let both = "algorithms = [\"tq\"]\norders = [\"file\"]";
        assert_eq!(
            fault("algorithms = [\"tq\"]", both),
            "line 21: orders has no effect: it is for task \"irreducible\"; take it out"
        );
        let task = fault("task = \"convert\"", "task = \"irreducible\"");
        assert!(task.starts_with("line 17: augmentations has no effect"), "{task}");
        assert_eq!(
            fault("A1 = 7", "A11 = 7"),
            "line 25: A11 has no effect: no mesh of group \"g\" is called so; take it out, or \
             \"A1\" is meant"
        );
        let far = fault("own = 1", "botijo = 1");
        assert!(far.starts_with("line 23: botijo has no effect") && far.ends_with("; take it out"));
        let empty = fault("meshes = [\"A1\"]\nfiles = [\"x/own.obj.gz\"]\n", "");
        assert!(empty.starts_with("line 11: group has no effect: group \"g\" has no meshes"));
        let unread = fault("{quads}", "{quads} {stats}");
        assert!(unread.starts_with("line 10: command has no effect: its {stats}"), "{unread}");
    }
}
