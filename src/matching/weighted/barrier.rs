//! Sets of nodes that show how many nodes every matching leaves unpaired (Tutte 1947, Berge 1958).
//!
//! Without the nodes of a set A the graph falls apart. Each component of an odd number of nodes has
//! a node that is unpaired or paired with one in A, and A has |A| nodes to give.

use super::problem::{NONE, Problem};

/// A set A of nodes as evidence that a perfect matching, or a larger one, is impossible.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Barrier {
    /// The nodes of the set, in order, each once.
    pub nodes: Vec<u32>,
}

impl Barrier {
    /// Returns a lower bound on the unpaired nodes of every matching: the odd components without
    /// the set, less its size. O((nodes + edges) log nodes).
    ///
    /// # Panics
    /// If a node of the set or of an edge does not exist.
    pub fn least_unpaired(&self, problem: &impl Problem) -> usize {
        let components = Components::without(problem, &self.nodes);
        components.odd(problem, |_| true).saturating_sub(self.nodes.len())
    }

    /// Returns whether the set proves that some node without a price stays unpaired: there are more
    /// odd components of such nodes than nodes in the set. O((nodes + edges) log nodes).
    ///
    /// # Panics
    /// If a node of the set or of an edge does not exist.
    pub fn proves_infeasible(&self, problem: &impl Problem) -> bool {
        let components = Components::without(problem, &self.nodes);
        let must_pair = |node| problem.price(node).is_none();
        components.odd(problem, must_pair) > self.nodes.len()
    }
}

/// Components of a graph without some of its nodes, by union-find with halved paths.
struct Components {
    removed: Vec<bool>,
    up: Vec<u32>,
}

impl Components {
    fn without(problem: &impl Problem, nodes: &[u32]) -> Self {
        let count = problem.node_count();
        let mut components = Self { removed: vec![false; count], up: (0..count as u32).collect() };
        nodes.iter().for_each(|&node| components.removed[node as usize] = true);
        for edge in problem.edges() {
            if !edge.ends.iter().any(|&end| components.removed[end as usize]) {
                components.join(edge.ends);
            }
        }
        components
    }

    fn join(&mut self, ends: [u32; 2]) {
        let [a, b] = ends.map(|end| self.find(end));
        self.up[a.max(b) as usize] = a.min(b);
    }

    fn find(&mut self, mut node: u32) -> u32 {
        while self.up[node as usize] != node {
            let next = self.up[self.up[node as usize] as usize];
            self.up[node as usize] = next;
            node = next;
        }
        node
    }

    /// Counts the odd components all of whose nodes are `counted`.
    fn odd(mut self, problem: &impl Problem, counted: impl Fn(u32) -> bool) -> usize {
        let count = problem.node_count() as u32;
        let mut parity = vec![0_u32; count as usize];
        for node in 0..count {
            if self.removed[node as usize] {
                continue;
            }
            let slot = &mut parity[self.find(node) as usize];
            *slot = if *slot == NONE || !counted(node) { NONE } else { *slot ^ 1 };
        }
        parity.into_iter().filter(|&parity| parity == 1).count()
    }
}
