//! What is going on, on standard error when that is a terminal.

use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};
use triquad::{Progress, Stage};

/// One line that says what is being done and, while paths are searched, how many are found.
///
/// Hidden where standard error is no terminal; cleared when dropped.
pub struct StatusLine(ProgressBar);

impl StatusLine {
    /// Shows `message`.
    pub fn new(message: &str) -> Self {
        let bar = ProgressBar::new_spinner();
        bar.enable_steady_tick(Duration::from_millis(120));
        bar.set_message(message.to_owned());
        Self(bar)
    }

    /// Shows another message.
    pub fn say(&self, message: &str) {
        self.0.set_style(ProgressStyle::default_spinner());
        self.0.set_message(message.to_owned());
    }
}

impl Progress for StatusLine {
    fn stage(&mut self, stage: Stage) {
        match stage {
            Stage::Building => self.say("building the triangulation"),
            Stage::Pairing => self.say("pairing triangles"),
            Stage::Checking => self.say("checking the quads"),
            Stage::Augmenting(paths) => {
                let template = "{spinner} augmenting paths: {pos} of {len} found, {eta} left";
                if let Ok(style) = ProgressStyle::with_template(template) {
                    self.0.set_style(style);
                }
                self.0.reset();
                self.0.set_length(paths as u64);
            }
        }
    }

    fn path_found(&mut self) {
        self.0.inc(1);
    }
}

impl Drop for StatusLine {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
