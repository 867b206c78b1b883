//! Tables that the papers do not have: both augmentations side by side, other meshes, what edge
//! flips do to the quads, memory, every irreducible triangulation.

use triquad::augmentation::Augmentation;

use super::columns::{self, ColumnOf, Line, NOT_PLANNED, column, mean, mean_count, of_cell, table};
use super::pairings::{five_columns, flipped_percent, spread_columns};
use super::table::{ReportTable, Value};
use crate::experiment::RunRecord;
use crate::paper::Paper;
use crate::report::number::quotient;
use crate::report::statistics::Statistics;
use crate::report::summary::{Cell, Summary};

/// A column of a table without a counterpart.
pub(super) type OwnColumn = ColumnOf<'static, ()>;

/// File of the table with both augmentations; its last column is the ratio of their times.
pub const AUGMENTATION: &str = "table_augmentation.csv";

/// Makes all of them.
pub fn all(summary: &Summary) -> Vec<ReportTable> {
    vec![
        augmentation(summary),
        data(summary),
        quality(summary),
        irreducible(summary),
        memory(summary),
    ]
}

/// Returns the line of one cell.
fn line(cell: &Cell) -> Line<'_, ()> {
    Line { mesh: cell.mesh().into(), of_mesh: vec![cell], cells: vec![Some(cell)], paper: None }
}

/// Makes a table of cells, one a row: mesh and algorithm, then `columns`.
pub(super) fn of_cells<'a>(
    (file, title): (&'static str, &'static str),
    cells: impl Iterator<Item = &'a Cell>,
    columns: impl IntoIterator<Item = OwnColumn>,
) -> ReportTable {
    let label = of_cell("algorithm", 0, |cell| Some(Value::Text(cell.label())));
    let columns = std::iter::once(label).chain(columns).collect();
    table(file, title, columns, &cells.map(line).collect::<Vec<_>>())
}

/// Puts `tarjan` beside `local`, for every algorithm.
fn augmentation(summary: &Summary) -> ReportTable {
    // Programs that are not ours have neither.
    let is_ours = |cell: &&Cell| !cell.id.job.is_program();
    let cells: Vec<&Cell> = summary.of_paper(Paper::Comparison).filter(is_ours).collect();
    let bare = |cell: &Cell| {
        let job = cell.id.job.with_augmentation(Augmentation::Tarjan);
        (cell.id.mesh.clone(), job)
    };
    let pairs = cells.chunk_by(|one, other| bare(one) == bare(other)).map(|group: &[&Cell]| {
        let with = |augmentation: Augmentation| {
            let job = group[0].id.job.with_augmentation(augmentation);
            group.iter().copied().find(|cell| cell.id.job == job)
        };
        let cells = [Augmentation::Tarjan, Augmentation::Local].map(with).into();
        Line { cells, ..line(group[0]) }
    });
    let label = |line: &Line<()>| Value::Text(line.of_mesh[0].id.job.facts().label.into());
    let mut columns = vec![column("algorithm", label)];
    columns.extend(columns::mesh());
    columns.extend(search_columns("tarjan", 0, &[0]).into_iter().chain(search_columns(
        "local",
        1,
        &[1],
    )));
    columns.push(columns::extrapolated("tarjan_extrapolated", 0));
    let gain = column("total_seconds_tarjan_to_local", gain).starred(&[0, 1]);
    columns.push(gain.heading("(e) tarjan / local"));
    let title = "The augmentation as published beside the one that touches what it visits only";
    table(AUGMENTATION, title, columns, &pairs.collect::<Vec<_>>())
}

/// Returns the total time with `tarjan` divided by that with `local`.
fn gain(line: &Line<()>) -> Value {
    let parallel = line.cells.iter().flatten().any(|cell| cell.is_parallel());
    let total = |at: usize| line.cells[at]?.mean(RunRecord::whole_total_seconds);
    quotient(total(0), total(1)).filter(|_| !parallel).map_or(Value::Missing, Value::Ratio)
}

/// Returns the columns that both augmentations have.
fn search_columns(prefix: &str, at: usize, star: &'static [usize]) -> [OwnColumn; 9] {
    let name = |name: &str| format!("{prefix}_{name}");
    let heading = |heading: &str| format!("{heading}, {prefix}");
    let length = |run: &RunRecord| run.measured.augmenting_path_length_mean;
    let seconds = |what, number| mean(name(what), at, Value::Seconds, number).starred(star);
    [
        columns::ok_runs(name("n"), at).hidden(),
        columns::outcomes(name("outcomes"), at).heading(heading("runs")),
        mean_count(name("unpaired_triangles"), at, |measured| measured.unpaired_triangles)
            .heading(heading("(c)")),
        // Half of the unpaired triangles.
        mean_count(name("augmenting_paths"), at, |measured| measured.augmenting_paths).hidden(),
        mean(name("path_length_mean"), at, Value::Ratio, length).heading(heading("mean path")),
        mean_count(name("path_length_max"), at, |measured| measured.augmenting_path_length_max)
            .heading(heading("longest path")),
        mean_count(name("triangles_visited"), at, |run| run.augmentation_triangles_visited)
            .heading(heading("visited")),
        seconds("augmentation_seconds", RunRecord::whole_augmentation_seconds)
            .heading(heading("(d) s")),
        seconds("total_seconds", RunRecord::whole_total_seconds).heading(heading("(e) s")),
    ]
}

/// Lists times: of meshes that the papers do not have; if nothing is the papers' own, of all.
fn data(summary: &Summary) -> ReportTable {
    let columns = five_columns().into_iter().chain(columns::mesh());
    let columns = columns.chain(spread_columns(|_| NOT_PLANNED));
    if summary.is_own() {
        let names = ("table_data.csv", "Times and unpaired triangles");
        return of_cells(names, summary.of_paper(Paper::Comparison), columns);
    }
    let names = ("table_data.csv", "Meshes that the papers do not have");
    let table = of_cells(names, summary.of_group(Paper::Comparison, "data"), columns);
    ReportTable { group: Some((Paper::Comparison, "data")), ..table }
}

/// Lists the shape of the quads.
fn quality(summary: &Summary) -> ReportTable {
    let names =
        ("table_quality.csv", "Scaled Jacobian of the quads by algorithm: what edge flips cost");
    let least = |cell: &Cell| {
        let found = cell.statistics(|run| run.measured.quality_minimum)?;
        Some(Value::Ratio(found.minimum))
    };
    let columns = [
        mean("scaled_jacobian_mean", 0, Value::Ratio, |run| run.measured.quality_mean),
        of_cell("scaled_jacobian_minimum", 0, least),
        of_cell("edge_flips_percent", 0, flipped_percent),
        columns::ok_runs("n", 0),
        columns::outcomes("outcomes", 0),
    ];
    let columns = columns::mesh().into_iter().chain(columns);
    let shape = |cell: &Cell| {
        cell.mean(|run| run.measured.quality_mean.or(run.measured.quality_minimum)).is_some()
            || flipped_percent(cell).is_some()
    };
    of_cells(names, with_number(summary.of_paper(Paper::Comparison), shape), columns)
}

/// Leaves out cells whose runs ended well and have no number to show, as imported ones may.
fn with_number<'a>(
    cells: impl Iterator<Item = &'a Cell>,
    has_number: impl Fn(&Cell) -> bool,
) -> impl Iterator<Item = &'a Cell> {
    cells.filter(move |cell| cell.ok_runs().next().is_none() || has_number(cell))
}

/// Lists every irreducible triangulation, in either order of the input.
fn irreducible(summary: &Summary) -> ReportTable {
    let names = ("table_irreducible.csv", "Irreducible triangulations: times, tests and sizes");
    let seconds = |name: &'static str, number: fn(&Statistics) -> f64| {
        of_cell(name, 0, move |cell| {
            let time = cell.statistics(|run| run.measured.seconds)?;
            Some(Value::Seconds(number(&time)))
        })
    };
    let columns = [
        columns::ok_runs("n", 0),
        seconds("seconds", |time| time.mean).heading("t, s"),
        seconds("seconds_median", |time| time.median).heading("t, median"),
        seconds("seconds_lower_quartile", |time| time.lower_quartile).hidden(),
        seconds("seconds_upper_quartile", |time| time.upper_quartile).hidden(),
        mean_count("link_condition_tests", 0, |measured| measured.link_condition_tests)
            .heading("ℓ"),
        mean_count("edges_tested_more_than_once", 0, |run| run.edges_tested_more_than_once)
            .heading("ε"),
        mean_count("link_vertices_visited", 0, |measured| measured.link_vertices_visited)
            .heading("visited"),
        mean_count("degree_products", 0, |measured| measured.degree_products).heading("d·d"),
        mean_count("result_vertices", 0, |measured| measured.result_vertices)
            .heading("vertices left"),
        mean_count("result_triangles", 0, |measured| measured.result_triangles)
            .heading("triangles left"),
        columns::outcomes("outcomes", 0),
    ];
    let columns = columns::mesh().into_iter().chain(columns);
    of_cells(names, summary.of_paper(Paper::Irreducible), columns)
}

/// Lists the peak memory of whole processes.
fn memory(summary: &Summary) -> ReportTable {
    let names = ("table_memory.csv", "Peak memory of the process, mesh and program included");
    let peak = |cell: &Cell| cell.mean_count(|measured| measured.peak_memory_bytes);
    let a_triangle = move |cell: &Cell| {
        let triangles = cell.count(|measured| measured.triangles).map(|count| count as f64);
        quotient(peak(cell), triangles).map(Value::Ratio)
    };
    let columns = [
        columns::ok_runs("n", 0),
        of_cell("peak_memory_bytes", 0, move |cell| peak(cell).map(Value::Bytes)),
        of_cell("peak_memory_bytes_per_triangle", 0, a_triangle),
        columns::outcomes("outcomes", 0),
    ];
    let cells = with_number(summary.cells().iter(), move |cell| peak(cell).is_some());
    of_cells(names, cells, columns::mesh().into_iter().chain(columns))
}
