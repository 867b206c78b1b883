//! Files without a name (`O_TMPFILE`), which vanish with their process.

use std::fs::File;
use std::io::{self, Seek};
use std::os::fd::AsRawFd;
use std::path::{Path, PathBuf};

use rustix::fs::{AtFlags, CWD, Mode, OFlags, linkat, open as open_at};
use tempfile::NamedTempFile;

use super::target::folder_of;
use super::temporary::{Registration, temporary_file, temporary_name, without_path};

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
