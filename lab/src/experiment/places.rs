//! Places in experiment files: from a key or a name to its line.

use std::path::Path;

use super::spec::{Experiment, MeshGroup, RunSpec};

/// A step from a table or a list to what is in it.
pub(super) enum Step {
    Key(String),
    Item(usize),
}

impl Step {
    /// Returns the key, if it is one.
    pub(super) fn key(&self) -> Option<&str> {
        match self {
            Self::Key(key) => Some(key),
            Self::Item(_) => None,
        }
    }
}

/// Returns the steps to an item of the list of that key.
pub(super) fn item(key: &str, at: usize) -> [Step; 2] {
    [Step::Key(key.into()), Step::Item(at)]
}

/// Returns the line of the first item of that name, or with a variant of that name, in the list
/// `key` of a run.
pub(super) fn line_of_job(
    experiment: &Experiment,
    text: &str,
    key: &str,
    name: &str,
) -> Option<usize> {
    let variant = |item: &str| item.split_once(' ').is_some_and(|(_, variant)| variant == name);
    let place = |run: &RunSpec| run.list(key).iter().position(|item| item == name || variant(item));
    experiment.groups.iter().enumerate().find_map(|(at, group)| {
        let mut runs = group.runs.iter().enumerate();
        let (run, place) = runs.find_map(|(run, spec)| Some((run, place(spec)?)))?;
        let path = [item("group", at), item("run", run), item(key, place)];
        Some(line_of(text, &path.into_iter().flatten().collect::<Vec<_>>()))
    })
}

/// Returns the line of the algorithms of the first run that `is_meant`.
pub(super) fn line_of_run(
    experiment: &Experiment,
    text: &str,
    is_meant: impl Fn(&RunSpec) -> bool,
) -> Option<usize> {
    experiment.groups.iter().enumerate().find_map(|(at, group)| {
        let run = group.runs.iter().position(&is_meant)?;
        let path = [item("group", at), item("run", run)].into_iter().flatten();
        let path: Vec<_> = path.chain([Step::Key("algorithms".into())]).collect();
        Some(line_of(text, &path))
    })
}

/// Returns the line of the first mesh of that name, as one of a group or of the pictures.
pub(super) fn line_of_mesh(experiment: &Experiment, text: &str, name: &str) -> Option<usize> {
    let is_pictured = experiment.pictures.as_deref() == Some(name);
    let in_group = line_in_group(experiment, text, "meshes", |group| {
        group.meshes.iter().position(|one| one == name)
    });
    in_group.or_else(|| is_pictured.then(|| line_of(text, &[Step::Key("pictures".into())])))
}

/// Returns the line of the first mesh file of that path.
pub(super) fn line_of_file(experiment: &Experiment, text: &str, path: &Path) -> Option<usize> {
    line_in_group(experiment, text, "files", |group| group.files.iter().position(|one| one == path))
}

/// Returns the line of the first item that `place` finds in the list `key` of a group.
fn line_in_group(
    experiment: &Experiment,
    text: &str,
    key: &str,
    place: impl Fn(&MeshGroup) -> Option<usize>,
) -> Option<usize> {
    let mut groups = experiment.groups.iter().enumerate();
    let (at, place) = groups.find_map(|(at, group)| Some((at, place(group)?)))?;
    let path = [item("group", at), item(key, place)];
    Some(line_of(text, &path.into_iter().flatten().collect::<Vec<_>>()))
}

/// Returns the line, from 1, of a key, table or value in a TOML file.
pub(super) fn line_of(text: &str, path: &[Step]) -> usize {
    let Ok(document) = toml::de::DeTable::parse(text) else { return 1 };
    let mut start = 0;
    let mut table = Some(document.get_ref());
    let mut list: Option<&toml::de::DeArray> = None;
    for step in path {
        let value = match step {
            Step::Key(key) => {
                let entry = table.and_then(|table| {
                    table.iter().find(|(name, _)| name.get_ref().as_ref() == key.as_str())
                });
                let Some((name, value)) = entry else { break };
                start = name.span().start;
                value
            }
            Step::Item(at) => {
                let Some(value) = list.and_then(|list| list.get(*at)) else { break };
                start = value.span().start;
                value
            }
        };
        table = value.get_ref().as_table();
        list = value.get_ref().as_array();
    }
    1 + text[..start].matches('\n').count()
}
