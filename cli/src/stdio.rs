//! Printing that does not panic on a closed pipe.

use std::io::{self, ErrorKind, Write};
use std::process::ExitCode;

use triquad::mesh::io_remedy;

use crate::failure::Failure;

/// Prints a line on standard output. A closed pipe is no failure.
pub fn say(line: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match writeln!(out, "{line}").and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            let remedy = match error.kind() {
                ErrorKind::StorageFull | ErrorKind::QuotaExceeded => io_remedy(&error),
                _ => "check where it is redirected to",
            };
            let problem = crate::input::system_problem(&error);
            Err(Failure::bad(format!("standard output: {problem}; {remedy}")))
        }
        _ => Ok(()),
    }
}

/// Prints a help text; returns `code`, or 2 if that is impossible. A closed pipe is no failure.
pub fn print_help(text: &clap::Error, code: u8) -> ExitCode {
    let printed = text.print().and_then(|()| io::stdout().flush());
    match printed {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            complain(&format!("standard output: {}", crate::input::system_problem(&error)));
            ExitCode::from(2)
        }
        _ => ExitCode::from(code),
    }
}

/// Prints a line on standard error.
pub fn complain(line: &str) {
    let _ = writeln!(io::stderr().lock(), "triquad: {}", one_line(line));
}

/// Returns `text` with its control characters escaped: file names and headers may hold any.
pub fn one_line(text: &str) -> String {
    let mut line = String::with_capacity(text.len());
    for c in text.chars() {
        if c.is_control() || matches!(c, '\u{2028}' | '\u{2029}' | '\u{202a}'..='\u{202e}') {
            line.extend(c.escape_default());
        } else {
            line.push(c);
        }
    }
    line
}
