//! Number of threads that the library's parallel parts use.

use std::num::NonZeroUsize;
#[cfg(unix)]
use std::process::Command;

use rayon::{ThreadPoolBuildError, ThreadPoolBuilder};
use triquad_lab::experiment::process::RUN_VARIABLE;

#[cfg(unix)]
use crate::stdio;

/// The most threads: they work on one core each, and starting very many takes minutes.
const MOST: usize = 1024;

/// Parses a number of threads.
pub fn count(text: &str) -> Result<NonZeroUsize, String> {
    let count = text.parse::<NonZeroUsize>().ok().filter(|count| count.get() <= MOST);
    count.ok_or_else(|| format!("'{text}' is not a number from 1 to {MOST}"))
}

/// Sets the number of threads: `wanted`, else one for each core.
///
/// A run of an experiment takes one, like the programs of the papers. Where threads cannot be had,
/// this one does everything: the results are the same.
pub fn settle(wanted: Option<NonZeroUsize>) {
    let is_one = [RUN_VARIABLE, ALONE].into_iter().any(|name| std::env::var_os(name).is_some());
    let threads = if is_one { 1 } else { wanted.map_or(0, NonZeroUsize::get) };
    if threads == 1 {
        // Fails if a pool exists already, which then does the work.
        let _ = ThreadPoolBuilder::new().num_threads(1).use_current_thread().build_global();
    } else if pool(threads).is_err() {
        #[cfg(unix)]
        start_over_alone();
    }
}

/// Set for a process that could not have as many threads as it wanted.
const ALONE: &str = "TRIQUAD_ALONE";

/// Becomes the same program with one thread: where a pool could not be made, rayon makes no other.
/// Nothing has been read or written yet.
#[cfg(unix)]
fn start_over_alone() {
    use std::os::unix::process::CommandExt;
    if let Ok(program) = std::env::current_exe() {
        let words = std::env::args_os().skip(1);
        let error = Command::new(program).args(words).env(ALONE, "1").exec();
        stdio::complain(&format!("no threads, and no other start: {error}"));
    }
}

/// Starts `threads` threads; 0 stands for one a core, or the number in `RAYON_NUM_THREADS`.
fn pool(threads: usize) -> Result<(), ThreadPoolBuildError> {
    ThreadPoolBuilder::new().num_threads(threads).build_global()
}
