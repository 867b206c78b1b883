//! What may be a target.

use std::fs::File;
use std::io;
use std::path::{Path, PathBuf};

/// The folder of a target does not exist.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there is no folder {}", .0.display())]
pub struct NoFolderError(pub PathBuf);

/// Refuses a file that the user may not write to: renaming another over it would be possible.
pub(super) fn refuse_protected(target: &Path) -> io::Result<()> {
    if target.metadata()?.permissions().readonly() {
        return Err(io::Error::new(io::ErrorKind::PermissionDenied, "is write-protected"));
    }
    File::options().write(true).open(target).map(|_| ())
}

pub(super) fn folder_of(target: &Path) -> &Path {
    match target.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}
