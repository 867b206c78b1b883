//! Nodes of any number of sides, in compressed rows.

use super::nodes::{Label, NONE, Nodes};
use super::number::{Number, doubled};
use super::problem::Problem;
use super::refusal::Refusal;
use crate::prefetch::prefetch;

/// State of a search at a node.
#[derive(Clone, Copy, Debug)]
struct Row<N> {
    potential: N,
    mate: u32,
    parent: u32,
    set: u32,
    label: Label,
    is_marked: bool,
}

/// A half-edge.
#[derive(Clone, Copy, Debug)]
struct HalfEdge<N> {
    origin: u32,
    twin: u32,
    cost: N,
}

/// Any graph. The half-edges of a node are consecutive; the one to the ground is the last.
pub(super) struct Sparse<N> {
    rows: Vec<Row<N>>,
    half_edges: Vec<HalfEdge<N>>,
    /// First half-edge of each node, and the number of all.
    first: Vec<u32>,
    /// Empty if no node has one.
    prices: Vec<Option<N>>,
}

impl<N: Number> Sparse<N> {
    /// Reads a problem; leaves out loops. O(nodes + edges).
    pub(super) fn new(problem: &impl Problem) -> Result<Self, Refusal> {
        let count = problem.node_count();
        let first = first_half_edges(problem)?;
        let nodes = 0..count as u32;
        let mut half_edges = Vec::with_capacity(first[count] as usize);
        for node in nodes.clone() {
            let ground = HalfEdge { origin: node, twin: NONE, cost: N::ZERO };
            half_edges.resize(first[node as usize + 1] as usize, ground);
        }
        let mut next = first.clone();
        for edge in problem.edges().filter(|edge| edge.ends[0] != edge.ends[1]) {
            let cost = doubled(edge.cost)?;
            let codes = edge.ends.map(|end| next[end as usize]);
            for (end, [code, twin]) in edge.ends.into_iter().zip([codes, [codes[1], codes[0]]]) {
                next[end as usize] += 1;
                half_edges[code as usize] = HalfEdge { origin: end, twin, cost };
            }
        }
        let prices = if nodes.clone().any(|node| problem.price(node).is_some()) {
            let price = |node| problem.price(node).map(doubled).transpose();
            nodes.map(price).collect::<Result<_, _>>()?
        } else {
            Vec::new()
        };
        let row = Row {
            potential: N::ZERO,
            mate: NONE,
            parent: NONE,
            set: NONE,
            label: Label::Free,
            is_marked: false,
        };
        let mut nodes = Self { rows: vec![row; count], half_edges, first, prices };
        nodes.set_feasible_potentials();
        Ok(nodes)
    }

    /// Makes each potential half of the cheapest edge, or the price if that is less.
    fn set_feasible_potentials(&mut self) {
        for node in self.range() {
            let halves = self.sides(node).map(|side| self.cost(side).half());
            if let Some(least) = halves.chain(self.price(node)).min() {
                self.add_potential(node, least);
            }
        }
    }
}

/// Returns where the half-edges of each node begin, and how many there are.
fn first_half_edges(problem: &impl Problem) -> Result<Vec<u32>, Refusal> {
    let count = problem.node_count();
    // Half-edges, and a number for every blossom beyond them, in 32 bits.
    let most = (u32::MAX as usize).saturating_sub(count);
    if count > u32::MAX as usize / 4 {
        return Err(Refusal::TooLarge);
    }
    let mut degrees = vec![1_u32; count];
    let mut total = count;
    for edge in problem.edges() {
        for end in edge.ends {
            let degree = degrees.get_mut(end as usize).ok_or(Refusal::NoSuchNode(end))?;
            let counts = edge.ends[0] != edge.ends[1];
            total += usize::from(counts);
            if total > most {
                return Err(Refusal::TooLarge);
            }
            *degree += u32::from(counts);
        }
    }
    let mut first = vec![0];
    first.extend(degrees.iter().scan(0, |sum, degree| {
        *sum += degree;
        Some(*sum)
    }));
    Ok(first)
}

impl<N: Number> Nodes for Sparse<N> {
    type N = N;
    const MOST_SETS: u32 = NONE - 1;

    fn len(&self) -> u32 {
        self.rows.len() as u32
    }
    fn range(&self) -> std::ops::Range<u32> {
        0..self.len()
    }
    fn is_on_border(&self, _: u32) -> bool {
        false
    }
    fn codes(&self) -> u32 {
        self.half_edges.len() as u32
    }
    #[inline]
    fn origin(&self, half_edge: u32) -> u32 {
        self.half_edges[half_edge as usize].origin
    }
    #[inline]
    fn twin(&self, half_edge: u32) -> u32 {
        self.half_edges[half_edge as usize].twin
    }
    #[inline]
    fn ground(&self, node: u32) -> u32 {
        self.first[node as usize + 1] - 1
    }
    #[inline]
    fn sides(&self, node: u32) -> std::ops::Range<u32> {
        self.first[node as usize]..self.ground(node)
    }
    #[inline]
    fn cost(&self, half_edge: u32) -> N {
        self.half_edges[half_edge as usize].cost
    }
    #[inline]
    fn price(&self, node: u32) -> Option<N> {
        self.prices.get(node as usize).copied().flatten()
    }
    #[inline]
    fn prefetch(&self, node: u32) {
        prefetch(&self.rows, node as usize);
    }

    #[inline]
    fn potential(&self, node: u32) -> N {
        self.rows[node as usize].potential
    }
    #[inline]
    fn add_potential(&mut self, node: u32, change: N) {
        self.rows[node as usize].potential += change;
    }
    #[inline]
    fn mate(&self, node: u32) -> u32 {
        self.rows[node as usize].mate
    }
    #[inline]
    fn set_mate(&mut self, node: u32, half_edge: u32) {
        self.rows[node as usize].mate = half_edge;
    }
    #[inline]
    fn parent(&self, node: u32) -> u32 {
        self.rows[node as usize].parent
    }
    #[inline]
    fn set_parent(&mut self, node: u32, half_edge: u32) {
        self.rows[node as usize].parent = half_edge;
    }
    #[inline]
    fn label(&self, node: u32) -> Label {
        self.rows[node as usize].label
    }
    #[inline]
    fn set_label(&mut self, node: u32, label: Label) {
        self.rows[node as usize].label = label;
    }
    #[inline]
    fn is_marked(&self, node: u32) -> bool {
        self.rows[node as usize].is_marked
    }
    #[inline]
    fn set_marked(&mut self, node: u32, marked: bool) {
        self.rows[node as usize].is_marked = marked;
    }
    #[inline]
    fn set(&self, node: u32) -> u32 {
        self.rows[node as usize].set
    }
    #[inline]
    fn set_set(&mut self, node: u32, set: u32) {
        self.rows[node as usize].set = set;
    }
}
