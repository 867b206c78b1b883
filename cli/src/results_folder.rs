//! Failures of results folders, with the remedy that each has.

use std::io::{self, ErrorKind};
use std::path::Path;

use triquad::mesh::io_remedy;
use triquad_lab::experiment::folder_lock::FolderLockError;
use triquad_lab::experiment::journal::JournalError;
use triquad_lab::experiment::results::ResultsError;

use crate::failure::Failure;
use crate::input::system_problem;

/// Makes the failure that a folder cannot be written into.
pub fn unwritable(path: &Path, error: &io::Error) -> Failure {
    let remedy = match error.kind() {
        ErrorKind::NotADirectory | ErrorKind::AlreadyExists => "name a folder",
        ErrorKind::PermissionDenied => "make it writable, or name another folder",
        ErrorKind::NotFound => "name a folder in one that exists",
        _ => io_remedy(error),
    };
    Failure::bad(format!("{}: {}; {remedy}", path.display(), system_problem(error)))
}

/// Makes the failure that a folder's records cannot be read; `otherwise` is the remedy unless they
/// are there and kept from being read.
pub fn unreadable(ResultsError { path, error }: &ResultsError, otherwise: &str) -> Failure {
    let remedy = match error.kind() {
        ErrorKind::NotFound | ErrorKind::NotADirectory | ErrorKind::Other => otherwise,
        ErrorKind::PermissionDenied => "make it readable",
        _ => io_remedy(error),
    };
    Failure::bad(format!("{}: {}; {remedy}", path.display(), system_problem(error)))
}

/// Makes the failure that a folder is another process's, or cannot be locked.
pub fn unlockable(error: &FolderLockError) -> Failure {
    match error {
        FolderLockError::Io { folder, error } => unwritable(folder, error),
        busy => Failure::bad(busy.to_string()),
    }
}

/// Makes the failure that rows cannot be added to a folder.
pub fn closed(error: &JournalError) -> Failure {
    match error {
        JournalError::Lock(error) => unlockable(error),
        JournalError::Read(error) => unreadable(error, "name another folder with --out"),
        JournalError::Write { folder, error } => unwritable(folder, error),
    }
}
