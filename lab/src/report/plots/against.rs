//! One against the other: ours against the paper's numbers, LRS against PS.

use super::Words;
use super::axis::Spread;
use super::chart::{BLUE, Chart, GREY, Look, Mark, Point, Series, VERMILION, look_of, notes};
use crate::experiment::RunRecord;
use crate::report::paper::{PairingRow, Table};
use crate::report::summary::{Cell, Summary};

/// Every chart of ratios.
pub fn all(summary: &Summary) -> Vec<(Words, Chart)> {
    vec![
        lrs_against_ps(summary),
        seconds_against_paper(summary),
        unpaired_against_paper(summary),
        tests_against_paper(summary),
    ]
}

/// A ratio on a mesh, of one series; `None` where a side has no number.
type Ratio<'a> = dyn Fn(&str) -> Option<(f64, bool)> + 'a;

/// Points in rows of meshes: one for each series and mesh that has a ratio.
struct Rows<'a> {
    summary: &'a Summary,
    experiment: &'static str,
    meshes: Vec<String>,
    series: Vec<Series>,
}

impl<'a> Rows<'a> {
    fn new(summary: &'a Summary, experiment: &'static str, meshes: Vec<String>) -> Self {
        Self { summary, experiment, meshes, series: Vec::new() }
    }

    fn cells(&self, mesh: &str) -> impl Iterator<Item = &'a Cell> + Clone {
        let experiment = self.experiment;
        let cells = self.summary.of_group(experiment, None);
        let own: Vec<&Cell> = cells.filter(|cell| cell.mesh == mesh).collect();
        own.into_iter()
    }

    /// Adds a series of the ratios that there are, on our meshes or, with `printed`, on the paper's.
    fn add(&mut self, name: &str, look: Look, printed: bool, ratio: &Ratio) {
        let point = |(row, mesh): (usize, &String)| {
            let (x, extrapolated) = ratio(mesh)?;
            let kind = self.cells(mesh).next().map(|cell| cell.mesh_kind.clone());
            let mesh_kind = if printed { "printed".into() } else { kind.unwrap_or_default() };
            Some(Point {
                mesh: mesh.clone(),
                mesh_kind,
                x,
                y: row as f64,
                range: None,
                extrapolated,
            })
        };
        let points: Vec<Point> = self.meshes.iter().enumerate().filter_map(point).collect();
        if !points.is_empty() {
            let name = name.into();
            self.series.push(Series { name, look, points, joined: false, fit: None });
        }
    }

    /// The chart, without rows in which nothing is.
    fn chart(mut self, title: &str, x_name: &str, sides: [&str; 2]) -> Chart {
        let used = |row: usize| {
            self.series.iter().flat_map(|s| &s.points).any(|point| point.y as usize == row)
        };
        let kept: Vec<usize> = (0..self.meshes.len()).filter(|&row| used(row)).collect();
        for point in self.series.iter_mut().flat_map(|series| &mut series.points) {
            let row = kept.iter().position(|&row| row == point.y as usize);
            point.y = row.expect("rows with points are kept") as f64;
        }
        let name = |&row: &usize| {
            let mesh = &self.meshes[row];
            let stand_in = self.cells(mesh).any(Cell::is_stand_in);
            format!("{mesh}{}", if stand_in { "†" } else { "" })
        };
        let cells: Vec<&Cell> =
            kept.iter().flat_map(|&row| self.cells(&self.meshes[row])).collect();
        let mut notes = notes(cells.into_iter());
        let is_shown = |note: &String| {
            let points = || self.series.iter().flat_map(|series| &series.points);
            !note.starts_with('*') || points().any(|point| point.extrapolated)
        };
        notes.retain(is_shown);
        Chart {
            title: title.into(),
            x_name: x_name.into(),
            y_name: String::new(),
            x_spread: Spread::Logarithmic,
            y_spread: Spread::Rows,
            rows: kept.iter().map(name).collect(),
            bars: Vec::new(),
            line: Some((1.0, sides.map(str::to_owned))),
            notes,
            series: self.series,
        }
    }
}

/// The meshes of an experiment in their order.
fn meshes_of(summary: &Summary, experiment: &str) -> Vec<String> {
    let mut meshes: Vec<String> =
        summary.of_group(experiment, None).map(|cell| cell.mesh.clone()).collect();
    meshes.dedup();
    meshes
}

/// The rows of Tables 4.3 and 4.4.
fn printed_pairings() -> Vec<PairingRow> {
    let tables = ["4.3", "4.4(i)", "4.4(ii)"].into_iter().filter_map(Table::numbered);
    tables.flat_map(|table| table.pairing_rows()).collect()
}

/// Time of LRS divided by that of PS, with either augmentation.
fn lrs_against_ps(summary: &Summary) -> (Words, Chart) {
    let mut rows = Rows::new(summary, "comparison", meshes_of(summary, "comparison"));
    let looks = [("tarjan", VERMILION, Mark::Diamond), ("local", BLUE, Mark::Square)];
    for (how, colour, mark) in looks {
        let ratio = |mesh: &str| {
            let cell = |algorithm| summary.cell("comparison", mesh, algorithm, None, how);
            lrs_to_ps(cell("lrs")?, cell("ps")?)
        };
        rows.add(how, Look { colour, mark }, false, &ratio);
    }
    let printed = printed_pairings();
    let in_paper = |mesh: &str| {
        let total = |algorithm: &str| {
            let row = printed.iter().find(|row| row.mesh == mesh && row.algorithm == algorithm);
            row.map(|row| row.total_seconds)
        };
        // Where nothing of ours is, the paper's alone would say nothing.
        summary.cell("comparison", mesh, "lrs", None, "tarjan")?.ok_runs().next()?;
        Some((total("lrs")? / total("ps")?, false))
    };
    rows.add("in the paper", Look { colour: GREY, mark: Mark::Down }, true, &in_paper);
    let chart = rows.chart(
        "LRS against PS: does its lead survive a better augmentation?",
        "total time of LRS / total time of PS",
        ["LRS faster", "PS faster"],
    );
    let caption = "Left of the line LRS is faster, right of it PS. tarjan: augmentation as \
                   published; local: ours. Both of a pair ran on the same machine.";
    (Words { figure: "", stem: "lrs_against_ps".into(), caption: caption.into() }, chart)
}

/// The quotient of the mean totals, unless the runs disturbed each other.
pub fn lrs_to_ps(lrs: &Cell, ps: &Cell) -> Option<(f64, bool)> {
    if lrs.is_parallel() || ps.is_parallel() {
        return None;
    }
    let total = |cell: &Cell| cell.mean(RunRecord::whole_total_seconds).filter(|&t| t > 0.0);
    Some((total(lrs)? / total(ps)?, lrs.is_extrapolated() || ps.is_extrapolated()))
}

/// Our total time divided by the paper's.
fn seconds_against_paper(summary: &Summary) -> (Words, Chart) {
    let chart = against_printed(
        summary,
        "Total time, ours against Tables 4.3 and 4.4",
        "our total time / the paper's",
        ["faster than in the paper", "slower"],
        |cell| cell.mean(RunRecord::whole_total_seconds),
        |row| row.total_seconds,
    );
    let caption = "Seconds of two machines about fifteen years apart: where the marks of a row lie \
                   shows the machines and the implementations together. Augmentation as published \
                   (tarjan).";
    (Words { figure: "", stem: "ratio_total_seconds".into(), caption: caption.into() }, chart)
}

/// Our number of unpaired triangles divided by the paper's.
fn unpaired_against_paper(summary: &Summary) -> (Words, Chart) {
    let chart = against_printed(
        summary,
        "Unpaired triangles, ours against Tables 4.3 and 4.4",
        "our unpaired triangles / the paper's",
        ["fewer than in the paper", "more"],
        |cell| cell.mean(|run| run.unpaired_triangles.map(|count| count as f64)),
        |row| row.unpaired_triangles,
    );
    let caption = "Column (c), which no machine changes. On a stand-in it is comparable in kind, not \
                   in its digits. DS leaves none, so that it has no ratio.";
    (Words { figure: "", stem: "ratio_unpaired_triangles".into(), caption: caption.into() }, chart)
}

fn against_printed(
    summary: &Summary,
    title: &str,
    x_name: &str,
    sides: [&str; 2],
    ours: fn(&Cell) -> Option<f64>,
    theirs: fn(&PairingRow) -> f64,
) -> Chart {
    let printed = printed_pairings();
    let mut rows = Rows::new(summary, "comparison", meshes_of(summary, "comparison"));
    for algorithm in ["sg", "ps", "ds", "lrs"] {
        let ratio = |mesh: &str| {
            let cell = summary.cell("comparison", mesh, algorithm, None, "tarjan")?;
            let row = printed.iter().find(|row| row.mesh == mesh && row.algorithm == algorithm)?;
            let comparable = cell.scale == "full" && theirs(row) > 0.0;
            Some((
                ours(cell).filter(|&ours| comparable && ours > 0.0)? / theirs(row),
                cell.is_extrapolated(),
            ))
        };
        rows.add(&algorithm.to_uppercase(), look_of(algorithm, None), false, &ratio);
    }
    rows.chart(title, x_name, sides)
}

/// Our number of link condition tests divided by the paper's.
fn tests_against_paper(summary: &Summary) -> (Words, Chart) {
    let tables = ["6", "8", "10"].into_iter().filter_map(Table::numbered);
    let printed: Vec<_> = tables.flat_map(|table| table.link_test_rows()).collect();
    let mut rows = Rows::new(summary, "irreducible", meshes_of(summary, "irreducible"));
    for (algorithm, name) in [("rs", "RS"), ("schipper", "S"), ("brute-force", "BF")] {
        let ratio = |mesh: &str| {
            let cell = summary.cell("irreducible", mesh, algorithm, None, "file")?;
            let row = printed.iter().find(|row| row.mesh == mesh)?;
            let theirs = match algorithm {
                "rs" => row.rs_link_condition_tests,
                "schipper" => row.schipper_link_condition_tests,
                _ => row.brute_force_link_condition_tests,
            };
            let ours = cell.mean(|run| run.link_condition_tests.map(|count| count as f64))?;
            (cell.scale == "full").then_some((ours / theirs, false))
        };
        rows.add(name, look_of(algorithm, None), false, &ratio);
    }
    let chart = rows.chart(
        "Link condition tests, ours against Tables 6, 8 and 10",
        "our link condition tests / the paper's",
        ["fewer than in the paper", "more"],
    );
    let caption = "Counts, which no machine changes. Simplified meshes have the paper's number of \
                   vertices and genus, not its connectivity.";
    (
        Words { figure: "", stem: "ratio_link_condition_tests".into(), caption: caption.into() },
        chart,
    )
}
