//! The work of one run, as the arguments of the command that does it and as columns of its record.

use serde::{Deserialize, Serialize};
use triquad::augmentation::Augmentation;
use triquad::irreducible::{Contractor, Order};
use triquad::pairing::{Algorithm, Expansion};

use super::task::Task;
use crate::algorithms::AlgorithmFacts;
use crate::nearest::likely;

/// Stands for augmentation or order in the records of programs that are not ours.
const EXTERNAL: &str = "external";

/// A job: the work of a run on its mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(try_from = "JobNames<String>", into = "JobNames<&'static str>")]
pub enum Job {
    /// `triquad convert`.
    Convert {
        /// Algorithm of the initial pairing.
        algorithm: Algorithm,
        /// Algorithm that makes the pairing perfect.
        augmentation: Augmentation,
    },
    /// `triquad irreducible`.
    Reduce {
        /// Algorithm that finds contractible edges.
        method: Contractor,
        /// Order of the vertices.
        order: Order,
    },
    /// A program or algorithm that is not ours.
    Program {
        /// Its product.
        task: Task,
        /// Its name.
        name: ProgramName,
    },
}

/// The name of a program or algorithm that is not ours; it has a row in [`crate::algorithms`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ProgramName(&'static str);

/// A job in the columns of `runs.csv` and `plan.csv`.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct JobNames<S> {
    /// Algorithm.
    pub algorithm: S,
    /// Expansion of LRS.
    pub lrs_variant: Option<S>,
    /// Augmentation of a conversion.
    pub augmentation: Option<S>,
    /// Order of the vertices of a reduction.
    pub order: Option<S>,
}

/// A name that no algorithm, variant, augmentation or order has.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "{name:?} is none of {known}{}",
    .nearest.as_ref().map_or(String::new(), |one| format!("; the nearest is {one:?}"))
)]
pub struct UnknownNameError {
    name: String,
    known: String,
    /// The known name that is probably meant.
    nearest: Option<String>,
}

impl UnknownNameError {
    /// Names `name`, what it may be, and what is probably meant.
    pub(crate) fn new(name: &str, known: &[&str]) -> Self {
        let nearest = likely(name, known.iter().copied()).map(str::to_owned);
        Self { name: name.into(), known: known.join(", "), nearest }
    }

    /// Returns the name that is not known.
    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    /// Adds names that there are too.
    pub(crate) fn with<'n>(&self, more: impl Iterator<Item = &'n str>) -> Self {
        let more: Vec<&str> = more.collect();
        let known: Vec<&str> = self.known.split(", ").chain(more).collect();
        Self::new(&self.name, &known)
    }
}

impl Default for Job {
    /// Returns the job of `triquad convert` without options.
    fn default() -> Self {
        Self::Convert { algorithm: Algorithm::EagerRescue, augmentation: Augmentation::Local }
    }
}

impl Job {
    /// Returns the conversion with the augmentation as published.
    pub const fn published(algorithm: Algorithm) -> Self {
        Self::Convert { algorithm, augmentation: Augmentation::Tarjan }
    }

    /// Returns the reduction of vertices in the order of the file, as published.
    pub const fn in_file_order(method: Contractor) -> Self {
        Self::Reduce { method, order: Order::File }
    }

    /// Returns the job of a program or algorithm that is not ours.
    pub fn program(task: Task, name: &str) -> Self {
        Self::Program { task, name: ProgramName(AlgorithmFacts::other(name).name) }
    }

    /// Returns the job of that algorithm, its variant after a space, as its paper ran it.
    ///
    /// # Errors
    /// There is no such algorithm.
    pub fn named(name: &str) -> Result<Self, UnknownNameError> {
        let reduction = find_method(name).map(Self::in_file_order);
        reduction.or_else(|_| find_conversion(name).map(Self::published))
    }

    /// Returns its names in records.
    pub fn names(self) -> JobNames<&'static str> {
        let mut names =
            JobNames { algorithm: "", lrs_variant: None, augmentation: None, order: None };
        match self {
            Self::Convert { algorithm, augmentation } => {
                (names.algorithm, names.augmentation) = (algorithm.id(), Some(augmentation.id()));
                if let Algorithm::Lrs(expansion) = algorithm {
                    names.lrs_variant = Some(expansion.id());
                }
            }
            Self::Reduce { method, order } => {
                (names.algorithm, names.order) = (method.id(), Some(order.id()));
            }
            Self::Program { task: Task::Convert, name } => {
                (names.algorithm, names.augmentation) = (name.0, Some(EXTERNAL));
            }
            Self::Program { task: Task::Irreducible, name } => {
                (names.algorithm, names.order) = (name.0, Some(EXTERNAL));
            }
        }
        names
    }

    /// Returns the name of the algorithm in records.
    pub fn algorithm(self) -> &'static str {
        self.names().algorithm
    }

    /// Returns what it makes.
    pub fn task(self) -> Task {
        match self {
            Self::Convert { .. } => Task::Convert,
            Self::Reduce { .. } => Task::Irreducible,
            Self::Program { task, .. } => task,
        }
    }

    /// Returns whether it is a program or algorithm that is not ours.
    pub fn is_program(self) -> bool {
        matches!(self, Self::Program { .. })
    }

    /// Returns the same conversion with another augmentation; others have none.
    pub fn with_augmentation(self, augmentation: Augmentation) -> Self {
        match self {
            Self::Convert { algorithm, .. } => Self::Convert { algorithm, augmentation },
            other => other,
        }
    }

    /// Returns the facts of the algorithm.
    ///
    /// # Panics
    /// If the algorithm has no row in [`crate::algorithms`]. A test finds out.
    pub fn facts(self) -> &'static AlgorithmFacts {
        if let Self::Program { name, .. } = self {
            return AlgorithmFacts::other(name.0);
        }
        let JobNames { algorithm, lrs_variant, .. } = self.names();
        let variant = lrs_variant.filter(|&variant| variant != Expansion::Printed.id());
        let name = variant.map_or(algorithm.into(), |variant| format!("{algorithm} {variant}"));
        AlgorithmFacts::named(&name)
            .unwrap_or_else(|| panic!("{name} needs a row in lab/src/algorithms.rs"))
    }

    /// Returns the name in the papers, with what is not as published: `PS`, `LRS few-flips`,
    /// `PS local`, `RS random`.
    pub fn label(self) -> String {
        let (label, JobNames { augmentation, order, .. }) = (self.facts().label, self.names());
        let published = [Augmentation::Tarjan.id(), Order::File.id(), EXTERNAL];
        let how = augmentation.or(order).filter(|how| !published.contains(how));
        how.map_or(label.into(), |how| format!("{label} {how}"))
    }

    /// Returns the name that no other job has: `lrs printed tarjan`.
    pub fn name(self) -> String {
        let JobNames { algorithm, lrs_variant, augmentation, order } = self.names();
        let words = [Some(algorithm), lrs_variant, augmentation, order];
        words.into_iter().flatten().collect::<Vec<_>>().join(" ")
    }

    /// Returns the options on the command line, omitting defaults.
    pub fn options(self) -> Vec<&'static str> {
        let JobNames { algorithm, lrs_variant, augmentation, order } = self.names();
        let options = [
            ("--algorithm", Some(algorithm)),
            ("--lrs-variant", lrs_variant.filter(|&variant| variant != Expansion::Printed.id())),
            ("--augmentation", augmentation),
            ("--order", order.filter(|&order| order != Order::File.id())),
        ];
        options.into_iter().filter_map(|(name, value)| Some([name, value?])).flatten().collect()
    }
}

impl From<Job> for JobNames<&'static str> {
    fn from(job: Job) -> Self {
        job.names()
    }
}

impl TryFrom<JobNames<String>> for Job {
    type Error = UnknownNameError;

    /// Names that are none of ours are those of a program; only an empty one is refused.
    fn try_from(names: JobNames<String>) -> Result<Self, UnknownNameError> {
        let task = if names.augmentation.is_some() { Task::Convert } else { Task::Irreducible };
        let words = [Some(&names.algorithm), names.lrs_variant.as_ref()];
        let how = [names.augmentation.as_ref(), names.order.as_ref()];
        let how = how.into_iter().filter(|how| how.is_some_and(|how| how != EXTERNAL));
        let words: Vec<&str> = words.into_iter().chain(how).flatten().map(String::as_str).collect();
        let other = words.join(" ");
        match Self::of_ours(names) {
            Err(_) if !other.is_empty() => Ok(Self::program(task, &other)),
            found => found,
        }
    }
}

impl Job {
    /// Returns the job of these names if all of them are ours.
    fn of_ours(names: JobNames<String>) -> Result<Self, UnknownNameError> {
        let JobNames { algorithm, lrs_variant, augmentation, order } = names;
        let Some(augmentation) = augmentation else {
            let (method, order) = (find_method(&algorithm)?, order.unwrap_or_default());
            return Ok(Self::Reduce { method, order: find_order(&order)? });
        };
        let name =
            lrs_variant.map_or(algorithm.clone(), |variant| format!("{algorithm} {variant}"));
        let augmentation = find_augmentation(&augmentation)?;
        Ok(Self::Convert { algorithm: find_conversion(&name)?, augmentation })
    }
}

/// Returns the conversion algorithm of that name; the variant of LRS follows after a space.
pub(crate) fn find_conversion(name: &str) -> Result<Algorithm, UnknownNameError> {
    match name.split_once(' ') {
        Some(("lrs", variant)) => find(Expansion::ALL, Expansion::id, variant).map(Algorithm::Lrs),
        _ => find(Algorithm::ALL, Algorithm::id, name),
    }
}

/// Returns the name that we give an algorithm of ours, and its task: case does not matter.
pub(crate) fn our_name(name: &str) -> Option<(String, Task)> {
    let ours = name.to_lowercase();
    let task = Job::named(&ours).ok()?.task();
    Some((ours, task))
}

pub(crate) fn find_augmentation(name: &str) -> Result<Augmentation, UnknownNameError> {
    find(Augmentation::ALL, Augmentation::id, name)
}

pub(crate) fn find_method(name: &str) -> Result<Contractor, UnknownNameError> {
    find(Contractor::ALL, Contractor::id, name)
}

pub(crate) fn find_order(name: &str) -> Result<Order, UnknownNameError> {
    find(Order::ALL, Order::id, name)
}

fn find<T: Copy, const N: usize>(
    all: [T; N],
    id: fn(T) -> &'static str,
    name: &str,
) -> Result<T, UnknownNameError> {
    let unknown = || UnknownNameError::new(name, &all.map(id));
    all.into_iter().find(|&one| id(one) == name).ok_or_else(unknown)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all() -> Vec<Job> {
        let conversions = Algorithm::ALL.into_iter().chain(Expansion::ALL.map(Algorithm::Lrs));
        let methods = Contractor::ALL.into_iter();
        let mut jobs: Vec<Job> = conversions.map(Job::published).collect();
        jobs.extend(methods.map(|method| Job::Reduce { method, order: Order::Random }));
        jobs
    }

    #[test]
    fn every_algorithm_has_one_row_of_facts_and_a_look_of_its_own_among_its_kind() {
        let (jobs, rows) = (all(), AlgorithmFacts::all());
        assert!(rows.iter().all(|facts| jobs.iter().any(|job| job.facts().name == facts.name)));
        for (i, facts) in rows.iter().enumerate() {
            assert_eq!(facts.rank(), i, "{} has two rows", facts.name);
        }
        for (one, other) in jobs.iter().flat_map(|one| jobs.iter().map(move |other| (one, other))) {
            let alike = one.task() == other.task() && one.facts().look == other.facts().look;
            assert!(!alike || one.facts().name == other.facts().name, "{one:?} {other:?}");
        }
    }

    #[test]
    fn names_give_the_same_job_again_and_unknown_ones_are_programs() {
        for job in all() {
            let names = serde_json::to_string(&job).unwrap();
            assert_eq!(serde_json::from_str::<Job>(&names).unwrap(), job);
            let unknown = names.replace(job.algorithm(), "xx");
            let program = serde_json::from_str::<Job>(&unknown).unwrap();
            assert!(program.is_program() && program.label().starts_with("xx"), "{program:?}");
            assert_eq!(program.task(), job.task());
            let names = serde_json::to_string(&program).unwrap();
            assert_eq!(serde_json::from_str::<Job>(&names).unwrap(), program);
        }
        let nameless = r#"{"algorithm": "", "augmentation": null, "order": null}"#;
        assert!(serde_json::from_str::<Job>(nameless).is_err());
    }
}
