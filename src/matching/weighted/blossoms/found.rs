//! New blossoms: of half-integral cycles, and of cycles in the tree.

use super::super::nodes::{Label, NONE, Nodes};
use super::super::number::Number;
use super::super::refusal::Refusal;
use super::family::{Blossom, Kid, Set};
use super::search::Trees;

impl<S: Nodes> Trees<S> {
    /// Returns the outermost blossom of a root, new if the root is on a half-integral cycle.
    pub(super) fn root_top(&mut self, root: u32) -> Result<u32, Refusal> {
        if self.family.nodes.label(root) != Label::Half {
            return Ok(self.family.top(root));
        }
        let mut kids = Vec::new();
        let mut node = root;
        loop {
            let edge = self.family.nodes.mate(node);
            kids.push(Kid { top: node, edge });
            node = self.family.nodes.head(edge);
            if node == root {
                break;
            }
        }
        let set = self.family.new_set(Set { offset: S::N::ZERO, top: 0, label: Label::Free })?;
        for kid in &kids {
            self.family.nodes.set_label(kid.top, Label::Free);
            self.family.nodes.set_set(kid.top, set);
        }
        Ok(self.found_blossom(kids, set, NONE, S::N::ZERO))
    }

    /// Makes a blossom of kids that have the blossom's set already.
    pub(super) fn found_blossom(
        &mut self,
        kids: Vec<Kid>,
        set: u32,
        mate: u32,
        value: S::N,
    ) -> u32 {
        let family = &mut self.family;
        let (first, mut last) = family.ends(kids[0].top);
        let mut size = family.size(kids[0].top);
        for kid in &kids[1..] {
            let (kid_first, kid_last) = family.ends(kid.top);
            family.set_next(last, kid_first);
            last = kid_last;
            size += family.size(kid.top);
        }
        let tops: Vec<u32> = kids.iter().map(|kid| kid.top).collect();
        let top = family.new_blossom(Blossom {
            up: NONE,
            mate,
            parent: NONE,
            set,
            size,
            first,
            last,
            value,
            kids,
            is_marked: false,
        });
        for kid in tops {
            if let Some(place) = family.place(kid) {
                family.blossoms[place].up = top;
            }
        }
        family.sets[set as usize].top = top;
        top
    }
}
