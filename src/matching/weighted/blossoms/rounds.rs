//! Rounds of searches, each with a greater limit than the one before.

use std::ops::Range;

use super::super::limits::Limits;
use super::super::nodes::{Label, NONE, Nodes};
use super::super::observer::{Observer, Stage};
use super::super::refusal::Refusal;
use super::super::roots::Roots;
use super::search::{Found, Trees};

impl<S: Nodes> Trees<S> {
    /// Pairs every root: free nodes, and one node of every half-integral cycle. Those that were cut
    /// before, at limits up to `most`, miss these rounds. Roots that are many for their limit grow
    /// together at last.
    pub(crate) fn pair_all(
        &mut self,
        mut left: Roots,
        most: usize,
        limits: Limits,
        observer: &mut Observer,
    ) -> Result<(), Refusal> {
        let mut roots = left.take_blocked();
        let mut limit = limits.first;
        while !(roots.is_empty() && left.cut.is_empty()) {
            if limit > most {
                left.join_cut(&mut roots);
                let visits = roots.len().saturating_mul(limit) as u64;
                if visits > u64::from(limits.patience) * u64::from(self.family.nodes.len()) {
                    return self.grow_together(roots, observer);
                }
            }
            self.search_each(&mut roots, &mut left.blocked, limit, observer)?;
            limit = limits.next(limit);
        }
        Ok(())
    }

    /// Pairs roots with the limits up to the end of `within`; returns the others. Those that were
    /// cut before miss the rounds with limits up to its start.
    pub(crate) fn pair_within(
        &mut self,
        within: Range<usize>,
        mut left: Roots,
        limits: Limits,
        observer: &mut Observer,
    ) -> Result<Roots, Refusal> {
        let mut roots = left.take_blocked();
        let mut limit = limits.first;
        while limit <= within.end && !(roots.is_empty() && left.cut.is_empty()) {
            if limit > within.start {
                left.join_cut(&mut roots);
            }
            self.search_each(&mut roots, &mut left.blocked, limit, observer)?;
            limit = limits.next(limit);
        }
        left.cut.append(&mut roots);
        Ok(left)
    }

    /// Searches from each root; keeps the roots whose trees were cut, and puts those apart that are
    /// blocked.
    fn search_each(
        &mut self,
        roots: &mut Vec<u32>,
        blocked: &mut Vec<u32>,
        limit: usize,
        observer: &mut Observer,
    ) -> Result<(), Refusal> {
        let mut kept = 0;
        for place in 0..roots.len() {
            let root = roots[place];
            if observer.stops(Stage::Blossoms, roots.len() - place + kept) {
                return Err(Refusal::Stopped(self.bound()));
            }
            if !self.is_free(root) {
                continue;
            }
            match self.search(root, limit)? {
                Found::Mate => {}
                Found::Border => blocked.push(root),
                Found::Nothing => {
                    roots[kept] = root;
                    kept += 1;
                }
            }
        }
        roots.truncate(kept);
        Ok(())
    }

    /// Returns whether a root still needs a mate.
    pub(super) fn is_free(&self, root: u32) -> bool {
        self.family.nodes.label(root) == Label::Half
            || self.family.mate(self.family.top(root)) == NONE
    }
}
