//! Files that appear only when they are complete.
//!
//! On Linux, and where the file system allows it, a file has no name while it is written: a process
//! that is killed leaves nothing behind. Elsewhere it has a temporary name beside its target.
//!
//! ```
//! use std::io::Write as _;
//! use triquad::atomic_file::AtomicFile;
//!
//! let path = std::env::temp_dir().join(format!("triquad-{}.txt", std::process::id()));
//! let mut file = AtomicFile::create(&path)?;
//! file.write_all(b"complete\n")?;
//! assert!(!path.exists());
//! file.commit()?;
//! assert_eq!(std::fs::read(&path)?, b"complete\n");
//! # std::fs::remove_file(&path)?;
//! # Ok::<(), std::io::Error>(())
//! ```
//!
//! The functions for interrupts and for the disk have no examples of their own.

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError, TryLockError};
use std::time::Duration;

use tempfile::NamedTempFile;

/// Temporary files not yet renamed, to be removed if the process is interrupted.
static PENDING: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Removes the temporary files of everything that is being written.
///
/// To be called just before the process ends, on an interrupt for example. Waits at most a second
/// for a thread that is just making a file: it may be the one that calls.
pub fn abandon_all() {
    for _ in 0..100 {
        let pending = match PENDING.try_lock() {
            Ok(pending) => pending,
            Err(TryLockError::Poisoned(poisoned)) => poisoned.into_inner(),
            Err(TryLockError::WouldBlock) => {
                std::thread::sleep(Duration::from_millis(10));
                continue;
            }
        };
        for path in pending.iter() {
            let _ = std::fs::remove_file(path);
        }
        return;
    }
}

/// A file that gets its name when it is complete.
///
/// To be made before the work starts, so that a folder without write permission is found at once.
/// Dropped without [`AtomicFile::commit`], it leaves nothing behind. A symbolic link is followed,
/// but not to a file that does not exist. A write-protected file is not replaced. A device or pipe
/// cannot be replaced and is written to directly.
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

/// The folder of a target does not exist.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there is no folder {}", .0.display())]
pub struct NoFolder(pub PathBuf);

#[derive(Debug)]
enum Kind {
    /// Renamed to the target when it is complete.
    Named {
        target: PathBuf,
        file: BufWriter<NamedTempFile>,
        _registration: Registration,
    },
    /// Without a name until it is complete.
    #[cfg(target_os = "linux")]
    Nameless {
        target: PathBuf,
        file: BufWriter<File>,
    },
    Direct(BufWriter<File>),
}

/// Bytes collected before they are written.
const BUFFER: usize = 1 << 16;

impl AtomicFile {
    /// Opens a file that is to become `target`.
    ///
    /// # Errors
    /// `target` is a folder, a write-protected file or a link to nothing, its folder does not exist
    /// ([`NoFolder`]), or no file can be made there. Other errors are those of the file system.
    pub fn create(target: impl AsRef<Path>) -> io::Result<Self> {
        let target = target.as_ref();
        let resolved = target.canonicalize().unwrap_or_else(|_| target.to_owned());
        if resolved.is_dir() {
            return Err(io::Error::new(io::ErrorKind::IsADirectory, "is a folder"));
        }
        if resolved.is_symlink() {
            let problem = "is a link to a file that does not exist";
            return Err(io::Error::new(io::ErrorKind::NotFound, problem));
        }
        if resolved.exists() && !resolved.is_file() {
            let device = File::options().write(true).open(resolved)?;
            return Ok(Self(Kind::Direct(BufWriter::new(device))));
        }
        let folder = folder_of(&resolved);
        if !folder.exists() {
            return Err(io::Error::new(io::ErrorKind::NotFound, NoFolder(folder.to_owned())));
        }
        let replaced = resolved.metadata().ok();
        if replaced.is_some() {
            refuse_protected(&resolved)?;
        }
        let kind = Kind::open(resolved)?;
        if let Some(replaced) = replaced {
            kind.file().set_permissions(replaced.permissions())?;
        }
        Ok(Self(kind))
    }

    /// Waits until what was written is on the disk, so that a power cut cannot leave an empty file
    /// under the name of the target.
    ///
    /// # Errors
    /// Those of the file system.
    pub fn sync(&mut self) -> io::Result<()> {
        self.flush()?;
        match &self.0 {
            // A device has nothing to wait for, and some refuse to.
            Kind::Direct(_) => Ok(()),
            kind => kind.file().sync_all(),
        }
    }

    /// Gives the complete file the name of its target, in place of a file that has it.
    ///
    /// # Errors
    /// Those of the file system. The target is then what it was.
    pub fn commit(self) -> io::Result<()> {
        match self.0 {
            Kind::Named { target, file, _registration } => {
                let file = file.into_inner().map_err(io::IntoInnerError::into_error);
                let file = file.map_err(without_path)?;
                file.persist(target).map_err(|error| without_path(error.error))?;
                Ok(())
            }
            #[cfg(target_os = "linux")]
            Kind::Nameless { target, file } => {
                let file = file.into_inner().map_err(io::IntoInnerError::into_error)?;
                nameless::persist(file, &target)
            }
            Kind::Direct(mut file) => file.flush(),
        }
    }
}

impl Kind {
    fn open(target: PathBuf) -> io::Result<Self> {
        #[cfg(target_os = "linux")]
        if let Some(file) = nameless::open(folder_of(&target)) {
            return Ok(Self::Nameless { target, file: BufWriter::with_capacity(BUFFER, file) });
        }
        let (file, registration) = temporary_file(folder_of(&target))?;
        let file = BufWriter::with_capacity(BUFFER, file);
        Ok(Self::Named { target, file, _registration: registration })
    }

    fn file(&self) -> &File {
        match self {
            Self::Named { file, .. } => file.get_ref().as_file(),
            #[cfg(target_os = "linux")]
            Self::Nameless { file, .. } => file.get_ref(),
            Self::Direct(file) => file.get_ref(),
        }
    }
}

/// Refuses a file that the user may not write to: renaming another over it would be possible.
fn refuse_protected(target: &Path) -> io::Result<()> {
    if target.metadata()?.permissions().readonly() {
        return Err(io::Error::new(io::ErrorKind::PermissionDenied, "is write-protected"));
    }
    File::options().write(true).open(target).map(|_| ())
}

fn folder_of(target: &Path) -> &Path {
    match target.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}

/// Returns an error without the path of the temporary file, which means nothing to the user.
fn without_path(error: io::Error) -> io::Error {
    error.raw_os_error().map_or_else(|| error.kind().into(), io::Error::from_raw_os_error)
}

#[cfg(target_os = "linux")]
mod nameless {
    //! Files without a name (`O_TMPFILE`), which vanish with their process.

    use std::fs::File;
    use std::io::{self, Seek};
    use std::os::fd::AsRawFd;
    use std::path::{Path, PathBuf};

    use rustix::fs::{AtFlags, CWD, Mode, OFlags, linkat, open as open_at};
    use tempfile::NamedTempFile;

    use super::{Registration, folder_of, temporary_file, temporary_name, without_path};

    /// Opens a file without a name in `folder`; none where that does not work.
    pub(super) fn open(folder: &Path) -> Option<File> {
        let flags = OFlags::TMPFILE | OFlags::RDWR | OFlags::CLOEXEC;
        // As for any new file, the user's umask takes its part from the mode.
        let file = File::from(open_at(folder, flags, Mode::from_raw_mode(0o666)).ok()?);
        // The way to a name leads through this.
        link_of(&file).exists().then_some(file)
    }

    /// Gives `file` the name `target`, in place of a file that has it.
    pub(super) fn persist(mut file: File, target: &Path) -> io::Result<()> {
        // A link replaces nothing, so it gets a temporary name first.
        let (link, folder) = (link_of(&file), folder_of(target));
        let made = temporary_name().make_in(folder, |name| {
            linkat(CWD, &link, CWD, name, AtFlags::SYMLINK_FOLLOW)?;
            Ok(Registration::new(name))
        });
        let named = match made {
            Ok(named) => named.into_parts().1,
            Err(_) => return copy(&mut file, target),
        };
        named.persist(target).map_err(|error| without_path(error.error))
    }

    /// Writes the content of `file` to another one with a name.
    fn copy(file: &mut File, target: &Path) -> io::Result<()> {
        let (mut named, _registration): (NamedTempFile, _) = temporary_file(folder_of(target))?;
        named.as_file().set_permissions(file.metadata()?.permissions())?;
        file.rewind()?;
        io::copy(file, &mut named).map_err(without_path)?;
        named.persist(target).map_err(|error| without_path(error.error))?;
        Ok(())
    }

    fn link_of(file: &File) -> PathBuf {
        PathBuf::from(format!("/proc/self/fd/{}", file.as_raw_fd()))
    }
}

impl Write for AtomicFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.0 {
            Kind::Named { file, .. } => file.write(bytes).map_err(without_path),
            #[cfg(target_os = "linux")]
            Kind::Nameless { file, .. } => file.write(bytes),
            Kind::Direct(file) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match &mut self.0 {
            Kind::Named { file, .. } => file.flush().map_err(without_path),
            #[cfg(target_os = "linux")]
            Kind::Nameless { file, .. } => file.flush(),
            Kind::Direct(file) => file.flush(),
        }
    }
}

/// Makes a temporary file, registered from the moment that it exists.
fn temporary_file(folder: &Path) -> io::Result<(NamedTempFile, Registration)> {
    let mut builder = temporary_name();
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
    drop(pending);
    let registration = Registration(file.path().to_owned());
    Ok((file, registration))
}

/// Returns what makes names of temporary files.
fn temporary_name() -> tempfile::Builder<'static, 'static> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".triquad-").suffix(".tmp");
    builder
}

/// Keeps a path in [`PENDING`] while it lives.
#[derive(Debug)]
struct Registration(PathBuf);

#[cfg(target_os = "linux")]
impl Registration {
    fn new(path: &Path) -> Self {
        PENDING.lock().unwrap_or_else(PoisonError::into_inner).push(path.to_owned());
        Self(path.to_owned())
    }
}

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

    #[cfg(target_os = "linux")]
    #[test]
    fn a_file_has_no_name_before_it_is_complete_and_both_ways_agree() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        if nameless::open(folder.path()).is_none() {
            println!("skipped: no files without a name here");
            return;
        }
        let mut file = AtomicFile::create(&path).unwrap();
        file.write_all(&[7; 100_000]).unwrap();
        assert_eq!(entries(folder.path()), 0);
        file.commit().unwrap();
        let (named, registration) = temporary_file(folder.path()).unwrap();
        let other = folder.path().join("b.txt");
        let file = BufWriter::new(named);
        let kind = Kind::Named { target: other.clone(), file, _registration: registration };
        let mut file = AtomicFile(kind);
        file.write_all(&[7; 100_000]).unwrap();
        assert_eq!(entries(folder.path()), 2);
        file.commit().unwrap();
        assert_eq!(std::fs::read(&path).unwrap(), std::fs::read(&other).unwrap());
        let modes = [&path, &other].map(|path| path.metadata().unwrap().permissions());
        assert_eq!(modes[0], modes[1]);
        assert_eq!(entries(folder.path()), 2);
    }

    #[cfg(unix)]
    #[test]
    fn protected_files_and_links_to_nothing_are_no_targets() {
        let folder = tempfile::tempdir().unwrap();
        let (file, link) = (folder.path().join("kept"), folder.path().join("link"));
        std::fs::write(&file, "old").unwrap();
        let mut permissions = file.metadata().unwrap().permissions();
        permissions.set_readonly(true);
        std::fs::set_permissions(&file, permissions).unwrap();
        std::os::unix::fs::symlink(folder.path().join("nowhere"), &link).unwrap();
        for (target, kind) in
            [(&file, io::ErrorKind::PermissionDenied), (&link, io::ErrorKind::NotFound)]
        {
            assert_eq!(AtomicFile::create(target).unwrap_err().kind(), kind);
        }
        assert_eq!(std::fs::read_to_string(&file).unwrap(), "old");
        assert!(link.is_symlink());
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
