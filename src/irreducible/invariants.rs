//! RS under observation: after every step, what the algorithm relies on is counted by brute force.

use std::cell::{Cell, RefCell};
use std::collections::BTreeSet;

use proptest::prelude::*;
use triquad_generators::Surface;
use triquad_generators::random::{Mix, random_surface};

use super::edge_lists::{Discipline, List};
use super::ramaswami_siqueira::{ContractionObserver, NEVER, RamaswamiSiqueira};
use crate::mesh::Mesh;
use crate::random::Random;
use crate::samples::{sculpted, surfaces, triangulation};
use crate::triangulation::{
    HalfEdgeId, ShrinkingTriangulation, TriangleId, Triangulation, VertexId,
};

/// The graph of a small triangulation, from the origins of half-edges alone.
struct Graph {
    triangles: Vec<[VertexId; 3]>,
    /// For each vertex the set of its neighbours, one bit each.
    neighbours: Vec<u128>,
}

impl Graph {
    fn of(k: &ShrinkingTriangulation) -> Self {
        let all = (0..k.half_edge_id_count() / 3).map(TriangleId::new);
        let corners = |f: TriangleId| f.half_edges().map(|h| k.origin(h));
        let triangles: Vec<_> = all.filter(|&f| k.is_alive(f)).map(corners).collect();
        let mut neighbours = vec![0; k.vertex_id_count()];
        for &[a, b, c] in &triangles {
            for (from, to) in [(a, b), (b, c), (c, a)] {
                neighbours[from.index()] |= 1 << to.index();
            }
        }
        Self { triangles, neighbours }
    }

    fn neighbours(&self, v: VertexId) -> impl Iterator<Item = VertexId> + use<> {
        members(self.neighbours[v.index()])
    }

    /// Iterates over the vertices that make a critical cycle with edge [u, v]: they are joined to
    /// both ends, but there is no triangle.
    fn cycles(&self, u: VertexId, v: VertexId) -> impl Iterator<Item = VertexId> + use<> {
        let at_edge = self.triangles.iter().filter(|t| t.contains(&u) && t.contains(&v));
        let apexes = at_edge.flatten().fold(0, |set, z| set | 1 << z.index());
        members(self.neighbours[u.index()] & self.neighbours[v.index()] & !apexes)
    }

    fn is_contractible(&self, u: VertexId, v: VertexId) -> bool {
        let is_tetrahedron =
            [u, v].iter().all(|end| self.neighbours[end.index()].count_ones() == 3);
        !is_tetrahedron && self.cycles(u, v).next().is_none()
    }

    /// Asserts that it triangulates closed surfaces with this Euler characteristic.
    fn assert_valid(&self, euler_characteristic: i64) {
        let triangles = self.triangles.iter().map(|t| t.map(|v| v.index() as u32)).collect();
        let positions = vec![[0.0; 3]; self.neighbours.len()];
        let rebuilt = Triangulation::build(&Mesh::from_triangles(positions, triangles));
        let rebuilt = rebuilt.expect("still a triangulation");
        assert_eq!(rebuilt.euler_characteristic(), euler_characteristic);
    }
}

fn members(set: u128) -> impl Iterator<Item = VertexId> {
    (0..128).filter(move |&v| set >> v & 1 == 1).map(VertexId::new)
}

/// Checks Propositions 8 to 11 and that no edge is tested twice.
struct Checker {
    discipline: Discipline,
    euler_characteristic: i64,
    tested: RefCell<BTreeSet<[VertexId; 2]>>,
    contractions: Cell<usize>,
    /// Critical cycles found through processed vertices that u has gained.
    cycles_gained: Cell<usize>,
}

impl ContractionObserver for Checker {
    /// The edges that wait are those that the printed walk round the processed vertex finds.
    fn gaining(&self, run: &RamaswamiSiqueira<Self>, g: HalfEdgeId) {
        let put_aside = |&w: &VertexId| {
            let n = run.lists[w];
            n.round == run.round && n.tested_at != NEVER && !n.processed
        };
        let ends = run.k.far_spokes(g).map(|spoke| run.k.destination(spoke));
        let walked: BTreeSet<_> = ends.filter(put_aside).collect();
        let first = run.lists[run.k.destination(g)].first_waiting(run.round);
        let apexes = run.k.apexes(g);
        let waiting = run.waiting.list(first);
        let listed: Vec<_> =
            waiting.filter(|w| !run.lists[*w].processed && !apexes.contains(w)).collect();
        assert_eq!(listed.len(), walked.len(), "no edge waits twice");
        assert_eq!(listed.iter().copied().collect::<BTreeSet<_>>(), walked);
        self.cycles_gained.set(self.cycles_gained.get() + walked.len());
    }

    fn popped(&self, run: &RamaswamiSiqueira<Self>, v: VertexId) {
        assert!(!run.lists[v].processed && run.k.outgoing(v).is_some());
        self.check_untested(run);
        self.check_tested(run);
    }

    fn tested(&self, run: &RamaswamiSiqueira<Self>, v: VertexId) {
        let edge = [run.centre.min(v), run.centre.max(v)];
        assert!(self.tested.borrow_mut().insert(edge), "{edge:?} is tested again");
    }

    fn contracting(&self, run: &RamaswamiSiqueira<Self>, h: HalfEdgeId) {
        let (u, v) = (run.k.origin(h), run.k.destination(h));
        assert_eq!(u, run.centre);
        assert!(Graph::of(&run.k).is_contractible(u, v), "{v:?} must not go into {u:?}");
        self.contractions.set(self.contractions.get() + 1);
    }

    fn settled(&self, run: &RamaswamiSiqueira<Self>) {
        let graph = Graph::of(&run.k);
        graph.assert_valid(self.euler_characteristic);
        self.check_neighbours(run, &graph);
        self.check_untested(run);
        self.check_tested(run);
        self.check_counters(run, &graph);
    }

    fn processed(&self, run: &RamaswamiSiqueira<Self>) {
        let graph = Graph::of(&run.k);
        let u = run.centre;
        let loose = graph.neighbours(u).find(|&v| graph.is_contractible(u, v));
        assert_eq!(loose, None, "{u:?} is not trapped");
    }
}

impl Checker {
    /// Checks that the vertices known as neighbours of u are its neighbours, with the right spokes.
    fn check_neighbours(&self, run: &RamaswamiSiqueira<Self>, graph: &Graph) {
        for v in (0..run.k.vertex_id_count())
            .map(VertexId::new)
            .filter(|&v| run.k.outgoing(v).is_some() && v != run.centre)
        {
            let is_known = run.lists[v].round == run.round;
            assert_eq!(is_known, graph.neighbours(run.centre).any(|w| w == v));
            if is_known {
                let h = run.lists[v].spoke;
                assert!(run.k.is_alive(h.triangle()));
                assert_eq!((run.k.origin(h), run.k.destination(h)), (run.centre, v));
            }
        }
    }

    /// Checks Proposition 8. Its second part is not claimed of other disciplines.
    fn check_untested(&self, run: &RamaswamiSiqueira<Self>) {
        let untested: Vec<_> = run.lists.iter(List::Untested).collect();
        for &v in &untested {
            let n = run.lists[v];
            assert_eq!((n.round, n.tested_at, n.critical_cycles), (run.round, NEVER, 0));
            assert!(!n.processed && run.k.outgoing(v).is_some());
        }
        if self.discipline == Discipline::FirstInFirstOut {
            assert!(untested.is_sorted_by_key(|&v| run.k.degree(v) > 3), "degree 3 comes first");
        }
    }

    /// Checks Propositions 9 and 10.
    fn check_tested(&self, run: &RamaswamiSiqueira<Self>) {
        let put_aside: Vec<_> = run.lists.iter(List::Tested).collect();
        for &v in &put_aside {
            let n = run.lists[v];
            assert!(n.tested_at != NEVER && n.tested_at >= n.known_since && !n.processed);
            let edge = [run.centre.min(v), run.centre.max(v)];
            assert!(self.tested.borrow().contains(&edge));
        }
        let counted = |&v: &VertexId| run.lists[v].critical_cycles > 0;
        assert!(put_aside.is_sorted_by_key(counted), "contractible edges come first");
    }

    /// Checks Proposition 11, and what holds while edges are untested: of the critical cycles
    /// through [u, w], those are counted whose third vertex has been processed or put aside, or was
    /// known as a neighbour when [u, w] was tested.
    fn check_counters(&self, run: &RamaswamiSiqueira<Self>, graph: &Graph) {
        for w in run.lists.iter(List::Tested) {
            let n = run.lists[w];
            let is_counted = |&z: &VertexId| {
                let third = run.lists[z];
                third.processed || third.tested_at != NEVER || n.tested_at >= third.known_since
            };
            let cycles: Vec<_> = graph.cycles(run.centre, w).collect();
            let counted = cycles.iter().filter(|&z| is_counted(z)).count();
            assert_eq!(n.critical_cycles as usize, counted, "of [{:?}, {w:?}]", run.centre);
            if run.lists.front(List::Untested).is_none() {
                assert_eq!(counted, cycles.len());
            }
        }
    }
}

/// Makes `surface` irreducible under observation; returns how many vertices are left.
fn observe(surface: &Surface, discipline: Discipline, seed: u64) -> usize {
    observe_cycles(surface, discipline, seed).0
}

/// Does the same, and returns how many critical cycles came with processed vertices too.
fn observe_cycles(surface: &Surface, discipline: Discipline, seed: u64) -> (usize, usize) {
    let triangulation = triangulation(surface);
    let checker = Checker {
        discipline,
        euler_characteristic: triangulation.euler_characteristic(),
        tested: RefCell::default(),
        contractions: Cell::default(),
        cycles_gained: Cell::default(),
    };
    let mut order: Vec<_> = (0..triangulation.vertex_id_count()).map(VertexId::new).collect();
    if seed > 0 {
        Random::stream(seed, &["order"]).shuffle(&mut order);
    }
    let vertices = triangulation.vertex_count();
    let mut run =
        RamaswamiSiqueira::new(ShrinkingTriangulation::from(triangulation), discipline, checker);
    run.process_all(order);
    let (tests, contractions) =
        (run.observer.tested.borrow().len(), run.observer.contractions.get());
    let cycles_gained = run.observer.cycles_gained.get();
    let reduction = run.finish();
    assert_eq!(reduction.counts.link_condition_tests, tests);
    assert_eq!(reduction.splits.len(), contractions);
    assert_eq!(reduction.counts.edges_tested_more_than_once, 0);
    assert_eq!(reduction.triangulation.vertex_count(), vertices - contractions);
    (reduction.triangulation.vertex_count(), cycles_gained)
}

/// Without walks round processed vertices the algorithm does what it did with them.
#[test]
fn edges_that_wait_are_those_that_a_walk_would_find() {
    let mut cycles = 0;
    for seed in 0..60 {
        let mut random = Random::stream(seed, &["waiting"]);
        let mix = Mix::ALL[seed as usize % Mix::ALL.len()];
        let genus = 2 + seed as usize % 5;
        let surface = random_surface(genus, 40, mix, &mut |bound| random.below(bound));
        for discipline in Discipline::ALL {
            cycles += observe_cycles(&surface, discipline, seed).1;
        }
    }
    assert!(cycles > 100, "{cycles}");
}

#[test]
fn every_step_is_what_the_propositions_say() {
    for (seed, surface) in surfaces(40, 41).enumerate() {
        observe(&surface, Discipline::FirstInFirstOut, seed as u64 % 3);
    }
}

#[test]
fn counters_are_right_when_the_last_edge_goes_first() {
    for (seed, surface) in surfaces(20, 41).enumerate() {
        observe(&surface, Discipline::LastInFirstOut, seed as u64 % 3);
    }
}

/// Returns a surface of triangles whose corners are separated by points.
fn surface(triangles: &str) -> Surface {
    let corners = |t: &str| -> Vec<u32> { t.split('.').map(|v| v.parse().unwrap()).collect() };
    let triangles: Vec<[u32; 3]> =
        triangles.split_whitespace().map(|t| corners(t).try_into().unwrap()).collect();
    let vertices = triangles.iter().flatten().max().unwrap() + 1;
    Surface { positions: vec![[0.0; 3]; vertices as usize], triangles }
}

/// A torus for which Algorithm 4.2 as printed contracts nothing, as it keeps the counters
/// of an earlier centre (no reset after line 11).
#[test]
fn counters_are_reset_for_every_centre() {
    let torus = surface(
        "0.2.3 3.2.6 0.7.1 5.6.4 0.6.5 1.5.3 3.6.1 4.0.3 5.2.0 7.4.2 3.5.4 0.1.6 7.5.1 7.0.4 6.2.4 \
         5.7.2",
    );
    assert_eq!(observe(&torus, Discipline::FirstInFirstOut, 0), 7);
}

/// A torus for which Algorithm 4.3 as printed stops at 8 vertices, as line 14 has > for ≥.
#[test]
fn cycles_are_uncounted_if_no_contraction_came_between() {
    let torus = surface(
        "9.6.8 0.8.7 8.3.2 9.8.0 8.6.3 2.6.1 2.3.6 5.9.0 1.7.5 4.5.0 1.0.7 8.2.1 9.7.4 5.7.9 6.9.4 \
         4.0.6 1.6.0 8.5.4 1.5.8 8.4.7",
    );
    assert_eq!(observe(&torus, Discipline::FirstInFirstOut, 0), 7);
}

/// A torus on which Algorithm 4.2 as printed leaves vertex 2 before it is trapped, as line
/// 34 looks at one list only.
#[test]
fn no_vertex_is_left_before_it_is_trapped() {
    let torus = surface(
        "7.0.1 12.9.4 15.0.3 6.14.15 7.15.14 2.7.8 11.13.10 10.13.5 7.5.0 6.15.8 15.4.0 3.0.5 9.15.3 \
         12.4.15 9.3.4 1.4.5 1.5.9 8.7.6 5.7.2 15.2.8 5.2.11 12.1.9 1.15.7 15.13.2 5.13.15 0.4.1 \
         13.11.2 15.9.5 11.10.5 3.5.4 14.6.7 12.15.1",
    );
    observe(&torus, Discipline::FirstInFirstOut, 0);
}

/// A surface of genus 2 that Algorithm 4.2 as printed leaves reducible, with 11 vertices,
/// for the same reason.
#[test]
fn no_contractible_edge_is_left_behind() {
    let double_torus = surface(
        "6.7.10 3.6.0 12.10.8 11.6.8 7.1.3 4.14.5 1.15.3 11.9.6 8.2.9 3.15.6 7.15.12 6.13.0 13.4.5 \
         6.1.12 15.0.13 2.8.7 13.10.15 0.14.7 7.8.10 13.5.14 13.1.10 1.14.0 6.9.2 15.10.12 7.3.0 \
         0.15.1 1.13.14 8.9.11 6.12.8 7.12.1 10.1.6 2.4.13 2.13.6 7.14.2 15.7.6 4.2.14",
    );
    assert_eq!(observe(&double_torus, Discipline::FirstInFirstOut, 0), 10);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn sculpted_surfaces_go_by_the_propositions(surface in sculpted(), seed in 0..3u64) {
        observe(&surface, Discipline::FirstInFirstOut, seed);
    }
}
