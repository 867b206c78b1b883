//! Printing that does not panic on a closed pipe, as loud as is wanted.

use std::io::{self, BufWriter, ErrorKind, Write};
use std::sync::OnceLock;

use crate::failure::Failure;

/// What is printed beside answers.
#[derive(clap::Args, Clone, Copy, Default)]
#[command(next_help_heading = "Everywhere")]
pub struct Voice {
    /// Print neither summaries nor notes, only what was asked for and failures
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
