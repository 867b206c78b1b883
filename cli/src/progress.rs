//! Progress on standard error when that is a terminal.

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};
use triquad::{Progress, Stage};

use crate::{interrupt, stdio};

/// One line with the current step and, during augmentation, the number of paths found.
///
/// Hidden where standard error is no terminal; cleared when dropped. Where much shall be printed,
/// every step is a line that stays.
pub struct StatusLine {
    bar: ProgressBar,
    start: Instant,
    /// Augmenting paths until the conversion is stopped.
    paths_left: usize,
}

impl StatusLine {
    /// Shows `message`.
    pub fn new(message: &str) -> Self {
        let stdio::Voice { quiet, verbose, .. } = stdio::voice();
        let bar = if quiet || verbose {
            ProgressBar::hidden()
        } else {
            let bar = ProgressBar::new_spinner();
            if !bar.is_hidden() && threads_can_be_had() {
                bar.enable_steady_tick(Duration::from_millis(120));
            }
            bar
        };
        interrupt::clear_on_interrupt(&bar);
        let line = Self { bar, start: Instant::now(), paths_left: usize::MAX };
        line.say(message);
        line
    }

    /// Stops a conversion after `paths` augmenting paths.
    pub fn stop_after(&mut self, paths: usize) {
        self.paths_left = paths;
    }

    /// Shows another message.
    pub fn say(&self, message: &str) {
        self.bar.set_style(ProgressStyle::default_spinner());
        self.bar.set_message(message.to_owned());
        self.keep(message);
    }
}

/// Returns whether the system grants a thread: the spinner panics without.
fn threads_can_be_had() -> bool {
    std::thread::Builder::new().spawn(|| ()).is_ok()
}

impl StatusLine {
    /// Prints a line that stays, if much shall be printed.
    fn keep(&self, message: &str) {
        if stdio::voice().verbose {
            let seconds = self.start.elapsed().as_secs_f64();
            stdio::complain(&format!("{seconds:.3} s: {message}"));
        }
    }
}

impl Progress for StatusLine {
    fn stage(&mut self, stage: Stage) {
        match stage {
            Stage::Building => self.say("building the triangulation"),
            Stage::Pairing => self.say("pairing triangles"),
            Stage::Checking => self.say("checking the quads"),
            Stage::Augmenting(0) => {}
            Stage::Augmenting(paths) => {
                let template = "{spinner} augmenting paths: {pos} of {len} found, {eta} left";
                if let Ok(style) = ProgressStyle::with_template(template) {
                    self.bar.set_style(style);
                }
                self.bar.reset();
                let paths = paths.min(self.paths_left);
                self.bar.set_length(paths as u64);
                self.keep(&format!("augmenting paths: {paths} to be found"));
            }
            _ => {}
        }
    }

    fn path_found(&mut self) -> ControlFlow<()> {
        self.bar.inc(1);
        self.paths_left -= 1;
        if self.paths_left == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

impl Drop for StatusLine {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
