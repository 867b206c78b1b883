//! Printing that does not panic on a closed pipe, as loud as is wanted.

use std::io::{self, BufWriter, ErrorKind, Write};
use std::process::ExitCode;
use std::sync::OnceLock;

use triquad::mesh::io_remedy;

use crate::failure::Failure;

/// Output beside answers.
#[derive(clap::Args, Clone, Copy, Default)]
#[command(next_help_heading = "Everywhere")]
pub struct Voice {
    /// Print neither summaries nor notes, only answers and failures
    #[arg(short, long, global = true, conflicts_with = "verbose")]
    pub quiet: bool,
    /// Print every step with the seconds since the start on standard error
    #[arg(short, long, global = true)]
    pub verbose: bool,
    /// Print failures as JSON, a line each, on standard error; info prints JSON, too
    #[arg(long, global = true)]
    pub json: bool,
}

static VOICE: OnceLock<Voice> = OnceLock::new();

/// Settles what is printed, once.
pub fn settle(voice: Voice) {
    let _ = VOICE.set(voice);
}

/// Returns what was settled.
pub fn voice() -> Voice {
    VOICE.get().copied().unwrap_or_default()
}

/// Prints a summary on standard output, unless it shall be quiet.
pub fn summarise(line: &str) -> Result<(), Failure> {
    if voice().quiet { Ok(()) } else { say(line) }
}

/// Prints a note on standard error, unless it shall be quiet.
pub fn note(line: &str) {
    if !voice().quiet {
        complain(line);
    }
}

/// Prints a failure on standard error.
pub fn fail(failure: &Failure) {
    if voice().json {
        let _ = writeln!(io::stderr().lock(), "{}", failure.json());
    } else {
        complain(&failure.message);
    }
}

/// Prints a line on standard output. A closed pipe is no failure.
pub fn say(line: &str) -> Result<(), Failure> {
    say_by(|out| writeln!(out, "{line}"))
}

/// Prints on standard output what `write` writes. A closed pipe is no failure.
pub fn say_by(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Failure> {
    let mut out = BufWriter::new(io::stdout().lock());
    match write(&mut out).and_then(|()| out.flush()) {
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
