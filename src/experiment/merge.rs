//! Results of several machines in one folder.

use std::io;
use std::path::{Path, PathBuf};

use super::journal::{merge_plans, write_results};
use super::results::{Results, ResultsError};

/// Puts the rows of all `folders` together in `out`: of the same run done twice, the last that ended
/// well, else the last.
///
/// # Errors
/// A folder cannot be read, or `out` not be written.
pub fn merge(folders: &[PathBuf], out: &Path) -> Result<Results, ResultsError> {
    let mut merged = Results::default();
    for folder in folders {
        let part = Results::read(folder)?;
        for record in part.records {
            let known =
                merged.records.iter().any(|other| other.is_ok() && other.is_same_run(&record));
            if record.is_ok() || !known {
                merged.push(record);
            }
        }
        merged.damaged.extend(part.damaged);
        merge_plans(&mut merged.planned, part.planned);
        merged.machines.extend(part.machines);
    }
    let failure = |error: io::Error| ResultsError { path: out.to_owned(), error };
    write_results(out, &merged).map_err(failure)?;
    Ok(merged)
}
