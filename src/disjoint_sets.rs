//! Disjoint sets whose members know their parity relative to the root.

/// Disjoint sets over `0..n`, each member even or odd relative to the root of its set.
///
/// Union by size and path halving; without parities (all joins even) these are the ordinary sets.
pub(crate) struct ParitySets {
    parent: Vec<u32>,
    size: Vec<u32>,
    odd: Vec<bool>,
}

impl ParitySets {
    /// `n` sets of one even member each.
    pub(crate) fn new(n: usize) -> Self {
        Self { parent: (0..n as u32).collect(), size: vec![1; n], odd: vec![false; n] }
    }

    /// The root of the set of `member`, and whether `member` is odd relative to it.
    pub(crate) fn find(&mut self, member: u32) -> (u32, bool) {
        let mut at = member as usize;
        let mut odd = false;
        while self.parent[at] as usize != at {
            let up = self.parent[at] as usize;
            // Halving: skip the parent, adding its parity to ours (a root's is even).
            self.odd[at] ^= self.odd[up];
            self.parent[at] = self.parent[up];
            odd ^= self.odd[at];
            at = self.parent[at] as usize;
        }
        (at as u32, odd)
    }

    /// Joins the sets of `a` and `b` so that they differ in parity exactly if `differ`.
    ///
    /// False if both are in one set already with the other relation.
    pub(crate) fn join(&mut self, a: u32, b: u32, differ: bool) -> bool {
        let ((root_a, odd_a), (root_b, odd_b)) = (self.find(a), self.find(b));
        let parity = odd_a ^ odd_b ^ differ;
        if root_a == root_b {
            return !parity;
        }
        let a_larger = self.size[root_a as usize] >= self.size[root_b as usize];
        let (above, below) = if a_larger { (root_a, root_b) } else { (root_b, root_a) };
        self.parent[below as usize] = above;
        self.odd[below as usize] = parity;
        self.size[above as usize] += self.size[below as usize];
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parities_follow_the_joins() {
        let mut sets = ParitySets::new(8);
        for v in 0..6 {
            assert!(sets.join(v, v + 1, v % 2 == 0));
        }
        let relative = |sets: &mut ParitySets, a, b| sets.find(a).1 ^ sets.find(b).1;
        assert!(relative(&mut sets, 0, 1));
        assert!(relative(&mut sets, 0, 2));
        assert!(!relative(&mut sets, 0, 4));
        assert!(sets.join(0, 4, false));
        assert!(!sets.join(0, 4, true), "an odd cycle");
        assert_ne!(sets.find(7).0, sets.find(0).0);
    }
}
