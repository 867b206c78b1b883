//! Printing that does not panic when nobody listens any more.

use std::io::{self, ErrorKind, Write};

use crate::failure::Failure;

/// Prints a line on standard output. A reader that has gone away is no failure.
pub fn say(line: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match writeln!(out, "{line}").and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Failure::bad(format!("standard output: {error}; check where it is redirected to")))
        }
        _ => Ok(()),
    }
}

/// Prints a line on standard error. Control characters, as file names may hold them, are replaced.
pub fn complain(line: &str) {
    let line: String = line.chars().map(|c| if c.is_control() { '\u{fffd}' } else { c }).collect();
    let _ = writeln!(io::stderr().lock(), "triquad: {line}");
}
