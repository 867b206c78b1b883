//! Numbers that no run on the mesh can have.

use csv::StringRecord;

use super::error::ImportError;
use super::{RunRecord, Task, cell};

/// Refuses counts greater than what they are counted among, and totals that are no sum.
pub(super) fn check(
    row: &StringRecord,
    columns: &[String],
    header: &StringRecord,
    record: &RunRecord,
) -> Result<(), ImportError> {
    let line = row.position().map_or(0, csv::Position::line);
    let measured = &record.measured;
    let name_of = |column: &str| {
        let place = columns.iter().position(|name| name == column);
        place.map_or(String::new(), |place| header[place].to_owned())
    };
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
    let parts = measured.pairing_seconds.zip(measured.augmentation_seconds);
    let is_whole = record.id.job.task() == Task::Convert && record.stopped_after_paths.is_none();
    if let (Some(total), Some((pairing, augmentation))) = (measured.total_seconds, parts)
        && is_whole
    {
        let fields = ["total_seconds", "pairing_seconds", "augmentation_seconds"];
        let rounding: f64 =
            fields.iter().filter_map(|name| Some(last_digit(cell(row, columns, name)?))).sum();
        let sum = pairing + augmentation;
        if (total - sum).abs() > rounding.max(1e-9 * sum) {
            let total = cell(row, columns, "total_seconds").unwrap_or_default().to_owned();
            let sum = format!("{sum:.9}");
            let sum = sum.trim_end_matches('0').trim_end_matches('.').to_owned();
            return Err(ImportError::Total { line, column: name_of("total_seconds"), total, sum });
        }
    }
    Ok(())
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
