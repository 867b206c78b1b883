//! A results folder belongs to one writer at a time.
//!
//! The lock is the operating system's (`flock`, which holds over NFS too). It ends with the process
//! that has it, however that ends, so that no lock is ever stale.

use std::fs::{File, OpenOptions};
use std::io::{self, Read as _, Seek as _, Write as _};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use fs4::{FileExt, TryLockError};
use sysinfo::System;

use crate::whole_file::refuse_link;

/// Name of the file that is locked; it holds who has the lock.
const LOCK: &str = ".lock";

/// Time to wait for another writer: one that is just being killed needs a moment.
const PATIENCE: Duration = Duration::from_secs(3);

/// A locked results folder, until it is dropped.
#[derive(Debug)]
pub struct FolderLock {
    /// Kept open: closing it ends the lock.
    _file: File,
    /// True if the file system has locks.
    pub is_locked: bool,
}

/// Reason why a folder cannot be locked.
#[derive(Debug, thiserror::Error)]
pub enum FolderLockError {
    /// Another process writes there.
    #[error(
        "{}: {owner} writes into this folder; wait until that has ended, or name another folder",
        folder.display()
    )]
    Busy {
        /// The folder.
        folder: PathBuf,
        /// The process, as it has written itself down.
        owner: String,
    },
    /// The file system refuses.
    #[error("{}: {error}", folder.display())]
    Io {
        /// The folder.
        folder: PathBuf,
        /// Its reason.
        error: io::Error,
    },
}

impl FolderLock {
    /// Makes `folder` if it is not there and locks it. Waits three seconds for another writer.
    ///
    /// # Errors
    /// Another process has it locked, or those of the file system.
    pub fn take(folder: &Path) -> Result<Self, FolderLockError> {
        let failure = |error| FolderLockError::Io { folder: folder.to_owned(), error };
        if folder.exists() && !folder.is_dir() {
            let problem = "is a file, not a folder";
            return Err(failure(io::Error::new(io::ErrorKind::NotADirectory, problem)));
        }
        std::fs::create_dir_all(folder).map_err(failure)?;
        let path = folder.join(LOCK);
        refuse_link(&path).map_err(failure)?;
        let mut options = OpenOptions::new();
        let options = options.read(true).write(true).create(true).truncate(false);
        let mut file = options.open(&path).map_err(failure)?;
        let start = Instant::now();
        loop {
            match FileExt::try_lock(&file) {
                Ok(()) => break,
                Err(TryLockError::WouldBlock) if start.elapsed() < PATIENCE => {
                    std::thread::sleep(Duration::from_millis(50));
                }
                Err(TryLockError::WouldBlock) => {
                    let owner = owner(&mut file);
                    return Err(FolderLockError::Busy { folder: folder.to_owned(), owner });
                }
                // A file system without locks.
                Err(TryLockError::Error(_)) => return Ok(Self { _file: file, is_locked: false }),
            }
        }
        sign(&mut file).map_err(failure)?;
        Ok(Self { _file: file, is_locked: true })
    }
}

/// Writes down who has the lock.
fn sign(file: &mut File) -> io::Result<()> {
    let host = System::host_name().unwrap_or_else(|| "this machine".into());
    file.set_len(0)?;
    file.rewind()?;
    writeln!(file, "process {} on {host}", std::process::id())
}

fn owner(file: &mut File) -> String {
    let mut text = String::new();
    let read = file.rewind().and_then(|()| file.read_to_string(&mut text));
    let line = text.lines().next().filter(|line| read.is_ok() && !line.is_empty());
    line.unwrap_or("another process").to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_second_is_refused_and_the_next_is_not() {
        let folder = tempfile::tempdir().unwrap();
        let first = FolderLock::take(folder.path()).unwrap();
        assert!(first.is_locked);
        let second = FolderLock::take(folder.path()).unwrap_err().to_string();
        assert!(second.contains(&format!("process {} on ", std::process::id())), "{second}");
        drop(first);
        assert!(FolderLock::take(folder.path()).is_ok());
    }
}
