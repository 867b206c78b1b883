//! The program that runs: its path and its hash.

use std::io;
#[cfg(target_os = "linux")]
use std::path::Path;
use std::path::PathBuf;

use triquad_lab::experiment::machine;

/// Returns a path that leads to this very program, even if its file is replaced meanwhile.
#[cfg(target_os = "linux")]
pub fn path() -> io::Result<PathBuf> {
    let program = Path::new("/proc/self/exe");
    // Without /proc there is the path only.
    if program.exists() { Ok(program.to_owned()) } else { std::env::current_exe() }
}

/// Returns the path of this program.
#[cfg(not(target_os = "linux"))]
pub fn path() -> io::Result<PathBuf> {
    std::env::current_exe()
}

/// Returns the SHA-256 of this program.
pub fn hash() -> io::Result<String> {
    machine::hash_of_file(&path()?)
}
