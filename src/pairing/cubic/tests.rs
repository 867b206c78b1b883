//! Every step against a naive test of the definition, on all small graphs, families and random ones.

use proptest::prelude::*;

use super::graph::{Candidate, Contraction, NodeId, Reduction};
use super::solve::Decide;
use super::*;
use crate::random::Random;

type Edges = Vec<(u32, u32)>;

// The naive test.

/// A low-point search (Tarjan): whether `nodes` nodes can be reached from `root`, without passing a
/// loop or a bridge.
fn is_legal(graph: &Multigraph, root: NodeId, nodes: usize) -> bool {
    struct Search<'g> {
        graph: &'g Multigraph,
        reached: IdVec<NodeId, u32>,
        count: u32,
    }
    impl Search<'_> {
        /// The lowest number of a node that the subtree of `v` has an edge to, if all is well there.
        fn low_point(&mut self, v: NodeId, via: EdgeId) -> Option<u32> {
            self.count += 1;
            let number = self.count;
            self.reached[v] = number;
            let mut low = number;
            for edge in self.graph.around[v].into_iter().filter(|&edge| edge != via) {
                let [a, b] = self.graph.ends[edge];
                if a == b || (v != a && v != b) {
                    return None;
                }
                let g = self.graph.far_end(edge, v);
                let below = match self.reached[g] {
                    0 => self.low_point(g, edge).filter(|&below| below <= number)?,
                    seen => seen,
                };
                low = low.min(below);
            }
            Some(low)
        }
    }
    let reached = IdVec::filled(0, graph.around.len());
    let mut search = Search { graph, reached, count: 0 };
    search.low_point(root, EdgeId::NONE) == Some(1) && search.count as usize == nodes
}

/// Decides by trying.
struct Naive {
    left: usize,
}

impl Decide for Naive {
    fn decide(&mut self, graph: &Multigraph, cut: &Reduction) -> Candidate {
        self.left -= 2;
        let is_good = |&candidate: &Candidate| {
            let mut next = graph.clone();
            let _ = next.reduce(cut, candidate);
            is_legal(&next, cut.w, self.left)
        };
        [Candidate::H1, Candidate::H2].into_iter().find(is_good).expect("Frink's theorem")
    }

    fn contract(&mut self, _: &Multigraph, _: &Contraction) {
        self.left -= 2;
    }

    fn cost(&self, _: EdgeId, _: [EdgeId; 4]) -> u32 {
        0
    }
}

/// What a decider claims to know.
trait Audit: Decide {
    /// Compares it with a graph of `nodes` nodes, one of which is `root`.
    fn audit(&mut self, graph: &Multigraph, root: NodeId, nodes: usize);
}

impl Audit for Naive {
    fn audit(&mut self, _: &Multigraph, _: NodeId, _: usize) {}
}

/// The nodes that can be reached from `root` by edges that `passable` lets through.
fn reach(graph: &Multigraph, root: NodeId, passable: impl Fn(EdgeId) -> bool) -> Vec<NodeId> {
    let mut reached = vec![root];
    let mut next = 0;
    while next < reached.len() {
        for edge in graph.around[reached[next]].into_iter().filter(|&edge| passable(edge)) {
            let g = graph.far_end(edge, reached[next]);
            if !reached.contains(&g) {
                reached.push(g);
            }
        }
        next += 1;
    }
    reached
}

fn edges_at(graph: &Multigraph, nodes: &[NodeId]) -> Vec<EdgeId> {
    let mut edges: Vec<_> = nodes.iter().flat_map(|&v| graph.around[v]).collect();
    edges.sort_unstable();
    edges.dedup();
    edges
}

impl Audit for SpanningTree {
    /// The tree spans the graph, the forest is that tree, and every cover crosses its cut.
    fn audit(&mut self, graph: &Multigraph, root: NodeId, nodes: usize) {
        let live = reach(graph, root, |_| true);
        let edges = edges_at(graph, &live);
        let tree: Vec<_> = edges.iter().copied().filter(|&edge| self.in_tree[edge]).collect();
        assert_eq!(self.in_tree.ids().filter(|&edge| self.in_tree[edge]).count(), nodes - 1);
        assert_eq!((live.len(), tree.len()), (nodes, nodes - 1));
        let below = reach(graph, root, |edge| self.in_tree[edge]);
        assert_eq!(below.len(), nodes, "the tree spans the graph");
        for &edge in &tree {
            let [a, b] = graph.ends[edge];
            let node = self.node(edge);
            self.forest.evert(a.0);
            assert_eq!((self.forest.lca(b.0, node), self.forest.lca(a.0, node)), (node, a.0));
            let cover = EdgeId(self.forest.value(node));
            assert!(edges.contains(&cover) && !self.in_tree[cover], "{cover:?} covers {edge:?}");
            let side = reach(graph, a, |other| self.in_tree[other] && other != edge);
            let ends = graph.ends[cover].map(|v| side.contains(&v));
            assert_ne!(ends[0], ends[1], "{cover:?} covers {edge:?}");
        }
    }
}

impl Audit for DynamicGraph {
    /// It has the edges of the graph, and its forest is a spanning tree, in both structures.
    fn audit(&mut self, graph: &Multigraph, root: NodeId, nodes: usize) {
        let live = reach(graph, root, |_| true);
        let edges = edges_at(graph, &live);
        for edge in graph.ends.ids() {
            assert_eq!(self.graph.contains(edge.0), edges.contains(&edge));
        }
        for &edge in &edges {
            let [mut ours, mut known] = [graph.ends[edge].map(|v| v.0), self.graph.ends(edge.0)];
            ours.sort_unstable();
            known.sort_unstable();
            assert_eq!(ours, known);
        }
        let in_tree = |edge: EdgeId| self.graph.is_tree_edge(edge.0);
        assert_eq!(edges.iter().filter(|&&edge| in_tree(edge)).count(), nodes - 1);
        assert_eq!(reach(graph, root, in_tree).len(), nodes);
        for &edge in edges.iter().filter(|&&edge| self.graph.is_tree_edge(edge.0)) {
            let [a, b] = graph.ends[edge].map(|v| v.0);
            self.forest.cut(a, b);
            self.forest.link(a, b);
        }
    }
}

/// Checks the graph after every step, and on request what the decider knows of it.
struct Checked<D> {
    decider: D,
    left: usize,
    audited: bool,
}

impl<D: Audit> Checked<D> {
    fn check(&mut self, graph: &Multigraph, root: NodeId) {
        assert!(is_legal(graph, root, self.left), "after {} nodes", self.left);
        if self.audited {
            self.decider.audit(graph, root, self.left);
        }
    }
}

impl<D: Audit> Decide for Checked<D> {
    fn decide(&mut self, graph: &Multigraph, cut: &Reduction) -> Candidate {
        let candidate = self.decider.decide(graph, cut);
        self.left -= 2;
        let mut next = graph.clone();
        let _ = next.reduce(cut, candidate);
        self.check(&next, cut.w);
        candidate
    }

    fn contract(&mut self, graph: &Multigraph, double: &Contraction) {
        self.decider.contract(graph, double);
        self.left -= 2;
        let mut next = graph.clone();
        let _ = next.contract(double);
        self.check(&next, double.w);
    }

    fn cost(&self, e: EdgeId, beside: [EdgeId; 4]) -> u32 {
        self.decider.cost(e, beside)
    }
}

/// How much of each step is checked.
#[derive(Clone, Copy, PartialEq)]
enum Depth {
    Result,
    Graphs,
    Everything,
}

#[derive(Clone, Copy, PartialEq, Debug)]
enum Back {
    Naive,
    Ds,
    Gw,
}

fn solve_with(graph: &Multigraph, f: EdgeId, decider: impl Audit, depth: Depth) -> Matched {
    let left = graph.around.len();
    let mut decider = Checked { decider, left, audited: depth == Depth::Everything };
    match depth {
        Depth::Result => matching_without(graph.clone(), f, &mut decider.decider),
        _ => {
            decider.check(graph, NodeId(0));
            matching_without(graph.clone(), f, &mut decider)
        }
    }
}

type Matched = IdVec<EdgeId, bool>;

/// A graph, and what decides about it, ready to be copied for each excluded edge.
struct Solver<'e> {
    edges: &'e Edges,
    graph: CubicGraph,
    ds: DynamicGraph,
    gw: SpanningTree,
}

impl<'e> Solver<'e> {
    fn new(edges: &'e Edges, graph: CubicGraph) -> Self {
        let component = &graph.component;
        let ds = DynamicGraph::new(&component.graph);
        let gw = SpanningTree::new(&component.graph, &component.cover);
        Self { edges, graph, ds, gw }
    }

    /// A perfect matching without the edge `excluded`, checked against the definition.
    fn assert_solves(&self, excluded: usize, back: Back, depth: Depth) {
        let (graph, f) = (&self.graph.component.graph, self.graph.edge[excluded]);
        let nodes = graph.around.len();
        let matched = match back {
            Back::Naive => solve_with(graph, f, Naive { left: nodes }, depth),
            Back::Ds => solve_with(graph, f, self.ds.clone(), depth),
            Back::Gw => solve_with(graph, f, self.gw.clone(), depth),
        };
        assert!(!matched[f], "{back:?}");
        let mut met = vec![0; nodes];
        for (&(a, b), &edge) in self.edges.iter().zip(&self.graph.edge) {
            met[a as usize] += u32::from(matched[edge]);
            met[b as usize] += u32::from(matched[edge]);
        }
        let perfect = met.iter().all(|&times| times == 1);
        assert!(perfect, "{back:?} without {excluded}: {:?}", self.edges);
    }
}

fn assert_all(edges: &Edges, excluded: impl IntoIterator<Item = usize>, depth: Depth) {
    let nodes = edges.len() * 2 / 3;
    let graph = CubicGraph::from_edges(nodes, edges).unwrap_or_else(|e| panic!("{e}: {edges:?}"));
    let solver = Solver::new(edges, graph);
    for excluded in excluded {
        solver.assert_solves(excluded, Back::Ds, depth);
        solver.assert_solves(excluded, Back::Gw, depth);
        if nodes <= 100 {
            solver.assert_solves(excluded, Back::Naive, Depth::Result);
        }
    }
}

// All small graphs.

/// Calls `found` with every labelled cubic multigraph without loops of `nodes` nodes, once.
fn every_graph(nodes: u32, found: &mut impl FnMut(&Edges)) {
    fn extend(edges: &mut Edges, degree: &mut [u8], found: &mut impl FnMut(&Edges)) {
        let Some(a) = degree.iter().position(|&d| d < 3) else { return found(edges) };
        // The edges of each node in the order of their other ends.
        let from = match edges.last() {
            Some(&(last, b)) if last as usize == a => b as usize,
            _ => a + 1,
        };
        for b in from..degree.len() {
            if degree[b] < 3 {
                degree[a] += 1;
                degree[b] += 1;
                edges.push((a as u32, b as u32));
                extend(edges, degree, found);
                edges.pop();
                degree[a] -= 1;
                degree[b] -= 1;
            }
        }
    }
    extend(&mut Edges::new(), &mut vec![0; nodes as usize], found);
}

/// Whether all nodes hang together without the edge `removed`, by union of sets.
fn holds_together(nodes: usize, edges: &Edges, removed: Option<usize>) -> bool {
    let mut set: Vec<_> = (0..nodes).collect();
    for (_, &(a, b)) in edges.iter().enumerate().filter(|&(i, _)| Some(i) != removed) {
        let [from, to] = [set[a as usize], set[b as usize]];
        set.iter_mut().filter(|s| **s == from).for_each(|s| *s = to);
    }
    set.iter().all(|&s| s == set[0])
}

/// What `CubicGraph::from_edges` should say, for 3-regular graphs without loops.
fn assert_verdict(nodes: usize, edges: &Edges) -> Option<CubicGraph> {
    let is_bridge = |i| !holds_together(nodes, edges, Some(i));
    match CubicGraph::from_edges(nodes, edges) {
        Ok(graph) => {
            assert!(!(0..edges.len()).any(is_bridge), "{edges:?}");
            Some(graph)
        }
        Err(IllegalGraph::Disconnected(_)) => {
            assert!(!holds_together(nodes, edges, None), "{edges:?}");
            None
        }
        Err(IllegalGraph::Bridge(a, b)) => {
            let named = edges.iter().position(|&edge| edge == (a, b) || edge == (b, a));
            assert!(holds_together(nodes, edges, None) && is_bridge(named.unwrap()), "{edges:?}");
            None
        }
        Err(other) => panic!("{other}: {edges:?}"),
    }
}

/// Solves all legal graphs of `nodes` nodes without each edge that `excluded` chooses from the number
/// of the graph and its edges. Returns how many legal ones there are, and how many in all.
fn every_graph_is_solved<I: IntoIterator<Item = usize>>(
    nodes: u32,
    backs: &[Back],
    depth: Depth,
    excluded: impl Fn(usize, usize) -> I,
) -> (usize, usize) {
    let (mut legal, mut all) = (0, 0);
    every_graph(nodes, &mut |edges| {
        all += 1;
        let Some(graph) = assert_verdict(nodes as usize, edges) else { return };
        let solver = Solver::new(edges, graph);
        for excluded in excluded(legal, edges.len()) {
            backs.iter().for_each(|&back| solver.assert_solves(excluded, back, depth));
        }
        legal += 1;
    });
    (legal, all)
}

#[test]
fn all_graphs_of_up_to_six_nodes_are_solved() {
    let backs = [Back::Naive, Back::Ds, Back::Gw];
    let solve = |nodes| every_graph_is_solved(nodes, &backs, Depth::Everything, |_, m| 0..m);
    let counts = [2, 4, 6].map(solve);
    assert_eq!(counts.map(|(legal, _)| legal), [1, 7, 550]);
    assert_eq!(counts[2].1, 760);
}

/// Without one edge of each. Graphs are labelled: apart from labels, each comes hundreds of times, and
/// every edge of it has its turn.
#[test]
fn all_graphs_of_eight_nodes_are_solved() {
    let backs = [Back::Ds, Back::Gw];
    let one = |number: usize, edges| [number % edges];
    let counts = every_graph_is_solved(8, &backs, Depth::Everything, one);
    assert_eq!(counts, (138_600, 190_050));
}

#[test]
#[ignore = "takes half a minute"]
fn all_graphs_of_eight_nodes_are_solved_without_every_edge() {
    let backs = [Back::Naive, Back::Ds, Back::Gw];
    let counts = every_graph_is_solved(8, &backs, Depth::Graphs, |_, m| 0..m);
    assert_eq!(counts, (138_600, 190_050));
}

// Families.

/// Two rings of `k` nodes with rungs, or one of 2k with `twisted`.
fn ladder(k: u32, twisted: bool) -> Edges {
    let rails = (0..k - 1).flat_map(|i| [(i, i + 1), (k + i, k + i + 1)]);
    let ends = if twisted { [(k - 1, k), (2 * k - 1, 0)] } else { [(k - 1, 0), (2 * k - 1, k)] };
    rails.chain(ends).chain((0..k).map(|i| (i, k + i))).collect()
}

/// The generalised Petersen graph G(k, step).
fn petersen(k: u32, step: u32) -> Edges {
    (0..k).flat_map(|i| [(i, (i + 1) % k), (i, k + i), (k + i, k + (i + step) % k)]).collect()
}

/// A ring of `k` double edges joined by single ones.
fn necklace(k: u32) -> Edges {
    let bead =
        |i: u32| [(2 * i, 2 * i + 1), (2 * i, 2 * i + 1), (2 * i + 1, (2 * i + 2) % (2 * k))];
    (0..k).flat_map(bead).collect()
}

/// A ring of graphs, each opened at its last edge: cuts of two edges everywhere.
fn ring(links: &[Edges]) -> Edges {
    let (mut edges, mut open) = (Edges::new(), Edges::new());
    let mut first = 0;
    for link in links {
        let shifted = link.iter().map(|&(a, b)| (a + first, b + first));
        edges.extend(shifted);
        open.extend(edges.pop());
        first += link.len() as u32 * 2 / 3;
    }
    let next = open.iter().cycle().skip(1);
    edges.extend(open.iter().zip(next).map(|(&(_, b), &(a, _))| (b, a)));
    edges
}

/// Puts graphs into graphs: cuts of two edges, nested.
fn nest(depth: u32) -> Edges {
    let mut edges = ladder(3, true);
    for i in 0..depth {
        edges = ring(&[edges, if i % 2 == 0 { petersen(4, 1) } else { necklace(2) }]);
        edges.rotate_left(5);
    }
    edges
}

fn families() -> Vec<(&'static str, Edges)> {
    vec![
        ("triple edge", vec![(0, 1); 3]),
        ("K4", ladder(2, true).into_iter().collect()),
        ("K3,3", ladder(3, true)),
        ("prism", ladder(3, false)),
        ("cube", ladder(4, false)),
        ("Möbius ladder", ladder(17, true)),
        ("long prism", ladder(40, false)),
        ("Petersen", petersen(5, 2)),
        ("Desargues", petersen(10, 3)),
        ("generalised Petersen", petersen(23, 4)),
        ("necklaces of one and two", ring(&[necklace(2), necklace(2)])),
        ("necklace", necklace(20)),
        (
            "ring of K3,3 and beads",
            ring(&[ladder(3, true), necklace(2), ladder(3, true), necklace(3)]),
        ),
        ("ring of many", ring(&vec![ladder(2, true); 12])),
        ("nest", nest(9)),
    ]
}

#[test]
fn families_are_solved() {
    for (name, edges) in families() {
        println!("{name}");
        assert_all(&edges, 0..edges.len(), Depth::Everything);
    }
}

#[test]
fn large_families_are_solved() {
    let large = [ladder(20_000, false), ladder(20_001, true), necklace(20_000), nest(2000)];
    let rings = [ring(&vec![petersen(5, 2); 2000])];
    for edges in large.into_iter().chain(rings) {
        assert_all(&edges, [0, edges.len() / 2, edges.len() - 1], Depth::Result);
    }
}

// Random graphs.

/// A random cubic multigraph without loops, not always connected: stubs are paired up in random
/// order until there is no loop.
fn random_graph(nodes: u32, random: &mut Random) -> Edges {
    let mut stubs: Vec<u32> = (0..3 * nodes).map(|i| i / 3).collect();
    loop {
        random.shuffle(&mut stubs);
        let edges: Edges = stubs.chunks(2).map(|pair| (pair[0], pair[1])).collect();
        if edges.iter().all(|(a, b)| a != b) {
            return edges;
        }
    }
}

#[test]
fn random_graphs_are_solved_or_refused() {
    let (mut solved, mut refused) = (0, 0);
    for seed in 0..4000 {
        let mut random = Random::stream(seed, &["cubic"]);
        let nodes = 2 * (1 + random.below(if seed % 20 == 0 { 40 } else { 8 }));
        let edges = random_graph(nodes, &mut random);
        if assert_verdict(nodes as usize, &edges).is_some() {
            assert_all(&edges, [random.below(3 * nodes / 2) as usize], Depth::Everything);
            solved += 1;
        } else {
            refused += 1;
        }
    }
    assert!(solved > 2000 && refused > 300, "{solved} {refused}");
}

#[test]
fn large_random_graphs_are_solved() {
    for seed in 0..6 {
        let mut random = Random::stream(seed, &["large cubic"]);
        let edges = random_graph(10_000, &mut random);
        if CubicGraph::from_edges(10_000, &edges).is_ok() {
            assert_all(&edges, [0, 7777], Depth::Result);
        }
    }
}

/// Builds a graph from a triple edge: each step puts a new node on each of two edges, which may be the
/// same, and joins them. No bridge can come of that.
fn grown(steps: &[(u32, u32)]) -> Edges {
    let mut edges = vec![(0, 1); 3];
    for &(first, second) in steps {
        let node = edges.len() as u32 * 2 / 3;
        for (i, new) in [(first, node), (second, node + 1)] {
            let edge = i as usize % edges.len();
            let b = std::mem::replace(&mut edges[edge].1, new);
            edges.push((new, b));
        }
        edges.push((node, node + 1));
    }
    edges
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn any_grown_graph_is_solved(
        steps in prop::collection::vec((any::<u32>(), any::<u32>()), 0..30),
        excluded: u32,
    ) {
        let edges = grown(&steps);
        assert_all(&edges, [excluded as usize % edges.len()], Depth::Everything);
    }
}

// Refusals.

/// Two K4, each with a node put on one edge, and those two joined: the smallest sort of bridge.
fn dumbbell() -> Edges {
    let half = |first: u32| {
        [(0, 1), (0, 2), (1, 2), (1, 3), (2, 3), (0, 4), (3, 4)]
            .map(|(a, b)| (a + first, b + first))
    };
    half(0).into_iter().chain(half(5)).chain([(4, 9)]).collect()
}

#[test]
fn illegal_graphs_are_refused() {
    let refusal = |nodes, edges: &Edges| CubicGraph::from_edges(nodes, edges).err();
    assert_eq!(refusal(10, &dumbbell()), Some(IllegalGraph::Bridge(4, 9)));
    assert_eq!(refusal(0, &vec![]), Some(IllegalGraph::Empty));
    assert_eq!(
        refusal(4, &[[(0, 1); 3], [(2, 3); 3]].concat()),
        Some(IllegalGraph::Disconnected(2))
    );
    assert_eq!(refusal(2, &vec![(0, 1); 2]), Some(IllegalGraph::Degree(0)));
    let with = |error| Some(IllegalGraph::NotADualGraph(error));
    assert_eq!(refusal(2, &vec![(0, 1), (1, 1)]), with(NotADualGraph::Loop(1)));
    assert_eq!(refusal(2, &vec![(0, 1); 4]), with(NotADualGraph::Degree(0)));
    assert_eq!(refusal(2, &vec![(0, 2)]), with(NotADualGraph::OutOfRange(2)));
}

#[test]
fn components_are_solved_one_by_one_and_refused_by_name() {
    let mut edges = ladder(5, true);
    edges.extend(dumbbell().iter().map(|&(a, b)| (a + 10, b + 10)));
    let dual = DualGraph::from_edges(20, &edges).unwrap();
    for solve in [diks_stanczyk, gawrychowski_wasylkiewicz] {
        assert_eq!(solve(&dual), Err(IllegalGraph::Bridge(14, 19)));
        let sound = [ladder(5, true), necklace(3).iter().map(|&(a, b)| (a + 10, b + 10)).collect()];
        let dual = DualGraph::from_edges(16, &sound.concat()).unwrap();
        assert!(solve(&dual).unwrap().certify(&dual).is_ok());
        let open = DualGraph::from_edges(3, &[(0, 1); 3]).unwrap();
        assert_eq!(solve(&open), Err(IllegalGraph::Degree(2)));
        assert_eq!(solve(&DualGraph::from_edges(0, &[]).unwrap()), Ok(Matching::empty(0)));
    }
}

#[test]
fn matchings_are_of_the_edges_as_given() {
    for (_, edges) in families() {
        let nodes = edges.len() * 2 / 3;
        let graph = CubicGraph::from_edges(nodes, &edges).unwrap();
        for (excluded, method) in (0..edges.len() as u32).zip(Method::ALL.into_iter().cycle()) {
            let matching = graph.matching_without(excluded, method);
            assert!(matching.is_sorted() && !matching.contains(&excluded));
            let mut met: Vec<_> =
                matching.iter().flat_map(|&e| [edges[e as usize].0, edges[e as usize].1]).collect();
            met.sort_unstable();
            assert!(met.into_iter().eq(0..nodes as u32));
        }
    }
}
