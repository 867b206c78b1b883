//! Nodes and blossoms. An odd cycle of tight edges is a blossom, and so is an odd cycle of nodes
//! and blossoms; the ones on the cycle are its *kids*.
//!
//! Nodes and blossoms share one numbering: blossom b has number n + b. What lies in no blossom is
//! *outermost*. All nodes of an outermost blossom share a *set*: its label and an offset that is
//! part of their potentials. A new blossom takes over the set of its largest kid, so that few nodes
//! are touched, and hands it back when it is taken apart. Blossoms are nested thousands deep;
//! nothing here costs time in proportion to that depth.

use super::super::nodes::{Label, NONE, Nodes};
use super::super::number::Number;
use super::super::refusal::Refusal;

/// A kid of a blossom and the half-edge from it to the next one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Kid {
    pub(crate) top: u32,
    pub(crate) edge: u32,
}

/// An odd cycle of nodes and blossoms.
#[derive(Clone, Debug)]
pub(crate) struct Blossom<N> {
    /// The blossom that this one is a kid of, by its number; `NONE` if outermost.
    pub(crate) up: u32,
    /// Half-edge to the mate; its origin is the base, which is paired outside the blossom.
    pub(crate) mate: u32,
    /// Half-edge to the parent in the tree.
    pub(crate) parent: u32,
    pub(crate) set: u32,
    /// Number of nodes, and their list: `next` leads from the first to the last.
    pub(crate) size: u32,
    pub(crate) first: u32,
    pub(crate) last: u32,
    /// Dual value, less the clock if labelled outer, plus the clock if inner.
    pub(crate) value: N,
    /// Empty in a blossom that does not exist.
    pub(crate) kids: Vec<Kid>,
    pub(crate) is_marked: bool,
}

/// State shared by the nodes of an outermost blossom.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Set<N> {
    pub(crate) offset: N,
    /// Number of the outermost blossom.
    pub(crate) top: u32,
    pub(crate) label: Label,
}

/// All nodes and blossoms.
pub(crate) struct Family<S: Nodes> {
    pub(crate) nodes: S,
    /// For each node in range the next one in the list of a blossom.
    pub(super) next: Vec<u32>,
    pub(crate) blossoms: Vec<Blossom<S::N>>,
    pub(crate) sets: Vec<Set<S::N>>,
    /// For each set the half-edges from outer nodes that met it while it was inner.
    pub(crate) pending: Vec<Vec<u32>>,
    pub(super) unused_blossoms: Vec<u32>,
    pub(super) unused_sets: Vec<u32>,
}

impl<S: Nodes> Family<S> {
    pub(crate) fn new(nodes: S) -> Self {
        Self {
            next: vec![NONE; nodes.range().len()],
            nodes,
            blossoms: Vec::new(),
            sets: Vec::new(),
            pending: Vec::new(),
            unused_blossoms: Vec::new(),
            unused_sets: Vec::new(),
        }
    }

    /// Returns the node after this one in the list of a blossom.
    #[inline]
    pub(crate) fn next(&self, node: u32) -> u32 {
        self.next[(node - self.nodes.range().start) as usize]
    }

    pub(crate) fn set_next(&mut self, node: u32, next: u32) {
        let first = self.nodes.range().start;
        self.next[(node - first) as usize] = next;
    }

    /// Returns the place of a blossom in the array, or `None` for a node.
    #[inline]
    pub(crate) fn place(&self, top: u32) -> Option<usize> {
        top.checked_sub(self.nodes.len()).map(|place| place as usize)
    }

    #[inline]
    pub(crate) fn blossom(&self, top: u32) -> &Blossom<S::N> {
        &self.blossoms[(top - self.nodes.len()) as usize]
    }

    #[inline]
    pub(crate) fn blossom_mut(&mut self, top: u32) -> &mut Blossom<S::N> {
        &mut self.blossoms[(top - self.nodes.len()) as usize]
    }

    /// Returns the outermost blossom that holds a node, or the node.
    #[inline]
    pub(crate) fn top(&self, node: u32) -> u32 {
        match self.nodes.set(node) {
            NONE => node,
            set => self.sets[set as usize].top,
        }
    }

    /// Returns the label of a node's top, and the node's potential at a time of the clock.
    #[inline]
    pub(crate) fn standing(&self, node: u32, clock: S::N) -> (Label, S::N) {
        let stored = self.nodes.potential(node);
        let (label, potential) = match self.nodes.set(node) {
            NONE => (self.nodes.label(node), stored),
            set => {
                let set = &self.sets[set as usize];
                (set.label, stored + set.offset)
            }
        };
        (label, potential + rise(label, clock))
    }

    /// Returns 2c − π(u) − π(v) of an edge between different tops.
    pub(crate) fn slack(&self, half_edge: u32, clock: S::N) -> S::N {
        let [u, v] = [self.nodes.origin(half_edge), self.nodes.head(half_edge)];
        let [(_, pu), (_, pv)] = [u, v].map(|node| self.standing(node, clock));
        self.nodes.cost(half_edge) - pu - pv
    }

    #[inline]
    pub(crate) fn mate(&self, top: u32) -> u32 {
        match self.place(top) {
            None => self.nodes.mate(top),
            Some(place) => self.blossoms[place].mate,
        }
    }

    pub(crate) fn set_mate(&mut self, top: u32, half_edge: u32) {
        match self.place(top) {
            None => self.nodes.set_mate(top, half_edge),
            Some(place) => self.blossoms[place].mate = half_edge,
        }
    }

    pub(crate) fn parent(&self, top: u32) -> u32 {
        match self.place(top) {
            None => self.nodes.parent(top),
            Some(place) => self.blossoms[place].parent,
        }
    }

    pub(crate) fn set_parent(&mut self, top: u32, half_edge: u32) {
        match self.place(top) {
            None => self.nodes.set_parent(top, half_edge),
            Some(place) => self.blossoms[place].parent = half_edge,
        }
    }

    pub(crate) fn label(&self, top: u32) -> Label {
        match self.place(top) {
            None => self.nodes.label(top),
            Some(place) => self.sets[self.blossoms[place].set as usize].label,
        }
    }

    pub(crate) fn set_label(&mut self, top: u32, label: Label) {
        match self.place(top) {
            None => self.nodes.set_label(top, label),
            Some(place) => self.sets[self.blossoms[place].set as usize].label = label,
        }
    }

    /// Changes the potentials of all nodes in a top.
    pub(crate) fn raise(&mut self, top: u32, change: S::N) {
        match self.place(top) {
            None => self.nodes.add_potential(top, change),
            Some(place) => self.sets[self.blossoms[place].set as usize].offset += change,
        }
    }

    pub(crate) fn is_marked(&self, top: u32) -> bool {
        match self.place(top) {
            None => self.nodes.is_marked(top),
            Some(place) => self.blossoms[place].is_marked,
        }
    }

    pub(crate) fn set_marked(&mut self, top: u32, marked: bool) {
        match self.place(top) {
            None => self.nodes.set_marked(top, marked),
            Some(place) => self.blossoms[place].is_marked = marked,
        }
    }

    /// Returns the number of nodes in a top.
    pub(crate) fn size(&self, top: u32) -> u32 {
        self.place(top).map_or(1, |place| self.blossoms[place].size)
    }

    /// Returns the first and the last node in the list of a top.
    pub(crate) fn ends(&self, top: u32) -> (u32, u32) {
        match self.place(top) {
            None => (top, top),
            Some(place) => (self.blossoms[place].first, self.blossoms[place].last),
        }
    }

    /// Returns whether a number stands for a node or a blossom that exists, in no other blossom.
    pub(crate) fn is_outermost(&self, top: u32) -> bool {
        match self.place(top) {
            None => self.nodes.set(top) == NONE,
            Some(place) => !self.blossoms[place].kids.is_empty() && self.blossoms[place].up == NONE,
        }
    }

    /// Returns the number of a new blossom; all its fields but `kids` are for the caller to set.
    pub(crate) fn new_blossom(&mut self, blossom: Blossom<S::N>) -> u32 {
        let place = match self.unused_blossoms.pop() {
            Some(place) => {
                self.blossoms[place as usize] = blossom;
                place
            }
            None => {
                self.blossoms.push(blossom);
                self.blossoms.len() as u32 - 1
            }
        };
        self.nodes.len() + place
    }

    /// Ends a blossom and returns its kids.
    pub(crate) fn remove_blossom(&mut self, top: u32) -> Vec<Kid> {
        self.unused_blossoms.push(top - self.nodes.len());
        std::mem::take(&mut self.blossom_mut(top).kids)
    }

    pub(crate) fn new_set(&mut self, set: Set<S::N>) -> Result<u32, Refusal> {
        if let Some(place) = self.unused_sets.pop() {
            self.sets[place as usize] = set;
            return Ok(place);
        }
        if self.sets.len() > S::MOST_SETS as usize {
            return Err(Refusal::TooNarrow);
        }
        self.sets.push(set);
        self.pending.push(Vec::new());
        Ok(self.sets.len() as u32 - 1)
    }

    pub(crate) fn remove_set(&mut self, set: u32) {
        self.clear_pending(set);
        self.unused_sets.push(set);
    }

    /// Empties a list of half-edges; gives the memory of long ones back.
    pub(crate) fn clear_pending(&mut self, set: u32) {
        let pending = &mut self.pending[set as usize];
        if pending.capacity() > 64 {
            *pending = Vec::new();
        } else {
            pending.clear();
        }
    }
}

/// Returns how much the clock adds to stored potentials under a label.
#[inline]
pub(crate) fn rise<N: Number>(label: Label, clock: N) -> N {
    // Labels are hard to predict: nothing branches.
    let if_so = |is_so: bool| if is_so { clock } else { N::ZERO };
    if_so(label == Label::Outer) - if_so(label == Label::Inner)
}
