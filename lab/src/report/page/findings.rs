//! The findings, in five sentences at most, each with a link to its evidence.

use serde::Serialize;
use triquad::counted::counted;

use super::lrs_against_ps::LrsAgainstPs;
use super::parts::Parts;
use crate::paper::{Paper, Table, TableKind};
use crate::report::claims::ClaimKind;
use crate::report::compare::Verdict;
use crate::report::summary::Cell;
use crate::report::tables::{ReportTable, Row, Value};

/// A sentence and where its evidence is.
#[derive(Serialize)]
pub struct Finding {
    sentence: String,
    target: String,
    evidence: &'static str,
}

/// A count equals the printed one as far as a reader cares within this factor.
const CLOSE: f64 = 1.015;

/// Returns the findings; what the records say nothing about is left out.
pub fn findings(parts: &Parts, duel: &LrsAgainstPs) -> Vec<Finding> {
    let finding = |sentence: Option<String>, target: &str, evidence| {
        sentence.map(|sentence| Finding { sentence, target: target.into(), evidence })
    };
    let findings = [
        finding(Some(verdicts(parts)), "verdicts", "every verdict"),
        finding(meshes(parts), "table-6", "the counts"),
        finding(Some(ranking(duel)), "better-augmentation", "mesh by mesh"),
        finding(reductions(parts), "table-6", "costs and ratios"),
        finding(Some(errata(parts)), "verdict-paper-inconsistent", "the contradictions"),
    ];
    findings.into_iter().flatten().collect()
}

/// Returns ` at scale demo` if meshes of a paper were made smaller than the paper's.
fn at_scale(parts: &Parts, papers: &[Paper]) -> String {
    let mut cells = papers.iter().flat_map(|&paper| parts.summary.of_paper(paper));
    let smaller = cells.find_map(Cell::smaller_scale);
    smaller.map_or(String::new(), |scale| format!(" at scale {}", scale.id()))
}

/// Counts the verdicts by kind of claim.
fn verdicts(parts: &Parts) -> String {
    let judged = &parts.comparison.verdicts;
    let of = |kind: ClaimKind| {
        let own = judged.iter().filter(move |judged| judged.kind == kind);
        let reproduced = own.clone().filter(|judged| judged.verdict == Verdict::Reproduced).count();
        let differs = own.clone().filter(|judged| judged.verdict == Verdict::Differs).count();
        (reproduced, reproduced + differs)
    };
    let kinds = [
        (ClaimKind::MachineFree, "about counts"),
        (ClaimKind::Ratio, "about ratios of times"),
        (ClaimKind::Exponent, "about growth"),
    ];
    let text = |(kind, about)| match of(kind) {
        (_, 0) => None,
        (reproduced, decided) => Some(format!("{reproduced} of {decided} {about}")),
    };
    let found: Vec<String> = kinds.into_iter().filter_map(text).collect();
    let all = judged.len();
    if found.is_empty() {
        return format!("These records decide none of the {all} claims of the two papers.");
    }
    format!(
        "The two papers make {all} claims. Of those that could be decided{}, these are \
         reproduced: {}.",
        at_scale(parts, &[Paper::Comparison, Paper::Irreducible]),
        found.join(", ")
    )
}

/// Counts the meshes on which RS makes as many tests as printed; on smaller ones it cannot.
fn meshes(parts: &Parts) -> Option<String> {
    let column = "rs_link_condition_tests";
    let rows = numbers(parts, TableKind::LinkTests, column);
    let scale = at_scale(parts, &[Paper::Irreducible]);
    if !rows.is_empty() && !scale.is_empty() {
        return Some(format!(
            "The printed counts determine the papers' box, whose proportions are not printed. The \
             numbers of link condition tests are not comparable with the printed ones{scale}."
        ));
    }
    let is_close = |(ours, paper): &&(f64, f64)| {
        let ratio = ours / paper;
        ratio <= CLOSE && ratio * CLOSE >= 1.0
    };
    let close = rows.iter().filter(is_close).count();
    (!rows.is_empty()).then(|| {
        format!(
            "The printed counts determine the papers' box, whose proportions are not printed: on \
             the meshes of these records RS makes the printed number of link condition tests \
             within 1.5 % on {close} of {}.",
            rows.len()
        )
    })
}

fn ranking(duel: &LrsAgainstPs) -> String {
    format!("Does LRS beat PS, whatever the augmentation? {}", duel.answer())
}

/// Counts the meshes on which RS visits fewer link vertices than S and BF, and is faster.
fn reductions(parts: &Parts) -> Option<String> {
    let faster = |(other, column)| {
        let ratios = numbers(parts, TableKind::Ratios, column);
        let faster = ratios.iter().filter(|(ours, _)| *ours > 1.0).count();
        let all = ratios.len();
        (all > 0).then(|| format!("than {other} on {faster} of {}", counted(all, "box", "boxes")))
    };
    let visited = visited(parts);
    let fewer = |other: usize| visited.iter().filter(|row| row[0] < row[other]).count();
    let cost = (!visited.is_empty()).then(|| {
        format!(
            "visits fewer link vertices than S on {} and than BF on {} of {}",
            fewer(1),
            fewer(2),
            counted(visited.len(), "box", "boxes")
        )
    });
    let times = [("S", "schipper_to_rs_seconds"), ("BF", "brute_force_to_rs_seconds")];
    let times: Vec<String> = times.into_iter().filter_map(faster).collect();
    let times = (!times.is_empty()).then(|| format!("is faster {}", times.join(" and ")));
    let found: Vec<String> = [cost, times].into_iter().flatten().collect();
    let scale = at_scale(parts, &[Paper::Irreducible]);
    (!found.is_empty()).then(|| format!("RS {}{scale}.", found.join("; it ")))
}

/// Counts what the papers contradict themselves in.
fn errata(parts: &Parts) -> String {
    let inconsistent = parts.comparison.count(Verdict::PaperInconsistent);
    let rows: usize = Table::ALL.iter().map(Table::errata).sum();
    format!(
        "The papers contradict themselves in {rows} rows of their tables and in {inconsistent} of \
         these claims, and the pseudo-code of RS needs four corrections to do what it is meant to."
    )
}

/// Returns the link vertices that RS, S and BF visit, on each mesh where all three are known.
fn visited(parts: &Parts) -> Vec<[f64; 3]> {
    let of_table = |table: &ReportTable| -> Vec<[f64; 3]> {
        let places = ["rs", "schipper", "brute_force"].map(|algorithm| {
            let name = format!("{algorithm}_link_vertices_visited");
            table.columns.iter().position(|column| column.name == name)
        });
        let row = |row: &Row| {
            let [rs, s, bf] = places.map(|place| row.cells[place?].ours.number());
            Some([rs?, s?, bf?])
        };
        table.rows.iter().filter_map(row).collect()
    };
    let tables = parts.tables.iter().filter(|table| is_of(table, TableKind::LinkTests));
    tables.flat_map(of_table).collect()
}

fn is_of(table: &ReportTable, kind: TableKind) -> bool {
    table.paper.is_some_and(|paper| (paper.paper, paper.kind) == (Paper::Irreducible, kind))
}

/// Returns our numbers and the printed ones of a column in the second paper's tables of a kind.
fn numbers(parts: &Parts, kind: TableKind, column: &str) -> Vec<(f64, f64)> {
    let of_table = |table: &ReportTable| -> Vec<(f64, f64)> {
        let place = table.columns.iter().position(|other| other.name == column);
        let pair = |row: &Row| {
            let cell = &row.cells[place?];
            let number = |value: &Value| value.number();
            Some((number(&cell.ours)?, number(&cell.paper)?))
        };
        table.rows.iter().filter_map(pair).collect()
    };
    parts.tables.iter().filter(|table| is_of(table, kind)).flat_map(of_table).collect()
}
