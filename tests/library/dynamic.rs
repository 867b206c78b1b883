//! Dynamic trees and dynamic connectivity against naive ones, on random sequences of operations.

use proptest::prelude::*;
use triquad::dynamic::{Deletion, DynamicConnectivity, EulerTourForest, LinkCutForest, NodeMark};
use triquad::random::Random;

/// A graph as a set of edges; everything is found by walking.
struct NaiveGraph {
    nodes: u32,
    edges: Vec<Option<(u32, u32)>>,
    /// Of every node.
    value: Vec<u32>,
}

impl NaiveGraph {
    fn new(nodes: u32, names: usize) -> Self {
        Self { nodes, edges: vec![None; names], value: vec![0; nodes as usize] }
    }

    fn neighbours(&self, v: u32) -> impl Iterator<Item = u32> {
        let across = move |&(a, b): &(u32, u32)| match v {
            _ if v == a => Some(b),
            _ if v == b => Some(a),
            _ => None,
        };
        self.edges.iter().flatten().filter_map(across)
    }

    /// All nodes that can be reached from `root`, each after the one that it was reached from,
    /// which is told beside it.
    fn walk(&self, root: u32) -> Vec<(u32, u32)> {
        let mut reached = vec![(root, root)];
        let mut next = 0;
        while next < reached.len() {
            for g in self.neighbours(reached[next].0) {
                if reached.iter().all(|&(v, _)| v != g) {
                    reached.push((g, reached[next].0));
                }
            }
            next += 1;
        }
        reached
    }

    fn component(&self, root: u32) -> Vec<u32> {
        self.walk(root).into_iter().map(|(v, _)| v).collect()
    }

    fn connected(&self, a: u32, b: u32) -> bool {
        self.component(a).contains(&b)
    }

    /// The path from `a` to `b`, both included, in a forest.
    fn path(&self, a: u32, b: u32) -> Vec<u32> {
        let reached = self.walk(a);
        let mut path = vec![b];
        while path[path.len() - 1] != a {
            let last = path[path.len() - 1];
            path.push(reached.iter().find(|&&(v, _)| v == last).unwrap().1);
        }
        path.reverse();
        path
    }

    /// Number of components, by merging sets.
    fn components(&self) -> usize {
        let mut set: Vec<_> = (0..self.nodes).collect();
        for &(a, b) in self.edges.iter().flatten() {
            let [from, to] = [set[a as usize], set[b as usize]];
            set.iter_mut().filter(|s| **s == from).for_each(|s| *s = to);
        }
        set.sort_unstable();
        set.dedup();
        set.len()
    }
}

/// Raw numbers from which operations are made; shrinks to shorter and simpler lists.
type Draws = Vec<[u32; 4]>;

fn random_draws(seed: u64, length: usize) -> Draws {
    let mut random = Random::stream(seed, &["dynamic"]);
    (0..length).map(|_| [(); 4].map(|()| random.below(u32::MAX))).collect()
}

// Link-cut trees.

/// The root of the tree of `v` is the node that all ancestors are on the way to.
fn run_link_cut(nodes: u32, draws: &Draws) {
    let mut forest = LinkCutForest::from_parents(nodes as usize, |_| None);
    let mut naive = NaiveGraph::new(nodes, 0);
    // The root of each component: the last one that was made one.
    let mut root: Vec<u32> = (0..nodes).collect();
    for &[kind, a, b, value] in draws {
        let (a, b, value) = (a % nodes, b % nodes, value % (LinkCutForest::MAX_VALUE + 1));
        let joined = naive.connected(a, b);
        // Not always: the question brings both to the top, and hides what would go wrong below.
        if value % 3 == 0 {
            assert_eq!(forest.connected(a, b), joined);
        }
        let set_root = |root: &mut Vec<u32>, naive: &NaiveGraph, new: u32| {
            naive.component(new).into_iter().for_each(|v| root[v as usize] = new);
        };
        match kind % 8 {
            0 | 1 if !joined => {
                let new = root[b as usize];
                forest.link(a, b);
                naive.edges.push(Some((a, b)));
                set_root(&mut root, &naive, new);
            }
            2 if a != b && naive.neighbours(a).any(|g| g == b) => {
                forest.cut(a, b);
                naive.edges.retain(|&edge| edge != Some((a, b)) && edge != Some((b, a)));
                set_root(&mut root, &naive, a);
                set_root(&mut root, &naive, b);
            }
            3 => {
                forest.evert(a);
                set_root(&mut root, &naive, a);
            }
            4 if joined => {
                let path = naive.path(root[a as usize], a);
                let on_path = |v: &&u32| naive.path(root[b as usize], b).contains(v);
                assert_eq!(forest.lca(a, b), *path.iter().rfind(on_path).unwrap());
            }
            5 if joined => {
                forest.assign_path(a, b, value);
                naive.path(a, b).into_iter().for_each(|v| naive.value[v as usize] = value);
                set_root(&mut root, &naive, a);
            }
            6 => {
                forest.assign_above(a, value);
                let path = naive.path(root[a as usize], a);
                path.into_iter().for_each(|v| naive.value[v as usize] = value);
            }
            7 if value % 2 == 0 => {
                forest.set_value(a, value);
                naive.value[a as usize] = value;
            }
            7 if root[a as usize] == a => assert_eq!(forest.cut_above(a), None),
            7 => {
                let path = naive.path(root[a as usize], a);
                let above = forest.cut_above(a).unwrap();
                let parent = path[path.len() - 2];
                assert!(path.contains(&above) && above != a);
                naive.edges.retain(|&edge| edge != Some((a, parent)) && edge != Some((parent, a)));
                set_root(&mut root, &naive, a);
            }
            _ => assert_eq!(forest.value(a), naive.value[a as usize]),
        }
    }
    (0..nodes).for_each(|v| assert_eq!(forest.value(v), naive.value[v as usize]));
}

#[test]
fn link_cut_trees_do_as_told() {
    for seed in 0..60 {
        run_link_cut(2 + seed as u32, &random_draws(seed, 600));
    }
}

#[test]
fn link_cut_trees_are_joined_through_a_node_and_dissolved() {
    let mut forest = LinkCutForest::from_parents(5, |v| (v == 1 || v == 3).then(|| v - 1));
    forest.assign_path(0, 1, 7);
    forest.link_through(1, 4, 3);
    forest.evert(0);
    assert_eq!((forest.lca(2, 4), forest.lca(3, 2), forest.lca(1, 2)), (4, 3, 1));
    assert_eq!((forest.value(1), forest.value(4)), (7, 0));
    assert!(forest.cut_above(2).is_some() && forest.connected(0, 3));
    forest.dissolve(&[0, 1, 3, 4]);
    assert!((0..5).all(|v| !forest.connected(v, (v + 1) % 5) && forest.value(v) == 0));
}

/// However the path lies in splay trees, which depends on who was the root before.
#[test]
fn an_edge_that_is_not_there_cannot_be_cut() {
    let n = 6;
    let all = (0..n).flat_map(|a| (0..n).flat_map(move |b| (0..n).map(move |root| (a, b, root))));
    for (a, b, root) in all {
        let mut path = LinkCutForest::from_parents(n as usize, |v| v.checked_sub(1));
        path.evert(root);
        let cut = std::panic::catch_unwind(move || path.cut(a, b));
        assert_eq!(cut.is_ok(), a.abs_diff(b) == 1, "{a} from {b} below {root}");
    }
}

#[test]
fn long_paths_need_no_stack() {
    let n = 1_000_000;
    let mut path = LinkCutForest::from_parents(n as usize, |v| v.checked_sub(1));
    path.assign_path(n - 1, 0, 5);
    assert_eq!((path.lca(0, n / 2), path.value(n / 3)), (n / 2, 5));
    let mut tours = EulerTourForest::with_capacity(0);
    (0..n).for_each(|v| assert_eq!(tours.add_vertex(v), v));
    let ways: Vec<_> = (1..n).map(|v| tours.link(v - 1, v, v)).collect();
    assert_eq!(tours.vertex_count(0), n);
    ways.into_iter().for_each(|way| tours.cut(way));
    assert_eq!(tours.vertex_count(n / 2), 1);
}

// Euler-tour trees.

fn run_euler_tour(nodes: u32, draws: &Draws) {
    let mut forest = EulerTourForest::with_capacity(0);
    let names: Vec<_> = (0..nodes).map(|v| forest.add_vertex(v)).collect();
    let mut naive = NaiveGraph::new(nodes, 0);
    let mut ways: Vec<u32> = Vec::new();
    let mut marked = vec![[false; 2]; nodes as usize];
    for &[kind, a, b, value] in draws {
        let (a, b) = (a % nodes, b % nodes);
        let joined = naive.connected(a, b);
        assert_eq!(forest.connected(names[a as usize], names[b as usize]), joined);
        match kind % 5 {
            0 | 1 if !joined => {
                ways.push(forest.link(names[a as usize], names[b as usize], value >> 2));
                assert_eq!(forest.label(ways[ways.len() - 1]), value >> 2);
                naive.edges.push(Some((a, b)));
            }
            2 if !ways.is_empty() => {
                let edge = value as usize % ways.len();
                forest.cut(ways.swap_remove(edge));
                naive.edges.swap_remove(edge);
            }
            3 => {
                let which = (value % 2) as usize;
                marked[a as usize][which] ^= true;
                let mark = [NodeMark::Tree, NodeMark::NonTree][which];
                forest.set_mark(names[a as usize], mark, marked[a as usize][which]);
            }
            _ => {
                let component = naive.component(a);
                assert_eq!(forest.vertex_count(names[a as usize]) as usize, component.len());
                assert_eq!(forest.is_alone(names[a as usize]), component.len() == 1);
                for (which, mark) in [NodeMark::Tree, NodeMark::NonTree].into_iter().enumerate() {
                    let mut expected = component.clone();
                    expected.retain(|&v| marked[v as usize][which]);
                    expected.sort_unstable();
                    let first = forest.first_marked(names[a as usize], mark);
                    let mut found: Vec<_> =
                        std::iter::successors(first, |&node| forest.next_marked(node, mark))
                            .collect();
                    assert!(found.iter().all(|&node| forest.has_mark(node, mark)));
                    found.sort_unstable();
                    assert_eq!(found, expected);
                }
            }
        }
    }
}

#[test]
fn euler_tour_trees_do_as_told() {
    for seed in 0..60 {
        run_euler_tour(2 + seed as u32, &random_draws(seed, 600));
    }
}

#[test]
fn names_of_removed_nodes_are_used_again() {
    let mut forest = EulerTourForest::with_capacity(0);
    let [a, b] = [3, 4].map(|label| forest.add_vertex(label));
    for _ in 0..10 {
        let way = forest.link(a, b, 9);
        forest.cut(way);
        forest.remove_vertex(b);
        assert_eq!((forest.add_vertex(5), forest.label(b)), (b, 5));
    }
    assert_eq!(forest.name_bound(), 4);
}

// Connectivity.

fn run_connectivity(nodes: u32, names: u32, deletions: u32, draws: &Draws) {
    let mut graph = DynamicConnectivity::new(nodes as usize, names as usize);
    let mut naive = NaiveGraph::new(nodes, names as usize);
    for &[kind, name, a, b] in draws {
        let (name, a, b) = (name % names, a % nodes, b % nodes);
        if naive.edges[name as usize].is_some() && kind % 8 < deletions {
            let is_tree_edge = graph.is_tree_edge(name);
            let (x, y) = naive.edges[name as usize].take().unwrap();
            assert_eq!(graph.ends(name), [x, y]);
            let deletion = graph.delete(name);
            assert_eq!(deletion == Deletion::NonTree, !is_tree_edge);
            assert_eq!(deletion == Deletion::Split, !naive.connected(x, y));
            if let Deletion::Replaced(other) = deletion {
                assert!(graph.is_tree_edge(other));
            }
        } else if a != b && naive.edges[name as usize].is_none() {
            assert_eq!(graph.insert(name, a, b), !naive.connected(a, b));
            naive.edges[name as usize] = Some((a, b));
        }
        assert_eq!(graph.connected(a, b), naive.connected(a, b));
    }
    let mut forest = NaiveGraph::new(nodes, names as usize);
    for name in 0..names {
        assert_eq!(graph.contains(name), naive.edges[name as usize].is_some());
        if graph.contains(name) && graph.is_tree_edge(name) {
            forest.edges[name as usize] = naive.edges[name as usize];
        }
    }
    let edges = forest.edges.iter().flatten().count();
    let [spanned, all] = [&forest, &naive].map(NaiveGraph::components);
    assert_eq!((spanned, edges), (all, nodes as usize - all), "a spanning forest");
}

#[test]
fn connectivity_of_random_graphs() {
    for seed in 0..80 {
        let nodes = 2 + seed as u32 % 40;
        for (names, deletions) in [(nodes, 4), (2 * nodes, 3), (5 * nodes, 6)] {
            run_connectivity(nodes, names, deletions, &random_draws(seed, 500));
        }
    }
}

/// Deletes all edges of dense graphs: levels fill up, beyond what trials without rising can do.
#[test]
fn connectivity_while_a_dense_graph_is_taken_apart() {
    let nodes = 120;
    let mut random = Random::stream(0, &["dense"]);
    let mut edges: Vec<_> = (0..nodes).flat_map(|b| (0..b).map(move |a| (a, b))).collect();
    random.shuffle(&mut edges);
    let mut graph = DynamicConnectivity::new(nodes as usize, edges.len());
    let mut naive = NaiveGraph::new(nodes, edges.len());
    for (name, &(a, b)) in edges.iter().enumerate() {
        graph.insert(name as u32, a, b);
        naive.edges[name] = Some((a, b));
    }
    let mut order: Vec<u32> = (0..edges.len() as u32).collect();
    random.shuffle(&mut order);
    let mut splits = 0;
    for (step, name) in order.into_iter().enumerate() {
        splits += usize::from(graph.delete(name) == Deletion::Split);
        naive.edges[name as usize] = None;
        if step % 97 == 0 || step + 200 > edges.len() {
            assert_eq!(naive.components(), 1 + splits);
        }
    }
    assert_eq!(splits, nodes as usize - 1);
}

/// A ring of cliques, cut and mended at random: replacements are far away, and there is only one.
#[test]
fn connectivity_of_a_ring_that_is_cut_and_mended() {
    let (cliques, size) = (30, 12);
    let nodes = cliques * size;
    let inside =
        |c: u32| (0..size).flat_map(move |b| (0..b).map(move |a| (c * size + a, c * size + b)));
    let ring: Vec<_> = (0..cliques).map(|c| (c * size, (c + 1) % cliques * size + 1)).collect();
    let edges: Vec<_> = (0..cliques).flat_map(inside).collect();
    let mut graph = DynamicConnectivity::new(nodes as usize, ring.len() + edges.len());
    for (name, &(a, b)) in ring.iter().chain(&edges).enumerate() {
        graph.insert(name as u32, a, b);
    }
    let mut random = Random::stream(0, &["ring"]);
    for _ in 0..3000 {
        let [one, other] = [(); 2].map(|()| random.below(cliques));
        assert_ne!(graph.delete(one), Deletion::Split);
        if one != other {
            assert_eq!(graph.delete(other), Deletion::Split);
            // Between the two cuts lie the cliques after `one`, up to `other`.
            let first = (one + 1) % cliques;
            let offset = |clique| (clique + cliques - first) % cliques;
            let clique = random.below(cliques);
            let within = offset(clique) <= offset(other);
            assert_eq!(graph.connected(clique * size, first * size), within);
            assert!(graph.insert(other, ring[other as usize].0, ring[other as usize].1));
        }
        assert!(!graph.insert(one, ring[one as usize].0, ring[one as usize].1));
    }
}

#[test]
#[should_panic(expected = "edge 0 is a loop")]
fn loops_are_refused() {
    DynamicConnectivity::new(2, 1).insert(0, 1, 1);
}

/// The way of the first edge has the name 2.
#[test]
#[should_panic(expected = "edge 1 has an end that does not exist")]
fn ends_that_do_not_exist_are_refused() {
    let mut graph = DynamicConnectivity::new(2, 2);
    graph.insert(0, 0, 1);
    graph.insert(1, 0, 2);
}

fn draws() -> impl Strategy<Value = Draws> {
    prop::collection::vec(any::<[u32; 4]>(), 0..120)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn any_operations_on_link_cut_trees(nodes in 1u32..20, draws in draws()) {
        run_link_cut(nodes, &draws);
    }

    #[test]
    fn any_operations_on_euler_tour_trees(nodes in 1u32..20, draws in draws()) {
        run_euler_tour(nodes, &draws);
    }

    #[test]
    fn any_insertions_and_deletions(
        nodes in 2u32..14,
        names in 1u32..40,
        deletions in 1u32..8,
        draws in draws(),
    ) {
        run_connectivity(nodes, names, deletions, &draws);
    }
}
