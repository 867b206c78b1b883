//! Time against size: Figures 15 to 18 of the paper on irreducible triangulations, and the same for
//! conversions, with fitted exponents.

use super::Words;
use super::axis::Spread;
use super::chart::{Chart, Point, Series, look_of, notes};
use crate::experiment::RunRecord;
use crate::report::fit::PowerLaw;
use crate::report::summary::{Cell, Summary};

/// A number of a run.
type Number = fn(&RunRecord) -> Option<f64>;

/// The counterparts of Figures 15 to 18.
pub fn figures(summary: &Summary) -> Vec<(Words, Chart)> {
    let figures = [
        ("Figure 15", "scans", "scans of Table 2"),
        ("Figure 16", "B", "box of genus 0 (Table 3)"),
        ("Figure 17", "C", "box of genus 3,500 (Table 4)"),
        ("Figure 18", "D", "boxes of growing genus (Table 5)"),
    ];
    figures.map(|(figure, group, meshes)| of_figure(summary, figure, group, meshes)).into()
}

fn of_figure(summary: &Summary, figure: &'static str, group: &str, meshes: &str) -> (Words, Chart) {
    let cells: Vec<&Cell> =
        summary.of_group("irreducible", Some(group)).filter(|cell| cell.how() == "file").collect();
    let against_genus = group == "D";
    let chart = Chart {
        title: format!("RS, S and BF on the {meshes}"),
        x_name: if against_genus { "genus g" } else { "triangles n" }.into(),
        x_spread: if against_genus { Spread::Linear } else { Spread::Logarithmic },
        y_spread: if against_genus { Spread::Linear } else { Spread::Logarithmic },
        series: all_series(&cells, |run| run.seconds, against_genus),
        notes: notes(cells.iter().copied()),
        ..time_chart()
    };
    let axes = if against_genus {
        "Against the genus, as in the paper; the meshes have about the same number of triangles."
    } else {
        "Logarithmic axes, so that powers are straight lines (those of the paper are linear)."
    };
    let caption = format!("{axes} {READING}");
    let number = figure.trim_start_matches("Figure ");
    (Words { figure, stem: format!("figure_{number}"), caption }, chart)
}

/// What holds for all of these plots.
const READING: &str = "Points are means of the runs, strokes go from the fastest to the slowest; \
                       n^… is the least-squares exponent with its 95 % interval (Student's t).";

/// A chart of seconds without anything in it.
fn time_chart() -> Chart {
    Chart {
        title: String::new(),
        x_name: "triangles n".into(),
        y_name: "seconds".into(),
        x_spread: Spread::Logarithmic,
        y_spread: Spread::Logarithmic,
        rows: Vec::new(),
        series: Vec::new(),
        bars: Vec::new(),
        line: None,
        notes: Vec::new(),
    }
}

/// Total time of conversions against the number of triangles.
pub fn totals(summary: &Summary) -> Vec<(Words, Chart)> {
    let groups = [
        ("scans", "Total time on the scans of Table 4.1", "as published (tarjan)"),
        ("A", "Total time on the box of genus 0", "as published (tarjan)"),
        ("B", "Total time on the box of genus 3,500", "as published (tarjan)"),
        ("data", "Total time on other scans", "as published (tarjan)"),
    ];
    let mut charts: Vec<_> = groups
        .map(|(group, title, how)| {
            let cells = summary.of_group("comparison", Some(group));
            let cells: Vec<&Cell> = cells.filter(|cell| cell.how() == "tarjan").collect();
            let title = format!("{title}, {how}");
            (format!("total_{group}"), total(title, &cells))
        })
        .into();
    let ours = |cell: &&Cell| {
        let local = ["tq", "gw"].contains(&cell.algorithm.as_str()) && cell.how() == "local";
        local || cell.algorithm == "ds"
    };
    let cells: Vec<&Cell> = summary.of_group("comparison", None).filter(ours).collect();
    let title = "Growth of TQ, GW and DS on all meshes".to_owned();
    charts.push(("growth_tq_gw_ds".into(), total(title, &cells)));
    charts
        .into_iter()
        .map(|(stem, chart)| (Words { figure: "", stem, caption: READING.into() }, chart))
        .collect()
}

fn total(title: String, cells: &[&Cell]) -> Chart {
    Chart {
        title,
        series: all_series(cells, RunRecord::whole_total_seconds, false),
        notes: notes(cells.iter().copied()),
        ..time_chart()
    }
}

/// One series for each algorithm.
fn all_series(cells: &[&Cell], number: Number, against_genus: bool) -> Vec<Series> {
    let mut names: Vec<String> = cells.iter().map(|cell| name_of(cell)).collect();
    let mut seen = Vec::new();
    names.retain(|name| {
        !seen.contains(name) && {
            seen.push(name.clone());
            true
        }
    });
    let series = names.into_iter().map(|name| {
        let own: Vec<&Cell> = cells.iter().copied().filter(|cell| name_of(cell) == name).collect();
        let look = look_of(&own[0].algorithm, own[0].lrs_variant.as_deref());
        let points = points(&own, number, against_genus);
        let law: Vec<(f64, f64)> = points.iter().map(|point| (point.x, point.y)).collect();
        let fit = if against_genus { None } else { PowerLaw::through(&law) };
        Series { name, look, points, joined: true, fit }
    });
    series.filter(|series| !series.points.is_empty()).collect()
}

/// The name of an algorithm without its augmentation, which the title tells.
fn name_of(cell: &Cell) -> String {
    cell.label().trim_end_matches(" local").to_owned()
}

/// A point for each cell with a run that ended well, from left to right.
fn points(cells: &[&Cell], number: Number, against_genus: bool) -> Vec<Point> {
    let x: fn(&RunRecord) -> Option<u64> =
        if against_genus { |run| run.genus } else { |run| run.triangles };
    let point = |cell: &&Cell| {
        let seconds = cell.statistics(number)?;
        Some(Point {
            mesh: cell.mesh.clone(),
            mesh_kind: cell.mesh_kind.clone(),
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
