//! Cubic multigraphs as lists of edges: all, special ones, random ones.

use crate::random::Random;

/// Both ends of each edge.
pub(super) type EdgeList = Vec<(u32, u32)>;

/// Calls `found` with every labelled cubic multigraph without loops of `nodes` nodes, once.
pub(super) fn every_graph(nodes: u32, found: &mut impl FnMut(&EdgeList)) {
    fn extend(edges: &mut EdgeList, degree: &mut [u8], found: &mut impl FnMut(&EdgeList)) {
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
    extend(&mut EdgeList::new(), &mut vec![0; nodes as usize], found);
}

/// Two rings of `k` nodes with rungs, or one of 2k with `twisted`.
pub(super) fn ladder(k: u32, twisted: bool) -> EdgeList {
    let rails = (0..k - 1).flat_map(|i| [(i, i + 1), (k + i, k + i + 1)]);
    let ends = if twisted { [(k - 1, k), (2 * k - 1, 0)] } else { [(k - 1, 0), (2 * k - 1, k)] };
    rails.chain(ends).chain((0..k).map(|i| (i, k + i))).collect()
}

/// Returns the generalised Petersen graph G(k, step).
pub(super) fn petersen(k: u32, step: u32) -> EdgeList {
    (0..k).flat_map(|i| [(i, (i + 1) % k), (i, k + i), (k + i, k + (i + step) % k)]).collect()
}

/// Returns a ring of `k` double edges joined by single ones.
pub(super) fn necklace(k: u32) -> EdgeList {
    let bead =
        |i: u32| [(2 * i, 2 * i + 1), (2 * i, 2 * i + 1), (2 * i + 1, (2 * i + 2) % (2 * k))];
    (0..k).flat_map(bead).collect()
}

/// Returns a ring of graphs, each opened at its last edge: cuts of two edges everywhere.
pub(super) fn ring(links: &[EdgeList]) -> EdgeList {
    let (mut edges, mut open) = (EdgeList::new(), EdgeList::new());
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
pub(super) fn nest(depth: u32) -> EdgeList {
    let mut edges = ladder(3, true);
    for i in 0..depth {
        edges = ring(&[edges, if i % 2 == 0 { petersen(4, 1) } else { necklace(2) }]);
        edges.rotate_left(5);
    }
    edges
}

pub(super) fn families() -> Vec<(&'static str, EdgeList)> {
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

/// Returns a random cubic multigraph without loops, not always connected: stubs are paired up in
/// random order until there is no loop.
pub(super) fn random_graph(nodes: u32, random: &mut Random) -> EdgeList {
    let mut stubs: Vec<u32> = (0..3 * nodes).map(|i| i / 3).collect();
    loop {
        random.shuffle(&mut stubs);
        let edges: EdgeList = stubs.chunks(2).map(|pair| (pair[0], pair[1])).collect();
        if edges.iter().all(|(a, b)| a != b) {
            return edges;
        }
    }
}

/// Builds a graph from a triple edge: each step puts a new node on each of two edges, which may be
/// the same, and joins them. No bridge can come of that.
pub(super) fn grown(steps: &[(u32, u32)]) -> EdgeList {
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

/// Two K4, each with a node put on one edge, and those two joined: the smallest sort of bridge.
pub(super) fn dumbbell() -> EdgeList {
    let half = |first: u32| {
        [(0, 1), (0, 2), (1, 2), (1, 3), (2, 3), (0, 4), (3, 4)]
            .map(|(a, b)| (a + first, b + first))
    };
    half(0).into_iter().chain(half(5)).chain([(4, 9)]).collect()
}
