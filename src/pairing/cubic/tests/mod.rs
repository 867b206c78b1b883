//! Every step against a naive test of the definition, on all small graphs, families and random
//! ones.

mod families;
mod naive;

use proptest::prelude::*;
use triquad_generators::random::{Mix, random_surface};

use super::graph::NodeId;
use super::*;
use crate::dual::DualGraphError;
use crate::mesh::Mesh;
use crate::random::Random;
use crate::triangulation::Triangulation;
use families::*;
use naive::{Audit, Checked, Naive};

/// The checks made after each step.
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
    edges: &'e EdgeList,
    graph: CubicGraph,
    ds: DynamicGraph,
    gw: SpanningTree,
}

impl<'e> Solver<'e> {
    fn new(edges: &'e EdgeList, graph: CubicGraph) -> Self {
        let component = &graph.component;
        let ds = DynamicGraph::new(&component.graph);
        let gw = SpanningTree::new(&component.graph, &component.cover);
        Self { edges, graph, ds, gw }
    }

    /// Finds a perfect matching without the edge `excluded`, checked against the definition.
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

fn assert_all(edges: &EdgeList, excluded: impl IntoIterator<Item = usize>, depth: Depth) {
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

/// Returns the lowest node not connected with node 0 without the edge `removed`, by union of sets.
fn stray(nodes: usize, edges: &EdgeList, removed: Option<usize>) -> Option<usize> {
    let mut set: Vec<_> = (0..nodes).collect();
    for (_, &(a, b)) in edges.iter().enumerate().filter(|&(i, _)| Some(i) != removed) {
        let [from, to] = [set[a as usize], set[b as usize]];
        set.iter_mut().filter(|s| **s == from).for_each(|s| *s = to);
    }
    set.iter().position(|&s| s != set[0])
}

/// Returns the first end of an edge that does not exist, closes a loop or is the fourth at its
/// node.
fn wrong_end(nodes: usize, edges: &EdgeList) -> Option<DualGraphError> {
    let ends: Vec<_> = edges.iter().flat_map(|&(a, b)| [(a, b), (b, a)]).collect();
    (0..ends.len()).find_map(|i| {
        let (from, to) = ends[i];
        let before = ends[..i].iter().filter(|end| end.0 == from).count();
        match from {
            _ if from as usize >= nodes => Some(DualGraphError::OutOfRange(from)),
            _ if from == to => Some(DualGraphError::Loop(from)),
            _ if before == 3 => Some(DualGraphError::Degree(from)),
            _ => None,
        }
    })
}

/// Returns the graph of these edges, or else the error, checked against the definitions.
fn assert_verdict(nodes: usize, edges: &EdgeList) -> Result<CubicGraph, CubicGraphError> {
    let verdict = CubicGraph::from_edges(nodes, edges);
    let error = verdict.as_ref().err().copied();
    let degree = |v: u32| edges.iter().filter(|&&(a, b)| a == v || b == v).count();
    let is_bridge = |i| stray(nodes, edges, Some(i)).is_some();
    let named = |pair| edges.iter().position(|&(a, b)| (a.min(b), a.max(b)) == pair).unwrap();
    let as_told = if nodes == 0 {
        error == Some(CubicGraphError::Empty)
    } else if let Some(wrong) = wrong_end(nodes, edges) {
        error == Some(CubicGraphError::DualGraphError(wrong))
    } else if let Some(v) = stray(nodes, edges, None) {
        error == Some(CubicGraphError::Disconnected(v as u32))
    } else if (0..nodes as u32).any(|v| degree(v) < 3) {
        matches!(error, Some(CubicGraphError::Degree(v)) if degree(v) < 3)
    } else if (0..edges.len()).any(is_bridge) {
        matches!(error, Some(CubicGraphError::Bridge(a, b)) if is_bridge(named((a.min(b), a.max(b)))))
    } else {
        error.is_none()
    };
    assert!(as_told, "{nodes} nodes, {error:?}: {edges:?}");
    verdict
}

/// Solves all legal graphs of `nodes` nodes without each edge that `excluded` chooses from the
/// number of the graph and its edges. Returns how many legal ones there are, and how many in all.
fn every_graph_is_solved<I: IntoIterator<Item = usize>>(
    nodes: u32,
    backs: &[Back],
    depth: Depth,
    excluded: impl Fn(usize, usize) -> I,
) -> (usize, usize) {
    let (mut legal, mut all) = (0, 0);
    every_graph(nodes, &mut |edges| {
        all += 1;
        let Ok(graph) = assert_verdict(nodes as usize, edges) else { return };
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

/// Without one edge of each. Graphs are labelled: apart from labels, each comes hundreds of times,
/// and every edge of it has its turn.
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

#[test]
fn random_graphs_are_solved_or_refused() {
    let (mut solved, mut refused) = (0, 0);
    for seed in 0..4000 {
        let mut random = Random::stream(seed, &["cubic"]);
        let nodes = 2 * (1 + random.below(if seed % 20 == 0 { 40 } else { 8 }));
        let edges = random_graph(nodes, &mut random);
        if assert_verdict(nodes as usize, &edges).is_ok() {
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

#[test]
fn duals_of_random_surfaces_are_solved() {
    for seed in 0..240 {
        let random = &mut Random::stream(seed, &["surface"]);
        let (genus, mix) = ([0, 0, 1, 3][seed as usize % 4], Mix::ALL[seed as usize / 4 % 4]);
        let operations = if seed % 40 == 39 { 3000 } else { random.below(24) as usize };
        let surface = random_surface(genus, operations, mix, &mut |bound| random.below(bound));
        let list = Mesh::from_triangles(surface.positions, surface.triangles);
        let dual = DualGraph::new(&Triangulation::build(&list).unwrap());
        let around = |f| dual.neighbours(f).filter(move |&g| f < g).map(move |g| (f.0, g.0));
        let edges: EdgeList = dual.triangles().flat_map(around).collect();
        let depth = if operations < 100 { Depth::Everything } else { Depth::Result };
        assert_all(&edges, [random.below(edges.len() as u32) as usize], depth);
    }
}

// Refusals.

#[test]
fn illegal_graphs_are_refused() {
    let refusal = |nodes, edges: &EdgeList| CubicGraph::from_edges(nodes, edges).err();
    assert_eq!(refusal(10, &dumbbell()), Some(CubicGraphError::Bridge(4, 9)));
    assert_eq!(refusal(0, &vec![]), Some(CubicGraphError::Empty));
    assert_eq!(
        refusal(4, &[[(0, 1); 3], [(2, 3); 3]].concat()),
        Some(CubicGraphError::Disconnected(2))
    );
    assert_eq!(refusal(2, &vec![(0, 1); 2]), Some(CubicGraphError::Degree(0)));
    let with = |error| Some(CubicGraphError::DualGraphError(error));
    assert_eq!(refusal(2, &vec![(0, 1), (1, 1)]), with(DualGraphError::Loop(1)));
    assert_eq!(refusal(2, &vec![(0, 1); 4]), with(DualGraphError::Degree(0)));
    assert_eq!(refusal(2, &vec![(0, 2)]), with(DualGraphError::OutOfRange(2)));
}

/// Sound graphs with a little damage: an edge that is gone, doubled or led elsewhere.
#[test]
fn damaged_graphs_are_refused_for_what_is_wrong_first() {
    let mut refusals = std::collections::BTreeMap::new();
    for seed in 0..20_000 {
        let mut random = Random::stream(seed, &["damage"]);
        let steps: Vec<_> =
            (0..seed % 4).map(|_| [(); 2].map(|()| random.below(9)).into()).collect();
        let mut edges = grown(&steps);
        let nodes = edges.len() * 2 / 3;
        random.shuffle(&mut edges);
        for _ in 0..random.below(3) {
            let edge = random.below(edges.len() as u32) as usize;
            match random.below(3) {
                0 => {
                    edges.swap_remove(edge);
                }
                1 => edges.push(edges[edge]),
                _ => edges[edge].1 = random.below(nodes as u32 + 1),
            }
        }
        let nodes = nodes.saturating_sub(usize::from(seed % 100 == 0));
        let error = assert_verdict(nodes, &edges).err();
        let kind = format!("{error:?}").replace(|c: char| c.is_ascii_digit(), "");
        *refusals.entry(kind).or_insert(0) += 1;
    }
    assert_eq!(refusals.len(), 7, "every kind of refusal, and none: {refusals:?}");
}

#[test]
#[should_panic(expected = "index out of bounds")]
fn an_edge_that_is_not_there_cannot_be_excluded() {
    let graph = CubicGraph::from_edges(2, &[(0, 1); 3]).unwrap();
    graph.matching_without(3, Decider::LinkCutTree);
}

#[test]
fn components_are_solved_one_by_one_and_refused_by_name() {
    let mut edges = ladder(5, true);
    edges.extend(dumbbell().iter().map(|&(a, b)| (a + 10, b + 10)));
    let dual = DualGraph::from_edges(20, &edges).unwrap();
    for solve in [diks_stanczyk, gawrychowski_wasylkiewicz] {
        assert_eq!(solve(&dual), Err(CubicGraphError::Bridge(14, 19)));
        let sound = [ladder(5, true), necklace(3).iter().map(|&(a, b)| (a + 10, b + 10)).collect()];
        let dual = DualGraph::from_edges(16, &sound.concat()).unwrap();
        assert!(solve(&dual).unwrap().certify(&dual).is_ok());
        let open = DualGraph::from_edges(3, &[(0, 1); 3]).unwrap();
        assert_eq!(solve(&open), Err(CubicGraphError::Degree(2)));
        assert_eq!(solve(&DualGraph::from_edges(0, &[]).unwrap()), Ok(Matching::empty(0)));
    }
}

#[test]
fn matchings_are_of_the_edges_as_given() {
    for (_, edges) in families() {
        let nodes = edges.len() * 2 / 3;
        let graph = CubicGraph::from_edges(nodes, &edges).unwrap();
        for (excluded, method) in (0..edges.len() as u32).zip(Decider::ALL.into_iter().cycle()) {
            let matching = graph.matching_without(excluded, method);
            assert!(matching.is_sorted() && !matching.contains(&excluded));
            let mut met: Vec<_> =
                matching.iter().flat_map(|&e| [edges[e as usize].0, edges[e as usize].1]).collect();
            met.sort_unstable();
            assert!(met.into_iter().eq(0..nodes as u32));
        }
    }
}
