//! Files that appear only when they are complete, and what is left of those that never were.

use std::fs;
use std::io::{self, Write};
use std::path::Path;
use std::time::{Duration, SystemTime};

use triquad::atomic_file::AtomicFile;

/// Writes `bytes` to the file at `path`, which keeps its former content until they are all on the
/// disk.
///
/// # Errors
/// Those of the file system; `path` is a link, which may lead out of its folder.
pub(crate) fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    refuse_link(path)?;
    let mut file = AtomicFile::create(path)?;
    file.write_all(bytes)?;
    file.sync()?;
    file.commit()
}

/// Refuses a link in place of a file.
pub(crate) fn refuse_link(path: &Path) -> io::Result<()> {
    if path.is_symlink() {
        let name = path.file_name().unwrap_or_default().display();
        return Err(io::Error::other(format!("{name} is a link and is not followed; remove it")));
    }
    Ok(())
}

/// Removes the temporary files in `folder` that killed processes have left, if they are older than
/// `age`. What cannot be removed stays.
pub(crate) fn remove_leftovers(folder: &Path, age: Duration) {
    let is_old = |path: &Path| {
        let written = path.symlink_metadata().and_then(|file| file.modified());
        let since = written.ok().and_then(|time| SystemTime::now().duration_since(time).ok());
        age.is_zero() || since.is_some_and(|since| since >= age)
    };
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        let is_temporary = name.starts_with(".triquad-") && name.ends_with(".tmp");
        if is_temporary && is_old(&entry.path()) {
            let _ = fs::remove_file(entry.path());
        }
    }
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn links_are_not_followed_and_leftovers_are_removed() {
        let folder = tempfile::tempdir().unwrap();
        let [victim, link] = ["victim", "link"].map(|name| folder.path().join(name));
        fs::write(&victim, "kept").unwrap();
        std::os::unix::fs::symlink(&victim, &link).unwrap();
        assert!(write(&link, b"new").unwrap_err().to_string().contains("is not followed"));
        assert_eq!(fs::read_to_string(&victim).unwrap(), "kept");
        fs::write(folder.path().join(".triquad-aB3.tmp"), "half").unwrap();
        remove_leftovers(folder.path(), Duration::from_secs(3600));
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 3);
        remove_leftovers(folder.path(), Duration::ZERO);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2);
    }
}
