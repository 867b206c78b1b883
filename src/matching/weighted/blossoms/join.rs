//! Families of parts of the nodes become one of all.

use std::ops::Range;

use super::super::nodes::{NONE, Nodes};
use super::super::number::Number;
use super::super::work::Work;
use super::family::{Blossom, Family, Kid, Set};
use super::search::Trees;

/// The blossoms of a range of nodes, without the nodes. No search is under way.
pub(crate) struct Grown<N> {
    range: Range<u32>,
    next: Vec<u32>,
    blossoms: Vec<Blossom<N>>,
    sets: Vec<Set<N>>,
    unused_blossoms: Vec<u32>,
    unused_sets: Vec<u32>,
    work: Work,
}

impl<S: Nodes> Trees<S> {
    /// Leaves the nodes behind.
    pub(crate) fn into_grown(self) -> Grown<S::N> {
        let range = self.family.nodes.range();
        let Family { next, blossoms, sets, unused_blossoms, unused_sets, .. } = self.family;
        Grown { range, next, blossoms, sets, unused_blossoms, unused_sets, work: self.work }
    }

    /// Joins the trees of parts, at least one, that hold each node once, in order.
    ///
    /// The sets of the nodes must have been renumbered: see [`Grown::renumber_sets`].
    pub(crate) fn join(nodes: S, parts: Vec<Grown<S::N>>, mut work: Work) -> Self {
        let count = nodes.len();
        let mut parts = parts.into_iter();
        let first = parts.next().expect("there is a part");
        work.add(first.work);
        let Grown { next, blossoms, sets, unused_blossoms, unused_sets, .. } = first;
        let pending = vec![Vec::new(); sets.len()];
        let family = Family { nodes, next, blossoms, sets, pending, unused_blossoms, unused_sets };
        let mut trees = Self::of(family, work);
        parts.for_each(|part| trees.add(part, count));
        trees
    }

    fn add(&mut self, part: Grown<S::N>, nodes: u32) {
        let family = &mut self.family;
        let (blossoms, sets) = (family.blossoms.len() as u32, family.sets.len() as u32);
        let top = |top: u32| if top == NONE || top < nodes { top } else { top + blossoms };
        family.next.extend(part.next);
        family.blossoms.extend(part.blossoms.into_iter().map(|mut blossom| {
            blossom.up = top(blossom.up);
            // Stale in a blossom that is not outermost.
            blossom.set = blossom.set.wrapping_add(sets);
            blossom.kids.iter_mut().for_each(|kid: &mut Kid| kid.top = top(kid.top));
            blossom
        }));
        family.pending.extend(part.sets.iter().map(|_| Vec::new()));
        family.sets.extend(part.sets.into_iter().map(|set| Set { top: top(set.top), ..set }));
        family.unused_blossoms.extend(part.unused_blossoms.into_iter().map(|b| b + blossoms));
        family.unused_sets.extend(part.unused_sets.into_iter().map(|set| set + sets));
        self.work.add(part.work);
    }
}

impl<N: Number> Grown<N> {
    /// Makes a part without blossoms.
    pub(crate) fn new(range: Range<u32>) -> Self {
        Self {
            next: vec![NONE; range.len()],
            range,
            blossoms: Vec::new(),
            sets: Vec::new(),
            unused_blossoms: Vec::new(),
            unused_sets: Vec::new(),
            work: Work::default(),
        }
    }

    /// Returns the nodes of the part.
    pub(crate) fn range(&self) -> Range<u32> {
        self.range.clone()
    }

    /// Returns the number of sets.
    pub(crate) fn set_count(&self) -> usize {
        self.sets.len()
    }

    /// Adds `before`, the number of sets of earlier parts, to the sets of the part's nodes.
    /// O(nodes in range).
    pub(crate) fn renumber_sets<S: Nodes>(nodes: &mut S, before: u32) {
        for node in nodes.range() {
            let set = nodes.set(node);
            if set != NONE {
                nodes.set_set(node, set + before);
            }
        }
    }
}
