//! A brute-force checker for the tests of this crate: hash maps only, none of the generators'
//! own structures.

use crate::surface::Surface;
use std::collections::{HashMap, HashSet};

/// Findings of [`inspect`] on a surface.
#[derive(Debug, PartialEq)]
pub(crate) struct Facts {
    pub(crate) euler: i64,
    pub(crate) components: usize,
    pub(crate) boundary_edges: usize,
    pub(crate) orientable: bool,
}

/// Asserts that `surface` is a connected closed simple surface of the given genus, all triangles
/// oriented alike.
pub(crate) fn assert_oriented(surface: &Surface, genus: usize) {
    let euler = 2 - 2 * genus as i64;
    let facts = Facts { euler, components: 1, boundary_edges: 0, orientable: true };
    assert_eq!(inspect(surface), facts);
    let sides = directed_edges(surface);
    assert_eq!(sides.len(), 3 * surface.triangles.len(), "a directed edge occurs twice");
    assert!(sides.iter().all(|&(a, b)| sides.contains(&(b, a))), "an edge has no reverse");
}

/// Asserts the laws of a simple surface, with or without boundary, and describes it: three
/// distinct corners a triangle, no triangle twice, at most two triangles an edge, one fan a
/// vertex, no vertex unused, coordinates finite.
pub(crate) fn inspect(surface: &Surface) -> Facts {
    assert!(surface.positions.as_flattened().iter().all(|x| x.is_finite()));
    let mut known = HashSet::new();
    let mut fans: HashMap<u32, Vec<[u32; 2]>> = HashMap::new();
    for &[a, b, c] in &surface.triangles {
        assert!(a != b && b != c && c != a, "triangle {a} {b} {c} repeats a corner");
        let mut corners = [a, b, c];
        corners.sort_unstable();
        assert!(known.insert(corners), "triangle {corners:?} occurs twice");
        for (v, edge) in [(a, [b, c]), (b, [c, a]), (c, [a, b])] {
            assert!((v as usize) < surface.positions.len(), "vertex {v} does not exist");
            fans.entry(v).or_default().push(edge);
        }
    }
    assert_eq!(fans.len(), surface.positions.len(), "a vertex is unused");
    fans.iter().for_each(|(v, link)| assert_one_fan(*v, link));

    let edges = triangles_by_edge(surface);
    assert!(edges.values().all(|around| around.len() <= 2), "an edge has three triangles");
    let (components, orientable) = spread_orientation(surface, &edges);
    Facts {
        euler: fans.len() as i64 - edges.len() as i64 + known.len() as i64,
        components,
        boundary_edges: edges.values().filter(|around| around.len() == 1).count(),
        orientable,
    }
}

/// Asserts that no two vertices have the same coordinates.
pub(crate) fn assert_distinct_positions(surface: &Surface) {
    // Adding zero makes -0 and 0 the same.
    let places: HashSet<_> =
        surface.positions.iter().map(|p| p.map(|x| (x + 0.0).to_bits())).collect();
    assert_eq!(places.len(), surface.positions.len(), "two vertices coincide");
}

/// The number of neighbours of each vertex.
pub(crate) fn degrees(surface: &Surface) -> Vec<usize> {
    let mut degrees = vec![0; surface.positions.len()];
    for edge in triangles_by_edge(surface).keys() {
        edge.iter().for_each(|&v| degrees[v as usize] += 1);
    }
    degrees
}

/// The share of vertices of degree 6 on a closed surface.
pub(crate) fn degree_six_share(surface: &Surface) -> f64 {
    let mut triangles_around = vec![0; surface.positions.len()];
    for &v in surface.triangles.as_flattened() {
        triangles_around[v as usize] += 1;
    }
    let six = triangles_around.iter().filter(|&&count| count == 6).count();
    six as f64 / surface.positions.len() as f64
}

/// The volume enclosed, positive if the triangles face outward.
pub(crate) fn signed_volume(surface: &Surface) -> f64 {
    let corner = |v: u32| surface.positions[v as usize];
    let prism = |&[a, b, c]: &[u32; 3]| determinant(corner(a), corner(b), corner(c));
    surface.triangles.iter().map(prism).sum::<f64>() / 6.0
}

pub(crate) fn determinant(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> f64 {
    a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
}

/// Asserts that no edge passes through the inside of a triangle that it does not touch. Triangles
/// in general position that meet outside their common vertices do so.
pub(crate) fn assert_embedded(surface: &Surface) {
    let point = |v: u32| surface.positions[v as usize];
    let edges = || directed_edges(surface).into_iter().filter(|(a, b)| a < b).map(|(a, b)| [a, b]);
    let extent = |[p, q]: [[f64; 3]; 2]| (0..3).map(|k| (p[k] - q[k]).abs()).sum::<f64>();
    let mean = edges().map(|edge| extent(edge.map(point))).sum::<f64>() / edges().count() as f64;
    let mut nearby: HashMap<_, Vec<_>> = HashMap::new();
    for triangle in &surface.triangles {
        for block in blocks(&triangle.map(point), mean) {
            nearby.entry(block).or_default().push(*triangle);
        }
    }
    for edge in edges() {
        for block in blocks(&edge.map(point), mean) {
            for triangle in nearby.get(&block).into_iter().flatten() {
                let apart = edge.iter().all(|v| !triangle.contains(v));
                let through = apart && passes_through(edge.map(point), triangle.map(point));
                assert!(!through, "edge {edge:?} passes through triangle {triangle:?}");
            }
        }
    }
}

/// The blocks of a regular subdivision of space that the bounding box of `points` meets.
fn blocks(points: &[[f64; 3]], size: f64) -> Vec<[i64; 3]> {
    let [x, y, z] = [0, 1, 2].map(|axis| {
        let at = points.iter().map(|p| (p[axis] / size).floor() as i64);
        at.clone().min().unwrap()..=at.max().unwrap()
    });
    let columns = x.flat_map(|x| y.clone().map(move |y| [x, y]));
    columns.flat_map(|[x, y]| z.clone().map(move |z| [x, y, z])).collect()
}

/// Returns whether the segment crosses the triangle, boundaries left out.
fn passes_through([p, q]: [[f64; 3]; 2], [a, b, c]: [[f64; 3]; 3]) -> bool {
    let side = |i: [f64; 3], others: [[f64; 3]; 3]| {
        let [j, k, l] = others.map(|o| [o[0] - i[0], o[1] - i[1], o[2] - i[2]]);
        determinant(j, k, l)
    };
    let around = [side(p, [q, a, b]), side(p, [q, b, c]), side(p, [q, c, a])];
    side(a, [b, c, p]) * side(a, [b, c, q]) < 0.0
        && (around.iter().all(|&s| s > 0.0) || around.iter().all(|&s| s < 0.0))
}

/// The directed edges of all triangles.
pub(crate) fn directed_edges(surface: &Surface) -> HashSet<(u32, u32)> {
    surface.triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]).collect()
}

/// Asserts that the edges opposite to `v` form a single path or cycle.
fn assert_one_fan(v: u32, link: &[[u32; 2]]) {
    let mut neighbours: HashMap<u32, Vec<u32>> = HashMap::new();
    for &[a, b] in link {
        neighbours.entry(a).or_default().push(b);
        neighbours.entry(b).or_default().push(a);
    }
    assert!(neighbours.values().all(|next| next.len() <= 2), "the link of {v} branches");
    let mut reached = HashSet::from([link[0][0]]);
    let mut stack = vec![link[0][0]];
    while let Some(a) = stack.pop() {
        stack.extend(neighbours[&a].iter().filter(|b| reached.insert(**b)));
    }
    assert_eq!(reached.len(), neighbours.len(), "vertex {v} has several fans");
}

/// For each undirected edge its triangles, and whether each runs along it from low to high.
fn triangles_by_edge(surface: &Surface) -> HashMap<[u32; 2], Vec<(usize, bool)>> {
    let mut edges: HashMap<_, Vec<_>> = HashMap::new();
    for (f, &[a, b, c]) in surface.triangles.iter().enumerate() {
        for (p, q) in [(a, b), (b, c), (c, a)] {
            edges.entry([p.min(q), p.max(q)]).or_default().push((f, p < q));
        }
    }
    edges
}

/// The number of connected components, and whether turning some triangles over makes all agree.
fn spread_orientation(
    surface: &Surface,
    edges: &HashMap<[u32; 2], Vec<(usize, bool)>>,
) -> (usize, bool) {
    let mut neighbours = vec![Vec::new(); surface.triangles.len()];
    for around in edges.values() {
        if let [(f, f_rises), (g, g_rises)] = around[..] {
            neighbours[f].push((g, f_rises == g_rises));
            neighbours[g].push((f, f_rises == g_rises));
        }
    }
    let mut turned = vec![None; neighbours.len()];
    let (mut components, mut orientable) = (0, true);
    for root in 0..neighbours.len() {
        if turned[root].is_some() {
            continue;
        }
        components += 1;
        turned[root] = Some(false);
        let mut stack = vec![root];
        while let Some(f) = stack.pop() {
            for &(g, differ) in &neighbours[f] {
                let wanted = turned[f].map(|turn| turn ^ differ);
                if turned[g].is_none() {
                    turned[g] = wanted;
                    stack.push(g);
                }
                orientable &= turned[g] == wanted;
            }
        }
    }
    (components, orientable)
}

/// The checker itself must notice what is broken.
#[cfg(test)]
mod tests {
    use super::*;
    use crate::classic::{klein_bottle, seven_vertex_torus, tetrahedron};

    #[test]
    #[should_panic(expected = "a directed edge occurs twice")]
    fn notices_a_triangle_turned_over() {
        let mut surface = tetrahedron();
        surface.triangles[2].swap(0, 1);
        assert_oriented(&surface, 0);
    }

    #[test]
    #[should_panic(expected = "has several fans")]
    fn notices_two_fans() {
        let mut surface = tetrahedron();
        let other = surface.triangles.clone();
        surface.positions.extend([[2.0; 3], [3.0; 3], [4.0; 3]]);
        // Vertex 0 belongs to both tetrahedra.
        let moved = other.iter().map(|corners| corners.map(|v| if v == 0 { 0 } else { v + 3 }));
        surface.triangles.extend(moved);
        inspect(&surface);
    }

    #[test]
    #[should_panic(expected = "passes through triangle")]
    fn notices_a_surface_that_passes_through_itself() {
        assert_embedded(&seven_vertex_torus());
        assert_embedded(&klein_bottle(20, 21));
    }

    #[test]
    fn counts_boundary_edges() {
        let mut surface = tetrahedron();
        surface.triangles.pop();
        assert_eq!(inspect(&surface).boundary_edges, 3);
    }
}
