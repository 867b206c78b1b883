//! Number of threads that the library's parallel parts use.

use std::num::NonZeroUsize;

use rayon::{ThreadPoolBuildError, ThreadPoolBuilder};
use triquad_lab::experiment::process::RUN_VARIABLE;

/// Sets the number of threads: `wanted`, else one for each core.
///
/// A run of an experiment takes one, like the programs of the papers. Where threads cannot be had,
/// this one does everything: the results are the same.
pub fn settle(wanted: Option<NonZeroUsize>) {
    let is_run = std::env::var_os(RUN_VARIABLE).is_some();
    let threads = if is_run { 1 } else { wanted.map_or(0, NonZeroUsize::get) };
    if threads == 1 || pool(threads).is_err() {
        // Fails if a pool exists already, which then does the work.
        let _ = ThreadPoolBuilder::new().num_threads(1).use_current_thread().build_global();
    }
}

/// Starts `threads` threads; 0 stands for one a core, or the number in `RAYON_NUM_THREADS`.
fn pool(threads: usize) -> Result<(), ThreadPoolBuildError> {
    ThreadPoolBuilder::new().num_threads(threads).build_global()
}
