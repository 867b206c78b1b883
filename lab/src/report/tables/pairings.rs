//! Tables 4.3 and 4.4 of the comparison paper: four algorithms, with the augmentation as published.

use triquad::augmentation::Augmentation;

use super::columns::{self, ColumnOf, Line, NOT_PLANNED, column, counterpart, of_cell};
use super::table::{ReportTable, Value};
use crate::experiment::{Job, RunRecord};
use crate::paper::{PairingRow, Paper, Table, TableKind};
use crate::report::notes::Note;
use crate::report::number::quotient;
use crate::report::statistics::Statistics;
use crate::report::summary::{Cell, Summary};

/// A job of the paper, and its printed row if there is one.
struct PrintedJob {
    job: Job,
    row: Option<PairingRow>,
}

/// Makes Tables 4.3, 4.4(i) and 4.4(ii).
pub fn all(summary: &Summary) -> impl Iterator<Item = ReportTable> {
    Table::of_kind(Paper::Comparison, TableKind::Pairings).map(|printed| table(summary, printed))
}

fn table(summary: &Summary, printed: Table) -> ReportTable {
    let jobs = printed.pairing_jobs();
    let is_complete = jobs.iter().all(|(_, _, row)| row.is_some());
    let line = |(mesh, job, row): (String, Job, Option<PairingRow>)| {
        let cell = summary.cell(Paper::Comparison, &mesh, job);
        (row.is_some() || cell.is_some()).then(|| {
            let printed = Some(PrintedJob { job, row });
            let line = Line::new(summary, Paper::Comparison, &mesh, printed);
            Line { cells: vec![cell], ..line }
        })
    };
    let lines: Vec<_> = with_programs(jobs, summary).into_iter().filter_map(line).collect();
    let job = |line: &Line<PrintedJob>| line.paper.as_ref().map(|printed| printed.job);
    let algorithm = move |line: &Line<_>| job(line).map_or(Value::Missing, Value::Algorithm);
    let mut columns = vec![column("algorithm", algorithm)];
    let [pairing, percent, unpaired, augmentation, total] = five_columns();
    columns.extend([
        beside(pairing, Value::Seconds, |row| row.pairing_seconds).with_ratio(),
        beside(percent, Value::Percent, |row| row.paired_percent),
        beside(unpaired, Value::Mean, |row| row.unpaired_triangles).with_ratio(),
        beside(augmentation, Value::Seconds, |row| row.augmentation_seconds),
        beside(total, Value::Seconds, |row| row.total_seconds).with_ratio(),
    ]);
    columns.extend(columns::hidden_mesh());
    columns.extend(spread_columns(absent));
    let mut table = counterpart(printed, columns, &lines, |printed| {
        printed.row.as_ref().map_or("", |row| &row.errata)
    });
    if !is_complete {
        table.notes.push(Note::TwoOfFour);
    }
    if lines.iter().any(|line| line.cells[0].is_none() && is_run_otherwise(line)) {
        table.notes.push(Note::TarjanOnly);
    }
    table.notes.push(Note::OtherMachine);
    table
}

/// Returns whether the algorithm of a line is planned on the mesh with another augmentation.
fn is_run_otherwise(line: &Line<PrintedJob>) -> bool {
    let published = |cell: &&Cell| cell.id.job.with_augmentation(Augmentation::Tarjan);
    let job = line.paper.as_ref().map(|printed| printed.job);
    line.of_mesh.iter().any(|cell| Some(published(cell)) == job)
}

/// Words why a line has no cell.
fn absent(line: &Line<PrintedJob>) -> &'static str {
    if is_run_otherwise(line) { "not run with tarjan" } else { NOT_PLANNED }
}

/// Adds to the jobs on each mesh the programs that are not ours.
pub fn with_programs(
    jobs: Vec<(String, Job, Option<PairingRow>)>,
    summary: &Summary,
) -> Vec<(String, Job, Option<PairingRow>)> {
    let programs = summary.programs(Paper::Comparison);
    let mut all = Vec::new();
    for of_mesh in jobs.chunk_by(|one, other| one.0 == other.0) {
        all.extend_from_slice(of_mesh);
        all.extend(programs.iter().map(|&program| (of_mesh[0].0.clone(), program, None)));
    }
    all
}

fn beside(
    column: ColumnOf<'static, PrintedJob>,
    unit: fn(f64) -> Value,
    number: fn(&PairingRow) -> f64,
) -> ColumnOf<'static, PrintedJob> {
    column.printed(move |printed| {
        printed.row.as_ref().map_or(Value::Missing, |row| unit(number(row)))
    })
}

/// Returns the columns that the paper has too: means over the runs that ended well.
pub fn five_columns<P: 'static>() -> [ColumnOf<'static, P>; 5] {
    [
        columns::mean("pairing_seconds", 0, Value::Seconds, |run| run.measured.pairing_seconds)
            .heading("(a) pairing, s"),
        columns::mean("paired_percent", 0, Value::Percent, |run| run.measured.paired_percent)
            .heading("(b) paired, %"),
        columns::mean_count("unpaired_triangles", 0, |measured| measured.unpaired_triangles)
            .heading("(c) unpaired"),
        columns::mean(
            "augmentation_seconds",
            0,
            Value::Seconds,
            RunRecord::whole_augmentation_seconds,
        )
        .heading("(d) augmentation, s")
        .starred(&[0]),
        columns::mean("total_seconds", 0, Value::Seconds, RunRecord::whole_total_seconds)
            .heading("(e) total, s")
            .starred(&[0]),
    ]
}

/// Returns the columns beside these: pairing without shuffle, runs, spread, flips, outcomes.
///
/// `absent` words why there is no cell.
pub fn spread_columns<P: 'static>(
    absent: fn(&Line<P>) -> &'static str,
) -> Vec<ColumnOf<'static, P>> {
    let total = |name, number: fn(&Statistics) -> f64| {
        of_cell(name, 0, move |cell| {
            let total = cell.statistics(RunRecord::whole_total_seconds)?;
            Some(Value::Seconds(number(&total)))
        })
    };
    let unpaired = |name, number: fn(&Statistics) -> f64| {
        of_cell(name, 0, move |cell| {
            let count = |run: &RunRecord| run.measured.unpaired_triangles.map(|n| n as f64);
            Some(Value::Count(number(&cell.statistics(count)?) as u64))
        })
    };
    vec![
        columns::mean("pairing_seconds_without_shuffle", 0, Value::Seconds, unshuffled)
            .heading("(a) without shuffle, s"),
        columns::ok_runs("n", 0),
        total("total_seconds_median", |total| total.median).heading("(e) median, s").starred(&[0]),
        total("total_seconds_lower_quartile", |total| total.lower_quartile).hidden(),
        total("total_seconds_upper_quartile", |total| total.upper_quartile).hidden(),
        unpaired("unpaired_triangles_least", |unpaired| unpaired.minimum).hidden(),
        unpaired("unpaired_triangles_greatest", |unpaired| unpaired.maximum).hidden(),
        columns::mean_count("edge_flips", 0, |measured| measured.edge_flips).heading("flips"),
        of_cell("edge_flips_percent", 0, flipped_percent).heading("flips, %"),
        columns::outcomes_or("outcomes", 0, absent),
        columns::extrapolated("extrapolated", 0),
    ]
}

/// Returns column (a) without the shuffle of SG and PS; others have none.
fn unshuffled(run: &RunRecord) -> Option<f64> {
    let shuffle = run.measured.shuffle_seconds?;
    Some(run.measured.pairing_seconds? - shuffle)
}

/// Returns the share of edges that were flipped.
pub fn flipped_percent(cell: &Cell) -> Option<Value> {
    let flips = cell.mean_count(|measured| measured.edge_flips);
    let edges = cell.count(|measured| measured.edges).map(|edges| edges as f64);
    quotient(flips, edges).map(|share| Value::Ratio(100.0 * share))
}
