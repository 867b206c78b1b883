//! Time against size: Figures 15 to 18 of the paper on irreducible triangulations, and the same for
//! conversions, with fitted exponents.

use triquad::augmentation::Augmentation;
use triquad::irreducible::Order;
use triquad::pairing::Algorithm;

use super::axis::Spread;
use super::chart::{Chart, Counterpart, Point, Series, legends};
use crate::algorithms::{AlgorithmFacts, Look};
use crate::experiment::{Job, Measured, RunRecord};
use crate::paper::Paper;
use crate::report::power_law::PowerLaw;
use crate::report::summary::{Cell, Summary};

/// A time of a run.
type Time = fn(&RunRecord) -> Option<f64>;

/// Makes the counterparts of Figures 15 to 18.
pub fn figures(summary: &Summary) -> Vec<Chart> {
    let figures = [
        (15, "scans", "scans of Table 2"),
        (16, "B", "box of genus 0 (Table 3)"),
        (17, "C", "box of genus 3,500 (Table 4)"),
        (18, "D", "boxes of growing genus (Table 5)"),
    ];
    figures.map(|(figure, group, meshes)| of_figure(summary, figure, group, meshes)).into()
}

fn of_figure(summary: &Summary, figure: u8, group: &str, meshes: &str) -> Chart {
    let in_file_order = |cell: &&Cell| {
        let job = cell.id.job;
        matches!(job, Job::Reduce { order: Order::File, .. }) || job.is_program()
    };
    let cells = summary.of_group(Paper::Irreducible, group).filter(in_file_order).collect();
    let against_genus = group == "D";
    let chart = chart(
        format!("figure_{figure}"),
        format!("RS, S and BF on the {meshes}"),
        cells,
        |run| run.measured.seconds,
        against_genus,
    );
    let axes = if against_genus {
        "Against the genus, as in the paper; the meshes have about the same number of triangles."
    } else {
        "Logarithmic axes, so that powers are straight lines (those of the paper are linear)."
    };
    let counterpart = Counterpart::Figure(figure);
    Chart { counterpart, caption: format!("{axes} {READING}"), ..chart }
}

/// Advice for reading all of these plots.
const READING: &str = "Points are means of the runs, strokes go from the fastest to the slowest; \
                       n^… is the least-squares exponent with its 95 % interval (Student's t).";

/// Makes the charts of the total time of conversions against the number of triangles.
pub fn totals(summary: &Summary) -> Vec<Chart> {
    let groups = [
        ("scans", "the scans of Table 4.1"),
        ("A", "the box of genus 0"),
        ("B", "the box of genus 3,500"),
        ("data", "other meshes"),
    ];
    let is_published = |cell: &&Cell| {
        let job = cell.id.job;
        let is_tarjan = matches!(job, Job::Convert { augmentation: Augmentation::Tarjan, .. });
        is_tarjan || job.is_program()
    };
    let of_group = |(group, meshes): (&str, &str)| {
        let cells: Vec<&Cell> =
            summary.of_group(Paper::Comparison, group).filter(is_published).collect();
        let has_ours = cells.iter().any(|cell| !cell.id.job.is_program());
        let how = if has_ours { ", as published (tarjan)" } else { "" };
        total(format!("total_{group}"), format!("Total time on {meshes}{how}"), cells)
    };
    let mut charts: Vec<Chart> = groups.into_iter().map(of_group).collect();
    let perfect = |cell: &&Cell| match cell.id.job {
        Job::Convert { algorithm: Algorithm::DiksStanczyk, .. } => true,
        Job::Convert { algorithm, augmentation: Augmentation::Local } => {
            [Algorithm::EagerRescue, Algorithm::GawrychowskiWasylkiewicz].contains(&algorithm)
        }
        _ => false,
    };
    let cells: Vec<&Cell> = summary.of_paper(Paper::Comparison).filter(perfect).collect();
    let is_run = |label: &&str| cells.iter().any(|cell| cell.id.job.facts().label == *label);
    let labels: Vec<&str> = ["TQ", "GW", "DS"].into_iter().filter(is_run).collect();
    let title = format!("Growth of {} on all meshes", labels.join(", "));
    charts.push(total("growth_tq_gw_ds".into(), title, cells));
    charts
}

fn total(stem: String, title: String, cells: Vec<&Cell>) -> Chart {
    chart(stem, title, cells, RunRecord::whole_total_seconds, false)
}

/// Makes a chart with one series for each algorithm among `cells`.
fn chart(stem: String, title: String, cells: Vec<&Cell>, time: Time, against_genus: bool) -> Chart {
    let spread = if against_genus { Spread::Linear } else { Spread::Logarithmic };
    let mut rows: Vec<&AlgorithmFacts> = Vec::new();
    for cell in &cells {
        let facts = cell.id.job.facts();
        if rows.iter().all(|seen| seen.name != facts.name) {
            rows.push(facts);
        }
    }
    // Programs of others may have one look.
    let looks = Look::distinct(&rows.iter().map(|facts| facts.look).collect::<Vec<_>>());
    let series = rows.into_iter().zip(looks).map(|(facts, look)| {
        let own = cells.iter().copied().filter(|cell| cell.id.job.facts().name == facts.name);
        series((facts.label, look), &own.collect::<Vec<_>>(), time, against_genus)
    });
    Chart {
        stem,
        title,
        caption: READING.into(),
        x_name: if against_genus { "genus g" } else { "triangles n" }.into(),
        y_name: "seconds".into(),
        x_spread: spread,
        y_spread: spread,
        series: series.filter(|series| !series.points.is_empty()).collect(),
        notes: legends(cells.iter().copied()),
        ..Chart::default()
    }
}

/// Makes the series of an algorithm's cells, of which there is one.
fn series((name, look): (&str, Look), cells: &[&Cell], time: Time, against_genus: bool) -> Series {
    let points = points(cells, time, against_genus);
    let law: Vec<(f64, f64)> = points.iter().map(|point| (point.x, point.y)).collect();
    // Two points determine a line, whatever the growth.
    let fit = PowerLaw::through(&law).filter(|fit| !against_genus && fit.n > 2);
    Series { name: name.into(), look, is_printed: false, points, joined: true, fit }
}

/// Makes a point for each cell with a run that ended well, from left to right.
fn points(cells: &[&Cell], time: Time, against_genus: bool) -> Vec<Point> {
    let x: fn(&Measured) -> Option<u64> =
        if against_genus { |measured| measured.genus } else { |measured| measured.triangles };
    let point = |cell: &&Cell| {
        let seconds = cell.statistics(time)?;
        Some(Point {
            mesh: cell.mesh().into(),
            origin: cell.origin,
            x: cell.count(x)? as f64,
            y: seconds.mean,
            range: (seconds.n > 1).then_some((seconds.minimum, seconds.maximum)),
            extrapolated: cell.is_extrapolated(),
        })
    };
    let mut points: Vec<Point> = cells.iter().filter_map(point).collect();
    points.sort_by(|a, b| a.x.total_cmp(&b.x));
    points
}
