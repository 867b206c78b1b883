//! A stack of a known size, where the shell allows less (`ulimit -s`).
//!
//! Readers of gzip files, the solver and the report keep arrays of up to 100 kB on the stack. With
//! less than [`ENOUGH`] for the first thread, another one does everything. Where the limit is the
//! usual one nothing changes, as memory is laid out otherwise in a second thread.

use std::process::ExitCode;
use std::thread::Builder;

use rustix::process::{Resource, getrlimit};

/// Bytes of stack with which the first thread does everything.
const ENOUGH: u64 = 1 << 20;

/// Bytes of stack of another thread, as many as the first one usually has. They are reserved, and
/// take memory as they are used.
const OWN: usize = 8 << 20;

/// Runs `tool` in a thread with enough stack: this one, or another.
pub fn with_enough(tool: fn() -> ExitCode) -> ExitCode {
    // No limit is none.
    let is_enough = getrlimit(Resource::Stack).current.is_none_or(|bytes| bytes >= ENOUGH);
    let other = if is_enough { None } else { Builder::new().stack_size(OWN).spawn(tool).ok() };
    match other {
        // The code of a program that panics; its message has been printed.
        Some(thread) => thread.join().unwrap_or(ExitCode::from(101)),
        None => tool(),
    }
}
