//! Files that appear only when they are complete.

use std::io::{self, Write};
use std::path::Path;

use triquad::atomic_file::AtomicFile;

/// Writes `bytes` to the file at `path`, which keeps its former content until they are all written.
pub(crate) fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = AtomicFile::create(path)?;
    file.write_all(bytes)?;
    file.commit()
}
