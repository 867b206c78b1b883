//! Printing that does not panic on a closed pipe.

use std::io::{self, BufWriter, ErrorKind, Write};

use crate::failure::Failure;

/// Prints a line on standard output. A closed pipe is no failure.
pub fn say(line: &str) -> Result<(), Failure> {
    say_by(|out| writeln!(out, "{line}"))
}

/// Prints on standard output what `write` writes. A closed pipe is no failure.
pub fn say_by(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Failure> {
    let mut out = BufWriter::new(io::stdout().lock());
    match write(&mut out).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Failure::bad(format!("standard output: {error}; check where it is redirected to")))
        }
        _ => Ok(()),
    }
}

/// Prints a line on standard error. Replaces control characters, which file names may hold.
pub fn complain(line: &str) {
    let line: String = line.chars().map(|c| if c.is_control() { '\u{fffd}' } else { c }).collect();
    let _ = writeln!(io::stderr().lock(), "triquad: {line}");
}
