//! Results of several machines in one folder.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::folder_lock::{FolderLock, FolderLockError};
use super::results::{Results, ResultsError, RunIndex};
use super::results_files::{merge_plans, write_results};
use crate::whole_file;

/// Reason why results cannot be merged.
#[derive(Debug, thiserror::Error)]
pub enum MergeError {
    /// Another process writes into the folder for all of them.
    #[error(transparent)]
    Lock(#[from] FolderLockError),
    /// A folder cannot be read.
    #[error(transparent)]
    Results(#[from] ResultsError),
    /// The folder for all of them cannot be written.
    #[error("{}: {error}", out.display())]
    Write {
        /// The folder.
        out: PathBuf,
        /// The reason of the file system.
        error: io::Error,
    },
}

/// Merges the rows of all `folders` into `out`: of the same run done twice, the last that ended
/// well, else the last. Copies the pictures of the first folder that has any. O(n).
///
/// # Errors
/// A folder cannot be read, or `out` not be written, by another process being at it for example.
pub fn merge(folders: &[PathBuf], out: &Path) -> Result<Results, MergeError> {
    let _lock = FolderLock::take(out)?;
    let (mut merged, mut index) = (Results::default(), RunIndex::default());
    for folder in folders {
        let part = Results::read(folder)?;
        for record in part.records {
            index.put(&mut merged.records, record);
        }
        merged.damaged.extend(part.damaged);
        merge_plans(&mut merged.planned, part.planned);
        merged.machines.extend(part.machines);
    }
    let failure = |error: io::Error| MergeError::Write { out: out.to_owned(), error };
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
        // Neither folders nor links, which may lead anywhere.
        if !entry.file_type()?.is_file() {
            continue;
        }
        whole_file::write(&out.join("pictures").join(entry.file_name()), &fs::read(entry.path())?)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(unix)]
    #[test]
    fn links_and_folders_among_the_pictures_stay_where_they_are() {
        let shop = tempfile::tempdir().unwrap();
        let [from, out] = ["from", "out"].map(|name| shop.path().join(name));
        write_results(&from, &Results::default()).unwrap();
        fs::create_dir_all(from.join("pictures/folder")).unwrap();
        fs::write(from.join("pictures/pictures.csv"), "list").unwrap();
        fs::write(shop.path().join("secret"), "secret").unwrap();
        std::os::unix::fs::symlink("../../secret", from.join("pictures/a.png")).unwrap();
        merge(&[from], &out).unwrap();
        assert_eq!(fs::read_dir(out.join("pictures")).unwrap().count(), 1);
    }

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
