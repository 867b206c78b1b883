//! Progress of a conversion, and the caller's word to stop it.

use std::ops::ControlFlow;

/// A stage of a conversion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Stage {
    /// Adjacency and validation.
    Building,
    /// The initial pairing.
    Pairing,
    /// Augmenting paths; holds the number of paths needed.
    Augmenting(usize),
    /// Quads and their check.
    Checking,
}

/// Receives progress events and can stop the augmentation between two paths.
pub trait Progress {
    /// Called at the beginning of each stage.
    fn stage(&mut self, _stage: Stage) {}

    /// Called after each augmenting path. [`ControlFlow::Break`] stops the conversion.
    fn path_found(&mut self) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}

impl Progress for () {}
