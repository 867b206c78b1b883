//! Roots of trees that have not been paired.

/// Roots that wait for another search.
#[derive(Debug, Default)]
pub(super) struct Roots {
    /// Their trees met the border of a part, or there has been no search from them.
    pub(super) blocked: Vec<u32>,
    /// Their trees were cut at the limits of some rounds; they miss as many later on.
    pub(super) cut: Vec<u32>,
}

impl Roots {
    /// Makes roots of nodes from which nothing has been searched.
    pub(super) fn new(nodes: Vec<u32>) -> Self {
        Self { blocked: nodes, cut: Vec::new() }
    }

    /// Returns the number of roots.
    pub(super) fn len(&self) -> usize {
        self.blocked.len() + self.cut.len()
    }

    /// Adds the roots of another part.
    pub(super) fn add(&mut self, other: Self) {
        self.blocked.extend(other.blocked);
        self.cut.extend(other.cut);
    }

    /// Returns the blocked roots, for another search from each.
    pub(super) fn take_blocked(&mut self) -> Vec<u32> {
        std::mem::take(&mut self.blocked)
    }

    /// Moves the roots that were cut to the others, all in order.
    pub(super) fn join_cut(&mut self, others: &mut Vec<u32>) {
        if !self.cut.is_empty() {
            others.append(&mut self.cut);
            others.sort_unstable();
        }
    }
}
