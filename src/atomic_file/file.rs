//! The file that is written: with a name, without one, or the target itself.

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

#[cfg(target_os = "linux")]
use super::nameless;
use super::target::{NoFolderError, folder_of, refuse_protected};
use super::temporary::{Registration, temporary_file, without_path};

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
pub struct AtomicFile(pub(super) Kind);

/// Where the bytes go.
#[derive(Debug)]
pub(super) enum Kind {
    /// Renamed to the target when it is complete.
    Named { target: PathBuf, file: BufWriter<NamedTempFile>, _registration: Registration },
    /// Without a name until it is complete.
    #[cfg(target_os = "linux")]
    Nameless { target: PathBuf, file: BufWriter<File> },
    /// Into the target itself.
    Direct(BufWriter<File>),
}

/// Bytes collected before they are written.
const BUFFER: usize = 1 << 16;

impl AtomicFile {
    /// Opens a file that is to become `target`.
    ///
    /// # Errors
    /// `target` is a folder, a write-protected file or a link to nothing, its folder does not exist
    /// ([`NoFolderError`]), or no file can be made there. Other errors are those of the file
    /// system.
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
            return Err(io::Error::new(io::ErrorKind::NotFound, NoFolderError(folder.to_owned())));
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
        Self::named(target)
    }

    /// Opens a file with a temporary name beside `target`.
    pub(super) fn named(target: PathBuf) -> io::Result<Self> {
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
