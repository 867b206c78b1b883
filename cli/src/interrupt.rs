//! What an interrupt leaves, and what it says.

use std::io::{self, IsTerminal, Write};
use std::sync::{Mutex, OnceLock, PoisonError};

use indicatif::ProgressBar;

use crate::failure::Failure;
use crate::stdio;

/// The bar that is shown.
static BAR: Mutex<Option<ProgressBar>> = Mutex::new(None);

/// What to do after an interrupt.
static REMEDY: OnceLock<&'static str> = OnceLock::new();

/// Notes that `bar` is shown, to be cleared on an interrupt.
pub fn clear_on_interrupt(bar: &ProgressBar) {
    *BAR.lock().unwrap_or_else(PoisonError::into_inner) = Some(bar.clone());
}

/// Notes what to do after an interrupt.
pub fn advise(remedy: &'static str) {
    let _ = REMEDY.set(remedy);
}

/// Removes half-written files on an interrupt, and says that it came; finished files stay.
pub fn settle() {
    let handler = || {
        triquad::atomic_file::abandon_all();
        let code = triquad_lab::experiment::process::INTERRUPTED;
        clear_line();
        let remedy = REMEDY.get().map_or(String::new(), |remedy| format!("; {remedy}"));
        let failure = Failure::with_code(code as u8, format!("interrupted{remedy}"));
        stdio::fail(&failure);
        std::process::exit(code);
    };
    // Fails only where no thread is to be had. Interrupts are ignored then, other signals are not.
    let _ = ctrlc::set_handler(handler);
}

/// Ends the line in which a terminal shows progress and `^C`.
fn clear_line() {
    let bar = BAR.try_lock().ok().and_then(|mut bar| bar.take());
    match bar.filter(|bar| !bar.is_hidden() && !bar.is_finished()) {
        Some(bar) => bar.finish_and_clear(),
        None if io::stderr().is_terminal() => {
            let _ = writeln!(io::stderr());
        }
        None => {}
    }
}
