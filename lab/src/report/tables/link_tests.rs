//! Tables 6 to 11 of the paper on irreducible triangulations: tests of the link condition, and
//! ratios of tests and times.

use super::columns::{self, ColumnOf, Line, column, counterpart, mean_count, quotient_of};
use super::table::{ReportTable, Value};
use crate::experiment::{Job, Measured};
use crate::paper::{LinkTestRow, Paper, RatioRow, Table, TableKind};
use crate::report::number::quotient;
use crate::report::summary::{Cell, Summary};

/// RS, S and BF in the names of columns, and their letters in the paper.
const TRIO: [(&str, &str); 3] = [("rs", "rs"), ("schipper", "s"), ("brute_force", "bf")];

/// Returns the jobs with columns: RS, S and BF, then the programs that are not ours.
fn jobs(summary: &Summary) -> Vec<Job> {
    let mut jobs = Paper::Irreducible.jobs().to_vec();
    jobs.extend(summary.programs(Paper::Irreducible));
    jobs
}

/// Returns the places and names of the programs that are not ours.
fn programs(summary: &Summary) -> impl Iterator<Item = (usize, String)> {
    let labels = summary.programs(Paper::Irreducible).into_iter().map(Job::label);
    labels.enumerate().map(|(i, label)| (TRIO.len() + i, label))
}

/// Makes a table with RS, S and BF on each mesh, in file order.
fn table<P: 'static>(
    summary: &Summary,
    printed: Table,
    rows: Vec<(String, P)>,
    mut columns: Vec<ColumnOf<'static, P>>,
    errata_of: fn(&P) -> &str,
) -> ReportTable {
    let line = |(mesh, row): (String, P)| {
        let cell = |job| summary.cell(Paper::Irreducible, &mesh, job);
        let cells = jobs(summary).into_iter().map(cell).collect();
        Line { cells, ..Line::new(summary, Paper::Irreducible, &mesh, Some(row)) }
    };
    let lines: Vec<Line<P>> = rows.into_iter().map(line).collect();
    columns.extend(columns::hidden_mesh());
    for (at, (name, letter)) in TRIO.into_iter().enumerate() {
        let heading = format!("{} runs", letter.to_uppercase());
        columns.push(columns::ok_runs(format!("{name}_n"), at).hidden());
        columns.push(columns::outcomes(format!("{name}_outcomes"), at).heading(heading));
    }
    for (at, name) in programs(summary) {
        let heading = format!("{name} runs");
        columns.push(columns::outcomes(format!("{name}_outcomes"), at).heading(heading));
    }
    counterpart(printed, columns, &lines, errata_of)
}

/// Makes Tables 6 to 11.
pub fn all(summary: &Summary) -> Vec<ReportTable> {
    let of_paper = Table::ALL.into_iter().filter(|table| table.paper == Paper::Irreducible);
    let made = of_paper.filter_map(|printed| match printed.kind {
        TableKind::LinkTests => Some(tests(summary, printed)),
        TableKind::Ratios => Some(ratios(summary, printed)),
        _ => None,
    });
    made.collect()
}

fn tests(summary: &Summary, printed: Table) -> ReportTable {
    let rows = printed.link_test_rows().into_iter().map(|row| (row.mesh.clone(), row)).collect();
    let counts = |what: &str, letter: &str, count: fn(&Measured) -> Option<u64>| {
        let column = |(at, (name, of)): (usize, (&str, &str))| {
            mean_count(format!("{name}_{what}"), at, count).heading(format!("{letter}_{of}"))
        };
        let columns: Vec<ColumnOf<LinkTestRow>> =
            TRIO.into_iter().enumerate().map(column).collect();
        <[_; 3]>::try_from(columns).ok().expect("there are three algorithms")
    };
    let beside = |column: ColumnOf<'static, LinkTestRow>, number: fn(&LinkTestRow) -> f64| {
        column.printed(move |row| Value::Mean(number(row))).with_ratio()
    };
    let [rs, s, bf] =
        counts("link_condition_tests", "ℓ", |measured| measured.link_condition_tests);
    let [rs_again, s_again, bf_again] = counts("edges_tested_more_than_once", "ε", |measured| {
        measured.edges_tested_more_than_once
    });
    let mut columns = vec![
        beside(rs, |row| row.rs_link_condition_tests),
        beside(s, |row| row.schipper_link_condition_tests),
        beside(bf, |row| row.brute_force_link_condition_tests),
        rs_again,
        beside(s_again, |row| row.schipper_edges_tested_more_than_once),
        beside(bf_again, |row| row.brute_force_edges_tested_more_than_once),
    ];
    for (at, name) in programs(summary) {
        columns.push(
            mean_count(format!("{name}_link_condition_tests"), at, |run| run.link_condition_tests)
                .heading(format!("ℓ_{name}")),
        );
    }
    columns
        .extend(cost_columns("link_vertices_visited", "visited", |run| run.link_vertices_visited));
    columns.extend(cost_columns("degree_products", "d·d", |run| run.degree_products));
    table(summary, printed, rows, columns, |row| &row.errata)
}

/// Returns the columns of a cost of RS, S and BF that no machine changes: the whole in the file,
/// and on the page what a test of the link condition costs.
fn cost_columns<P: 'static>(
    name: &'static str,
    symbol: &'static str,
    cost: fn(&Measured) -> Option<u64>,
) -> impl Iterator<Item = ColumnOf<'static, P>> {
    TRIO.into_iter().enumerate().flat_map(move |(at, (algorithm, letter))| {
        let whole = mean_count(format!("{algorithm}_{name}"), at, cost).hidden();
        let parts = [cost, |run: &Measured| run.link_condition_tests];
        let a_test = quotient_of(format!("{algorithm}_{name}_a_test"), at, parts);
        [whole, a_test.heading(format!("{symbol} a test, {}", letter.to_uppercase()))]
    })
}

fn ratios(summary: &Summary, printed: Table) -> ReportTable {
    let rows = printed.ratio_rows().into_iter().map(|row| (row.mesh.clone(), row)).collect();
    let mut columns = vec![
        ratio([1, 0], "tests", tests_of, |row| row.schipper_to_rs_tests),
        ratio([2, 0], "tests", tests_of, |row| row.brute_force_to_rs_tests),
        ratio([1, 2], "tests", tests_of, |row| row.schipper_to_brute_force_tests),
        ratio([1, 0], "seconds", seconds_of, |row| row.schipper_to_rs_seconds),
        ratio([2, 0], "seconds", seconds_of, |row| row.brute_force_to_rs_seconds),
        ratio([1, 2], "seconds", seconds_of, |row| row.schipper_to_brute_force_seconds),
    ];
    for (at, name) in programs(summary) {
        let to_rs = move |line: &Line<RatioRow>| {
            quotient(seconds_of(line, at), seconds_of(line, 0)).map_or(Value::Missing, Value::Ratio)
        };
        let column = column(format!("{name}_to_rs_seconds"), to_rs);
        columns.push(column.heading(format!("t_{name} / t_rs")));
    }
    table(summary, printed, rows, columns, |row| &row.errata)
}

/// Returns a column of the ratio of a number between two of the trio, the paper's beside it.
fn ratio(
    [top, bottom]: [usize; 2],
    what: &str,
    number: fn(&Line<RatioRow>, usize) -> Option<f64>,
    printed: fn(&RatioRow) -> f64,
) -> ColumnOf<'static, RatioRow> {
    let symbol = if what == "tests" { "ℓ" } else { "t" };
    let ours = move |line: &Line<RatioRow>| {
        quotient(number(line, top), number(line, bottom)).map_or(Value::Missing, Value::Ratio)
    };
    column(format!("{}_to_{}_{what}", TRIO[top].0, TRIO[bottom].0), ours)
        .heading(format!("{symbol}_{} / {symbol}_{}", TRIO[top].1, TRIO[bottom].1))
        .printed(move |row| Value::PrintedRatio(printed(row)))
}

fn tests_of(line: &Line<RatioRow>, at: usize) -> Option<f64> {
    line.cells[at]?.mean_count(|measured| measured.link_condition_tests)
}

/// Returns the time, unless runs disturbed each other.
fn seconds_of(line: &Line<RatioRow>, at: usize) -> Option<f64> {
    let parallel = line.cells.iter().flatten().any(|cell: &&Cell| cell.is_parallel());
    line.cells[at]?.mean(|run| run.measured.seconds).filter(|_| !parallel)
}
