//! Rounds of searches, each with a greater limit than the one before.

use super::super::limits::Limits;
use super::super::nodes::{Label, NONE, Nodes};
use super::super::observer::{Observer, Stage};
use super::super::refusal::Refusal;
use super::search::{Found, Trees};

impl<S: Nodes> Trees<S> {
    /// Pairs every root: free nodes, and one node of every half-integral cycle.
    pub(crate) fn pair_all(
        &mut self,
        roots: Vec<u32>,
        limits: Limits,
        observer: &mut Observer,
    ) -> Result<(), Refusal> {
        self.pair_within(usize::MAX, roots, limits, observer).map(|_| ())
    }

    /// Pairs roots as long as that takes no limit beyond `most`; returns the others.
    pub(crate) fn pair_within(
        &mut self,
        most: usize,
        mut roots: Vec<u32>,
        limits: Limits,
        observer: &mut Observer,
    ) -> Result<Vec<u32>, Refusal> {
        let mut limit = limits.first;
        while !roots.is_empty() && limit <= most {
            let mut kept = 0;
            for place in 0..roots.len() {
                let root = roots[place];
                if observer.stops(Stage::Blossoms, roots.len() - place + kept) {
                    return Err(Refusal::Stopped(self.bound()));
                }
                if self.is_free(root) && self.search(root, limit)? != Found::Mate {
                    roots[kept] = root;
                    kept += 1;
                }
            }
            roots.truncate(kept);
            limit = limits.next(limit);
        }
        Ok(roots)
    }

    /// Returns whether a root still needs a mate.
    fn is_free(&self, root: u32) -> bool {
        self.family.nodes.label(root) == Label::Half
            || self.family.mate(self.family.top(root)) == NONE
    }
}
