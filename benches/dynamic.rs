//! Microseconds an operation of the dynamic structures, for growing sizes, best of three.
//!
//! `cargo bench --bench dynamic`. The column of a structure of O(log n) should grow by a constant
//! from line to line, apart from what the caches do; the last one, of O(log² n), by a little more
//! each time.

use std::hint::black_box;
use std::time::Instant;

use triquad::dynamic::{DynamicConnectivity, EulerTourForest, LinkCutForest};
use triquad::random::Random;

const ROUNDS: usize = 3;

fn main() {
    println!(
        "{:>9} {:>14} {:>14} {:>14} {:>14}",
        "nodes", "link-cut", "Euler tour", "grid", "long strip"
    );
    for exponent in [10, 12, 14, 16] {
        let n = 1 << exponent;
        let side = 1 << (exponent / 2);
        println!(
            "{n:>9} {:>14.3} {:>14.3} {:>14.3} {:>14.3}",
            best(|| link_cut(n)),
            best(|| euler_tour(n)),
            best(|| connectivity(n, side)),
            best(|| connectivity(n, 4)),
        );
    }
}

/// The least of some results.
fn best(mut microseconds: impl FnMut() -> f64) -> f64 {
    (0..ROUNDS).map(|_| microseconds()).fold(f64::INFINITY, f64::min)
}

/// Microseconds for each of `count` calls.
fn time(count: u32, mut operation: impl FnMut(u32)) -> f64 {
    let start = Instant::now();
    (0..count).for_each(&mut operation);
    start.elapsed().as_secs_f64() * 1e6 / f64::from(count)
}

/// In a random tree, changing the root, a question, and moving a node elsewhere.
fn link_cut(n: u32) -> f64 {
    let mut random = Random::stream(0, &["link-cut"]);
    let parents: Vec<_> = (0..n).map(|v| v.checked_sub(1).map(|_| random.below(v))).collect();
    let mut forest = LinkCutForest::from_parents(n as usize, |v| parents[v as usize]);
    time(n, |_| {
        let [a, b, root] = [(); 3].map(|()| random.below(n));
        forest.evert(root);
        black_box(forest.lca(a, b));
        if forest.cut_above(a).is_some() {
            let new = if forest.connected(a, b) { root } else { b };
            forest.link(a, new);
        }
    })
}

/// In a random tree, removing an edge, asking for a size, and adding the edge again.
fn euler_tour(n: u32) -> f64 {
    let mut random = Random::stream(0, &["Euler tour"]);
    let mut forest = EulerTourForest::with_capacity(3 * n as usize);
    (0..n).for_each(|v| assert_eq!(forest.add_vertex(v), v));
    let parents: Vec<_> = (1..n).map(|v| random.below(v)).collect();
    let mut ways: Vec<_> = (1..n).zip(&parents).map(|(v, &up)| forest.link(v, up, v)).collect();
    time(n, |_| {
        let edge = random.below(n - 1);
        forest.cut(ways[edge as usize]);
        black_box(forest.vertex_count(edge + 1));
        ways[edge as usize] = forest.link(edge + 1, parents[edge as usize], edge);
    })
}

/// Deletes the edges of a grid with rows of `width` nodes in random order.
fn connectivity(n: u32, width: u32) -> f64 {
    let below = (0..n - width).map(|v| (v, v + width));
    let beside = (1..n).filter(|v| v % width != 0).map(|v| (v - 1, v));
    let mut edges: Vec<_> = below.chain(beside).collect();
    let mut random = Random::stream(0, &["grid"]);
    random.shuffle(&mut edges);
    let mut graph = DynamicConnectivity::new(n as usize, edges.len());
    for (name, &(a, b)) in edges.iter().enumerate() {
        graph.insert(name as u32, a, b);
    }
    time(edges.len() as u32, |name| {
        black_box(graph.delete(name));
    })
}
