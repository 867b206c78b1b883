//! Nested sets: the smallest one that holds two given ones, in constant time.
//!
//! Schieber and Vishkin, *On Finding Lowest Common Ancestors*, 1988: paths of the tree are mapped
//! to the nodes of a complete binary tree, whose bits determine common ancestors.

use super::super::problem::NONE;

/// A forest of sets, prepared for questions. 20 bytes a set.
pub(super) struct Nesting {
    /// Parent of each set, the root's number for outermost ones.
    parents: Vec<u32>,
    /// Position in preorder, from 1; the root is first.
    order: Vec<u32>,
    /// Number of the set's path in the binary tree.
    path: Vec<u32>,
    /// One bit for the height of each path between the set and the root.
    heights: Vec<u32>,
    /// The outermost set of each path.
    head: Vec<u32>,
}

impl Nesting {
    /// Prepares a forest in which parents have greater numbers than their children.
    ///
    /// A root is added that holds all sets; its number is the count of sets. O(sets).
    pub(super) fn new(parents: &[u32]) -> Self {
        let root = parents.len() as u32;
        let parents: Vec<u32> =
            parents.iter().map(|&parent| if parent == NONE { root } else { parent }).collect();
        let sizes = sizes(&parents);
        let order = preorder(&parents, &sizes);
        let path: Vec<u32> = order.iter().zip(&sizes).map(|(&at, &size)| path(at, size)).collect();
        let mut head = vec![0; order.len() + 1];
        (0..).zip(&path).for_each(|(set, &path)| head[path as usize] = set);
        let mut heights: Vec<u32> = path.iter().map(|path| 1 << path.trailing_zeros()).collect();
        for set in (0..parents.len()).rev() {
            heights[set] |= heights[parents[set] as usize];
        }
        Self { parents, order, path, heights, head }
    }

    /// Returns the smallest set that holds both `a` and `b`; the root if there is none. O(1).
    pub(super) fn smallest_common(&self, a: u32, b: u32) -> u32 {
        let (pa, pb) = (self.path[a as usize], self.path[b as usize]);
        let [a, b] = if pa == pb {
            [a, b]
        } else {
            let differ = 31 - (pa ^ pb).leading_zeros();
            let common = self.heights[a as usize] & self.heights[b as usize];
            let height = (common >> differ << differ).trailing_zeros();
            [a, b].map(|set| self.ancestor_on(set, height))
        };
        if self.order[a as usize] <= self.order[b as usize] { a } else { b }
    }

    /// Returns the innermost ancestor of `set` on the path of this height above it.
    fn ancestor_on(&self, set: u32, height: u32) -> u32 {
        let path = self.path[set as usize];
        if path.trailing_zeros() == height {
            return set;
        }
        let below = self.heights[set as usize] & ((1 << height) - 1);
        let bit = 31 - below.leading_zeros();
        let last = (path >> bit | 1) << bit;
        self.parents[self.head[last as usize] as usize]
    }
}

/// Returns the number of sets in each set, itself included; the root's count comes last.
fn sizes(parents: &[u32]) -> Vec<u32> {
    let mut sizes = vec![1; parents.len() + 1];
    for (set, &parent) in parents.iter().enumerate() {
        sizes[parent as usize] += sizes[set];
    }
    sizes
}

/// Returns the position of each set in preorder, from 1.
fn preorder(parents: &[u32], sizes: &[u32]) -> Vec<u32> {
    let mut order = vec![1; sizes.len()];
    let mut next = vec![2; sizes.len()];
    for (set, &parent) in parents.iter().enumerate().rev() {
        order[set] = next[parent as usize];
        next[parent as usize] += sizes[set];
        next[set] = order[set] + 1;
    }
    order
}

/// Returns the number with the most trailing zeros among `size` numbers from `first`.
fn path(first: u32, size: u32) -> u32 {
    let last = first + size - 1;
    let bit = 31 - ((first - 1) ^ last).leading_zeros();
    last >> bit << bit
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Climbs from both sets; the lower number is never an ancestor of the other.
    fn climb(parents: &[u32], mut a: u32, mut b: u32) -> u32 {
        let root = parents.len() as u32;
        while a != b {
            let lower = if a < b { &mut a } else { &mut b };
            *lower = Some(parents[*lower as usize]).filter(|&up| up != NONE).unwrap_or(root);
        }
        a
    }

    proptest! {
        #[test]
        fn the_smallest_common_set_is_the_one_found_by_climbing(
            draws in proptest::collection::vec(any::<u32>(), 0..60), spread in 1..60u32,
        ) {
            let count = draws.len() as u32;
            let parent = |(set, draw): (u32, &u32)| {
                let up = set + 1 + draw % spread;
                if up < count { up } else { NONE }
            };
            let parents: Vec<u32> = (0..).zip(&draws).map(parent).collect();
            let nesting = Nesting::new(&parents);
            for a in 0..count {
                for b in 0..count {
                    prop_assert_eq!(nesting.smallest_common(a, b), climb(&parents, a, b));
                }
            }
        }
    }
}
