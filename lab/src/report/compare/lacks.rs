//! What a claim needs and the records do not have.

use std::collections::BTreeSet;

use super::evidence::Evidence;
use crate::experiment::Job;
use crate::report::claims::{Claim, ClaimKind};
use crate::report::summary::Summary;

/// What a claim needs and the records do not have.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Lacks {
    /// Algorithms of which there are no runs.
    algorithms: Vec<&'static str>,
    /// Meshes without runs.
    meshes: Vec<String>,
    /// Numbers that the runs do not have: the algorithm and the number.
    numbers: Vec<(&'static str, &'static str)>,
    /// True if an algorithm of the claim was run on one of its meshes.
    has_runs: bool,
}

impl Lacks {
    /// Finds what `claim` lacks; `ours` has the meshes without a number.
    pub(super) fn new(claim: &Claim, summary: &Summary, ours: &Evidence) -> Self {
        let paper = claim.experiment;
        let meshes = claim.mesh_names();
        let factors = || {
            claim
                .value
                .factors
                .iter()
                .chain(claim.predicate.along().into_iter().flat_map(|along| &along.factors))
        };
        let was_run = |mesh: &str, job: Job| {
            summary.cell(paper, mesh, job).is_some_and(|cell| cell.ok_runs().next().is_some())
        };
        let runs_anywhere = |job: Job| meshes.iter().any(|mesh| was_run(mesh, job));
        let jobs: Vec<Job> = factors().filter_map(|factor| factor.job).collect();
        let has_runs =
            claim.kind != ClaimKind::Seconds && jobs.iter().any(|&job| runs_anywhere(job));
        if ours.missing.is_empty() || !has_runs {
            return Self::default();
        }
        let (there, absent): (Vec<Job>, Vec<Job>) =
            jobs.iter().partition(|&&job| runs_anywhere(job));
        let lacks_run = |mesh: &&String| there.iter().any(|&job| !was_run(mesh, job));
        let mut numbers = BTreeSet::new();
        for factor in factors() {
            let Some(job) = factor.job.filter(|job| there.contains(job)) else { continue };
            let has_number = |mesh: &String| {
                let cell = summary.cell(paper, mesh, job);
                cell.is_some_and(|cell| cell.ok_runs().any(|run| (factor.number.of)(run).is_some()))
            };
            let is_without = |mesh: &String| was_run(mesh, job) && !has_number(mesh);
            if meshes.iter().any(is_without) {
                numbers.insert((job.algorithm(), factor.number.name));
            }
        }
        let algorithms: BTreeSet<&str> = absent.into_iter().map(Job::algorithm).collect();
        Self {
            algorithms: algorithms.into_iter().collect(),
            meshes: meshes.iter().filter(lacks_run).cloned().collect(),
            numbers: numbers.into_iter().collect(),
            has_runs,
        }
    }

    /// Returns whether something of the claim was run, and what it lacks is known.
    pub fn is_near(&self) -> bool {
        self.has_runs && self.number() > 0
    }

    /// Returns how much it lacks; an algorithm is as much as any number of meshes.
    pub fn number(&self) -> usize {
        1000 * self.algorithms.len() + self.meshes.len() + self.numbers.len()
    }
}

impl std::fmt::Display for Lacks {
    /// Lists it: the algorithms, the meshes, the numbers.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let mut parts: Vec<String> =
            self.algorithms.iter().map(|name| (*name).to_owned()).collect();
        parts.extend(self.meshes.iter().cloned());
        parts.extend(self.numbers.iter().map(|(algorithm, name)| format!("{name} of {algorithm}")));
        match parts.split_last() {
            Some((last, [])) => f.write_str(last),
            Some((last, others)) => write!(f, "{} and {last}", others.join(", ")),
            None => Ok(()),
        }
    }
}
