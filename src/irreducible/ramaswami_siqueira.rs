//! RS, the algorithm of Ramaswami and Siqueira (section 4): every edge is tested at most once.
//!
//! Vertices are processed one after the other: edges at vertex u are contracted into u until u is
//! trapped, which it then stays (Lemma 5). An edge [u, v] that fails its test is put aside with the
//! number c(v) of its critical cycles, and the counters are kept right from then on, so that no
//! second test is needed when the edge becomes contractible.
//!
//! Departs from the printed pseudo-code at four places where that is wrong, each with a comment:
//! counters are reset for each u (Algorithm 4.2), a time stamp is compared with ≥ (Algorithm 4.3,
//! line 14), apexes are read before they are lost (line 4), and u is only done when no edge put
//! aside is contractible (Algorithm 4.2, line 34). Departs in form too: an edge at u is named by
//! its other end, so vertices carry what the paper keeps in edge records, and the two walks over
//! the new neighbours of u are one.
//!
//! Departs in cost at one place. When u gains a processed neighbour z, the printed Algorithm 4.5
//! walks round z to find the edges put aside that make a critical cycle with it, and z may have a
//! large part of all vertices for neighbours. Here an edge [u, w] that is put aside is listed at
//! every processed vertex in the link of w that is no neighbour of u yet. The link of w gains no
//! vertex as long as w is a neighbour of u, so these lists have all that a walk would find.

use super::contracted::{Contracted, Counts};
use super::edge_lists::{Discipline, EdgeLists, List};
use super::far_spoke::FarSpoke;
use super::waiting_edges::WaitingEdges;
use crate::triangulation::{
    Contraction, HalfEdgeId, ShrinkingTriangulation, VertexId, VertexSplit,
};

/// Contracts edges of `triangulation` until none can be, by RS. Vertices are processed in `order`,
/// which should hold all vertices. Those that are gone or in no triangle are skipped.
///
/// O(n) for surfaces of genus 0 and O(g² + g n) for genus g > 0; 36 bytes a vertex for the state
/// and the receipts, and 8 for each edge between one put aside and a processed vertex. Triangles
/// that are numbered at random take about three times as long as others; renumbering them first was
/// measured to take longer than that.
pub fn ramaswami_siqueira(
    triangulation: ShrinkingTriangulation,
    order: impl IntoIterator<Item = VertexId>,
    discipline: Discipline,
) -> Contracted {
    let mut run = RamaswamiSiqueira::new(triangulation, discipline, ());
    run.process_all(order);
    run.finish()
}

/// Test hook, called after each step; `()` in production.
pub(super) trait ContractionObserver: Sized {
    /// Edge [u, v] has left the list of untested edges.
    fn popped(&self, _run: &RamaswamiSiqueira<Self>, _v: VertexId) {}
    /// Edge [u, v] is being tested against the link condition.
    fn tested(&self, _run: &RamaswamiSiqueira<Self>, _v: VertexId) {}
    /// The edge of `h` is about to be contracted.
    fn contracting(&self, _run: &RamaswamiSiqueira<Self>, _h: HalfEdgeId) {}
    /// u is about to gain a processed vertex as a neighbour, through spoke `g`.
    fn gaining(&self, _run: &RamaswamiSiqueira<Self>, _g: HalfEdgeId) {}
    /// An edge has been dealt with: contracted, put aside or left alone.
    fn settled(&self, _run: &RamaswamiSiqueira<Self>) {}
    /// Vertex u has been processed.
    fn processed(&self, _run: &RamaswamiSiqueira<Self>) {}
}

impl ContractionObserver for () {}

/// Time before any contraction: the edge has not been tested.
pub(super) const NEVER: u32 = u32::MAX;

/// Data of a vertex v, mostly as a neighbour of the vertex u being processed (Table 1). All zeros
/// for one that has never been a neighbour.
#[derive(Clone, Copy, Debug, bytemuck::Zeroable)]
pub(super) struct Neighbour {
    /// n: the number of the last vertex u that it was a neighbour of, or one more if edges put
    /// aside have only waited for it.
    pub(super) round: u32,
    /// c: critical cycles through [u, v], if [u, v] has been put aside. The first edge that waits
    /// for v, if there are such edges.
    pub(super) critical_cycles: u32,
    /// o: when it became a neighbour of u.
    pub(super) known_since: u32,
    /// t: when [u, v] left the list of untested edges, or [`NEVER`].
    pub(super) tested_at: u32,
    /// The half-edge from u to v.
    pub(super) spoke: HalfEdgeId,
    /// p: it has been processed or is gone.
    pub(super) processed: bool,
}

/// The state of the algorithm.
pub(super) struct RamaswamiSiqueira<O> {
    pub(super) k: ShrinkingTriangulation,
    pub(super) lists: EdgeLists<Neighbour>,
    /// u.
    pub(super) centre: VertexId,
    /// Twice the number of vertices that have been u, with this one.
    pub(super) round: u32,
    /// ts: the number of contractions.
    now: u32,
    discipline: Discipline,
    /// Of the edge [u, v] at hand, the spokes of v but those to u and the apexes.
    far_spokes: Vec<FarSpoke>,
    /// Edges put aside that wait for a processed vertex to become a neighbour of u.
    pub(super) waiting: WaitingEdges,
    splits: Vec<VertexSplit>,
    counts: Counts,
    pub(super) observer: O,
}

impl<O: ContractionObserver> RamaswamiSiqueira<O> {
    pub(super) fn new(k: ShrinkingTriangulation, discipline: Discipline, observer: O) -> Self {
        Self {
            lists: EdgeLists::new(k.vertex_id_count()),
            splits: Vec::with_capacity(k.vertex_count()),
            centre: VertexId::NONE,
            round: 0,
            now: 0,
            discipline,
            far_spokes: Vec::new(),
            waiting: WaitingEdges::default(),
            counts: Counts::default(),
            observer,
            k,
        }
    }

    pub(super) fn finish(self) -> Contracted {
        Contracted { triangulation: self.k, splits: self.splits, counts: self.counts }
    }

    /// Processes all vertices in `order` (Algorithm 4.2).
    pub(super) fn process_all(&mut self, order: impl IntoIterator<Item = VertexId>) {
        for u in order {
            if self.k.outgoing(u).is_some() && !self.lists[u].processed {
                self.process(u);
            }
        }
    }

    /// Contracts edges at `u` until it is trapped (Algorithm 4.2, lines 7 to 35).
    fn process(&mut self, u: VertexId) {
        self.meet_neighbours(u);
        loop {
            while let Some(v) = self.lists.pop_front(List::Untested) {
                let neighbour = &mut self.lists[v];
                // Never true: no vertex is u twice, and none comes back into the list.
                let again = neighbour.processed || neighbour.tested_at != NEVER;
                self.counts.edges_tested_more_than_once += usize::from(again);
                neighbour.tested_at = self.now;
                self.observer.popped(self, v);
                if self.k.degree(v) == 3 {
                    self.contract_degree_three(v);
                } else {
                    self.test(v);
                }
                self.observer.settled(self);
            }
            self.contract_from_tested();
            self.observer.settled(self);
            // The printed loop ends as soon as no edge is untested. But a contraction of an edge
            // put aside may leave another one contractible and bring only processed neighbours.
            if self.lists.front(List::Untested).is_none() && self.contractible_tested().is_none() {
                break;
            }
        }
        self.lists[u].processed = true;
        self.observer.processed(self);
    }

    /// Makes `u` the centre and lists its edges to vertices that have not been processed.
    fn meet_neighbours(&mut self, u: VertexId) {
        self.centre = u;
        self.round += 2;
        self.waiting.clear();
        self.lists.clear(List::Untested);
        self.lists.clear(List::Tested);
        for h in self.k.spokes(u) {
            let v = self.k.destination(h);
            let neighbour = &mut self.lists[v];
            neighbour.meet(self.round, h, self.now);
            if !neighbour.processed {
                self.lists.enter(v, self.k.degree(v), self.discipline);
            }
        }
    }

    /// Contracts [u, v], where v has degree 3, unless all that is left is a tetrahedron. The cycle
    /// round v is then no longer critical for the edges that counted it (Algorithm 4.3).
    fn contract_degree_three(&mut self, v: VertexId) {
        if self.k.degree(self.centre) == 3 {
            return;
        }
        self.far_spokes.clear();
        // Read before they are lost, which the printed line 4 is too late for.
        let [x, y] = self.contract_walked(v);
        let [nx, ny] = [x, y].map(|w| self.lists[w]);
        let [x_tested, y_tested] = [nx, ny].map(|n| n.tested_at != NEVER);
        // Printed with > in the first case. If no edge was contracted between the moment y became
        // a neighbour and the test of [u, x], the times are equal, and that test counted the cycle.
        let x_counted = x_tested && (y_tested || nx.tested_at >= ny.known_since);
        let y_counted = y_tested && (x_tested || ny.tested_at >= nx.known_since);
        if x_counted {
            self.uncount(x);
        }
        if y_counted {
            self.uncount(y);
        }
    }

    /// Tests [u, v] against the link condition by counting its critical cycles, and contracts it or
    /// puts it aside (Algorithm 4.4). O(deg v).
    fn test(&mut self, v: VertexId) {
        self.counts.add_test([self.centre, v].map(|end| self.k.degree(end)));
        self.observer.tested(self, v);
        let Neighbour { spoke, known_since, .. } = self.lists[v];
        let (mut cycles, mut any_stranger) = (0, false);
        self.far_spokes.clear();
        for g in self.k.far_spokes(spoke) {
            let far = FarSpoke::new(&self.k, g);
            self.far_spokes.push(far);
            let z = far.end;
            // If [u, v] is contracted, [u, z] is tested soon.
            self.k.prefetch(far.across);
            let Neighbour { round, tested_at, processed, .. } = self.lists[z];
            if round == self.round {
                cycles += 1;
                if tested_at != NEVER && tested_at < known_since {
                    count(&mut self.lists, z);
                }
            } else {
                any_stranger |= processed;
            }
        }
        self.counts.link_vertices_visited += self.far_spokes.len() as u64;
        self.lists[v].critical_cycles = cycles;
        if cycles == 0 {
            self.contract_walked(v);
            return;
        }
        self.lists.push_rear(List::Tested, v);
        if any_stranger {
            self.wait_for_strangers(v);
        }
    }

    /// Lists [u, w], which has just been put aside, at each processed vertex in the link of `w`
    /// that is no neighbour of u.
    fn wait_for_strangers(&mut self, w: VertexId) {
        for &FarSpoke { end: z, .. } in &self.far_spokes {
            let stranger = &mut self.lists[z];
            if stranger.processed && stranger.round != self.round {
                let next = stranger.first_waiting(self.round);
                stranger.round = self.round + 1;
                stranger.critical_cycles = self.waiting.push_before(next, w);
            }
        }
    }

    /// Contracts edges that were put aside and have become contractible: all that lead to vertices
    /// of degree 3, and one more (Algorithm 4.6).
    fn contract_from_tested(&mut self) {
        while let Some(v) = self.lists.front(List::Tested)
            && self.k.degree(v) == 3
        {
            self.lists.remove(v);
            self.contract_degree_three(v);
            self.observer.settled(self);
        }
        if let Some(v) = self.contractible_tested() {
            self.lists.remove(v);
            self.contract(v);
        }
    }

    /// Returns an edge put aside that can be contracted now, if there is one: they come first
    /// (Proposition 10).
    fn contractible_tested(&self) -> Option<VertexId> {
        self.lists.front(List::Tested).filter(|&v| self.lists[v].critical_cycles == 0)
    }

    /// Contracts [u, v], which must be in no list. O(deg v) and the edges that wait for processed
    /// neighbours gained.
    fn contract(&mut self, v: VertexId) {
        self.far_spokes.clear();
        let far_spokes = self.k.far_spokes(self.lists[v].spoke);
        self.far_spokes.extend(far_spokes.map(|spoke| FarSpoke::new(&self.k, spoke)));
        self.contract_walked(v);
    }

    /// Contracts [u, v], whose far spokes are at hand, and meets the neighbours that u gains
    /// (Algorithms 4.5 and 4.7). Returns the apexes of the two removed triangles.
    fn contract_walked(&mut self, v: VertexId) -> [VertexId; 2] {
        self.now += 1;
        self.lists[v].processed = true;
        let h = self.lists[v].spoke;
        self.observer.contracting(self, h);
        let far_spokes = self.far_spokes.iter().map(|far| far.spoke);
        let Contraction { receipt, apexes, spoke_to_second } = self.k.contract_with(h, far_spokes);
        self.lists[apexes[1]].spoke = spoke_to_second;
        for w in apexes {
            let neighbour = &self.lists[w];
            let untested = !neighbour.processed && neighbour.tested_at == NEVER;
            if untested && self.k.degree(w) == 3 {
                self.lists.remove(w);
                self.lists.push_front(List::Untested, w);
            }
        }
        for &FarSpoke { spoke: g, end: z, across } in &self.far_spokes {
            self.prefetch_beyond(across);
            if self.lists[z].processed {
                self.observer.gaining(self, g);
            }
            let neighbour = &mut self.lists[z];
            let first_waiting = neighbour.first_waiting(self.round);
            neighbour.meet(self.round, g, self.now);
            if neighbour.processed {
                let visited = &mut self.counts.link_vertices_visited;
                let edges = self.waiting.list(first_waiting).inspect(|_| *visited += 1);
                count_cycles_through(&self.k, &mut self.lists, g, edges);
            } else {
                self.lists.enter(z, self.k.degree(z), self.discipline);
            }
        }
        self.splits.push(receipt);
        apexes
    }

    /// Prefetches what a test reads beyond the triangle of `across`.
    #[inline]
    fn prefetch_beyond(&self, across: HalfEdgeId) {
        self.lists.prefetch(self.k.origin(across.prev()));
        [across.next(), across.prev()]
            .into_iter()
            .for_each(|side| self.k.prefetch(self.k.twin(side)));
    }

    /// Counts one critical cycle less for [u, w], which has been put aside.
    fn uncount(&mut self, w: VertexId) {
        let cycles = &mut self.lists[w].critical_cycles;
        *cycles -= 1;
        if *cycles == 0 {
            self.lists.remove(w);
            self.lists.push_front(List::Tested, w);
        }
    }
}

impl Neighbour {
    /// Returns the first edge that waits for this vertex in this `round`, or
    /// [`WaitingEdges::NONE`].
    #[inline]
    pub(super) fn first_waiting(&self, round: u32) -> u32 {
        if self.round == round + 1 { self.critical_cycles } else { WaitingEdges::NONE }
    }

    /// Records that v is a neighbour of u in this `round`, through `spoke`.
    #[inline]
    fn meet(&mut self, round: u32, spoke: HalfEdgeId, now: u32) {
        self.round = round;
        self.spoke = spoke;
        self.known_since = now;
        self.tested_at = NEVER;
        // Missing in the printed Algorithm 4.2: else the count of an earlier centre remains.
        self.critical_cycles = 0;
    }
}

/// Counts the critical cycles through the end z of spoke `g`, a processed neighbour that u has
/// just gained, for all edges put aside (Algorithm 4.5, lines 33 to 41): those that wait for z. One
/// whose end w is an apex at [u, z] makes a triangle with it. O(1) for each.
fn count_cycles_through(
    k: &ShrinkingTriangulation,
    lists: &mut EdgeLists<Neighbour>,
    g: HalfEdgeId,
    waiting: impl Iterator<Item = VertexId>,
) {
    let apexes = k.apexes(g);
    for w in waiting {
        if !lists[w].processed && !apexes.contains(&w) {
            count(lists, w);
        }
    }
}

/// Counts one critical cycle more for [u, w], which has been put aside.
fn count(lists: &mut EdgeLists<Neighbour>, w: VertexId) {
    let cycles = &mut lists[w].critical_cycles;
    *cycles += 1;
    if *cycles == 1 {
        lists.remove(w);
        lists.push_rear(List::Tested, w);
    }
}
