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

/// Receives progress events and can stop the conversion between two searches.
pub trait Progress {
    /// Called at the beginning of each stage.
    fn stage(&mut self, _stage: Stage) {}

    /// Called now and then while `best` searches, with the number of triangles still to be paired.
    /// [`ControlFlow::Break`] stops the conversion.
    fn searching(&mut self, _left: usize) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    /// Called after each augmenting path. [`ControlFlow::Break`] stops the conversion.
    fn path_found(&mut self) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}

impl Progress for () {}
