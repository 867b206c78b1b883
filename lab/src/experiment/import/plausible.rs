//! Numbers that no run on the mesh can have.

use csv::StringRecord;

use super::error::ImportError;
use super::{AUGMENTATION, PAIRING, RunRecord, Task, cell};

/// Refuses counts greater than what they are counted among, and totals that are no sum of their
/// parts or less than one of them.
pub(super) fn check(
    row: &StringRecord,
    columns: &[String],
    header: &StringRecord,
    record: &RunRecord,
) -> Result<(), ImportError> {
    let line = row.position().map_or(0, csv::Position::line);
    let name_of = |column: &str| {
        let place = columns.iter().position(|name| name == column);
        place.map_or(String::new(), |place| header[place].to_owned())
    };
    check_counts(line, name_of, record)?;
    check_total(line, name_of("total_seconds"), |column| cell(row, columns, column), record)
}

/// Refuses counts greater than what they are counted among.
fn check_counts(
    line: u64,
    name_of: impl Fn(&str) -> String,
    record: &RunRecord,
) -> Result<(), ImportError> {
    let measured = &record.measured;
    let triangles = (measured.triangles, 1, "triangles");
    let pairs = (measured.triangles, 2, "triangles, and each takes two");
    let edges = (measured.edges, 1, "edges");
    let vertices = (measured.vertices, 1, "vertices");
    let counts = [
        ("unpaired_triangles", measured.unpaired_triangles, triangles),
        ("augmenting_paths", measured.augmenting_paths, pairs),
        ("augmenting_path_length_max", measured.augmenting_path_length_max, edges),
        ("quads", measured.quads, pairs),
        ("folded_quads", measured.folded_quads, pairs),
        ("edge_flips", measured.edge_flips, edges),
        ("sharp_edges", measured.sharp_edges, edges),
        ("sharp_edges_kept", measured.sharp_edges_kept, edges),
        ("degree_two_vertices", measured.degree_two_vertices, vertices),
        ("components", measured.components, vertices),
        ("contractions", measured.contractions, vertices),
        ("result_vertices", measured.result_vertices, vertices),
        ("result_edges", measured.result_edges, edges),
        ("result_triangles", measured.result_triangles, triangles),
    ];
    for (column, count, (all, each, what)) in counts {
        if let (Some(value), Some(all)) = (count, all)
            && value.saturating_mul(each) > all
        {
            let (column, mesh) = (name_of(column), record.id.mesh.name.clone());
            return Err(ImportError::TooMany { line, column, value, mesh, all, what });
        }
    }
    Ok(())
}

/// Refuses a total, in the file under the name `column`, that its parts cannot add up to.
fn check_total<'r>(
    line: u64,
    column: String,
    cell: impl Fn(&str) -> Option<&'r str>,
    record: &RunRecord,
) -> Result<(), ImportError> {
    let measured = &record.measured;
    let is_whole = record.id.job.task() == Task::Convert && record.stopped_after_paths.is_none();
    let Some(total) = measured.total_seconds.filter(|_| is_whole) else { return Ok(()) };
    let parts =
        [(PAIRING, measured.pairing_seconds), (AUGMENTATION, measured.augmentation_seconds)];
    let known = || parts.iter().filter_map(|&(name, seconds)| Some((name, seconds?)));
    let sum: f64 = known().map(|(_, seconds)| seconds).sum();
    let digits = ["total_seconds", PAIRING, AUGMENTATION]
        .iter()
        .filter_map(|name| Some(last_digit(cell(name)?)));
    let is_sum = if known().count() == 2 {
        (total - sum).abs() <= digits.sum::<f64>().max(1e-9 * sum)
    } else {
        // The other part may have taken any time. Rounding to the same digits keeps the order.
        let (least, most) = digits.fold((f64::INFINITY, 0.0_f64), |(least, most), worth| {
            (least.min(worth), most.max(worth))
        });
        let rounding = if least < most { most } else { 0.0 };
        total >= sum - rounding.max(1e-9 * sum)
    };
    if is_sum {
        return Ok(());
    }
    let total = cell("total_seconds").unwrap_or_default().to_owned();
    let sum = format!("{sum:.9}");
    let sum = sum.trim_end_matches('0').trim_end_matches('.').to_owned();
    let names: Vec<&str> = known().map(|(name, _)| name).collect();
    Err(match names[..] {
        [part] => ImportError::TotalOfPart { line, column, total, part, seconds: sum },
        _ => ImportError::Total { line, column, total, sum },
    })
}

/// Returns the worth of the last digit of a number: 0.01 of `1.25`.
fn last_digit(number: &str) -> f64 {
    let (digits, exponent) = number.split_once(['e', 'E']).unwrap_or((number, "0"));
    let decimals = digits.split_once('.').map_or(0, |(_, decimals)| decimals.len()) as i32;
    10_f64.powi(exponent.parse::<i32>().unwrap_or(0) - decimals)
}

#[cfg(test)]
mod tests {
    use super::last_digit;

    #[test]
    fn the_last_digit_has_a_worth() {
        for (number, worth) in [("1.25", 0.01), ("7", 1.0), ("2.5e-3", 1e-4), ("1E2", 100.0)] {
            assert!((last_digit(number) - worth).abs() < 1e-12, "{number}");
        }
    }
}
