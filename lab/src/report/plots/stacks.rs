//! Where the time goes: (a) and (d) of Tables 4.3 and 4.4, one bar a row.

use super::Words;
use super::axis::Spread;
use super::chart::{Bar, Chart, notes};
use crate::experiment::RunRecord;
use crate::report::paper::{PairingRow, Table};
use crate::report::summary::{Cell, Summary};

/// A chart for each of the three tables.
pub fn all(summary: &Summary) -> Vec<(Words, Chart)> {
    let tables = [("4.3", "4_3", "Table 4.3"), ("4.4(i)", "4_4_i", "Table 4.4(i)")];
    let tables = tables.into_iter().chain([("4.4(ii)", "4_4_ii", "Table 4.4(ii)")]);
    tables.map(|(number, stem, figure)| of_table(summary, number, stem, figure)).collect()
}

fn of_table(summary: &Summary, number: &str, stem: &str, figure: &'static str) -> (Words, Chart) {
    let printed = Table::numbered(number).expect("a table of the paper").pairing_rows();
    let mut meshes: Vec<&str> = printed.iter().map(|row| row.mesh.as_str()).collect();
    meshes.dedup();
    let (mut rows, mut bars, mut cells) = (Vec::new(), Vec::new(), Vec::new());
    for mesh in meshes {
        for algorithm in ["sg", "ps", "ds", "lrs"] {
            let Some(cell) = summary.cell("comparison", mesh, algorithm, None, "tarjan") else {
                continue;
            };
            let row = printed.iter().find(|row| row.mesh == mesh && row.algorithm == algorithm);
            let first = cells.last().is_none_or(|before: &&Cell| before.mesh != cell.mesh);
            rows.push(row_name(cell, first));
            bars.push(bar(cell, row, bars.len()));
            cells.push(cell);
        }
    }
    let chart = Chart {
        title: format!("Where the time goes: {figure}"),
        x_name: "seconds".into(),
        y_name: String::new(),
        x_spread: Spread::Logarithmic,
        y_spread: Spread::Rows,
        rows,
        series: Vec::new(),
        bars: if cells.iter().any(|cell| cell.ok_runs().next().is_some()) { bars } else { vec![] },
        line: None,
        notes: notes(cells.into_iter()),
    };
    let caption = "Column (e) is where a bar ends, column (a) where its first part ends. The axis is \
                   logarithmic: read the ends, not the lengths. The triangle is the paper's total on \
                   its own machine. Augmentation as published (tarjan).";
    (Words { figure, stem: format!("stack_{stem}"), caption: caption.into() }, chart)
}

/// The algorithm, after the mesh if it is the first there.
fn row_name(cell: &Cell, first: bool) -> String {
    let mark = if cell.is_stand_in() { "†" } else { "" };
    if first { format!("{}{mark}  {}", cell.mesh, cell.label()) } else { cell.label() }
}

fn bar(cell: &Cell, printed: Option<&PairingRow>, row: usize) -> Bar {
    let pairing = cell.mean(|run| run.pairing_seconds);
    let total = cell.mean(RunRecord::whole_total_seconds);
    let star = if cell.is_extrapolated() { " *" } else { "" };
    let text = match total {
        Some(total) => format!("{}{star}", brief(total)),
        None => cell.outcome_text(),
    };
    Bar {
        row,
        mesh: cell.mesh.clone(),
        mesh_kind: cell.mesh_kind.clone(),
        label: cell.label(),
        parts: pairing.zip(total).map(|(pairing, total)| [pairing, total]),
        text,
        extrapolated: cell.is_extrapolated(),
        paper: printed.filter(|_| cell.scale == "full").map(|row| row.total_seconds),
    }
}

/// Seconds in few characters.
fn brief(seconds: f64) -> String {
    let (value, unit) = match seconds {
        s if s < 1e-3 => (1e6 * s, "µs"),
        s if s < 1.0 => (1e3 * s, "ms"),
        s => (s, "s"),
    };
    let digits = if value < 10.0 { 2 } else { usize::from(value < 100.0) };
    format!("{value:.digits$} {unit}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seconds_have_three_digits_and_a_unit() {
        let written =
            [(0.0, "0.00 µs"), (6.51e-5, "65.1 µs"), (0.1684, "168 ms"), (1395.4, "1395 s")];
        for (seconds, expected) in written {
            assert_eq!(brief(seconds), expected);
        }
    }
}
