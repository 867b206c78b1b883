//! Programs that are not ours, as experiment files describe them.
//!
//! ```toml
//! [[program]]
//! name = "greedy"
//! version = ["python3", "--version"]      # a command; if it fails, the program is not installed
//! task = "convert"                        # or "irreducible"
//! command = ["python3", "{here}/peers/greedy.py", "{mesh}", "-o", "{quads}", "--seed", "{seed}"]
//! stats = "{stats}"                       # optional: where it writes JSON; "-": standard output
//! format = "obj"                          # or "ply", "off": of both files
//! ```

use std::path::{Path, PathBuf};

use serde::Deserialize;

use super::job::Job;
use super::task::Task;

/// A program that is run like an algorithm.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ProgramSpec {
    /// Its name in lists of algorithms, in records and in tables.
    pub name: String,
    /// Command whose first line of output is its version.
    pub version: Option<Words>,
    /// Its product.
    pub task: Task,
    /// Command of a run, with places in braces.
    pub command: Words,
    /// File in which it leaves statistics as JSON, `-` for standard output.
    pub stats: Option<String>,
    /// Format of the mesh that it reads and of the one that it writes.
    #[serde(default)]
    pub format: ProgramFormat,
    /// Folder of the experiment file.
    #[serde(skip)]
    pub here: PathBuf,
}

/// A command: a list of words, or a line that is split into words as a shell does.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(untagged, expecting = "a command is a list of words, or one line")]
pub enum Words {
    /// The words.
    List(Vec<String>),
    /// A line.
    Line(String),
}

/// A format that programs read and write.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ProgramFormat {
    /// Wavefront OBJ.
    #[default]
    Obj,
    /// Stanford PLY.
    Ply,
    /// Object File Format.
    Off,
}

/// Values for the places of a command.
#[derive(Clone, Copy, Debug)]
pub struct Places<'a> {
    /// `{mesh}`: the triangles.
    pub mesh: &'a Path,
    /// `{quads}` or `{result}`: where the result goes.
    pub result: &'a Path,
    /// `{stats}`: where statistics go.
    pub stats: &'a Path,
    /// `{seed}`: the seed of the run.
    pub seed: u64,
}

/// Fault of the description of a program.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ProgramSpecError {
    /// It has no usable name.
    #[error("a program is called {0:?}; its name must have letters, digits, '.', '_' or '-' only")]
    Name(String),
    /// An algorithm of ours has its name.
    #[error("a program is called {0:?}, as an algorithm of ours is; give it another name")]
    Taken(String),
    /// Two programs have its name.
    #[error("two programs are called {0:?}; give one of them another name")]
    Twice(String),
    /// Its command has no words, or a quotation mark without its partner.
    #[error("the command of {0:?} has no words, or quotes that do not end")]
    NoWords(String),
    /// Its command lacks a place.
    #[error("the command of {name:?} does not say where {place} goes")]
    NoPlace {
        /// The program.
        name: String,
        /// The place that is missing.
        place: &'static str,
    },
    /// A place is not known.
    #[error(
        "the command of {name:?} has the place {place}; there are {{mesh}}, {{quads}}, {{result}}, \
         {{stats}}, {{seed}} and {{here}}"
    )]
    UnknownPlace {
        /// The program.
        name: String,
        /// The place, in braces.
        place: String,
    },
    /// Its task is not that of the experiment.
    #[error("{0:?} has another task than the experiment")]
    OtherTask(String),
}

impl ProgramFormat {
    /// Returns the ending of its files.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Obj => "obj",
            Self::Ply => "ply",
            Self::Off => "off",
        }
    }
}

impl Words {
    /// Returns the words; none if quotes do not end.
    fn split(&self) -> Vec<String> {
        match self {
            Self::List(words) => words.clone(),
            Self::Line(line) => shlex::split(line).unwrap_or_default(),
        }
    }
}

impl ProgramSpec {
    /// Returns its job.
    pub fn job(&self) -> Job {
        Job::program(self.task, &self.name)
    }

    /// Checks name, places and task.
    ///
    /// # Errors
    /// The first fault found.
    pub(super) fn check(&self, task: Task) -> Result<(), ProgramSpecError> {
        let name = || self.name.clone();
        let is_plain = |byte: u8| byte.is_ascii_alphanumeric() || b"._-".contains(&byte);
        if self.name.is_empty() || !self.name.bytes().all(is_plain) {
            return Err(ProgramSpecError::Name(name()));
        }
        if Job::named(&self.name.to_lowercase()).is_ok() {
            return Err(ProgramSpecError::Taken(name()));
        }
        if self.task != task {
            return Err(ProgramSpecError::OtherTask(name()));
        }
        let words = self.command.split();
        if words.is_empty() {
            return Err(ProgramSpecError::NoWords(name()));
        }
        self.check_places(&words)
    }

    fn check_places(&self, words: &[String]) -> Result<(), ProgramSpecError> {
        let name = || self.name.clone();
        let has = |place: &str| words.iter().any(|word| word.contains(place));
        if !has("{mesh}") {
            return Err(ProgramSpecError::NoPlace { name: name(), place: "{mesh}" });
        }
        if !has("{quads}") && !has("{result}") {
            return Err(ProgramSpecError::NoPlace { name: name(), place: "{quads}" });
        }
        let known = ["{mesh}", "{quads}", "{result}", "{stats}", "{seed}", "{here}"];
        let unknown = words.iter().flat_map(|word| places(word)).find(|p| !known.contains(p));
        unknown.map_or(Ok(()), |place| {
            Err(ProgramSpecError::UnknownPlace { name: name(), place: place.into() })
        })
    }

    /// Returns whether the command has this place.
    pub(super) fn has_place(&self, place: &str) -> bool {
        self.command.split().iter().any(|word| word.contains(place))
    }

    /// Returns the command of a run.
    pub fn command(&self, places: Places<'_>) -> Vec<String> {
        self.command.split().iter().map(|word| self.fill(word, places)).collect()
    }

    /// Returns the command that prints the version, if there is one.
    pub fn version_command(&self) -> Option<Vec<String>> {
        let words = self.version.as_ref()?.split();
        let here = self.here.to_string_lossy();
        (!words.is_empty())
            .then(|| words.iter().map(|word| word.replace("{here}", &here)).collect())
    }

    /// Returns the file of its statistics; `None` if it has none or prints them.
    pub fn stats_file(&self, places: Places<'_>) -> Option<PathBuf> {
        let file = self.stats.as_ref().filter(|file| *file != "-")?;
        Some(self.fill(file, places).into())
    }

    /// Returns whether its statistics are on its standard output.
    pub fn prints_stats(&self) -> bool {
        self.stats.as_deref() == Some("-")
    }

    fn fill(&self, word: &str, places: Places<'_>) -> String {
        let Places { mesh, result, stats, seed } = places;
        let result = result.to_string_lossy();
        // The folder first: paths are not searched for places.
        word.replace("{here}", &self.here.to_string_lossy())
            .replace("{seed}", &seed.to_string())
            .replace("{mesh}", &mesh.to_string_lossy())
            .replace("{quads}", &result)
            .replace("{result}", &result)
            .replace("{stats}", &stats.to_string_lossy())
    }
}

/// Returns the places of a word: words of small letters in braces.
fn places(word: &str) -> impl Iterator<Item = &str> {
    word.match_indices('{').filter_map(|(start, _)| {
        let end = start + word[start..].find('}')?;
        let inner = &word[start + 1..end];
        let is_place = !inner.is_empty() && inner.bytes().all(|byte| byte.is_ascii_lowercase());
        is_place.then(|| &word[start..=end])
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spec(command: &str) -> ProgramSpec {
        let text = format!("name = \"mine\"\ntask = \"convert\"\ncommand = {command}");
        ProgramSpec { here: "/experiments".into(), ..toml::from_str(&text).unwrap() }
    }

    #[test]
    fn places_are_filled_in_words_and_in_lines() {
        let places = Places {
            mesh: Path::new("a b.obj"),
            result: Path::new("q.obj"),
            stats: Path::new("s.json"),
            seed: 7,
        };
        let expected = ["run", "/experiments/x", "a b.obj", "--out=q.obj", "7"];
        for command in [
            r#"["run", "{here}/x", "{mesh}", "--out={quads}", "{seed}"]"#,
            r#""run '{here}/x' {mesh} --out={result} {seed}""#,
        ] {
            assert_eq!(spec(command).command(places), expected);
            assert_eq!(spec(command).check(Task::Convert), Ok(()));
        }
        let printed = ProgramSpec { stats: Some("-".into()), ..spec("\"run {mesh} {quads}\"") };
        assert!(printed.prints_stats() && printed.stats_file(places).is_none());
    }

    #[test]
    fn what_is_no_command_is_told_what_one_is() {
        let text = "name = \"mine\"\ntask = \"convert\"\ncommand = 3";
        let fault = toml::from_str::<ProgramSpec>(text).unwrap_err();
        assert_eq!(fault.message(), "a command is a list of words, or one line");
    }

    #[test]
    fn faults_are_named() {
        let fault = |command| spec(command).check(Task::Convert).unwrap_err().to_string();
        assert!(fault("[]").contains("has no words"));
        assert!(fault("\"run '{mesh}\"").contains("quotes that do not end"));
        assert!(fault("\"run {quads}\"").contains("does not say where {mesh} goes"));
        assert!(fault("\"run {mesh}\"").contains("does not say where {quads} goes"));
        assert!(fault("\"run {mesh} {quads} {sed}\"").contains("the place {sed}; there are"));
        for name in ["ps", "PS"] {
            let taken = ProgramSpec { name: name.into(), ..spec("\"run {mesh} {quads}\"") };
            assert!(matches!(taken.check(Task::Convert), Err(ProgramSpecError::Taken(_))));
        }
        let other = spec("\"run {mesh} {quads}\"").check(Task::Irreducible);
        assert!(matches!(other, Err(ProgramSpecError::OtherTask(_))));
        let named = ProgramSpec { name: "a\nb".into(), ..spec("\"run {mesh} {quads}\"") };
        assert!(matches!(named.check(Task::Convert), Err(ProgramSpecError::Name(_))));
    }
}
