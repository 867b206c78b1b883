//! Files that appear only when they are complete.

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use tempfile::NamedTempFile;

/// Temporary files not yet renamed, to be removed if the process is interrupted.
static PENDING: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Removes the temporary files of everything that is being written.
///
/// To be called by the thread that handles an interrupt, just before the process ends.
pub fn abandon_all() {
    for path in PENDING.lock().unwrap_or_else(PoisonError::into_inner).iter() {
        let _ = std::fs::remove_file(path);
    }
}

/// A file written beside its target under a temporary name and renamed when it is complete.
///
/// To be made before the work starts, so that a folder without write permission is found at once.
/// Dropped without [`AtomicFile::commit`], it leaves nothing behind. A symbolic link is followed.
/// A device or pipe cannot be replaced and is written to directly.
///
/// ```
/// use std::io::Write;
/// use triquad::atomic_file::AtomicFile;
///
/// # let folder = tempfile::tempdir()?;
/// # let path = folder.path().join("counts.csv");
/// let mut file = AtomicFile::create(&path)?;
/// writeln!(file, "quads,1234")?;
/// assert!(!path.exists());
/// file.commit()?;
/// assert!(path.exists());
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Debug)]
pub struct AtomicFile(Kind);

#[derive(Debug)]
enum Kind {
    Renamed { target: PathBuf, file: BufWriter<NamedTempFile>, _registration: Registration },
    Direct(BufWriter<File>),
}

impl AtomicFile {
    /// Opens a temporary file in the folder of `target`.
    ///
    /// # Errors
    /// `target` is a folder, or no file can be made beside it. Other errors are those of the file
    /// system.
    pub fn create(target: impl AsRef<Path>) -> io::Result<Self> {
        let target = target.as_ref();
        let target = target.canonicalize().unwrap_or_else(|_| target.to_owned());
        if target.is_dir() {
            return Err(io::Error::new(io::ErrorKind::IsADirectory, "is a folder"));
        }
        if target.exists() && !target.is_file() {
            let device = File::options().write(true).open(target)?;
            return Ok(Self(Kind::Direct(BufWriter::new(device))));
        }
        let folder = match target.parent() {
            Some(parent) if !parent.as_os_str().is_empty() => parent,
            _ => Path::new("."),
        };
        let (file, registration) = temporary_file(folder)?;
        if let Ok(replaced) = target.metadata() {
            file.as_file().set_permissions(replaced.permissions())?;
        }
        let file = BufWriter::with_capacity(1 << 16, file);
        Ok(Self(Kind::Renamed { target, file, _registration: registration }))
    }

    /// Waits until what was written is on the disk, so that a power cut cannot leave an empty file
    /// under the name of the target.
    ///
    /// # Errors
    /// Those of the file system.
    pub fn sync(&mut self) -> io::Result<()> {
        self.flush()?;
        match &mut self.0 {
            Kind::Renamed { file, .. } => file.get_ref().as_file().sync_all(),
            // A device has nothing to wait for, and some refuse to.
            Kind::Direct(_) => Ok(()),
        }
    }

    /// Puts the complete file in place of the target.
    ///
    /// # Errors
    /// Those of the file system. The target is then what it was.
    pub fn commit(self) -> io::Result<()> {
        match self.0 {
            Kind::Renamed { target, file, _registration } => {
                let file = file.into_inner().map_err(io::IntoInnerError::into_error)?;
                file.persist(target).map_err(|error| error.error)?;
                Ok(())
            }
            Kind::Direct(mut file) => file.flush(),
        }
    }
}

impl Write for AtomicFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.0 {
            Kind::Renamed { file, .. } => file.write(bytes),
            Kind::Direct(file) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match &mut self.0 {
            Kind::Renamed { file, .. } => file.flush(),
            Kind::Direct(file) => file.flush(),
        }
    }
}

/// A temporary file, registered from the moment that it exists.
fn temporary_file(folder: &Path) -> io::Result<(NamedTempFile, Registration)> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".triquad-").suffix(".tmp");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // As for any new file, the user's umask takes its part from this.
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    let mut pending = PENDING.lock().unwrap_or_else(PoisonError::into_inner);
    // The error would name the temporary file.
    let file = builder.tempfile_in(folder).map_err(|error| io::Error::from(error.kind()))?;
    pending.push(file.path().to_owned());
    let registration = Registration(file.path().to_owned());
    Ok((file, registration))
}

/// Keeps a path in [`PENDING`] while it lives.
#[derive(Debug)]
struct Registration(PathBuf);

impl Drop for Registration {
    fn drop(&mut self) {
        PENDING.lock().unwrap_or_else(PoisonError::into_inner).retain(|path| *path != self.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn entries(folder: &Path) -> usize {
        std::fs::read_dir(folder).unwrap().count()
    }

    #[test]
    fn nothing_appears_before_commit_and_nothing_stays_without() {
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join("a.txt");
        let mut file = AtomicFile::create(&target).unwrap();
        file.write_all(b"new").unwrap();
        assert!(!target.exists());
        drop(file);
        assert_eq!(entries(folder.path()), 0);

        std::fs::write(&target, "old").unwrap();
        let mut file = AtomicFile::create(&target).unwrap();
        file.write_all(b"new").unwrap();
        assert_eq!(std::fs::read_to_string(&target).unwrap(), "old");
        file.commit().unwrap();
        assert_eq!(std::fs::read_to_string(&target).unwrap(), "new");
        assert_eq!(entries(folder.path()), 1);
    }

    #[test]
    fn a_folder_is_no_target() {
        let folder = tempfile::tempdir().unwrap();
        assert!(AtomicFile::create(folder.path()).is_err());
        assert!(AtomicFile::create(folder.path().join("missing/a.txt")).is_err());
    }

    #[cfg(unix)]
    #[test]
    fn a_private_file_stays_private() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join("private");
        std::fs::write(&target, "old").unwrap();
        std::fs::set_permissions(&target, std::fs::Permissions::from_mode(0o600)).unwrap();
        AtomicFile::create(&target).unwrap().commit().unwrap();
        assert_eq!(target.metadata().unwrap().permissions().mode() & 0o777, 0o600);
    }

    #[cfg(unix)]
    #[test]
    fn links_are_followed_and_devices_written_to() {
        let folder = tempfile::tempdir().unwrap();
        let (file, link) = (folder.path().join("file"), folder.path().join("link"));
        std::fs::write(&file, "old").unwrap();
        std::os::unix::fs::symlink(&file, &link).unwrap();
        let mut out = AtomicFile::create(&link).unwrap();
        out.write_all(b"new").unwrap();
        out.commit().unwrap();
        assert!(link.is_symlink());
        assert_eq!(std::fs::read_to_string(&file).unwrap(), "new");
        let mut out = AtomicFile::create("/dev/null").unwrap();
        out.write_all(b"gone").unwrap();
        out.commit().unwrap();
        assert!(!Path::new("/dev/null").is_file());
    }
}
