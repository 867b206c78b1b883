//! Patches hold every node once and make compact parts.

use proptest::prelude::*;

use super::super::patches::Patches;
use super::graphs::{Rows, any_graph};
use crate::random::Random;

proptest! {
    #[test]
    fn parts_hold_every_node_once(
        graph in any_graph(0..100), size in 1..20_usize, parts in 1..9_usize,
    ) {
        let mut nodes = Patches::new(&graph, size).into_parts(parts);
        nodes.sort_unstable();
        prop_assert!(nodes.into_iter().eq(0..graph.neighbours.len() as u32));
    }
}

/// A wall of bricks on a torus, its nodes numbered at random.
fn wall(width: u32) -> Rows {
    let mut numbers: Vec<u32> = (0..width * width).collect();
    Random::stream(1, &["wall"]).shuffle(&mut numbers);
    let number = |x: u32, y: u32| numbers[(y % width * width + x % width) as usize];
    let places = (0..width).flat_map(|y| (0..width).map(move |x| (x, y)));
    let edges = places.flat_map(|(x, y)| {
        let beside = (number(x, y), number(x + 1, y), 0);
        let above = (number(x, y), number(x, y + 1), 0);
        std::iter::once(beside).chain(((x + y) % 2 == 0).then_some(above))
    });
    Rows::from_edges(vec![None; (width * width) as usize], edges)
}

/// Returns how many nodes have neighbours in another sixteenth of the order.
fn border(graph: &Rows, order: &[u32]) -> usize {
    let mut part = vec![0; order.len()];
    (0..).zip(order).for_each(|(place, &node)| part[node as usize] = 16 * place / order.len());
    let is_on_border = |&node: &usize| {
        graph.neighbours[node].iter().any(|&other| part[other as usize] != part[node])
    };
    (0..order.len()).filter(is_on_border).count()
}

#[test]
fn parts_are_compact() {
    let graph = wall(128);
    let border = |parts| border(&graph, &Patches::new(&graph, 16).into_parts(parts));
    // Undivided, they are in breadth-first order: sixteenths are rings round the first node.
    let [rings, compact] = [border(1), border(16)];
    assert!(3 * compact < 2 * rings, "{compact} nodes on borders, {rings} of rings");
}
