//! Tables 6 to 11 of the paper on irreducible triangulations: tests of the link condition, and ratios
//! of tests and times.

use super::ReportTable;
use super::columns::{self, MESH, cells_of, header, mean, outcomes, printed};
use crate::experiment::RunRecord;
use crate::report::number::{mean_count, or_empty, quotient, significant};
use crate::report::paper::{Kind, LinkTestRow, RatioRow, Table};
use crate::report::statistics::Statistics;
use crate::report::summary::{Cell, Summary};

const TESTS: [&str; 6] = [
    "rs_link_condition_tests",
    "schipper_link_condition_tests",
    "brute_force_link_condition_tests",
    "rs_edges_tested_more_than_once",
    "schipper_edges_tested_more_than_once",
    "brute_force_edges_tested_more_than_once",
];

const PAPER_TESTS: [&str; 11] = [
    "paper_rs_link_condition_tests",
    "paper_schipper_link_condition_tests",
    "paper_brute_force_link_condition_tests",
    "paper_schipper_edges_tested_more_than_once",
    "paper_brute_force_edges_tested_more_than_once",
    "ratio_rs_link_condition_tests",
    "ratio_schipper_link_condition_tests",
    "ratio_brute_force_link_condition_tests",
    "ratio_schipper_edges_tested_more_than_once",
    "ratio_brute_force_edges_tested_more_than_once",
    "paper_errata",
];

const RATIOS: [&str; 6] = [
    "schipper_to_rs_tests",
    "brute_force_to_rs_tests",
    "schipper_to_brute_force_tests",
    "schipper_to_rs_seconds",
    "brute_force_to_rs_seconds",
    "schipper_to_brute_force_seconds",
];

const PAPER_RATIOS: [&str; 7] = [
    "paper_schipper_to_rs_tests",
    "paper_brute_force_to_rs_tests",
    "paper_schipper_to_brute_force_tests",
    "paper_schipper_to_rs_seconds",
    "paper_brute_force_to_rs_seconds",
    "paper_schipper_to_brute_force_seconds",
    "paper_errata",
];

const OUTCOMES: [&str; 3] = ["rs_outcomes", "schipper_outcomes", "brute_force_outcomes"];

/// RS, S and BF on one mesh, in file order.
struct Trio<'a>([Option<&'a Cell>; 3]);

/// Tables 6 to 11.
pub fn all(summary: &Summary) -> Vec<ReportTable> {
    let tables = [
        ("6", "table_6.csv"),
        ("7", "table_7.csv"),
        ("8", "table_8.csv"),
        ("9", "table_9.csv"),
        ("10", "table_10.csv"),
        ("11", "table_11.csv"),
    ];
    tables.map(|(number, file)| table(summary, number, file)).into()
}

fn table(summary: &Summary, number: &'static str, file: &'static str) -> ReportTable {
    let paper = printed(number);
    let lines = match paper.kind() {
        Kind::LinkTests => test_lines(summary, &paper),
        _ => ratio_lines(summary, &paper),
    };
    let mut rows = Vec::new();
    let mut shown = Vec::new();
    for (mesh, trio, [ours, beside]) in lines {
        let mut row = vec![mesh.clone()];
        row.extend(ours);
        row.extend(columns::of_mesh(cells_of(summary, "irreducible", &mesh)));
        row.extend(trio.0.map(outcomes));
        row.extend(beside);
        rows.push(row);
        shown.extend(trio.0.into_iter().flatten());
    }
    let (ours, beside): (&[&str], &[&str]) = match paper.kind() {
        Kind::LinkTests => (&TESTS, &PAPER_TESTS),
        _ => (&RATIOS, &PAPER_RATIOS),
    };
    ReportTable {
        number,
        file,
        title: paper.title().into(),
        header: header(&[&["mesh"], ours, &MESH, &OUTCOMES, beside]),
        rows,
        notes: columns::notes(&shown),
    }
}

/// Mesh, cells, and the columns that are the table's own: ours, and those from the paper.
type Line<'a> = (String, Trio<'a>, [Vec<String>; 2]);

fn test_lines<'a>(summary: &'a Summary, paper: &Table) -> Vec<Line<'a>> {
    let line = |row: LinkTestRow| {
        let trio = Trio::on(summary, &row.mesh);
        let columns = [trio.tests(), trio.tests_beside(&row)];
        (row.mesh, trio, columns)
    };
    paper.link_test_rows().into_iter().map(line).collect()
}

fn ratio_lines<'a>(summary: &'a Summary, paper: &Table) -> Vec<Line<'a>> {
    let line = |row: RatioRow| {
        let trio = Trio::on(summary, &row.mesh);
        let columns = [trio.ratios(), printed_ratios(&row)];
        (row.mesh, trio, columns)
    };
    paper.ratio_rows().into_iter().map(line).collect()
}

impl<'a> Trio<'a> {
    fn on(summary: &'a Summary, mesh: &str) -> Self {
        Self(
            ["rs", "schipper", "brute-force"]
                .map(|algorithm| summary.cell("irreducible", mesh, algorithm, None, "file")),
        )
    }

    fn describe(&self, number: fn(&RunRecord) -> Option<f64>) -> [Option<Statistics>; 3] {
        self.0.map(|cell| cell?.statistics(number))
    }

    /// The columns [`TESTS`].
    fn tests(&self) -> Vec<String> {
        let numbers = [self.describe(link_tests), self.describe(repeated)];
        numbers.concat().into_iter().map(|number| mean(number, mean_count)).collect()
    }

    /// The columns [`PAPER_TESTS`].
    fn tests_beside(&self, paper: &LinkTestRow) -> Vec<String> {
        let printed = [
            paper.rs_link_condition_tests,
            paper.schipper_link_condition_tests,
            paper.brute_force_link_condition_tests,
            paper.schipper_edges_tested_more_than_once,
            paper.brute_force_edges_tested_more_than_once,
        ];
        let [rs, schipper, brute_force] = self.describe(link_tests);
        let [_, schipper_again, brute_force_again] = self.describe(repeated);
        let ours = [rs, schipper, brute_force, schipper_again, brute_force_again];
        let ratio = |(ours, paper): (Option<Statistics>, f64)| {
            columns::ratio(ours.map(|s| s.mean), Some(paper))
        };
        let mut fields: Vec<String> = printed.iter().map(|&value| mean_count(value)).collect();
        fields.extend(ours.into_iter().zip(printed).map(ratio));
        fields.push(paper.errata.clone());
        fields
    }

    /// The columns [`RATIOS`]; no ratios of times of runs that disturbed each other.
    fn ratios(&self) -> Vec<String> {
        let parallel = self.0.iter().flatten().any(|cell| cell.is_parallel());
        let tests = self.describe(link_tests).map(|found| found.map(|s| s.mean));
        let seconds = self.describe(|run| run.seconds).map(|found| found.map(|s| s.mean));
        let seconds = if parallel { [None; 3] } else { seconds };
        let ratios = [tests, seconds].map(|[rs, schipper, brute_force]| {
            [quotient(schipper, rs), quotient(brute_force, rs), quotient(schipper, brute_force)]
        });
        ratios.concat().into_iter().map(|ratio| or_empty(ratio, significant)).collect()
    }
}

/// The columns [`PAPER_RATIOS`].
fn printed_ratios(paper: &RatioRow) -> Vec<String> {
    let ratios = [
        paper.schipper_to_rs_tests,
        paper.brute_force_to_rs_tests,
        paper.schipper_to_brute_force_tests,
        paper.schipper_to_rs_seconds,
        paper.brute_force_to_rs_seconds,
        paper.schipper_to_brute_force_seconds,
    ];
    let mut fields: Vec<String> = ratios.iter().map(|ratio| format!("{ratio:.2}")).collect();
    fields.push(paper.errata.clone());
    fields
}

/// ℓ of the paper.
fn link_tests(run: &RunRecord) -> Option<f64> {
    run.link_condition_tests.map(|count| count as f64)
}

/// ε of the paper.
fn repeated(run: &RunRecord) -> Option<f64> {
    run.edges_tested_more_than_once.map(|count| count as f64)
}
