//! Ratios in rows of meshes: ours to the paper's numbers, LRS to PS.

use triquad::augmentation::Augmentation;
use triquad::pairing::{Algorithm, Expansion};

use super::axis::Spread;
use super::chart::{Chart, Counterpart, Point, Series};
use crate::algorithms::{BLUE, GREEN, GREY, Look, Mark, VERMILION};
use crate::experiment::{Job, RunRecord};
use crate::meshes::Origin;
use crate::paper::{PairingRow, Paper, Table};
use crate::report::notes::Note;
use crate::report::path_price::PathPrice;
use crate::report::summary::{Cell, Summary};

/// Makes every chart of ratios.
pub fn all(summary: &Summary) -> Vec<Chart> {
    vec![
        lrs_against_ps(summary),
        seconds_against_paper(summary),
        unpaired_against_paper(summary),
        tests_against_paper(summary),
    ]
}

/// A number on a mesh.
pub(super) struct Ratio {
    value: f64,
    /// Origin of the mesh of the cells that it is of: of several, a stand-in.
    origin: Option<Origin>,
    extrapolated: bool,
}

impl Ratio {
    /// Takes a number of these cells.
    pub(super) fn of<const N: usize>(cells: [&Cell; N], value: f64) -> Self {
        let origin = cells.iter().find(|cell| cell.is_stand_in()).or(cells.first());
        Self {
            value,
            origin: origin.and_then(|cell| cell.origin),
            extrapolated: cells.iter().any(|cell| cell.is_extrapolated()),
        }
    }

    /// Takes a number of the paper.
    fn printed(value: f64) -> Self {
        Self { value, origin: None, extrapolated: false }
    }

    /// Takes a number that does not depend on times that are extrapolated.
    pub(super) fn exact(self) -> Self {
        Self { extrapolated: false, ..self }
    }
}

/// The meshes of an experiment as rows, and the series of ratios on them.
pub(super) struct Rows<'a> {
    summary: &'a Summary,
    paper: Paper,
    meshes: Vec<&'a str>,
    series: Vec<Series>,
}

impl<'a> Rows<'a> {
    pub(super) fn new(summary: &'a Summary, paper: Paper) -> Self {
        let meshes = summary.meshes(paper).into_iter().map(Cell::mesh).collect();
        Self { summary, paper, meshes, series: Vec::new() }
    }

    /// Adds a series of the ratios that there are, ours or, if `is_printed`, the paper's.
    pub(super) fn add(
        &mut self,
        name: &str,
        look: Look,
        is_printed: bool,
        ratio: impl Fn(&str) -> Option<Ratio>,
    ) {
        let point = |(row, &mesh): (usize, &&str)| {
            let Ratio { value, origin, extrapolated } = ratio(mesh)?;
            Some(Point {
                mesh: mesh.to_owned(),
                origin,
                x: value,
                y: row as f64,
                range: None,
                extrapolated,
            })
        };
        let points: Vec<Point> = self.meshes.iter().enumerate().filter_map(point).collect();
        if !points.is_empty() {
            let name = name.into();
            self.series.push(Series { name, look, is_printed, points, joined: false, fit: None });
        }
    }

    /// Makes the chart, without rows in which nothing is.
    pub(super) fn chart(
        mut self,
        stem: &str,
        title: &str,
        x_name: &str,
        sides: [&'static str; 2],
    ) -> Chart {
        let points = || self.series.iter().flat_map(|series| &series.points);
        let used = |&row: &usize| points().any(|point| point.y as usize == row);
        let kept: Vec<usize> = (0..self.meshes.len()).filter(used).collect();
        let cells = |row: usize| self.summary.of_mesh(self.paper, self.meshes[row]);
        let is_stand_in = |point: &&Point| point.origin == Some(Origin::StandIn);
        // A row is marked for what is shown in it.
        let name = |&row: &usize| {
            let of_row = |point: &&Point| point.y as usize == row;
            let stand_in = points().filter(of_row).find(is_stand_in);
            let dagger = stand_in.and(Some(Origin::StandIn)).map_or("", Origin::dagger);
            format!("{}{dagger}", self.meshes[row])
        };
        let rows = kept.iter().map(name).collect();
        let of_rows: Vec<&Cell> = kept.iter().flat_map(|&row| cells(row)).collect();
        let mut notes = Note::on(of_rows.into_iter());
        notes.retain(|note| match note {
            Note::Extrapolated => points().any(|point| point.extrapolated),
            Note::StandIn => points().any(|point| is_stand_in(&point)),
            _ => true,
        });
        for point in self.series.iter_mut().flat_map(|series| &mut series.points) {
            let row = kept.iter().position(|&row| row == point.y as usize);
            point.y = row.expect("rows with points are kept") as f64;
        }
        Chart {
            stem: stem.into(),
            title: title.into(),
            x_name: x_name.into(),
            y_spread: Spread::Rows,
            rows,
            line: Some((1.0, sides)),
            notes: notes.iter().filter_map(Note::legend).collect(),
            series: self.series,
            ..Chart::default()
        }
    }
}

/// Returns the rows of Tables 4.3 and 4.4.
fn printed_pairings() -> Vec<PairingRow> {
    Table::ALL.iter().flat_map(Table::pairing_rows).collect()
}

/// Charts the time of LRS divided by that of PS, with each augmentation.
fn lrs_against_ps(summary: &Summary) -> Chart {
    let mut rows = Rows::new(summary, Paper::Comparison);
    let jobs = [Algorithm::Lrs(Expansion::Printed), Algorithm::PulliSegal].map(Job::published);
    let look = Look { colour: GREEN, mark: Mark::Up };
    rows.add(Augmentation::Rebuild.id(), look, false, |mesh| lrs_to_ps_rebuilt(summary, mesh));
    let looks = [
        (Augmentation::Tarjan, VERMILION, Mark::Diamond),
        (Augmentation::Local, BLUE, Mark::Square),
    ];
    for (augmentation, colour, mark) in looks {
        rows.add(augmentation.id(), Look { colour, mark }, false, |mesh| {
            let jobs = jobs.map(|job| job.with_augmentation(augmentation));
            let [lrs, ps] = jobs.map(|job| summary.cell(Paper::Comparison, mesh, job));
            lrs_to_ps(lrs?, ps?)
        });
    }
    let printed = printed_pairings();
    rows.add("in the paper", Look { colour: GREY, mark: Mark::Down }, true, |mesh| {
        let total = |job| PairingRow::find(&printed, mesh, job).map(|row| row.total_seconds);
        // The paper's number alone would compare nothing.
        summary.cell(Paper::Comparison, mesh, jobs[0])?.ok_runs().next()?;
        Some(Ratio::printed(total(jobs[0])? / total(jobs[1])?))
    });
    let chart = rows.chart(
        "lrs_against_ps",
        "LRS against PS: does its lead survive a better augmentation?",
        "total time of LRS / total time of PS",
        ["LRS faster", "PS faster"],
    );
    let caption = "Left of the line LRS is faster, right of it PS. rebuild: the graph set up anew \
                   for each path, some paths timed and their mean taken for all; tarjan: \
                   augmentation as published; local: ours. Both of a pair ran on the same machine.";
    Chart { counterpart: Counterpart::LrsAgainstPs, caption: caption.into(), ..chart }
}

/// Returns the quotient of the mean totals with `rebuild`, as the table beside the plot has them.
fn lrs_to_ps_rebuilt(summary: &Summary, mesh: &str) -> Option<Ratio> {
    let algorithms = [Algorithm::Lrs(Expansion::Printed), Algorithm::PulliSegal];
    let [lrs, ps] = algorithms.map(|algorithm| PathPrice::total(summary, mesh, algorithm));
    let ps = ps.filter(|ps| ps.mean > 0.0 && !summary.is_parallel())?;
    let cell = |algorithm| summary.cell(Paper::Comparison, mesh, Job::published(algorithm));
    let [lrs_cell, ps_cell] = algorithms.map(cell);
    Some(Ratio::of([lrs_cell?, ps_cell?], lrs?.mean / ps.mean).exact())
}

/// Returns the quotient of the mean totals, unless the runs disturbed each other.
fn lrs_to_ps(lrs: &Cell, ps: &Cell) -> Option<Ratio> {
    if lrs.is_parallel() || ps.is_parallel() {
        return None;
    }
    let total = |cell: &Cell| cell.mean(RunRecord::whole_total_seconds).filter(|&t| t > 0.0);
    Some(Ratio::of([lrs, ps], total(lrs)? / total(ps)?))
}

/// Charts our total time divided by the paper's.
fn seconds_against_paper(summary: &Summary) -> Chart {
    let rows = against_printed(
        summary,
        |cell| cell.mean(RunRecord::whole_total_seconds),
        |row| row.total_seconds,
    );
    let chart = rows.chart(
        "ratio_total_seconds",
        "Total time, ours against Tables 4.3 and 4.4",
        "our total time / the paper's",
        ["faster than in the paper", "slower"],
    );
    let caption = "Seconds of two machines: where the marks of a row lie shows the machines and the \
                   implementations together. Augmentation as published (tarjan).";
    Chart { caption: caption.into(), ..chart }
}

/// Charts our number of unpaired triangles divided by the paper's.
fn unpaired_against_paper(summary: &Summary) -> Chart {
    let rows = against_printed(
        summary,
        |cell| cell.mean_count(|measured| measured.unpaired_triangles),
        |row| row.unpaired_triangles,
    );
    let chart = rows.chart(
        "ratio_unpaired_triangles",
        "Unpaired triangles, ours against Tables 4.3 and 4.4",
        "our unpaired triangles / the paper's",
        ["fewer than in the paper", "more"],
    );
    let caption = "Column (c), which does not depend on the machine. On a stand-in, compare orders \
                   of magnitude, not digits. DS leaves none, so that it has no ratio.";
    Chart { caption: caption.into(), ..chart }
}

fn against_printed(
    summary: &Summary,
    ours: fn(&Cell) -> Option<f64>,
    theirs: fn(&PairingRow) -> f64,
) -> Rows<'_> {
    let printed = printed_pairings();
    let mut rows = Rows::new(summary, Paper::Comparison);
    for &job in Paper::Comparison.jobs() {
        rows.add(job.facts().label, job.facts().look, false, |mesh| {
            let cell = summary.cell(Paper::Comparison, mesh, job)?;
            let theirs = theirs(PairingRow::find(&printed, mesh, job)?);
            let comparable = cell.is_full_scale() && theirs > 0.0;
            let ours = ours(cell).filter(|&ours| comparable && ours > 0.0)?;
            Some(Ratio::of([cell], ours / theirs))
        });
    }
    rows
}

/// Charts our number of link condition tests divided by the paper's.
fn tests_against_paper(summary: &Summary) -> Chart {
    let printed: Vec<_> = Table::ALL.iter().flat_map(Table::link_test_rows).collect();
    let mut rows = Rows::new(summary, Paper::Irreducible);
    for (at, &job) in Paper::Irreducible.jobs().iter().enumerate() {
        rows.add(job.facts().label, job.facts().look, false, |mesh| {
            let cell = summary.cell(Paper::Irreducible, mesh, job)?;
            let theirs = printed.iter().find(|row| row.mesh == mesh)?.link_condition_tests()[at];
            let ours = cell.mean_count(|measured| measured.link_condition_tests)?;
            cell.is_full_scale().then(|| Ratio::of([cell], ours / theirs))
        });
    }
    let chart = rows.chart(
        "ratio_link_condition_tests",
        "Link condition tests, ours against Tables 6, 8 and 10",
        "our link condition tests / the paper's",
        ["fewer than in the paper", "more"],
    );
    let caption = "Counts, which do not depend on the machine. Simplified meshes have the paper's \
                   number of vertices and genus, not its connectivity.";
    Chart { caption: caption.into(), ..chart }
}
