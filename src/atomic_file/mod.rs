//! Files that appear only when they are complete.
//!
//! On Linux, and where the file system allows it, a file has no name while it is written: a process
//! that is killed leaves nothing behind. Elsewhere it has a temporary name beside its target.
//!
//! The functions for interrupts and for the disk have no examples of their own.

mod file;
#[cfg(target_os = "linux")]
mod nameless;
mod target;
mod temporary;
#[cfg(test)]
mod tests;

pub use file::AtomicFile;
pub use target::NoFolderError;
pub use temporary::abandon_all;
