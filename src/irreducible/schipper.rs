//! S, Schipper's algorithm as Ramaswami and Siqueira describe and measure it (sections 3 and 5).
//!
//! Every vertex v has a dictionary D_v of its neighbours, here a treap; one more dictionary has all
//! vertices that may not be trapped yet, by degree. A vertex v of least degree is tried, edge after
//! edge: [v, u] can be contracted if no vertex in the link of v but the apexes is in D_u. If one
//! can be, u is merged into v; else v is trapped, and stays so (Lemma 5).
//!
//! The text does not state that v survives, and not u. It states that a few vertices of low
//! degree are chosen over and over again before they are trapped (section 5.3). Among equal degrees
//! the choice is random, as the text leaves it open.

use super::contracted::{Contracted, Counts};
use super::degree_queue::DegreeQueue;
use super::neighbour_sets::NeighbourSets;
use crate::random::Random;
use crate::triangulation::{HalfEdgeId, IdVec, ShrinkingTriangulation, VertexId, VertexSplit};

/// Contracts edges of `triangulation` until none can be, by Schipper's algorithm. Where degrees are
/// equal `random` chooses the vertex.
///
/// The edges of the chosen vertex survive a contraction. Its id goes to the end with more edges, as
/// it is a mere name and fewer edges have to be moved that way.
///
/// O(n log n + g log n + g⁴) as stated in the paper, here expected; about 105 bytes a vertex beside
/// `triangulation`.
pub fn schipper(triangulation: ShrinkingTriangulation, random: &mut Random) -> Contracted {
    let mut run = Schipper::new(triangulation);
    while let Some(v) = run.queue.draw_least(random) {
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
        let by_degree = vertices.map(|v| (k.degree(v), v));
        Self {
            sets: NeighbourSets::new(&k),
            queue: DegreeQueue::new(by_degree, k.vertex_id_count()),
            tests: IdVec::filled(0, k.half_edge_id_count()),
            splits: Vec::with_capacity(k.vertex_count()),
            counts: Counts::default(),
            k,
        }
    }

    /// Returns the first contractible edge at `v`, as half-edge from it.
    fn find_contractible(&mut self, v: VertexId) -> Option<HalfEdgeId> {
        let Self { k, sets, tests, counts, .. } = self;
        k.spokes(v).find(|&h| {
            let u = k.destination(h);
            counts.add_test([u, v].map(|end| k.degree(end)));
            counts.edges_tested_more_than_once += usize::from(tests[h] == 1);
            let tested = (tests[h] + 1).min(2);
            tests[h] = tested;
            tests[k.twin(h)] = tested;
            let visited = &mut counts.link_vertices_visited;
            let is_shared = |g| sets.contains(u, k.destination(g));
            !k.is_in_tetrahedron(h)
                && !k.far_spokes(k.twin(h)).inspect(|_| *visited += 1).any(is_shared)
        })
    }

    /// Contracts the edge of `chosen`, which leaves the vertex that survives, and updates all
    /// dictionaries.
    fn contract(&mut self, chosen: HalfEdgeId) {
        let k = &self.k;
        let ends = [chosen, k.twin(chosen)];
        let h = if k.degree(k.origin(ends[0])) < k.degree(k.origin(ends[1])) {
            ends[1]
        } else {
            chosen
        };
        let (stays, goes) = (k.origin(h), k.destination(h));
        let [x, y] = k.apexes(h);
        self.keep_tests(chosen);
        let split = self.k.contract(h);
        for w in [stays, x, y] {
            self.sets.remove(w, goes);
            self.queue.update(w, self.k.degree(w));
        }
        self.queue.remove(goes);
        for g in self.k.moved_spokes(&split) {
            let z = self.k.destination(g);
            let node = self.sets.remove(z, goes);
            self.sets.insert(z, node, stays);
            let node = self.sets.remove(goes, z);
            self.sets.insert(stays, node, z);
        }
        self.splits.push(split);
    }

    /// Gives the number of tests of the edges from the origin of `h` to the apexes to the edges
    /// that they and those from its destination become.
    fn keep_tests(&mut self, h: HalfEdgeId) {
        let twin = self.k.twin(h);
        for (kept, gone) in [(h.prev(), h.next()), (twin.next(), twin.prev())] {
            for side in [kept, gone] {
                self.tests[self.k.twin(side)] = self.tests[kept];
            }
        }
    }
}
