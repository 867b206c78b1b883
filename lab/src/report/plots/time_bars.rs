//! Parts of the time: (a) and (d) of Tables 4.3 and 4.4, one bar a row.

use super::axis::Spread;
use super::chart::{Bar, Chart, Counterpart, legends};
use crate::experiment::RunRecord;
use crate::paper::{PairingRow, Paper, Table, TableKind};
use crate::report::summary::{Cell, Summary};
use crate::report::tables::with_programs;

/// Makes a chart for each of the three tables.
pub fn all(summary: &Summary) -> Vec<Chart> {
    let tables = Table::of_kind(Paper::Comparison, TableKind::Pairings);
    tables.map(|table| of_table(summary, table)).collect()
}

fn of_table(summary: &Summary, table: Table) -> Chart {
    let (mut rows, mut bars, mut cells) = (Vec::new(), Vec::new(), Vec::<&Cell>::new());
    for (mesh, job, printed) in with_programs(table.pairing_jobs(), summary) {
        let Some(cell) = summary.cell(Paper::Comparison, &mesh, job) else { continue };
        let is_first = cells.last().is_none_or(|before| before.mesh() != cell.mesh());
        rows.push(row_name(cell, is_first));
        bars.push(bar(cell, printed.as_ref(), bars.len()));
        cells.push(cell);
    }
    let has_run = cells.iter().any(|cell| cell.ok_runs().next().is_some());
    let caption = "Column (e) is where a bar ends, column (a) where its first part ends. The axis \
                   is logarithmic: read the ends, not the lengths. The triangle is the paper's \
                   total on its own machine. Augmentation as published (tarjan).";
    Chart {
        counterpart: Counterpart::Table(table),
        stem: table.file.replace("table", "stack").replace(".csv", ""),
        caption: caption.into(),
        title: format!("Where the time goes: Table {}", table.number),
        x_name: "seconds".into(),
        y_spread: Spread::Rows,
        rows,
        bars: if has_run { bars } else { Vec::new() },
        notes: legends(cells.into_iter()),
        ..Chart::default()
    }
}

/// Returns the algorithm, after the mesh if it is the first there.
fn row_name(cell: &Cell, is_first: bool) -> String {
    if is_first { format!("{}  {}", cell.marked_mesh(), cell.label()) } else { cell.label() }
}

fn bar(cell: &Cell, printed: Option<&PairingRow>, row: usize) -> Bar {
    let pairing = cell.mean(|run| run.measured.pairing_seconds);
    let total = cell.mean(RunRecord::whole_total_seconds);
    // A program may report its total alone: a bar of one part.
    let pairing = pairing.or(total);
    let star = if cell.is_extrapolated() { " *" } else { "" };
    Bar {
        row,
        mesh: cell.mesh().into(),
        origin: cell.origin,
        label: cell.label(),
        parts: pairing.zip(total).map(|(pairing, total)| [pairing, total]),
        text: total.map_or(cell.outcome_text(), |total| format!("{}{star}", brief(total))),
        extrapolated: cell.is_extrapolated(),
        paper: printed.filter(|_| cell.is_full_scale()).map(|row| row.total_seconds),
    }
}

/// Writes seconds in few characters.
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
