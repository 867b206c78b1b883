//! Does LRS still beat PS when the augmentation is better? Answered from the records.

use serde::Serialize;

use super::Parts;
use crate::experiment::RunRecord;
use crate::report::number::significant;
use crate::report::plots::Plot;
use crate::report::statistics::Statistics;
use crate::report::summary::{Cell, Summary};

/// The section.
#[derive(Serialize)]
pub struct Better<'a> {
    answer: String,
    lines: Vec<String>,
    rows: Vec<Row>,
    plots: Vec<&'a Plot>,
}

/// PS and LRS on a mesh.
#[derive(Serialize)]
struct Row {
    mesh: String,
    cells: Vec<String>,
}

/// Totals of PS and LRS.
type Pair = (Statistics, Statistics);

/// A mesh with its pairs under `tarjan` and under `local`.
struct Duel<'a> {
    mesh: &'a Cell,
    tarjan: Option<Pair>,
    local: Option<Pair>,
}

/// The section, whatever is there.
pub fn of<'a>(parts: &Parts<'a>) -> Better<'a> {
    let plots = parts.plots.iter().filter(|plot| plot.stem == "lrs_against_ps").collect();
    let duels = duels(parts.summary);
    let both: Vec<&Duel> =
        duels.iter().filter(|duel| duel.tarjan.is_some() && duel.local.is_some()).collect();
    let rows = duels.iter().map(row).collect();
    if parts.summary.is_parallel() {
        let answer = "This cannot be answered from these records: runs went on side by side, so \
                      that their times are not ranked."
            .into();
        return Better { answer, lines: Vec::new(), rows: Vec::new(), plots };
    }
    if both.is_empty() {
        let answer =
            "This cannot be answered from these records: no mesh has PS and LRS under both \
                      augmentations."
                .into();
        return Better { answer, lines: Vec::new(), rows, plots };
    }
    Better { answer: answer(&both), lines: lines(&both, parts.summary), rows, plots }
}

/// Every mesh with PS and LRS under some augmentation, alone on their machine.
fn duels(summary: &Summary) -> Vec<Duel<'_>> {
    let mut meshes: Vec<&Cell> = summary.of_group("comparison", None).collect();
    meshes.dedup_by(|a, b| (&a.mesh, &a.group) == (&b.mesh, &b.group));
    let duel = |mesh: &Cell| {
        let pair = |how: &str| {
            let total = |algorithm: &str| {
                let cell = summary.cell("comparison", &mesh.mesh, algorithm, None, how)?;
                cell.statistics(RunRecord::whole_total_seconds)
            };
            Some((total("ps")?, total("lrs")?))
        };
        (pair("tarjan"), pair("local"))
    };
    let duels = meshes.into_iter().map(|mesh| {
        let (tarjan, local) = duel(mesh);
        Duel { mesh, tarjan, local }
    });
    duels.filter(|duel| duel.tarjan.is_some() || duel.local.is_some()).collect()
}

fn lrs_is_faster(pair: &Option<Pair>) -> bool {
    pair.as_ref().is_some_and(|(ps, lrs)| lrs.mean < ps.mean)
}

/// The answer in a sentence or two.
fn answer(both: &[&Duel]) -> String {
    let before: Vec<&&Duel> = both.iter().filter(|duel| lrs_is_faster(&duel.tarjan)).collect();
    let kept = before.iter().filter(|duel| lrs_is_faster(&duel.local)).count();
    let after = both.iter().filter(|duel| lrs_is_faster(&duel.local)).count();
    let all = both.len();
    let short = match (before.len(), kept) {
        (0, _) if after == 0 => "LRS does not beat PS, with either augmentation.",
        (0, _) => "LRS beats PS with the better augmentation only.",
        (_, 0) => "No: with the better augmentation LRS no longer beats PS.",
        (before, kept) if kept == before => "Yes: LRS still beats PS where it did.",
        _ => "On some meshes only.",
    };
    format!(
        "{short} With the augmentation as published LRS is faster on {} of {all} meshes; with ours it \
         is faster on {kept} of these, and on {after} of all {all}.",
        before.len()
    )
}

/// The same by groups, and what both gain.
fn lines(both: &[&Duel], summary: &Summary) -> Vec<String> {
    let mut lines = Vec::new();
    for (group, name) in [
        ("scans", "scans"),
        ("A", "boxes of genus 0"),
        ("B", "boxes of great genus"),
        ("data", "other scans"),
    ] {
        let own: Vec<&&Duel> = both.iter().filter(|duel| duel.mesh.group == group).collect();
        if own.is_empty() {
            continue;
        }
        let before = own.iter().filter(|duel| lrs_is_faster(&duel.tarjan)).count();
        let after = own.iter().filter(|duel| lrs_is_faster(&duel.local)).count();
        let all = own.len();
        let gain = |of: fn(&Pair) -> Statistics| {
            let ratio = |duel: &&&Duel| {
                let (tarjan, local) = (of(duel.tarjan.as_ref()?), of(duel.local.as_ref()?));
                (local.mean > 0.0).then(|| tarjan.mean / local.mean)
            };
            let ratios: Vec<f64> = own.iter().filter_map(ratio).collect();
            Statistics::of(&ratios).map_or("?".into(), |ratios| significant(ratios.median))
        };
        lines.push(format!(
            "{}{}: LRS faster on {before} of {all} under tarjan, on {after} of {all} under local. In \
             the median local makes PS {} times and LRS {} times as fast as tarjan does.",
            name[..1].to_uppercase(),
            &name[1..],
            gain(|pair| pair.0),
            gain(|pair| pair.1),
        ));
    }
    if summary.of_group("comparison", None).any(|cell| cell.scale != "full") {
        lines.push("Not at the papers' sizes: the cost of tarjan grows with them.".into());
    }
    lines
}

fn row(duel: &Duel) -> Row {
    let mark = if duel.mesh.is_stand_in() { "†" } else { "" };
    let cells = [&duel.tarjan, &duel.local].into_iter().flat_map(|pair| match pair {
        None => ["–".to_owned(), "–".to_owned(), "–".to_owned()],
        Some((ps, lrs)) => {
            let (winner, fast, slow) =
                if lrs.mean < ps.mean { ("LRS", lrs, ps) } else { ("PS", ps, lrs) };
            let unclear = if fast.maximum > slow.minimum { "~" } else { "" };
            let ratio = if ps.mean > 0.0 { significant(lrs.mean / ps.mean) } else { "–".into() };
            let ratio = format!("{ratio} {unclear}{winner} faster");
            [significant(ps.mean), significant(lrs.mean), ratio]
        }
    });
    Row { mesh: format!("{}{mark}", duel.mesh.mesh), cells: cells.collect() }
}
