//! BF, the brute-force algorithm that Ramaswami and Siqueira compare with (section 5).
//!
//! All edges in random order, each tested against the link condition and contracted if it passes;
//! those that fail are gone through again, until none has been contracted.

use super::contracted::{Contracted, Counts};
use crate::random::Random;
use crate::triangulation::{HalfEdgeId, IdVec, LinkMarks, ShrinkingTriangulation, VertexSplit};

/// Contracts edges of `triangulation` until none can be, by brute force. Which end survives is
/// arbitrary, as in the paper: `random` decides.
///
/// Each test of [u, v] takes O(deg u + deg v) time, and there may be Ω(n²) of them. 30 bytes a
/// triangle beside `triangulation`.
pub fn brute_force(triangulation: ShrinkingTriangulation, random: &mut Random) -> Contracted {
    let mut edges = StableEdges::new(&triangulation);
    let mut run = BruteForce {
        marks: LinkMarks::new(triangulation.vertex_id_count()),
        splits: Vec::with_capacity(triangulation.vertex_count()),
        counts: Counts::default(),
        k: triangulation,
    };
    let mut pending: Vec<u32> = (0..edges.side.len() as u32).collect();
    random.shuffle(&mut pending);
    loop {
        let before = run.splits.len();
        pending
            .retain(|&edge| edges.is_alive(edge) && !run.try_to_contract(&mut edges, edge, random));
        if run.splits.len() == before {
            break;
        }
    }
    Contracted { triangulation: run.k, splits: run.splits, counts: run.counts }
}

/// StableEdges with ids that stay the same while half-edges come and go.
struct StableEdges {
    /// One of the two half-edges of each edge; none for edges that are gone.
    side: Vec<HalfEdgeId>,
    /// Number of tests of each edge: 0, 1, or 2 for more.
    tests: Vec<u8>,
    /// The edge of each half-edge.
    of: IdVec<HalfEdgeId, u32>,
}

impl StableEdges {
    fn new(k: &ShrinkingTriangulation) -> Self {
        let half_edges = k.half_edge_id_count();
        let mut of = IdVec::filled(0, half_edges);
        let mut side = Vec::with_capacity(half_edges / 2);
        for h in (0..half_edges).map(HalfEdgeId::new).filter(|&h| h < k.twin(h)) {
            of[h] = side.len() as u32;
            of[k.twin(h)] = side.len() as u32;
            side.push(h);
        }
        Self { tests: vec![0; side.len()], side, of }
    }

    fn is_alive(&self, edge: u32) -> bool {
        self.side[edge as usize] != HalfEdgeId::NONE
    }

    /// Records the contraction of the edge of `h` from u to v in `k`, which is about to be made.
    /// [u, v], [v, x] and [v, y] go; [u, x] and [u, y] take over the outer half-edges.
    fn contract(&mut self, k: &ShrinkingTriangulation, h: HalfEdgeId) {
        let hp = k.twin(h);
        for (kept, gone) in [(h.prev(), h.next()), (hp.next(), hp.prev())] {
            let (edge, outer) = (self.of[kept], k.twin(gone));
            self.side[self.of[gone] as usize] = HalfEdgeId::NONE;
            self.side[edge as usize] = outer;
            self.of[outer] = edge;
        }
        self.side[self.of[h] as usize] = HalfEdgeId::NONE;
    }
}

struct BruteForce {
    k: ShrinkingTriangulation,
    marks: LinkMarks,
    splits: Vec<VertexSplit>,
    counts: Counts,
}

impl BruteForce {
    /// Tests `edge` and contracts it if it passes. Returns whether it did.
    fn try_to_contract(&mut self, edges: &mut StableEdges, edge: u32, random: &mut Random) -> bool {
        let side = edges.side[edge as usize];
        let tests = &mut edges.tests[edge as usize];
        self.counts.edges_tested_more_than_once += usize::from(*tests == 1);
        *tests = (*tests + 1).min(2);
        let degrees = [self.k.origin(side), self.k.destination(side)].map(|v| self.k.degree(v));
        self.counts.add_test(degrees);
        if !degrees.contains(&3) {
            self.counts.link_vertices_visited += degrees.map(u64::from).iter().sum::<u64>();
        }
        if !self.k.is_contractible(side, &mut self.marks) {
            return false;
        }
        let h = if random.below(2) == 0 { side } else { self.k.twin(side) };
        edges.contract(&self.k, h);
        self.splits.push(self.k.contract(h));
        true
    }
}
