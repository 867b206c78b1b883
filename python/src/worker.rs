//! Runs a call beside the interpreter, so that other threads go on and Ctrl-C ends it.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use rayon::ThreadPoolBuilder;
use triquad::Progress;

use crate::failure::Failure;

/// Time between two looks at the signals that have come.
const INTERVAL: Duration = Duration::from_millis(50);

/// The caller's word to stop.
#[derive(Clone, Debug, Default)]
pub struct Cancel(Arc<AtomicBool>);

impl Cancel {
    /// Returns whether the caller has gone.
    pub fn is_set(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }

    /// Returns what a hook answers.
    pub fn flow(&self) -> ControlFlow<()> {
        if self.is_set() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

impl Progress for Cancel {
    fn searching(&mut self, _left: usize) -> ControlFlow<()> {
        self.flow()
    }

    fn path_found(&mut self) -> ControlFlow<()> {
        self.flow()
    }
}

/// Runs `work` in a thread of its own without the interpreter lock. Its parallel parts use
/// `threads` threads, or one for each core for 0.
///
/// These threads end with the call, so that a process may be forked after it. An interrupt is
/// raised at once. The work then ends at its next look at `Cancel`; its result is dropped.
///
/// # Errors
/// Those of `work`, the exception of a signal handler, and `RuntimeError` if `work` panics.
pub fn run<T: Send + 'static>(
    py: Python<'_>,
    threads: usize,
    work: impl FnOnce(&Cancel) -> Result<T, Failure> + Send + 'static,
) -> PyResult<T> {
    let cancel = Cancel::default();
    let (sender, mut receiver) = channel();
    let seen = cancel.clone();
    thread::Builder::new().name("triquad".into()).spawn(move || {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build();
        let result = match pool {
            Ok(pool) => pool.install(|| work(&seen)),
            Err(error) => Err(Failure::Value(format!("threads: {error}"))),
        };
        // Nobody listens after an interrupt.
        let _ = sender.send(result);
    })?;
    loop {
        let waiting = &mut receiver;
        match py.detach(move || waiting.recv_timeout(INTERVAL)) {
            Ok(result) => return Ok(result?),
            Err(RecvTimeoutError::Timeout) => {
                py.check_signals().inspect_err(|_| cancel.0.store(true, Ordering::Relaxed))?;
            }
            Err(RecvTimeoutError::Disconnected) => {
                return Err(PyRuntimeError::new_err("internal error, please report this"));
            }
        }
    }
}
