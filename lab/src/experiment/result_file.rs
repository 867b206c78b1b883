//! The result of a run in a file: read, checked and measured from it, whoever made it.

use std::ffi::OsStr;
use std::path::Path;

use triquad::Mesh;

use super::measured::Measured;
use super::task::Task;
use super::verification::verify;

/// Reads a mesh and the result of `task` on it, checks the result and measures it.
///
/// # Errors
/// A file cannot be read, or the check fails: the reason in words.
pub fn measure(task: Task, mesh: &Path, result: &Path) -> Result<Measured, String> {
    let input = Mesh::read(mesh).map_err(|error| format!("its input: {}", error.without_path()))?;
    let name = result.file_name().map(OsStr::to_string_lossy).unwrap_or_default();
    if !result.exists() {
        return Err(format!("it ended well and left no result {name}"));
    }
    let result = Mesh::read(result)
        .map_err(|error| format!("its result {name}: {}", error.without_path()))?;
    verify(task, &input, &result).map_err(|error| format!("its result: {error}"))
}

/// Puts the numbers found in a file in place of those that a program has of itself.
///
/// Of a perfect result columns (b) and (c) stay: they belong to the first stage, which no file
/// shows.
pub fn confirmed(own: &Measured, found: &Measured) -> Measured {
    let mut numbers = own.overlaid(found);
    if found.unpaired_triangles == Some(0) && own.unpaired_triangles.is_some() {
        numbers.unpaired_triangles = own.unpaired_triangles;
        numbers.paired_percent = own.paired_percent.or(numbers.paired_percent);
    }
    numbers
}
