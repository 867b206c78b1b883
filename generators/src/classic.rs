//! The smallest closed surfaces, where algorithms first meet their special cases, and the
//! non-orientable and open surfaces that they have to refuse or handle apart.

use crate::circle::circle;
use crate::grids::grid_triangles;
use crate::surface::Surface;

/// The tetrahedron: 4 vertices of degree 3, 4 triangles. Regular, outward.
pub fn tetrahedron() -> Surface {
    Surface {
        positions: vec![[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]],
        triangles: vec![[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]],
    }
}

/// The octahedron: 6 vertices of degree 4, 8 triangles. Regular, outward.
pub fn octahedron() -> Surface {
    Surface {
        positions: vec![
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [-1.0, 0.0, 0.0],
            [0.0, -1.0, 0.0],
            [0.0, 0.0, 1.0],
            [0.0, 0.0, -1.0],
        ],
        triangles: (0..4)
            .map(|i| (i, (i + 1) % 4))
            .flat_map(|(i, j)| [[i, j, 4], [j, i, 5]])
            .collect(),
    }
}

/// The torus of Möbius: 7 vertices, each joined to every other, and 14 triangles; no torus has
/// fewer, and none of its edges can be contracted or flipped.
///
/// With the coordinates of Császár's polyhedron: flat triangles that meet only in common vertices
/// and edges, outward.
pub fn seven_vertex_torus() -> Surface {
    Surface {
        positions: vec![
            [0.0, 0.0, 15.0],
            [3.0, -3.0, 0.0],
            [3.0, 3.0, 1.0],
            [1.0, 2.0, 3.0],
            [-1.0, -2.0, 3.0],
            [-3.0, -3.0, 1.0],
            [-3.0, 3.0, 0.0],
        ],
        triangles: (0..7)
            .map(|i| [i, i + 1, i + 2, i + 3].map(|v| v % 7))
            .flat_map(|[a, b, c, d]| [[a, b, d], [a, d, c]])
            .collect(),
    }
}

/// The bipyramid over a polygon of `m` sides with a vertex in each of its triangles: `3m + 2`
/// vertices, `6m` triangles. Convex as seen from its axis, outward. O(m).
///
/// Figure 6 of Ramaswami and Siqueira (arXiv:1409.6015): the sides of the polygon and the edges
/// from its corners to the apexes cannot be contracted as long as the others are there.
///
/// The apexes are 0 and 1, the corners follow, then the vertices of the upper and of the lower
/// triangles.
///
/// # Panics
/// If `m` is less than 3 or more than 2²⁸.
pub fn starred_bipyramid(m: u32) -> Surface {
    assert!((3..=1 << 28).contains(&m), "a polygon has 3 to 2^28 sides here, not {m}");
    let corners: Vec<[f64; 2]> = (0..m).map(|i| circle(i, m)).collect();
    let corner = |i: u32| 2 + i % m;
    let mut positions = vec![[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
    positions.extend(corners.iter().map(|&[x, y]| [x, y, 0.0]));
    let mut triangles = Vec::with_capacity(6 * m as usize);
    for (apex, height) in [(0, 1.0), (1, -1.0)] {
        for i in 0..m {
            let [a, b] = [i, (i + 1) % m].map(|i| corners[i as usize]);
            let centre = positions.len() as u32;
            positions.push([0.4 * (a[0] + b[0]), 0.4 * (a[1] + b[1]), 0.4 * height]);
            let mut round = [corner(i), corner(i + 1), apex];
            if apex == 1 {
                round.reverse();
            }
            triangles.extend((0..3).map(|k| [round[k], round[(k + 1) % 3], centre]));
        }
    }
    Surface { positions, triangles }
}

/// The projective plane on 6 vertices, each joined to every other, with 10 triangles: closed, not
/// orientable, Euler characteristic 1.
///
/// The surface has no embedding in space; its vertices are points in general position.
pub fn projective_plane() -> Surface {
    Surface {
        positions: (0..6).map(f64::from).map(|t| [t, t * t, t * t * t]).collect(),
        triangles: (0..5)
            .map(|i| [i, i + 1, i + 3].map(|v| v % 5))
            .flat_map(|[a, b, c]| [[a, b, 5], [a, b, c]])
            .collect(),
    }
}

/// A Möbius strip of `n` quadrilaterals, each cut in two: `2n` vertices, `2n` triangles, one
/// boundary loop of `2n` edges; not orientable. O(n).
///
/// The vertices are numbered along the boundary, which goes around twice: `i` and `i + n` are
/// opposite.
///
/// # Panics
/// If `n` is less than 3, the fewest for which the strip is simple, or more than 2³⁰.
pub fn moebius_strip(n: u32) -> Surface {
    assert!((3..=1 << 30).contains(&n), "a Möbius strip needs 3 to 2^30 quadrilaterals, not {n}");
    Surface {
        positions: (0..2 * n)
            .map(|i| {
                // The width turns by half the angle by which the centre line does.
                let half = circle(i, 2 * n);
                turned(half, [2.0 + half[0], half[1]])
            })
            .collect(),
        triangles: (0..n)
            .map(|i| [i, i + 1, i + n + 1, i + n].map(|v| v % (2 * n)))
            .flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]])
            .collect(),
    }
}

/// A Klein bottle from a regular grid: `nu · nv` vertices of degree 6, `2 · nu · nv` triangles;
/// closed, not orientable, Euler characteristic 0. O(nu · nv).
///
/// The grid closes as in a torus, but after `nu` steps the other direction is reversed. Its shape
/// is a figure eight swept around with half a turn: the vertices are distinct, the surface passes
/// through itself.
///
/// # Panics
/// If `nu` or `nv` is less than 3, the fewest for which the surface is simple, or if there are
/// more vertices than a `u32` can number.
pub fn klein_bottle(nu: u32, nv: u32) -> Surface {
    let triangles =
        grid_triangles(nu, nv, |u, v| if u < nu { u * nv + v % nv } else { (2 * nv - 1 - v) % nv });
    let mut positions = Vec::with_capacity(nu as usize * nv as usize);
    for u in 0..nu {
        let half @ [cosine, sine] = circle(u, 2 * nu);
        for v in 0..nv {
            // Half a step off, so that the reversal maps samples to samples and no two of them
            // fall on the crossing of the eight.
            let [x, y] = circle(2 * v + 1, 2 * nv);
            let (across, along) = (y, 2.0 * x * y);
            let radius = 3.0 + cosine * across - sine * along;
            positions.push(turned(half, [radius, sine * across + cosine * along]));
        }
    }
    Surface { positions, triangles }
}

/// The point `[radius, height]` of the half plane that stands around the axis at twice the angle
/// of the unit vector `half`.
fn turned([cosine, sine]: [f64; 2], [radius, height]: [f64; 2]) -> [f64; 3] {
    let (x, y) = (cosine * cosine - sine * sine, 2.0 * cosine * sine);
    [radius * x, radius * y, height]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::{Facts, assert_distinct_positions, assert_oriented, inspect, signed_volume};

    #[test]
    fn orientable_classics_have_their_genus_and_face_outward() {
        for (surface, genus) in [(tetrahedron(), 0), (octahedron(), 0), (seven_vertex_torus(), 1)] {
            assert_oriented(&surface, genus);
            assert_distinct_positions(&surface);
            assert!(signed_volume(&surface) > 0.0);
        }
    }

    #[test]
    fn the_projective_plane_is_closed_and_not_orientable() {
        let closed = Facts { euler: 1, components: 1, boundary_edges: 0, orientable: false };
        assert_eq!(inspect(&projective_plane()), closed);
        assert_distinct_positions(&projective_plane());
    }

    #[test]
    fn klein_bottles_are_closed_and_not_orientable() {
        for (nu, nv) in [(3, 3), (3, 4), (4, 3), (5, 8), (12, 7)] {
            let surface = klein_bottle(nu, nv);
            let closed = Facts { euler: 0, components: 1, boundary_edges: 0, orientable: false };
            assert_eq!(inspect(&surface), closed, "{nu} by {nv}");
            assert_eq!(surface.triangles.len() as u32, 2 * nu * nv);
            assert_distinct_positions(&surface);
        }
    }

    #[test]
    fn moebius_strips_are_open_and_not_orientable() {
        for n in 3..12 {
            let boundary_edges = 2 * n as usize;
            let open = Facts { euler: 0, components: 1, boundary_edges, orientable: false };
            assert_eq!(inspect(&moebius_strip(n)), open, "{n}");
            assert_distinct_positions(&moebius_strip(n));
        }
    }

    /// Triangles that share a vertex can only meet elsewhere if an edge of one pierces the other,
    /// so it is enough to try every edge against every triangle without a common vertex.
    #[test]
    fn the_seven_vertex_torus_is_embedded() {
        let torus = seven_vertex_torus();
        for &[a, b, c] in &torus.triangles {
            for p in 0..7 {
                for q in 0..p {
                    if ![a, b, c].iter().any(|v| [p, q].contains(v)) {
                        assert!(!pierces(&torus.positions, [p, q], [a, b, c]));
                    }
                }
            }
        }
    }

    /// Returns whether the edge meets the triangle, boundaries included. Exact: small integers.
    fn pierces(positions: &[[f64; 3]], [p, q]: [u32; 2], [a, b, c]: [u32; 3]) -> bool {
        let side = |i: u32, j: u32, k: u32, l: u32| {
            let [i, j, k, l] = [i, j, k, l].map(|v| positions[v as usize]);
            let from_i = |p: [f64; 3]| [p[0] - i[0], p[1] - i[1], p[2] - i[2]];
            crate::check::determinant(from_i(j), from_i(k), from_i(l))
        };
        let ends = [side(a, b, c, p), side(a, b, c, q)];
        assert_ne!(ends, [0.0, 0.0], "no edge lies in the plane of a triangle it does not touch");
        let around = [side(p, q, a, b), side(p, q, b, c), side(p, q, c, a)];
        let crosses_the_plane = ends[0] * ends[1] <= 0.0;
        let left = around.iter().any(|&s| s > 0.0);
        let right = around.iter().any(|&s| s < 0.0);
        crosses_the_plane && !(left && right)
    }
}
