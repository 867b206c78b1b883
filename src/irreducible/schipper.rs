//! S, Schipper's algorithm as Ramaswami and Siqueira describe and measure it (sections 3 and 5).
//!
//! Every vertex v has a dictionary D_v of its neighbours, here a treap; one more dictionary, here a
//! binary heap, has all vertices that may not be trapped yet, by degree. A vertex of least degree
//! is tried, edge after edge: [v, u] can be contracted if no vertex in the link of v but the apexes
//! is in D_u. If one can be, v is merged into u; else v is trapped, and stays so (Lemma 5).

use super::contracted::{Contracted, Counts};
use super::degree_queue::DegreeQueue;
use super::neighbour_sets::NeighbourSets;
use crate::triangulation::{HalfEdgeId, IdVec, ShrinkingTriangulation, VertexId, VertexSplit};

/// Contracts edges of `triangulation` until none can be, by Schipper's algorithm. Where degrees are
/// equal the vertex of least id comes first.
///
/// O(n log n + g log n + g⁴) as stated in the paper, here expected; about 105 bytes a vertex beside
/// `triangulation`.
pub fn schipper(triangulation: ShrinkingTriangulation) -> Contracted {
    let mut run = Schipper::new(triangulation);
    while let Some(v) = run.queue.first() {
        match run.find_contractible(v) {
            Some(h) => run.contract(h),
            None => run.queue.remove(v),
        }
    }
    Contracted { triangulation: run.k, splits: run.splits, counts: run.counts }
}

struct Schipper {
    k: ShrinkingTriangulation,
    sets: NeighbourSets,
    queue: DegreeQueue,
    /// Number of tests of the edge of each half-edge: 0, 1, or 2 for more.
    tests: IdVec<HalfEdgeId, u8>,
    splits: Vec<VertexSplit>,
    counts: Counts,
}

impl Schipper {
    fn new(k: ShrinkingTriangulation) -> Self {
        let used = |v: &VertexId| k.outgoing(*v).is_some();
        let vertices = (0..k.vertex_id_count()).map(VertexId::new).filter(used);
        let by_degree = vertices.map(|v| (k.degree(v), v)).collect();
        Self {
            sets: NeighbourSets::new(&k),
            queue: DegreeQueue::new(by_degree, k.vertex_id_count()),
            tests: IdVec::filled(0, k.half_edge_id_count()),
            splits: Vec::with_capacity(k.vertex_count()),
            counts: Counts::default(),
            k,
        }
    }

    /// Returns the first contractible edge at `v`, as half-edge towards it.
    fn find_contractible(&mut self, v: VertexId) -> Option<HalfEdgeId> {
        let Self { k, sets, tests, counts, .. } = self;
        k.spokes(v).map(|h| k.twin(h)).find(|&h| {
            count_test(k, tests, counts, h);
            let u = k.origin(h);
            let is_shared = |g| sets.contains(u, k.destination(g));
            !k.is_in_tetrahedron(h) && !k.far_spokes(h).any(is_shared)
        })
    }

    /// Contracts the edge of `h` from u to v and updates all dictionaries.
    fn contract(&mut self, h: HalfEdgeId) {
        let (u, v) = (self.k.origin(h), self.k.destination(h));
        let [x, y] = self.k.apexes(h);
        let kept = [h.prev(), self.k.twin(h).next()].map(|side| (side, self.k.twin(side)));
        let split = self.k.contract(h);
        for w in [u, x, y] {
            self.sets.remove(w, v);
            self.queue.update(w, self.k.degree(w));
        }
        self.queue.remove(v);
        for g in self.k.moved_spokes(&split) {
            let z = self.k.destination(g);
            let node = self.sets.remove(z, v);
            self.sets.insert(z, node, u);
            let node = self.sets.remove(v, z);
            self.sets.insert(u, node, z);
        }
        for (gone, outer) in kept {
            self.tests[self.k.twin(outer)] = self.tests[gone];
        }
        self.splits.push(split);
    }
}

/// Counts a test of the edge of `h`.
fn count_test(
    k: &ShrinkingTriangulation,
    tests: &mut IdVec<HalfEdgeId, u8>,
    counts: &mut Counts,
    h: HalfEdgeId,
) {
    counts.link_condition_tests += 1;
    counts.edges_tested_more_than_once += usize::from(tests[h] == 1);
    let tested = (tests[h] + 1).min(2);
    tests[h] = tested;
    tests[k.twin(h)] = tested;
}
