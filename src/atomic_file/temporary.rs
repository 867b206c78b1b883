//! Temporary files, and which of them an interrupt would leave behind.

use std::io;
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

/// Makes a temporary file, registered from the moment that it exists.
pub(super) fn temporary_file(folder: &Path) -> io::Result<(NamedTempFile, Registration)> {
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
pub(super) fn temporary_name() -> tempfile::Builder<'static, 'static> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".triquad-").suffix(".tmp");
    builder
}

/// Keeps a path in [`PENDING`] while it lives.
#[derive(Debug)]
pub(super) struct Registration(PathBuf);

#[cfg(target_os = "linux")]
impl Registration {
    pub(super) fn new(path: &Path) -> Self {
        PENDING.lock().unwrap_or_else(PoisonError::into_inner).push(path.to_owned());
        Self(path.to_owned())
    }
}

impl Drop for Registration {
    fn drop(&mut self) {
        PENDING.lock().unwrap_or_else(PoisonError::into_inner).retain(|path| *path != self.0);
    }
}

/// Returns an error without the path of the temporary file, which means nothing to the user.
pub(super) fn without_path(error: io::Error) -> io::Error {
    error.raw_os_error().map_or_else(|| error.kind().into(), io::Error::from_raw_os_error)
}
