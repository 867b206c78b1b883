//! Disjoint sets, and disjoint sets whose members have a parity.

/// Disjoint sets over `0..n`, as trees of 4 bytes a member.
///
/// Searches halve their paths: O(log n) amortised, in practice O(1).
pub(crate) struct DisjointSets {
    parent: Vec<u32>,
}

impl DisjointSets {
    /// Makes `n` sets of one member each. O(n).
    pub(crate) fn new(n: usize) -> Self {
        Self { parent: (0..n as u32).collect() }
    }

    /// Returns the root of the set of `member`.
    #[inline]
    pub(crate) fn find(&mut self, member: u32) -> u32 {
        let mut at = member;
        loop {
            let up = self.parent[at as usize];
            if up == at {
                return at;
            }
            let higher = self.parent[up as usize];
            self.parent[at as usize] = higher;
            at = higher;
        }
    }

    /// Joins the sets of `a` and `b` under the lower root. Returns whether they were two.
    #[inline]
    pub(crate) fn join(&mut self, a: u32, b: u32) -> bool {
        let (a, b) = (self.find(a), self.find(b));
        if a != b {
            self.parent[a.max(b) as usize] = a.min(b);
        }
        a != b
    }

    /// Hangs the set with root `root` on a member of another set, whose root becomes that of both.
    #[inline]
    pub(crate) fn hang(&mut self, root: u32, member: u32) {
        debug_assert!(self.parent[root as usize] == root && self.find(member) != root);
        self.parent[root as usize] = member;
    }
}

/// Disjoint sets over `0..n`, each member even or odd relative to the others of its set.
///
/// Member v stands in two of the sets below: 2v in that of the members like v, 2v + 1 in that of
/// the members unlike v. 8 bytes a member.
pub(crate) struct ParitySets(DisjointSets);

impl ParitySets {
    /// Makes `n` sets of one even member each. O(n).
    pub(crate) fn new(n: usize) -> Self {
        Self(DisjointSets::new(2 * n))
    }

    /// Returns a member that names the set of `member`, and whether `member` is odd relative to it.
    pub(crate) fn find(&mut self, member: u32) -> (u32, bool) {
        let like = self.0.find(2 * member);
        let unlike = self.0.find(2 * member + 1);
        (like.min(unlike) / 2, like > unlike)
    }

    /// Joins the sets of `a` and `b` so that they differ in parity exactly if `differ`.
    ///
    /// Returns false if both are in one set already with the other relation.
    pub(crate) fn join(&mut self, a: u32, b: u32, differ: bool) -> bool {
        let [like, unlike] = [2 * b + u32::from(differ), 2 * b + u32::from(!differ)];
        if self.0.find(2 * a) == self.0.find(unlike) {
            return false;
        }
        self.0.join(2 * a, like);
        self.0.join(2 * a + 1, unlike);
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sets_are_joined_under_the_lower_root_or_as_they_are_hung() {
        let mut sets = DisjointSets::new(6);
        assert!(sets.join(4, 2) && sets.join(5, 4));
        assert_eq!([2, 4, 5].map(|v| sets.find(v)), [2; 3]);
        assert!(!sets.join(2, 5));
        sets.hang(2, 3);
        assert_eq!([2, 3, 4, 5].map(|v| sets.find(v)), [3; 4]);
        assert_eq!([0, 1].map(|v| sets.find(v)), [0, 1]);
    }

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
