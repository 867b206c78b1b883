//! Augmentation against oracles: petgraph's maximum matching, and every subset of edges.

use petgraph::algo::maximum_matching;
use petgraph::graph::UnGraph;
use proptest::prelude::*;
use std::ops::ControlFlow;

use triquad::pairing::{pulli_segal, simple_greedy};
use triquad::random::Random;
use triquad::triangulation::TriangleId;
use triquad::{
    Algorithm, Augmentation, Converter, DualGraph, Matching, Mesh, Triangulation, make_maximum,
};

use crate::common::{face_list, sculpted_surface};

type Edges = Vec<(u32, u32)>;

fn oracle(nodes: usize, edges: &Edges) -> usize {
    let mut graph = UnGraph::<(), ()>::with_capacity(nodes, edges.len());
    let ids: Vec<_> = (0..nodes).map(|_| graph.add_node(())).collect();
    edges.iter().for_each(|&(a, b)| {
        graph.add_edge(ids[a as usize], ids[b as usize], ());
    });
    maximum_matching(&graph).len()
}

/// The size of a maximum matching by trying, for the lowest node left, all partners or none.
fn exhaustive(nodes: usize, edges: &Edges) -> usize {
    fn best(left: u32, around: &[u32]) -> usize {
        let Some(f) = (left != 0).then(|| left.trailing_zeros()) else { return 0 };
        let without = left & !(1 << f);
        let alone = best(without, around);
        let partners = (0..32).filter(|g| around[f as usize] & without & 1 << g != 0);
        partners.map(|g| 1 + best(without & !(1 << g), around)).fold(alone, usize::max)
    }
    let mut around = vec![0u32; nodes];
    for &(a, b) in edges {
        around[a as usize] |= 1 << b;
        around[b as usize] |= 1 << a;
    }
    best(((1u64 << nodes) - 1) as u32, &around)
}

/// Starting points for augmentation: nothing, and what the greedy algorithms leave.
fn initial_matchings(graph: &DualGraph) -> [Matching; 3] {
    let random = &mut Random::stream(graph.len() as u64, &["start"]);
    [Matching::empty(graph.len()), simple_greedy(graph, random), pulli_segal(graph, Some(random))]
}

/// Both augmentations reach `expected` pairs from every start, and report what they did.
fn assert_maximum(graph: &DualGraph, expected: usize) {
    for start in initial_matchings(graph) {
        assert!(start.is_matching_of(graph));
        for augmentation in Augmentation::ALL {
            let mut paths = 0;
            let unpaired = start.unpaired_count();
            let (matching, stats) = make_maximum(graph, start.clone(), augmentation, &mut || {
                paths += 1;
                ControlFlow::Continue(())
            });
            assert!(matching.is_matching_of(graph), "{augmentation}");
            assert_eq!((graph.len() - matching.unpaired_count()) / 2, expected, "{augmentation}");
            assert_eq!((paths, 2 * paths), (stats.paths, unpaired - matching.unpaired_count()));
            assert!(stats.total_length >= paths && stats.longest <= stats.total_length);
            assert!(stats.total_length % 2 == paths % 2, "augmenting paths are of odd length");
            assert!(stats.triangles_visited >= 2 * paths);
        }
    }
}

fn assert_maximum_of_edges(nodes: usize, edges: &Edges, expected: usize) {
    assert_maximum(&DualGraph::from_edges(nodes, edges).unwrap(), expected);
}

/// Keeps the edges that leave every node at most three and no loops.
fn subcubic(nodes: usize, wished: impl IntoIterator<Item = (u32, u32)>) -> Edges {
    let mut degree = vec![0; nodes];
    let mut keep = |&(a, b): &(u32, u32)| {
        let room = a != b && degree[a as usize] < 3 && degree[b as usize] < 3;
        if room {
            degree[a as usize] += 1;
            degree[b as usize] += 1;
        }
        room
    };
    wished.into_iter().filter(|edge| keep(edge)).collect()
}

fn random_subcubic(nodes: usize, wishes: usize, seed: u64) -> Edges {
    let mut random = Random::stream(seed, &["graph"]);
    let mut node = || random.below(nodes as u32);
    subcubic(nodes, (0..wishes).map(|_| (node(), node())).collect::<Edges>())
}

#[test]
fn random_graphs_get_maximum_matchings() {
    for seed in 0..6000 {
        let nodes = 2 + seed as usize % 39;
        let edges = random_subcubic(nodes, nodes * (1 + seed as usize % 5), seed);
        assert_maximum_of_edges(nodes, &edges, oracle(nodes, &edges));
    }
}

#[test]
fn large_random_graphs_get_maximum_matchings() {
    for seed in 0..12 {
        let edges = random_subcubic(1500, 1500 * (1 + seed as usize % 4), seed);
        assert_maximum_of_edges(1500, &edges, oracle(1500, &edges));
    }
}

#[test]
fn the_oracle_agrees_with_every_subset() {
    for seed in 0..1500 {
        let nodes = 2 + seed as usize % 13;
        let edges = random_subcubic(nodes, 3 * nodes, 1000 + seed);
        let expected = exhaustive(nodes, &edges);
        assert_eq!(oracle(nodes, &edges), expected);
        assert_maximum_of_edges(nodes, &edges, expected);
    }
}

#[test]
fn duals_of_random_surfaces_get_perfect_matchings() {
    for (genus, surface) in crate::common::many_surfaces(160) {
        let triangulation = Triangulation::build(&crate::common::face_list(&surface)).unwrap();
        assert_eq!(triangulation.genus(), genus);
        let graph = DualGraph::new(&triangulation);
        assert_maximum(&graph, graph.len() / 2);
    }
}

#[test]
fn special_surfaces_get_perfect_matchings() {
    for (name, surface) in crate::common::special_surfaces() {
        let triangulation = Triangulation::build(&crate::common::face_list(&surface)).unwrap();
        for algorithm in Algorithm::ALL {
            for augmentation in Augmentation::ALL {
                let mut random = Random::stream(3, &[name]);
                let initial = algorithm.pair(&triangulation, &mut random);
                let unpaired = initial.matching.unpaired_count();
                let on_path = &mut || ControlFlow::Continue(());
                let (matching, stats) =
                    make_maximum(&initial.dual, initial.matching, augmentation, on_path);
                let perfect = matching.certify(&initial.dual).expect("a perfect matching");
                assert_eq!(stats.paths, unpaired / 2, "{name}");
                assert_eq!(perfect.pairs().count(), initial.dual.len() / 2, "{name}");
            }
        }
    }
}

/// Replaces every node by a triangle: blossoms in blossoms, one level more each time.
fn truncate(nodes: usize, edges: &Edges) -> (usize, Edges) {
    let mut used = vec![0; nodes];
    let mut port = |node: u32| {
        used[node as usize] += 1;
        3 * node + used[node as usize] - 1
    };
    let outside: Edges = edges.iter().map(|&(a, b)| (port(a), port(b))).collect();
    let inside = (0..nodes as u32)
        .flat_map(|f| [(3 * f, 3 * f + 1), (3 * f + 1, 3 * f + 2), (3 * f + 2, 3 * f)]);
    (3 * nodes, inside.chain(outside).collect())
}

#[test]
fn nested_blossoms_are_shrunk_and_expanded() {
    let k4 = vec![(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)];
    let claw = vec![(0, 1), (0, 2), (0, 3)];
    for start in [k4, claw] {
        let (mut nodes, mut edges) = (4, start);
        for _ in 0..7 {
            (nodes, edges) = truncate(nodes, &edges);
            let expected =
                if nodes < 1000 { oracle(nodes, &edges) } else { perfect_or_known(nodes, &edges) };
            assert_maximum_of_edges(nodes, &edges, expected);
        }
    }
}

/// Large truncations: a cubic bridgeless one has a perfect matching; of the others the two
/// augmentations must agree with each other.
fn perfect_or_known(nodes: usize, edges: &Edges) -> usize {
    if 2 * edges.len() == 3 * nodes {
        return nodes / 2;
    }
    let graph = DualGraph::from_edges(nodes, edges).unwrap();
    let (matching, _) =
        make_maximum(&graph, Matching::empty(nodes), Augmentation::Tarjan, &mut || {
            ControlFlow::Continue(())
        });
    (nodes - matching.unpaired_count()) / 2
}

/// A path of odd cycles, each joined to the next by an edge.
fn chain_of_odd_cycles(cycles: u32, length: u32) -> (usize, Edges) {
    let ring = |c: u32| (0..length).map(move |i| (c * length + i, c * length + (i + 1) % length));
    let link = |c: u32| (c * length + length / 2, (c + 1) * length);
    let edges = (0..cycles).flat_map(ring).chain((0..cycles - 1).map(link)).collect();
    ((cycles * length) as usize, edges)
}

#[test]
fn chains_of_odd_cycles() {
    for (cycles, length) in [(2, 3), (5, 3), (6, 5), (40, 7), (41, 3), (300, 9)] {
        let (nodes, edges) = chain_of_odd_cycles(cycles, length);
        assert_maximum_of_edges(nodes, &edges, oracle(nodes, &edges));
    }
}

/// Two rails of `length` nodes with rungs; `twisted` joins the ends crosswise (a Möbius ladder),
/// otherwise straight (a prism), or not at all.
fn ladder(length: u32, ends: Option<bool>) -> (usize, Edges) {
    let rail = |i: u32| [(i, i + 1), (length + i, length + i + 1)];
    let mut edges: Edges =
        (0..length - 1).flat_map(rail).chain((0..length).map(|i| (i, length + i))).collect();
    match ends {
        Some(true) => edges.extend([(length - 1, length), (2 * length - 1, 0)]),
        Some(false) => edges.extend([(length - 1, 0), (2 * length - 1, length)]),
        None => {}
    }
    (2 * length as usize, edges)
}

#[test]
fn long_ladders_need_long_paths() {
    for length in [3, 4, 5, 50, 51, 3001] {
        for ends in [None, Some(false), Some(true)] {
            let (nodes, edges) = ladder(length, ends);
            let graph = DualGraph::from_edges(nodes, &edges).unwrap();
            assert_maximum(&graph, nodes / 2);

            // All but one node of each rail's two ends paired along the rails: one path must mend
            // it.
            let mut shifted = Matching::empty(nodes);
            for rail in [0, length] {
                let pairs = (1..length - 1).step_by(2).filter(|i| i + 1 < length);
                pairs.for_each(|i| {
                    shifted.pair(
                        TriangleId::new((rail + i) as usize),
                        TriangleId::new((rail + i + 1) as usize),
                    );
                });
            }
            for augmentation in Augmentation::ALL {
                let (matching, _) =
                    make_maximum(&graph, shifted.clone(), augmentation, &mut || {
                        ControlFlow::Continue(())
                    });
                assert_eq!(matching.unpaired_count(), 0);
            }
        }
    }
}

#[test]
fn a_path_through_a_blossom_and_back() {
    // A stem 0-1-2, a pentagon 2-3-4-5-6, and 7 hanging on 3: the only path from 0 to 7 runs round
    // the pentagon the long way.
    let edges = vec![(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (5, 6), (6, 2), (3, 7)];
    let graph = DualGraph::from_edges(8, &edges).unwrap();
    let mut start = Matching::empty(8);
    for (a, b) in [(1, 2), (3, 4), (5, 6)] {
        start.pair(TriangleId::new(a), TriangleId::new(b));
    }
    for augmentation in Augmentation::ALL {
        let (matching, stats) =
            make_maximum(&graph, start.clone(), augmentation, &mut || ControlFlow::Continue(()));
        assert_eq!(
            (matching.unpaired_count(), stats.paths, stats.longest),
            (0, 1, 7),
            "{augmentation}"
        );
    }
}

#[test]
fn an_unpaired_node_without_partner_is_left_alone() {
    // Three leaves on one node, twice: two of each three stay unpaired.
    let edges = vec![(0, 1), (0, 2), (0, 3), (4, 5), (4, 6), (4, 7)];
    assert_maximum_of_edges(8, &edges, 2);
    assert_maximum_of_edges(5, &Vec::new(), 0);
}

#[test]
fn a_matching_that_leaves_a_triangle_is_not_certified() {
    let graph = DualGraph::from_edges(4, &[(0, 1), (0, 2), (0, 3)]).unwrap();
    let on_path = &mut || ControlFlow::Continue(());
    let (matching, _) = make_maximum(&graph, Matching::empty(4), Augmentation::Local, on_path);
    let refused = matching.certify(&graph).expect_err("a star has no perfect matching");
    assert_eq!(refused.unpaired_count(), 2);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn any_subcubic_graph_gets_a_maximum_matching(
        nodes in 2usize..26,
        wished in prop::collection::vec((0u32..26, 0u32..26), 0..70),
    ) {
        let inside = wished.into_iter().map(|(a, b)| (a % nodes as u32, b % nodes as u32));
        let edges = subcubic(nodes, inside);
        assert_maximum_of_edges(nodes, &edges, oracle(nodes, &edges));
    }

    #[test]
    fn any_sculpted_surface_gets_a_perfect_matching(surface in crate::common::sculpted_surface()) {
        let triangulation = Triangulation::build(&crate::common::face_list(&surface)).unwrap();
        let graph = DualGraph::new(&triangulation);
        assert_maximum(&graph, graph.len() / 2);
    }
}

/// The quads of `mesh`, each with its least corner first, in order.
fn sorted_quads(mesh: &Mesh) -> Vec<Vec<u32>> {
    let from_least = |face: &[u32]| {
        let mut face = face.to_vec();
        let least = (0..face.len()).min_by_key(|&corner| face[corner]).unwrap_or(0);
        face.rotate_left(least);
        face
    };
    let mut quads: Vec<_> = mesh.faces().iter().map(from_least).collect();
    quads.sort();
    quads
}

proptest! {
    #[test]
    fn quads_cut_in_order_come_back_with_tq(surface in sculpted_surface(), seed: u64) {
        let random = Algorithm::SimpleGreedy;
        let quads = Converter::new().algorithm(random).seed(seed).run(face_list(&surface));
        let quads = quads.unwrap().into_mesh();
        let halves = quads.faces().iter().flat_map(|q| [[q[0], q[1], q[2]], [q[0], q[2], q[3]]]);
        let triangles = Mesh::from_triangles(quads.positions().to_vec(), halves.collect());
        // The other diagonals can make two edges of one.
        prop_assume!(Triangulation::build(&triangles).is_ok());
        let back = Converter::new().algorithm(Algorithm::EagerRescue).run(&triangles).unwrap();
        prop_assert_eq!(sorted_quads(back.mesh()), sorted_quads(&quads));
    }
}
