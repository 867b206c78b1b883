//! Results of several machines in one folder.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::journal::{merge_plans, write_results};
use super::record::RunRecord;
use super::results::{Results, ResultsError, RunIndex};
use crate::whole_file;

/// Merges the rows of all `folders` into `out`: of the same run done twice, the last that ended
/// well, else the last. Copies the pictures of the first folder that has any. O(n).
///
/// # Errors
/// A folder cannot be read, or `out` not be written.
pub fn merge(folders: &[PathBuf], out: &Path) -> Result<Results, ResultsError> {
    let (mut merged, mut index) = (Results::default(), RunIndex::default());
    for folder in folders {
        let part = Results::read(folder)?;
        for record in part.records {
            let known = index.find(&merged.records, &record);
            if record.is_ok() || !known.is_some_and(RunRecord::is_ok) {
                index.put(&mut merged.records, record);
            }
        }
        merged.damaged.extend(part.damaged);
        merge_plans(&mut merged.planned, part.planned);
        merged.machines.extend(part.machines);
    }
    let failure = |error: io::Error| ResultsError { path: out.to_owned(), error };
    write_results(out, &merged).map_err(failure)?;
    copy_pictures(folders, out).map_err(failure)?;
    Ok(merged)
}

/// Copies the pictures of the first of `folders` that has them.
fn copy_pictures(folders: &[PathBuf], out: &Path) -> io::Result<()> {
    let mut galleries = folders.iter().map(|folder| folder.join("pictures"));
    // The list is written last.
    let Some(gallery) = galleries.find(|gallery| gallery.join("pictures.csv").exists()) else {
        return Ok(());
    };
    fs::create_dir_all(out.join("pictures"))?;
    for entry in fs::read_dir(gallery)? {
        let entry = entry?;
        whole_file::write(&out.join("pictures").join(entry.file_name()), &fs::read(entry.path())?)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_pictures_go_along() {
        let shop = tempfile::tempdir().unwrap();
        let folders = ["a", "b", "c"].map(|name| shop.path().join(name));
        for (folder, list) in folders.iter().zip([None, Some("list of b"), Some("list of c")]) {
            write_results(folder, &Results::default()).unwrap();
            fs::create_dir(folder.join("pictures")).unwrap();
            fs::write(folder.join("pictures/quads.png"), folder.to_str().unwrap()).unwrap();
            if let Some(list) = list {
                fs::write(folder.join("pictures/pictures.csv"), list).unwrap();
            }
        }
        // Into one of them, which must not spoil it.
        for out in [&shop.path().join("out"), &folders[1]] {
            merge(&folders, out).unwrap();
            let text = |name: &str| fs::read_to_string(out.join("pictures").join(name)).unwrap();
            assert_eq!(text("pictures.csv"), "list of b");
            assert_eq!(text("quads.png"), folders[1].to_str().unwrap());
        }
    }
}
