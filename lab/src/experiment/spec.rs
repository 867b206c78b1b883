//! Experiment files: meshes, algorithms, repetitions, limits.
//!
//! ```toml
//! name = "comparison"
//! title = "Four algorithms that turn triangulations into quadrangulations"
//! task = "convert"                        # or "irreducible"
//! seed = 1
//! pictures = "botijo"                     # the mesh whose quads are drawn
//!
//! [limits]
//! timeout_seconds = 900
//! memory_gigabytes = 12
//!
//! [[group]]
//! name = "scans"
//! meshes = ["botijo", "eros"]             # of the papers, or files in a data folder
//! files = ["plate.obj.gz"]                # beside the experiment file
//!
//! [[group.run]]
//! algorithms = ["sg", "lrs few-flips"]
//! augmentations = ["tarjan", "local"]
//! repetitions = { full = 10, small = 10, demo = 3 }
//! fewer = { eros = 2 }                    # at full scale
//! stop_after_paths = { eros = 2000 }      # at full scale: the rest is extrapolated
//! ```
//!
//! Programs that are not ours are described in tables `[[program]]`: see
//! [`program_spec`](super::program_spec).

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use serde::Deserialize;

use super::job::{self, Job, UnknownNameError};
use super::places;
use super::program_spec::{ProgramSpec, ProgramSpecError};
use super::spec_error::{SpecError, SpecFileError};
use super::task::Task;
use super::unused_keys;
use crate::meshes::paper::Scale;

/// An experiment file.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Experiment {
    /// Its name in records.
    pub name: String,
    /// Subject, in a line, for readers of the file.
    #[serde(default)]
    pub title: String,
    /// Task of its runs.
    pub task: Task,
    /// Master seed.
    pub seed: u64,
    /// The mesh whose results are drawn.
    pub pictures: Option<String>,
    /// True if our algorithms are measured as programs of others are: from the file of the mesh to
    /// that of the result, which is checked and measured by the lab.
    #[serde(default)]
    pub measured_from_files: bool,
    /// When a run is stopped.
    pub limits: Limits,
    /// Programs that are not ours, to be named among the algorithms.
    #[serde(default, rename = "program")]
    pub programs: Vec<ProgramSpec>,
    /// Meshes and what is run on them.
    #[serde(rename = "group")]
    pub groups: Vec<MeshGroup>,
    /// Remarks on keys that have no effect, with file and line.
    #[serde(skip)]
    pub remarks: Vec<String>,
    /// The file, to name places in it.
    #[serde(skip)]
    pub(super) file: SpecFile,
}

/// An experiment file as it was read.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct SpecFile {
    path: PathBuf,
    text: String,
}

/// When a run is stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields, expecting = "timeout_seconds and memory_gigabytes")]
pub struct Limits {
    /// Wall-clock time of its process.
    pub timeout_seconds: u64,
    /// Address space of its process.
    pub memory_gigabytes: u64,
}

/// Meshes of like shape, and what is run on each.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MeshGroup {
    /// Its name in records.
    pub name: String,
    /// Names of meshes, in any order.
    #[serde(default)]
    pub meshes: Vec<String>,
    /// Mesh files, their paths relative to the experiment file, at every scale.
    #[serde(default)]
    pub files: Vec<PathBuf>,
    /// True if every other mesh in the data folders belongs to it.
    #[serde(default)]
    pub other_data: bool,
    /// The jobs.
    #[serde(rename = "run")]
    pub runs: Vec<RunSpec>,
}

/// Algorithms that are run alike.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RunSpec {
    /// Their names; a variant follows after a space.
    pub algorithms: Vec<String>,
    /// For conversions.
    #[serde(default)]
    pub augmentations: Vec<String>,
    /// For irreducible triangulations.
    #[serde(default)]
    pub orders: Vec<String>,
    /// Repetitions, by scale.
    pub repetitions: Repetitions,
    /// Repetitions for some meshes, at full scale.
    #[serde(default)]
    pub fewer: BTreeMap<String, u32>,
    /// Augmenting paths after which to stop for some meshes, at full scale.
    #[serde(default)]
    pub stop_after_paths: BTreeMap<String, u64>,
}

/// Repetitions at each scale.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(from = "RepetitionsInFile")]
pub struct Repetitions {
    /// As large as in the papers.
    pub full: u32,
    /// A twentieth.
    pub small: u32,
    /// A hundredth.
    pub demo: u32,
}

/// Repetitions as a file has them: where a smaller scale has no number, that of full scale.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a number a scale: { full = 3, small = 3, demo = 3 }")]
struct RepetitionsInFile {
    full: u32,
    small: Option<u32>,
    demo: Option<u32>,
}

impl From<RepetitionsInFile> for Repetitions {
    fn from(RepetitionsInFile { full, small, demo }: RepetitionsInFile) -> Self {
        Self { full, small: small.unwrap_or(full), demo: demo.unwrap_or(full) }
    }
}

impl Experiment {
    /// Reads the file at `path`.
    ///
    /// # Errors
    /// It cannot be read, is no TOML, names something unknown, or has a key that can
    /// have no effect.
    pub fn read(path: &Path) -> Result<Self, SpecFileError> {
        let text = std::fs::read_to_string(path).map_err(SpecError::Io);
        let read = text.and_then(|text| Self::parse(&text)).map(|mut experiment| {
            let folder = path.parent().unwrap_or(Path::new(""));
            let files = experiment.groups.iter_mut().flat_map(|group| &mut group.files);
            files.for_each(|file| *file = folder.join(&*file));
            experiment.file.path = path.to_owned();
            let here = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
            experiment.programs.iter_mut().for_each(|program| here.clone_into(&mut program.here));
            for remark in &mut experiment.remarks {
                *remark = format!("{}: {remark}", path.display());
            }
            experiment
        });
        read.map_err(|error| SpecFileError { path: path.to_owned(), error })
    }

    /// Parses the text of an experiment file.
    fn parse(text: &str) -> Result<Self, SpecError> {
        let parsed: Result<Self, toml::de::Error> = toml::from_str(text);
        let mut experiment = parsed.map_err(|error| {
            let line = error.span().map_or(1, |span| 1 + text[..span.start].matches('\n').count());
            SpecError::Syntax { line, message: error.message().into() }
        })?;
        experiment.check().map_err(|error| match error {
            SpecError::UnknownName { list, error, .. } => {
                let line = places::line_of_job(&experiment, text, list, error.name());
                SpecError::UnknownName { line, list, error }
            }
            SpecError::NoList { algorithm, list, example, .. } => {
                let line = places::line_of_run(&experiment, text, |run| {
                    run.algorithms.contains(&algorithm) && run.list(list).is_empty()
                });
                SpecError::NoList { line, algorithm, list, example }
            }
            SpecError::NoAlgorithms { .. } => {
                let line = places::line_of_run(&experiment, text, |run| run.algorithms.is_empty());
                SpecError::NoAlgorithms { line }
            }
            error => error,
        })?;
        experiment.remarks = unused_keys::check(&experiment, text)?;
        let renamed = experiment.renamed_algorithms(text);
        experiment.remarks.extend(renamed);
        experiment.file.text = text.to_owned();
        Ok(experiment)
    }

    /// Returns a remark on each algorithm of ours whose name has other letters than we give it.
    fn renamed_algorithms(&self, text: &str) -> BTreeSet<String> {
        let runs = self.groups.iter().flat_map(|group| &group.runs);
        // No program has such a name.
        let renamed = runs.flat_map(|run| &run.algorithms).filter_map(|name| {
            let (ours, _) = job::our_name(name).filter(|(ours, _)| ours != name)?;
            let line = places::line_of_job(self, text, "algorithms", name)?;
            let why = "algorithms of triquad are called so in letters of either case";
            Some(format!("line {line}: note: {name} is taken as {ours}: {why}"))
        });
        renamed.collect()
    }

    /// Returns where a mesh is named: file and line; else the name of the experiment.
    pub(super) fn place_of_mesh(&self, name: &str) -> String {
        self.place(places::line_of_mesh(self, &self.file.text, name))
    }

    /// Returns where a mesh file is named.
    pub(super) fn place_of_file(&self, path: &Path) -> String {
        self.place(places::line_of_file(self, &self.file.text, path))
    }

    fn place(&self, line: Option<usize>) -> String {
        match line {
            Some(line) if !self.file.text.is_empty() => {
                format!("{}: line {line}", self.file.path.display())
            }
            _ => self.name.clone(),
        }
    }

    fn check(&self) -> Result<(), SpecError> {
        let names = self.groups.iter().map(|group| &group.name).chain([&self.name]);
        let breaks = |name: &&String| name.trim().is_empty() || name.contains(char::is_control);
        if let Some(name) = names.into_iter().find(breaks) {
            return Err(SpecError::Name(name.clone()));
        }
        for (place, group) in self.groups.iter().enumerate() {
            if self.groups[..place].iter().any(|other| other.name == group.name) {
                return Err(SpecError::TwoGroups(group.name.clone()));
            }
        }
        self.limits.check()?;
        for (place, program) in self.programs.iter().enumerate() {
            program.check(self.task)?;
            if self.programs[..place].iter().any(|other| other.name == program.name) {
                return Err(ProgramSpecError::Twice(program.name.clone()).into());
            }
        }
        self.groups.iter().try_for_each(|group| group.check(self.task, &self.programs))
    }
}

impl MeshGroup {
    /// Checks that every job is known and named once, and not repeated without end.
    fn check(&self, task: Task, programs: &[ProgramSpec]) -> Result<(), SpecError> {
        let mut known: Vec<Job> = Vec::new();
        for run in &self.runs {
            run.check_numbers()?;
            for job in run.jobs(task, programs)? {
                if known.contains(&job) {
                    return Err(SpecError::Twice { group: self.name.clone(), job: job.name() });
                }
                known.push(job);
            }
        }
        Ok(())
    }
}

/// Greatest number of repetitions: each is a row in memory for every job and mesh.
const MOST_REPETITIONS: u64 = 10_000;

/// Checks that a number is from 1 to `most`.
fn check_number(name: &'static str, value: u64, most: u64) -> Result<(), SpecError> {
    let is_within = (1..=most).contains(&value);
    is_within.then_some(()).ok_or(SpecError::Limit { name, value, most })
}

impl Limits {
    /// Checks that a run has some time and memory, and no more than numbers can say.
    fn check(self) -> Result<(), SpecError> {
        check_number("timeout_seconds", self.timeout_seconds, 1_000_000_000)?;
        check_number("memory_gigabytes", self.memory_gigabytes, 1_000_000)
    }
}

/// Returns the error for an algorithm of ours without a list that it needs.
fn lacks_list(task: Task, algorithm: &str) -> SpecError {
    let (list, example) = match task {
        Task::Convert => ("augmentations", "local"),
        Task::Irreducible => ("orders", "random"),
    };
    SpecError::NoList { line: None, algorithm: algorithm.into(), list, example }
}

impl RunSpec {
    /// Checks that everything is done at full scale, and no more often than rows can be kept of.
    fn check_numbers(&self) -> Result<(), SpecError> {
        let Repetitions { full, small, demo } = self.repetitions;
        let fewer = self.fewer.values().map(|&fewer| ("fewer", fewer));
        // None at a smaller scale leaves the run out there.
        let smaller =
            [("small", small), ("demo", demo)].into_iter().filter(|&(_, often)| often > 0);
        let mut all = [("full", full)].into_iter().chain(smaller).chain(fewer);
        all.try_for_each(|(name, often)| check_number(name, often.into(), MOST_REPETITIONS))?;
        let mut paths = self.stop_after_paths.values();
        paths.try_for_each(|&paths| check_number("stop_after_paths", paths, u64::from(u32::MAX)))
    }

    /// Returns the list of that key; an empty one for another key.
    pub(super) fn list(&self, key: &str) -> &[String] {
        match key {
            "algorithms" => &self.algorithms,
            "augmentations" => &self.augmentations,
            "orders" => &self.orders,
            _ => &[],
        }
    }

    /// Returns the jobs: every algorithm in every way, every program once.
    pub(super) fn jobs(&self, task: Task, programs: &[ProgramSpec]) -> Result<Vec<Job>, SpecError> {
        let mut jobs = Vec::new();
        for name in &self.algorithms {
            match programs.iter().find(|program| program.name == *name) {
                Some(program) => jobs.push(program.job()),
                None => {
                    let ours = job::our_name(name).map(|(ours, _)| ours);
                    let own = self.jobs_of(task, ours.as_ref().unwrap_or(name), programs)?;
                    // A program beside it would hide that it is not run.
                    if own.is_empty() {
                        return Err(lacks_list(task, name));
                    }
                    jobs.extend(own);
                }
            }
        }
        if jobs.is_empty() {
            return Err(SpecError::NoAlgorithms { line: None });
        }
        Ok(jobs)
    }

    /// Returns the jobs of an algorithm of ours.
    fn jobs_of(
        &self,
        task: Task,
        name: &str,
        programs: &[ProgramSpec],
    ) -> Result<Vec<Job>, SpecError> {
        let names = programs.iter().map(|program| program.name.as_str());
        let unknown =
            |list| move |error| SpecError::UnknownName { line: None, list, error: Box::new(error) };
        let or_program = |error: UnknownNameError| unknown("algorithms")(error.with(names));
        let mut jobs = Vec::new();
        match task {
            Task::Convert => {
                let algorithm = job::find_conversion(name).map_err(or_program)?;
                for augmentation in &self.augmentations {
                    let augmentation = job::find_augmentation(augmentation);
                    let augmentation = augmentation.map_err(unknown("augmentations"))?;
                    jobs.push(Job::Convert { algorithm, augmentation });
                }
            }
            Task::Irreducible => {
                let method = job::find_method(name).map_err(or_program)?;
                for order in &self.orders {
                    let order = job::find_order(order).map_err(unknown("orders"))?;
                    jobs.push(Job::Reduce { method, order });
                }
            }
        }
        Ok(jobs)
    }

    /// Returns how often a job is run on `mesh` at `scale`.
    pub(super) fn repetitions(&self, mesh: &str, scale: Scale) -> u32 {
        match scale {
            Scale::Full => self.fewer.get(mesh).copied().unwrap_or(self.repetitions.full),
            Scale::Small => self.repetitions.small,
            Scale::Demo => self.repetitions.demo,
        }
    }

    /// Returns the augmenting paths after which a run on `mesh` at `scale` stops.
    pub(super) fn stop_after_paths(&self, mesh: &str, scale: Scale) -> Option<u64> {
        self.stop_after_paths.get(mesh).copied().filter(|_| scale == Scale::Full)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use triquad::augmentation::Augmentation;
    use triquad::pairing::{Algorithm, Expansion};

    const TEXT: &str = r#"
        name = "a"
        title = "b"
        task = "convert"
        seed = 1
        [limits]
        timeout_seconds = 9
        memory_gigabytes = 2
        [[group]]
        name = "g"
        meshes = ["A1"]
        [[group.run]]
        algorithms = ["ps", "lrs few-flips"]
        augmentations = ["tarjan", "local"]
        repetitions = { full = 10, small = 5, demo = 2 }
        fewer = { A1 = 3 }
        stop_after_paths = { A1 = 7 }
    "#;

    #[test]
    fn a_file_says_what_is_run_how_often() {
        let experiment = Experiment::parse(TEXT).unwrap();
        let run = &experiment.groups[0].runs[0];
        let jobs = run.jobs(experiment.task, &[]).unwrap();
        let few = Algorithm::Lrs(Expansion::FewFlips);
        assert_eq!(jobs.len(), 4);
        assert_eq!(jobs[3], Job::Convert { algorithm: few, augmentation: Augmentation::Local });
        let often = |mesh, scale| run.repetitions(mesh, scale);
        assert_eq!(
            [often("A1", Scale::Full), often("A2", Scale::Full), often("A1", Scale::Demo)],
            [3, 10, 2]
        );
        assert_eq!(run.stop_after_paths("A1", Scale::Full), Some(7));
        assert_eq!(run.stop_after_paths("A1", Scale::Small), None);
        assert_eq!(run.stop_after_paths("A2", Scale::Full), None);
    }

    #[test]
    fn programs_are_named_among_the_algorithms() {
        let program = "[[program]]\nname = \"mine\"\ntask = \"convert\"\n\
                       command = \"run {mesh} {quads}\"\n[[group]]";
        let text = TEXT.replace("[[group]]", program).replace("\"ps\"", "\"ps\", \"mine\"");
        let experiment = Experiment::parse(&text).unwrap();
        let jobs = experiment.groups[0].runs[0].jobs(Task::Convert, &experiment.programs).unwrap();
        assert_eq!((jobs.len(), jobs[2].label()), (5, "mine".to_owned()));
        let typo = text.replace("\"mine\", \"lrs", "\"min\", \"lrs");
        let error = Experiment::parse(&typo).unwrap_err().to_string();
        assert!(error.ends_with("the nearest is \"mine\""), "{error}");
        let twice = text.replace("[[group]]", program);
        assert!(Experiment::parse(&twice).unwrap_err().to_string().starts_with("two programs"));
    }

    #[test]
    fn groups_have_names_of_their_own() {
        let group = &TEXT[TEXT.find("[[group]]").unwrap()..];
        let error = Experiment::parse(&format!("{TEXT}\n{group}")).unwrap_err().to_string();
        assert!(error.starts_with("two groups are named \"g\""), "{error}");
    }

    /// As in `import --algorithm`.
    #[test]
    fn algorithms_of_ours_may_be_in_capitals() {
        let plain = Experiment::parse(TEXT).unwrap();
        let text = TEXT.replace("\"ps\", \"lrs few", "\"PS\", \"LRS few");
        let capitals = Experiment::parse(&text).unwrap();
        let jobs = |experiment: &Experiment| experiment.groups[0].runs[0].jobs(Task::Convert, &[]);
        assert_eq!(jobs(&capitals).unwrap(), jobs(&plain).unwrap());
        assert!(plain.remarks.is_empty() && capitals.remarks.len() == 2);
        let why = "algorithms of triquad are called so in letters of either case";
        assert_eq!(capitals.remarks[1], format!("line 13: note: PS is taken as ps: {why}"));
    }

    /// As without the program: nothing that is named is left out in silence.
    #[test]
    fn a_program_hides_no_algorithm_that_lacks_augmentations() {
        let program = "[[program]]\nname = \"mine\"\ntask = \"convert\"\n\
                       command = \"run {mesh} {quads}\"\n[[group]]";
        let text = TEXT.replace("[[group]]", program);
        let text = text.replace("augmentations = [\"tarjan\", \"local\"]", "");
        for algorithms in ["\"mine\", \"ps\"", "\"ps\", \"mine\""] {
            let text = text.replace("\"ps\", \"lrs few-flips\"", algorithms);
            let fault = Experiment::parse(&text).unwrap_err().to_string();
            assert!(fault.starts_with("line 17: ps needs augmentations; "), "{fault}");
        }
        let alone = text.replace("\"ps\", \"lrs few-flips\"", "\"mine\"");
        let alone = alone.replace("stop_after_paths = { A1 = 7 }", "");
        assert!(Experiment::parse(&alone).is_ok(), "a program needs none");
    }

    #[test]
    fn what_is_wrong_is_named_with_its_line() {
        let problem = |from: &str, to: &str| {
            assert!(TEXT.contains(from));
            Experiment::parse(&TEXT.replace(from, to)).unwrap_err().to_string()
        };
        assert!(problem("seed = 1", "seed = -1").starts_with("line 5: "));
        assert!(problem("seed", "sed").contains("unknown field `sed`"));
        let all = Algorithm::ALL.map(Algorithm::id).join(", ");
        let unknown = format!("line 13: \"pss\" is none of {all}; the nearest is \"ps\"");
        assert_eq!(problem("\"ps\"", "\"pss\""), unknown);
        assert!(
            problem("few-flips", "none")
                .starts_with("line 13: \"none\" is none of printed, few-flips")
        );
        assert!(
            problem("\"local\"", "\"far\"")
                .starts_with("line 14: \"far\" is none of local, tarjan")
        );
        // A name that another list knows.
        assert!(problem("\"local\"", "\"ps\"").starts_with("line 14: \"ps\" is none of local"));
        assert!(problem("timeout_seconds = 9", "timeout_seconds = 0").contains("from 1 to"));
        assert!(
            problem("memory_gigabytes = 2", "memory_gigabytes = 36028797018963968")
                .contains("1000000")
        );
        assert!(problem("demo = 2", "demo = 4294967295").contains("from 1 to 10000"));
        let without_demo = Experiment::parse(&TEXT.replace("demo = 2", "demo = 0")).unwrap();
        assert_eq!(without_demo.groups[0].runs[0].repetitions("A1", Scale::Demo), 0);
        let full_alone = TEXT.replace(", small = 5, demo = 2", "");
        let expected = Repetitions { full: 10, small: 10, demo: 10 };
        let alone = Experiment::parse(&full_alone).unwrap();
        assert_eq!(alone.groups[0].runs[0].repetitions, expected);
        assert!(problem("{ A1 = 3 }", "{ A1 = 0 }").starts_with("fewer = 0: "));
        assert!(problem("{ A1 = 7 }", "{ A1 = 0 }").starts_with("stop_after_paths = 0: "));
        let twice = problem("\"ps\"", "\"ps\", \"lrs few-flips\"");
        assert!(twice.starts_with("group \"g\" names lrs few-flips tarjan twice"), "{twice}");
        assert!(problem("name = \"g\"", "name = \"g\\nh\"").contains("control character"));
        let nothing = problem("augmentations = [\"tarjan\", \"local\"]", "orders = [\"file\"]");
        assert_eq!(
            nothing,
            "line 13: ps needs augmentations; add a line augmentations = [\"local\"]"
        );
        let none = problem("[\"ps\", \"lrs few-flips\"]", "[]");
        assert!(none.starts_with("line 13: algorithms is empty; "), "{none}");
        let often = problem("{ full = 10, small = 5, demo = 2 }", "3");
        assert!(often.ends_with("expected a number a scale: { full = 3, small = 3, demo = 3 }"));
        let limits = problem("[limits]\n", "limits = 3\n[other]\n");
        assert!(limits.contains("expected timeout_seconds and memory_gigabytes"), "{limits}");
    }
}
