//! Tables that the papers do not have: both augmentations side by side, other meshes, what edge flips
//! do to the quads, memory, every irreducible triangulation.

use super::ReportTable;
use super::columns::{self, MESH, header, mean};
use super::pairing::{BESIDE, PRINTED, beside_columns, printed_columns};
use crate::experiment::RunRecord;
use crate::report::number::{mean_count, or_empty, quotient, seconds, significant};
use crate::report::summary::{Cell, Summary};

/// All of them.
pub fn all(summary: &Summary) -> Vec<ReportTable> {
    vec![
        augmentation(summary),
        data(summary),
        quality(summary),
        irreducible(summary),
        memory(summary),
    ]
}

/// A table of cells, one a row: mesh and algorithm, then `names`, filled by `fields`.
fn of_cells(
    (file, title): (&'static str, &str),
    cells: &[&Cell],
    names: &[&[&str]],
    fields: impl Fn(&Cell) -> Vec<String>,
) -> ReportTable {
    let row = |cell: &&Cell| {
        let mut row = vec![cell.mesh.clone(), cell.label()];
        row.extend(fields(cell));
        row
    };
    let names: Vec<&[&str]> =
        [["mesh", "algorithm"].as_slice()].iter().chain(names).copied().collect();
    ReportTable {
        number: "",
        file,
        title: title.into(),
        header: header(&names),
        rows: cells.iter().map(row).collect(),
        notes: columns::notes(cells),
    }
}

/// What both augmentations have a column for.
const SEARCH: [&str; 8] = [
    "outcomes",
    "unpaired_triangles",
    "augmenting_paths",
    "path_length_mean",
    "path_length_max",
    "triangles_visited",
    "augmentation_seconds",
    "total_seconds",
];

/// `tarjan` beside `local`, for every algorithm.
fn augmentation(summary: &Summary) -> ReportTable {
    let cells = of_experiment(summary, "comparison");
    let pairs = beside_each_other(&cells);
    let rows = pairs.iter().map(|(first, [tarjan, local])| {
        let name = first.label();
        let mut row = vec![first.mesh.clone(), name.trim_end_matches(" local").to_owned()];
        row.extend(columns::of_mesh([*first].into_iter()));
        row.extend(search(*tarjan).into_iter().chain(search(*local)));
        let whole =
            |cell: &Option<&Cell>| cell.and_then(|c| c.mean(RunRecord::whole_total_seconds));
        let parallel = [tarjan, local].into_iter().flatten().any(|cell| cell.is_parallel());
        let gain = quotient(whole(tarjan), whole(local)).filter(|_| !parallel);
        row.extend([columns::extrapolated(*tarjan), or_empty(gain, significant)]);
        row
    });
    let tarjan = SEARCH.map(|name| format!("tarjan_{name}"));
    let local = SEARCH.map(|name| format!("local_{name}"));
    let mut names = header(&[&["mesh", "algorithm"], &MESH]);
    names.extend(tarjan.into_iter().chain(local));
    names.extend(header(&[&["tarjan_extrapolated", "total_seconds_tarjan_to_local"]]));
    ReportTable {
        number: "",
        file: "table_augmentation.csv",
        title: "The augmentation as published beside the one that touches what it visits only"
            .into(),
        header: names,
        rows: rows.collect(),
        notes: columns::notes(&cells),
    }
}

/// Each algorithm on each mesh once, with its cells of either augmentation.
fn beside_each_other<'a>(cells: &[&'a Cell]) -> Vec<(&'a Cell, [Option<&'a Cell>; 2])> {
    let same = |one: &Cell, other: &Cell| {
        let name = |cell: &Cell| {
            let Cell { scale, group, mesh, algorithm, lrs_variant, .. } = cell.clone();
            (scale, group, mesh, algorithm, lrs_variant)
        };
        name(one) == name(other)
    };
    let groups = cells.chunk_by(|one, other| same(one, other));
    let with = |group: &[&'a Cell], how| group.iter().find(|cell| cell.how() == how).copied();
    groups.map(|group| (group[0], [with(group, "tarjan"), with(group, "local")])).collect()
}

/// The columns [`SEARCH`].
fn search(cell: Option<&Cell>) -> [String; 8] {
    let count = |number: fn(&RunRecord) -> Option<u64>| {
        or_empty(cell.and_then(|cell| cell.mean(|run| number(run).map(|n| n as f64))), mean_count)
    };
    let number = |number: fn(&RunRecord) -> Option<f64>, write: fn(f64) -> String| {
        mean(cell.and_then(|cell| cell.statistics(number)), write)
    };
    [
        columns::outcomes(cell),
        count(|run| run.unpaired_triangles),
        count(|run| run.augmenting_paths),
        number(|run| run.augmenting_path_length_mean, significant),
        count(|run| run.augmenting_path_length_max),
        count(|run| run.augmentation_triangles_visited),
        number(RunRecord::whole_augmentation_seconds, seconds),
        number(RunRecord::whole_total_seconds, seconds),
    ]
}

/// Meshes that the papers do not have.
fn data(summary: &Summary) -> ReportTable {
    let cells: Vec<&Cell> = summary.of_group("comparison", Some("data")).collect();
    of_cells(("table_data.csv", "Other real meshes"), &cells, &[&PRINTED, &MESH, &BESIDE], |cell| {
        let mut fields = Vec::from(printed_columns(Some(cell)));
        fields.extend(columns::of_mesh([cell].into_iter()));
        fields.extend(beside_columns(Some(cell)));
        fields
    })
}

/// The shape of the quads.
fn quality(summary: &Summary) -> ReportTable {
    let cells = of_experiment(summary, "comparison");
    let names = ["scaled_jacobian_mean", "scaled_jacobian_minimum", "edge_flips_percent", "n"];
    let title = "Scaled Jacobian of the quads by algorithm: what edge flips cost";
    of_cells(("table_quality.csv", title), &cells, &[&MESH, &names, &["outcomes"]], |cell| {
        let least = cell.statistics(|run| run.quality_minimum).map(|found| found.minimum);
        let flips = &beside_columns(Some(cell))[5];
        let mut fields = Vec::from(columns::of_mesh([cell].into_iter()));
        fields.extend([
            or_empty(cell.mean(|run| run.quality_mean), significant),
            or_empty(least, significant),
            flips.clone(),
            cell.ok_runs().count().to_string(),
            columns::outcomes(Some(cell)),
        ]);
        fields
    })
}

/// Every irreducible triangulation, in either order of the input.
fn irreducible(summary: &Summary) -> ReportTable {
    let cells = of_experiment(summary, "irreducible");
    let names = [
        "n",
        "seconds",
        "seconds_median",
        "seconds_lower_quartile",
        "seconds_upper_quartile",
        "link_condition_tests",
        "edges_tested_more_than_once",
        "result_vertices",
        "result_triangles",
        "outcomes",
    ];
    let title = "Irreducible triangulations: times, tests and sizes";
    of_cells(("table_irreducible.csv", title), &cells, &[&MESH, &names], |cell| {
        let time = cell.statistics(|run| run.seconds);
        let count = |number: fn(&RunRecord) -> Option<u64>| {
            or_empty(cell.mean(|run| number(run).map(|n| n as f64)), mean_count)
        };
        let mut fields = Vec::from(columns::of_mesh([cell].into_iter()));
        fields.extend([
            cell.ok_runs().count().to_string(),
            mean(time, seconds),
            or_empty(time, |time| seconds(time.median)),
            or_empty(time, |time| seconds(time.lower_quartile)),
            or_empty(time, |time| seconds(time.upper_quartile)),
            count(|run| run.link_condition_tests),
            count(|run| run.edges_tested_more_than_once),
            count(|run| run.result_vertices),
            count(|run| run.result_triangles),
            columns::outcomes(Some(cell)),
        ]);
        fields
    })
}

/// Peak memory of whole processes.
fn memory(summary: &Summary) -> ReportTable {
    let cells: Vec<&Cell> = summary.cells().iter().collect();
    let names = ["n", "peak_memory_bytes", "peak_memory_bytes_per_triangle", "outcomes"];
    let title = "Peak memory of the process, mesh and program included";
    of_cells(("table_memory.csv", title), &cells, &[&MESH, &names], |cell| {
        let peak = cell.mean(|run| run.peak_memory_bytes.map(|bytes| bytes as f64));
        let triangles = cell.count(|run| run.triangles).map(|count| count as f64);
        let mut fields = Vec::from(columns::of_mesh([cell].into_iter()));
        fields.extend([
            cell.ok_runs().count().to_string(),
            or_empty(peak, |bytes| format!("{bytes:.0}")),
            or_empty(quotient(peak, triangles), significant),
            columns::outcomes(Some(cell)),
        ]);
        fields
    })
}

fn of_experiment<'a>(summary: &'a Summary, experiment: &'a str) -> Vec<&'a Cell> {
    summary.of_group(experiment, None).collect()
}
