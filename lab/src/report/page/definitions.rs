//! Every symbol and every algorithm in a line; those of algorithms are in [`crate::algorithms`].

use serde::Serialize;
use triquad::augmentation::Augmentation;

use super::topic::Topic;
use crate::algorithms::AlgorithmFacts;
use crate::experiment::import::UNNAMED_PROGRAM;
use crate::experiment::{Job, Task};
use crate::meshes::Origin;
use crate::report::summary::Summary;

/// A word and its meaning.
#[derive(Serialize)]
pub struct Definition {
    word: String,
    meaning: String,
}

/// Symbols of both papers.
const SYMBOLS: [(&str, &str); 22] = [
    ("n", "runs that ended well, whose mean is shown"),
    (
        "n_v, n_e, n_f",
        "vertices, edges and triangles of a triangulation; in n^x and O(n), n is n_f",
    ),
    ("g", "genus: handles of the surface, summed over its components"),
    ("k", "triangles that SG or PS leave unpaired, column (c)"),
    ("ℓ (comparison)", "triangles that LRS leaves unpaired, column (c)"),
    ("α", "k / n_f: the share of triangles left unpaired"),
    ("(a), (d), (e)", "seconds of the initial pairing, of the augmentation, and of both"),
    ("(b)", "triangles in the initial pairing, in per cent"),
    ("ℓ (irreducible)", "tests of the link condition: may this edge be contracted?"),
    ("ε", "edges tested more than once"),
    ("t", "seconds of RS, S or BF"),
    ("visited a test", "vertices of links that a test of the link condition visits, in the mean"),
    (
        "d·d a test",
        "product of the degrees of both ends: the cost of a test without data structure",
    ),
    ("visited", "in a whole run: vertices that tests visit, or triangles that augmentations visit"),
    ("path", "augmenting path; its length counts pairs of neighbouring triangles"),
    ("flips", "edges of the triangles paired that the triangulation given does not have"),
    ("scaled Jacobian", "shape of a quad: 1 for a rectangle, 0 or less where it is not convex"),
    (
        "PS, PS local",
        "a label alone: with augmentation tarjan; with local or rebuild after it: with that one",
    ),
    ("RS, RS random", "vertices in the order of the file; in random order"),
    ("tarjan", "augmentation as published: a search over the whole mesh for each path"),
    ("rebuild", "the same paths, with the graph set up anew for each, as the printed times imply"),
    ("local", "our augmentation: a search touches only what it visits"),
];

/// Symbols of conversions alone.
const OF_CONVERSIONS: [&str; 9] = [
    "k",
    "ℓ (comparison)",
    "α",
    "(a), (d), (e)",
    "(b)",
    "path",
    "flips",
    "scaled Jacobian",
    "PS, PS local",
];

/// Symbols of irreducible triangulations alone.
const OF_REDUCTIONS: [&str; 6] =
    ["ℓ (irreducible)", "ε", "t", "visited a test", "d·d a test", "RS, RS random"];

/// Returns the definitions; programs that are not ours at the end. Pages of own results define of
/// our algorithms and augmentations, of symbols and origins of meshes only those with runs.
pub fn definitions(summary: &Summary, topic: &Topic) -> Vec<Definition> {
    let is_shown = |facts: &&AlgorithmFacts| {
        let is_run = || summary.cells().iter().any(|cell| cell.id.job.facts().name == facts.name);
        !topic.is_own() || is_run()
    };
    let algorithms = AlgorithmFacts::all().iter().filter(is_shown);
    let symbols = SYMBOLS.into_iter().filter(|(word, _)| !topic.is_own() || is_used(word, summary));
    let known = algorithms.map(|facts| (facts.label, facts.meaning)).chain(symbols);
    let has_meshes =
        |origin: &Origin| summary.cells().iter().any(|cell| cell.origin == Some(*origin));
    let origins = Origin::ALL.into_iter().filter(|origin| !topic.is_own() || has_meshes(origin));
    let known = known.chain(origins.map(|origin| (origin.id(), origin.meaning())));
    let known =
        known.map(|(word, meaning)| Definition { word: word.into(), meaning: meaning.into() });
    known.chain(programs(summary)).collect()
}

/// Returns whether a symbol stands in tables or plots of these runs.
fn is_used(word: &str, summary: &Summary) -> bool {
    let any = |test: &dyn Fn(Job) -> bool| summary.cells().iter().any(|cell| test(cell.id.job));
    if OF_CONVERSIONS.contains(&word) {
        any(&|job| job.task() == Task::Convert)
    } else if OF_REDUCTIONS.contains(&word) {
        any(&|job| job.task() == Task::Irreducible)
    } else if word.parse::<Augmentation>().is_ok() {
        any(&|job| job.names().augmentation == Some(word))
    } else {
        true
    }
}

fn programs(summary: &Summary) -> impl Iterator<Item = Definition> {
    let mut programs: Vec<(String, String)> = Vec::new();
    for cell in summary.cells().iter().filter(|cell| cell.id.job.is_program()) {
        let what = match cell.id.job.task() {
            Task::Convert => "quads",
            Task::Irreducible => "irreducible triangulations",
        };
        let versions = cell.runs.iter().map(|run| run.program.as_str());
        let version = { versions }.find(|text| !["", UNNAMED_PROGRAM].contains(text));
        let version = version.map_or(String::new(), |version| format!(": {version}"));
        let meaning = format!("{}, makes {what}{version}", cell.id.job.facts().meaning);
        if programs.iter().all(|program| program.0 != cell.label()) {
            programs.push((cell.label(), meaning));
        }
    }
    programs.into_iter().map(|(word, meaning)| Definition { word, meaning })
}

#[cfg(test)]
mod tests {
    use triquad::irreducible::{Contractor, Order};
    use triquad::pairing::Algorithm;

    use super::*;
    use crate::experiment::Job;

    #[test]
    fn labels_without_augmentation_or_order_are_defined() {
        let published = Job::published(Algorithm::PulliSegal);
        let in_file_order = Job::in_file_order(Contractor::RamaswamiSiqueira);
        let random = Job::Reduce { method: Contractor::RamaswamiSiqueira, order: Order::Random };
        for (bare, other, names) in [
            (published, published.with_augmentation(Augmentation::Local), ["tarjan", "local"]),
            (in_file_order, random, ["file", "random"]),
        ] {
            let word = format!("{}, {}", bare.label(), other.label());
            let (_, meaning) = SYMBOLS.iter().find(|symbol| symbol.0 == word).expect(&word);
            assert!(names.iter().all(|name| meaning.contains(name)), "{meaning}");
        }
    }

    #[test]
    fn symbols_of_one_task_are_symbols() {
        let is_symbol = |word: &&str| SYMBOLS.iter().any(|symbol| symbol.0 == *word);
        assert!(OF_CONVERSIONS.iter().chain(&OF_REDUCTIONS).all(is_symbol));
    }
}
