//! The invariants of the levels, by definition, after every change.

use proptest::prelude::*;

use super::*;
use crate::random::Random;

/// Compares everything that is kept for each level with the levels of the edges.
fn audit(graph: &mut DynamicConnectivity) {
    for i in 0..LEVELS as u8 {
        let set = components(graph, i);
        audit_vertices(graph, i, &set);
        audit_edges(graph, i, &set);
        if graph.level.iter().all(|&level| level < i) {
            return;
        }
    }
}

fn edges(graph: &DynamicConnectivity) -> Vec<u32> {
    (0..graph.edges.len() as u32).filter(|&edge| graph.contains(edge)).collect()
}

fn level(graph: &DynamicConnectivity, edge: u32) -> u8 {
    graph.level[edge as usize]
}

/// For each vertex the name of its tree in F_i, by merging sets.
fn components(graph: &DynamicConnectivity, i: u8) -> Vec<u32> {
    let mut set: Vec<u32> = (0..graph.nodes).collect();
    for edge in edges(graph) {
        if graph.is_tree_edge(edge) && level(graph, edge) >= i {
            let [from, to] = graph.ends(edge).map(|v| set[v as usize]);
            assert_ne!(from, to, "a forest");
            set.iter_mut().filter(|s| **s == from).for_each(|s| *s = to);
        }
    }
    set
}

fn audit_vertices(graph: &mut DynamicConnectivity, i: u8, set: &[u32]) {
    for v in 0..graph.nodes {
        let size = set.iter().filter(|&&s| s == set[v as usize]).count();
        assert!(size << i <= graph.nodes as usize, "{size} nodes at level {i}");
        let node = graph.chain(v)[i as usize];
        assert_eq!(node != NONE, i == 0 || size > 1, "a node where there are edges");
        if node == NONE {
            continue;
        }
        assert_eq!(graph.tours.vertex_count(node) as usize, size);
        for w in 0..v {
            let other = graph.chain(w)[i as usize];
            let joined = other != NONE && graph.tours.connected(node, other);
            assert_eq!(joined, set[v as usize] == set[w as usize]);
        }
        let mut hanging = edges(graph);
        hanging.retain(|&edge| {
            let here = graph.ends(edge).contains(&v) && level(graph, edge) == i;
            here && !graph.is_tree_edge(edge)
        });
        assert_eq!(listed(graph, v, node), hanging);
        assert_eq!(graph.tours.has_mark(node, NodeMark::NonTree), !hanging.is_empty());
    }
}

/// Returns the edges in the list of a vertex, sorted, and checks the links back.
fn listed(graph: &DynamicConnectivity, v: u32, node: u32) -> Vec<u32> {
    let (mut found, mut previous, mut edge) = (Vec::new(), NONE, graph.first[node as usize]);
    while edge != NONE {
        let end = graph.end_at(edge, v);
        assert_eq!(graph.edges[edge as usize].previous[end], previous);
        found.push(edge);
        (previous, edge) = (edge, graph.edges[edge as usize].next[end]);
    }
    found.sort_unstable();
    found
}

fn audit_edges(graph: &DynamicConnectivity, i: u8, set: &[u32]) {
    for edge in edges(graph) {
        let own = level(graph, edge);
        if !graph.is_tree_edge(edge) {
            let [a, b] = graph.ends(edge).map(|v| set[v as usize]);
            assert!(a == b || own < i, "the ends are connected at the edge's level");
            continue;
        }
        let first = graph.edges[edge as usize].way;
        let way = (0..i).fold(first, |way, _| match way {
            NONE => NONE,
            way => graph.above[way as usize],
        });
        assert_eq!(way != NONE, own >= i);
        if way != NONE {
            assert_eq!(graph.tours.label(way), edge);
            assert_eq!(graph.tours.has_mark(way, NodeMark::Tree), own == i);
        }
    }
}

/// Deletes the edge of a name, or inserts it where there is none.
fn toggle(graph: &mut DynamicConnectivity, edge: u32, a: u32, b: u32) {
    if graph.contains(edge) {
        graph.delete(edge);
    } else if a != b {
        graph.insert(edge, a, b);
    }
}

/// Without trials edges rise whenever they can.
#[test]
fn levels_are_kept_while_complete_graphs_are_taken_apart() {
    let mut highest = 0;
    for (nodes, trials) in [(16, 0), (17, 0), (24, 1), (32, 3)] {
        let mut random = Random::stream(u64::from(nodes), &["levels"]);
        let mut all: Vec<_> = (0..nodes).flat_map(|b| (0..b).map(move |a| (a, b))).collect();
        random.shuffle(&mut all);
        let mut graph = DynamicConnectivity::with_trials(nodes as usize, all.len(), trials);
        for (name, &(a, b)) in all.iter().enumerate() {
            graph.insert(name as u32, a, b);
        }
        let mut order: Vec<u32> = (0..all.len() as u32).collect();
        random.shuffle(&mut order);
        for name in order {
            graph.delete(name);
            highest =
                highest.max(edges(&graph).into_iter().map(|e| level(&graph, e)).max().unwrap_or(0));
            audit(&mut graph);
        }
    }
    assert!(highest >= 2, "no level above {highest} was seen");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn levels_are_kept_by_any_changes(
        (nodes, names) in (2..20u32, 1..50u32),
        trials in prop::sample::select(vec![0, 1, 2, TRIALS]),
        draws in prop::collection::vec(any::<[u32; 3]>(), 0..150),
    ) {
        let mut graph = DynamicConnectivity::with_trials(nodes as usize, names as usize, trials);
        for [name, a, b] in draws {
            toggle(&mut graph, name % names, a % nodes, b % nodes);
            audit(&mut graph);
        }
    }
}
