//! Does LRS still beat PS when the augmentation is better? Answered from the records.

use serde::Serialize;
use triquad::augmentation::Augmentation;
use triquad::counted::counted;
use triquad::pairing::{Algorithm, Expansion};

use super::parts::Parts;
use crate::experiment::{Job, RunRecord};
use crate::paper::Paper;
use crate::report::number::{seconds, significant};
use crate::report::path_price::PathPrice;
use crate::report::plots::{Counterpart, Plot};
use crate::report::statistics::Statistics;
use crate::report::summary::{Cell, Summary};

/// The section.
#[derive(Serialize)]
pub struct LrsAgainstPs<'a> {
    answer: String,
    lines: Vec<String>,
    rows: Vec<DuelRow>,
    plots: Vec<&'a Plot>,
}

impl LrsAgainstPs<'_> {
    /// Returns the answer in a sentence or two.
    pub fn answer(&self) -> &str {
        &self.answer
    }

    /// Returns whether the records say anything about it.
    pub fn is_answered(&self) -> bool {
        !self.lines.is_empty() || !self.plots.is_empty()
    }
}

/// PS and LRS on a mesh, as the page shows them.
#[derive(Serialize)]
struct DuelRow {
    mesh: String,
    cells: Vec<DuelCell>,
}

/// A mean with its number of runs, or a ratio.
#[derive(Clone, Serialize)]
struct DuelCell {
    text: String,
    n: Option<usize>,
}

/// Totals of PS and LRS.
type Pair = (Statistics, Statistics);

/// A mesh with its pairs under each augmentation.
struct Duel<'a> {
    mesh: &'a Cell,
    rebuild: Option<Pair>,
    tarjan: Option<Pair>,
    local: Option<Pair>,
}

/// Makes the section.
pub fn section<'a>(parts: &Parts<'a>) -> LrsAgainstPs<'a> {
    let is_own = |plot: &&Plot| plot.counterpart == Counterpart::LrsAgainstPs;
    let plots = parts.plots.iter().filter(is_own).collect();
    let duels = duels(parts.summary);
    let has_both = |duel: &&Duel| duel.tarjan.is_some() && duel.local.is_some();
    let both: Vec<&Duel> = duels.iter().filter(has_both).collect();
    let mut rows = duels.iter().map(row).collect();
    let mut lines = Vec::new();
    let answer = if parts.summary.is_parallel() {
        rows = Vec::new();
        "This cannot be answered from these records: runs went on side by side, so that their \
         times are not ranked."
            .into()
    } else if both.is_empty() {
        "This cannot be answered from these records: no mesh has PS and LRS under both \
         augmentations."
            .into()
    } else {
        lines = self::lines(&both, parts.summary);
        answer(&both)
    };
    LrsAgainstPs { answer, lines, rows, plots }
}

/// Returns every mesh with PS and LRS under some augmentation.
fn duels(summary: &Summary) -> Vec<Duel<'_>> {
    let duels = summary.meshes(Paper::Comparison).into_iter().map(|mesh| {
        let pair = |augmentation: Augmentation| {
            let total = |algorithm| {
                let job = Job::Convert { algorithm, augmentation };
                let cell = summary.cell(Paper::Comparison, mesh.mesh(), job)?;
                cell.statistics(RunRecord::whole_total_seconds)
            };
            Some((total(Algorithm::PulliSegal)?, total(Algorithm::Lrs(Expansion::Printed))?))
        };
        let rebuild = rebuilt(summary, mesh.mesh());
        let [tarjan, local] = [Augmentation::Tarjan, Augmentation::Local].map(pair);
        Duel { mesh, rebuild, tarjan, local }
    });
    duels.filter(|duel| duel.tarjan.is_some() || duel.local.is_some()).collect()
}

/// Returns the pair under `rebuild`.
fn rebuilt(summary: &Summary, mesh: &str) -> Option<Pair> {
    let total = |algorithm| PathPrice::total(summary, mesh, algorithm);
    Some((total(Algorithm::PulliSegal)?, total(Algorithm::Lrs(Expansion::Printed))?))
}

fn lrs_is_faster(pair: &Option<Pair>) -> bool {
    pair.as_ref().is_some_and(|(ps, lrs)| lrs.mean < ps.mean)
}

/// Counts the duels that LRS wins under `tarjan`, under both, and under `local`.
fn lrs_wins(duels: &[&Duel]) -> [usize; 3] {
    let count = |wins: &dyn Fn(&Duel) -> bool| duels.iter().filter(|duel| wins(duel)).count();
    let (before, after) =
        (|duel: &Duel| lrs_is_faster(&duel.tarjan), |duel: &Duel| lrs_is_faster(&duel.local));
    [count(&before), count(&|duel| before(duel) && after(duel)), count(&after)]
}

/// Returns the answer in a sentence or two.
fn answer(both: &[&Duel]) -> String {
    let all = both.len();
    let [before, kept, after] = lrs_wins(both);
    let smaller = both.iter().find_map(|duel| duel.mesh.smaller_scale());
    let short = match (before, kept, smaller) {
        // The papers' ranking is of large meshes: a few small ones say nothing of it.
        (_, _, Some(scale)) if 2 * before.max(after) <= all => format!(
            "Undecided: at scale {} LRS beats PS on most meshes with neither augmentation.",
            scale.id()
        ),
        (0, _, _) if after == 0 => "LRS does not beat PS, with either augmentation.".into(),
        (0, _, _) => "LRS beats PS with the better augmentation only.".into(),
        (_, 0, _) => "No: with the better augmentation LRS no longer beats PS where it did.".into(),
        (before, kept, _) if kept == before => "Yes: LRS still beats PS where it did.".into(),
        _ => "On some meshes only.".into(),
    };
    let meshes = counted(all, "mesh", "meshes");
    let text = format!(
        "{short} With the augmentation as published LRS is faster on {before} of {meshes}; \
         with ours it is faster on {kept} of these, and on {after} of all {all}."
    );
    let rebuilt = || both.iter().filter(|duel| duel.rebuild.is_some());
    if rebuilt().count() == 0 {
        return text;
    }
    let faster = rebuilt().filter(|duel| lrs_is_faster(&duel.rebuild)).count();
    let timed = rebuilt().count();
    format!("{text} With the graph set up anew for each path it is faster on {faster} of {timed}.")
}

/// Returns the same by groups, and what both gain.
fn lines(both: &[&Duel], summary: &Summary) -> Vec<String> {
    let mut lines = Vec::new();
    for (group, name) in [
        ("scans", "Scans"),
        ("A", "Boxes of genus 0"),
        ("B", "Boxes of great genus"),
        ("data", "Other meshes"),
    ] {
        let in_group = |duel: &&&Duel| duel.mesh.group == group;
        let own: Vec<&Duel> = both.iter().filter(in_group).copied().collect();
        if own.is_empty() {
            continue;
        }
        let all = own.len();
        let [before, _, after] = lrs_wins(&own);
        let gain = |of: fn(&Pair) -> Statistics| {
            let ratio = |duel: &&Duel| {
                let (tarjan, local) = (of(duel.tarjan.as_ref()?), of(duel.local.as_ref()?));
                (local.mean > 0.0).then(|| tarjan.mean / local.mean)
            };
            let ratios: Vec<f64> = own.iter().filter_map(ratio).collect();
            Statistics::from_values(&ratios).map_or("?".into(), |ratios| significant(ratios.median))
        };
        lines.push(format!(
            "{name}: LRS faster on {before} of {all} under tarjan, on {after} of {all} under \
             local. In the median local makes PS {} times and LRS {} times as fast as tarjan \
             does.",
            gain(|pair| pair.0),
            gain(|pair| pair.1),
        ));
    }
    if !summary.of_paper(Paper::Comparison).all(Cell::is_full_scale) {
        lines.push("Not at the papers' sizes: the cost of tarjan grows with them.".into());
    }
    lines
}

fn row(duel: &Duel) -> DuelRow {
    let cells = [&duel.rebuild, &duel.tarjan, &duel.local].into_iter().flat_map(cells);
    DuelRow { mesh: duel.mesh.marked_mesh(), cells: cells.collect() }
}

/// Returns the means of PS and LRS, and their ratio with the faster one.
fn cells(pair: &Option<Pair>) -> [DuelCell; 3] {
    let text = |text| DuelCell { text, n: None };
    let Some((ps, lrs)) = pair else { return ["–"; 3].map(|dash| text(dash.into())) };
    let (winner, fast, slow) = if lrs.mean < ps.mean { ("LRS", lrs, ps) } else { ("PS", ps, lrs) };
    let unclear = if fast.maximum > slow.minimum { "~" } else { "" };
    let ratio = if ps.mean > 0.0 { significant(lrs.mean / ps.mean) } else { "–".into() };
    let mean = |of: &Statistics| DuelCell { text: seconds(of.mean), n: Some(of.n) };
    [mean(ps), mean(lrs), text(format!("{ratio} {unclear}{winner}"))]
}
