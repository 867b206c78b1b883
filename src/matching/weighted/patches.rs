//! Patches of neighbouring nodes, and compact parts made of them.
//!
//! A search that meets the border of a part has to wait until all nodes are in view. So a part
//! should be about as wide as it is long. Patches are few: they can be divided over and over again.

use super::problem::{CubicProblem, NONE};

/// Patches of up to so many nodes each, every node in one. 8 bytes a node.
pub(super) struct Patches {
    /// The nodes, patch after patch.
    nodes: Vec<u32>,
    /// Where each patch begins in `nodes`.
    starts: Vec<u32>,
    /// The patch of each node.
    of_node: Vec<u32>,
    /// Neighbouring patches, each pair once, the later one first.
    links: Vec<[u32; 2]>,
}

impl Patches {
    /// Grows patches breadth first, each from a node beside an earlier one. O(n).
    pub(super) fn new(problem: &impl CubicProblem, size: usize) -> Self {
        let count = problem.node_count();
        let mut all = Self {
            nodes: Vec::with_capacity(count),
            starts: Vec::new(),
            of_node: vec![NONE; count],
            links: Vec::new(),
        };
        // Nodes beside patches: those from `next` on have not been tried.
        let mut seeds = Vec::new();
        let mut next = 0;
        for node in 0..count as u32 {
            seeds.push(node);
            while let Some(&seed) = seeds.get(next) {
                next += 1;
                if all.of_node[seed as usize] == NONE {
                    all.grow(problem, seed, size, &mut seeds);
                }
            }
            seeds.clear();
            next = 0;
        }
        all.links.sort_unstable();
        all.links.dedup();
        all
    }

    /// Grows a patch around a node that is in none; adds those behind it to `seeds`.
    fn grow(&mut self, problem: &impl CubicProblem, seed: u32, size: usize, seeds: &mut Vec<u32>) {
        let patch = self.starts.len() as u32;
        let start = self.nodes.len();
        self.starts.push(start as u32);
        self.add(seed, patch);
        let mut next = start;
        while let Some(&node) = self.nodes.get(next) {
            next += 1;
            for neighbour in problem.neighbours(node) {
                match self.of_node.get(neighbour as usize) {
                    Some(&NONE) if self.nodes.len() < start + size => self.add(neighbour, patch),
                    Some(&NONE) => seeds.push(neighbour),
                    Some(&earlier) if earlier != patch => self.link(patch, earlier),
                    Some(_) | None => {}
                }
            }
        }
    }

    fn add(&mut self, node: u32, patch: u32) {
        self.of_node[node as usize] = patch;
        self.nodes.push(node);
    }

    /// Adds a pair of neighbours, sometimes once more.
    fn link(&mut self, patch: u32, earlier: u32) {
        if self.links.last() != Some(&[patch, earlier]) {
            self.links.push([patch, earlier]);
        }
    }

    /// Returns the nodes in an order in which ranges of equal length, so many, are compact. O(n).
    pub(super) fn into_parts(self, parts: usize) -> Vec<u32> {
        let mut sections = Sections::new(&self);
        let mut rest = vec![(0, self.starts.len(), parts)];
        while let Some((start, end, parts)) = rest.pop() {
            if parts > 1 {
                let middle = sections.divide(start, end, parts);
                rest.push((start, middle, parts / 2));
                rest.push((middle, end, parts - parts / 2));
            }
        }
        let order = sections.order;
        let mut nodes = Vec::with_capacity(self.nodes.len());
        order.iter().for_each(|&patch| nodes.extend_from_slice(self.nodes_of(patch)));
        nodes
    }

    fn nodes_of(&self, patch: u32) -> &[u32] {
        let end = self.starts.get(patch as usize + 1).map_or(self.nodes.len(), |&end| end as usize);
        &self.nodes[self.starts[patch as usize] as usize..end]
    }
}

/// An order of patches, in sections that are divided further and further.
struct Sections<'a> {
    patches: &'a Patches,
    /// Neighbours of all patches, one patch after the other.
    neighbours: Vec<u32>,
    /// Where the neighbours of each patch end.
    ends: Vec<u32>,
    order: Vec<u32>,
    /// The section of each patch.
    section: Vec<u32>,
    sections: u32,
    /// The last sweep that met each patch.
    met: Vec<u32>,
    sweeps: u32,
    queue: Vec<u32>,
}

impl<'a> Sections<'a> {
    /// Puts all patches in one section.
    fn new(patches: &'a Patches) -> Self {
        let count = patches.starts.len();
        let mut ends = vec![0; count];
        patches.links.as_flattened().iter().for_each(|&patch| ends[patch as usize] += 1);
        let mut sum = 0;
        for end in &mut ends {
            sum += std::mem::replace(end, sum);
        }
        let mut neighbours = vec![0; 2 * patches.links.len()];
        for &[one, other] in &patches.links {
            for (patch, neighbour) in [(one, other), (other, one)] {
                neighbours[ends[patch as usize] as usize] = neighbour;
                ends[patch as usize] += 1;
            }
        }
        Self {
            patches,
            neighbours,
            ends,
            order: (0..count as u32).collect(),
            section: vec![0; count],
            sections: 1,
            met: vec![0; count],
            sweeps: 0,
            queue: Vec::with_capacity(count),
        }
    }

    /// Divides the section at `start..end` in two, the first to be divided into half of `parts`
    /// later on; returns where.
    fn divide(&mut self, start: usize, end: usize, parts: usize) -> usize {
        // From anywhere to a far end, and back.
        self.sweep(start, end);
        self.order[start..end].reverse();
        self.sweep(start, end);
        let size = |&patch: &u32| self.patches.nodes_of(patch).len();
        let nodes: usize = self.order[start..end].iter().map(size).sum();
        let mut rest = nodes * (parts / 2) / parts;
        let mut middle = start;
        while rest > 0 && middle < end {
            rest = rest.saturating_sub(size(&self.order[middle]));
            middle += 1;
        }
        for &patch in &self.order[middle..end] {
            self.section[patch as usize] = self.sections;
        }
        self.sections += 1;
        middle
    }

    /// Orders a section breadth first.
    fn sweep(&mut self, start: usize, end: usize) {
        self.sweeps += 1;
        self.queue.clear();
        let mut next = 0;
        for place in start..end {
            self.meet(self.order[place]);
            while let Some(&patch) = self.queue.get(next) {
                next += 1;
                let first = patch.checked_sub(1).map_or(0, |before| self.ends[before as usize]);
                for place in first..self.ends[patch as usize] {
                    let neighbour = self.neighbours[place as usize];
                    if self.section[neighbour as usize] == self.section[patch as usize] {
                        self.meet(neighbour);
                    }
                }
            }
        }
        self.order[start..end].copy_from_slice(&self.queue);
    }

    /// Adds a patch to the queue once in a sweep.
    fn meet(&mut self, patch: u32) {
        if std::mem::replace(&mut self.met[patch as usize], self.sweeps) != self.sweeps {
            self.queue.push(patch);
        }
    }
}
