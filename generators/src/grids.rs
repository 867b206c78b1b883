//! Regular spheres and tori of any size, numbered row by row, in linear time.
//!
//! Neighbouring triangles have neighbouring numbers, as in a file written by a careful program;
//! relabel with [`crate::sculptor::Sculptor::relabel`] for the opposite.

use crate::circle::circle;
use crate::surface::Surface;

/// The unit sphere as an octahedron with each face cut into `n` × `n` and projected: `4n² + 2`
/// vertices, `8n²` triangles, outward. Six vertices have degree 4, all others 6. O(n²).
///
/// Coordinates use only `+ * /` and the square root, all of them exact in IEEE 754 up to one
/// rounding, so they are the same on every platform.
///
/// # Panics
/// If `n` is 0 or more than 2¹⁵ − 1, where vertices no longer fit a `u32`.
pub fn sphere(n: u32) -> Surface {
    assert!((1..1 << 15).contains(&n), "a sphere needs 1 to 2^15 - 1 rows a face, not {n}");
    let rings = rings(n);
    let mut positions = Vec::with_capacity(4 * (n as usize).pow(2) + 2);
    for (k, ring) in rings.iter().enumerate() {
        ring.push_positions(f64::from(n) - k as f64, &mut positions);
    }
    let mut triangles = Vec::with_capacity(8 * (n as usize).pow(2));
    for pair in rings.windows(2) {
        push_band(pair[0], pair[1], &mut triangles);
    }
    Surface { positions, triangles }
}

/// One latitude of the octahedron: four straight sides of `side` edges each, or a pole.
#[derive(Clone, Copy)]
struct Ring {
    /// First vertex.
    start: u32,
    /// Edges on each of the four sides; 0 at a pole.
    side: u32,
}

/// All latitudes from the north pole to the south pole.
fn rings(n: u32) -> Vec<Ring> {
    let mut start = 0;
    let sides = (0..=n).chain((0..n).rev());
    sides
        .map(|side| {
            let ring = Ring { start, side };
            start += ring.len();
            ring
        })
        .collect()
}

impl Ring {
    fn len(self) -> u32 {
        (4 * self.side).max(1)
    }

    /// The vertex `step` edges into the given side; sides follow each other eastward.
    fn vertex(self, side: u32, step: u32) -> u32 {
        self.start + (side * self.side + step) % self.len()
    }

    /// Appends the projected vertices. Before that, `height` is the distance from the equator in
    /// rows: coordinates are whole numbers, so the projection alone rounds.
    fn push_positions(self, height: f64, positions: &mut Vec<[f64; 3]>) {
        if self.side == 0 {
            positions.push(on_unit_sphere([0.0, 0.0, height]));
        }
        for [x, y] in [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]] {
            for step in 0..self.side {
                // From the corner (x, y) towards the next one, (-y, x).
                let (there, here) = (f64::from(step), f64::from(self.side - step));
                let p = [here * x - there * y, here * y + there * x, height];
                positions.push(on_unit_sphere(p));
            }
        }
    }
}

fn on_unit_sphere([x, y, z]: [f64; 3]) -> [f64; 3] {
    let length = (x * x + y * y + z * z).sqrt();
    [x / length, y / length, z / length]
}

/// Appends the triangles between two neighbouring latitudes, west to east.
///
/// ```text
///     s0----s1----s2    the ring nearer to its pole
///    /  \  /  \  /  \
///  l0----l1----l2----l3
/// ```
fn push_band(upper: Ring, lower: Ring, triangles: &mut Vec<[u32; 3]>) {
    let northern = upper.side < lower.side;
    let (small, large) = if northern { (upper, lower) } else { (lower, upper) };
    // Drawn as above on both hemispheres, the picture is a mirror image in the south.
    let outward = |[a, b, c]: [u32; 3]| if northern { [a, b, c] } else { [a, c, b] };
    for side in 0..4 {
        for step in 0..large.side {
            let s0 = small.vertex(side, step);
            let l1 = large.vertex(side, step + 1);
            triangles.push(outward([s0, large.vertex(side, step), l1]));
            if step < small.side {
                triangles.push(outward([s0, l1, small.vertex(side, step + 1)]));
            }
        }
    }
}

/// A torus of revolution from a regular grid: `nu` steps around the axis, `nv` around the tube;
/// `nu · nv` vertices, all of degree 6, `2 · nu · nv` triangles, outward. O(nu · nv).
///
/// The tube has radius 1, its centre line radius 2. The circles are computed without the
/// platform's sine, so the coordinates are the same on every platform.
///
/// # Panics
/// If `nu` or `nv` is less than 3, the fewest for which the surface is simple, or if there are
/// more vertices than a `u32` can number.
pub fn torus(nu: u32, nv: u32) -> Surface {
    let triangles = grid_triangles(nu, nv, |u, v| (u % nu) * nv + v % nv);
    let tube: Vec<_> = (0..nv).map(|v| circle(v, nv)).collect();
    let mut positions = Vec::with_capacity(nu as usize * nv as usize);
    for u in 0..nu {
        let [x, y] = circle(u, nu);
        positions.extend(tube.iter().map(|[c, s]| [(2.0 + c) * x, (2.0 + c) * y, *s]));
    }
    Surface { positions, triangles }
}

/// The triangles of `nu` × `nv` square cells, each cut along the same diagonal. `vertex(u, v)`
/// numbers the corners, `u <= nu` and `v <= nv`, and so decides how the grid closes.
///
/// # Panics
/// If `nu` or `nv` is less than 3 or `nu · nv` does not fit a `u32`.
pub(crate) fn grid_triangles(nu: u32, nv: u32, vertex: impl Fn(u32, u32) -> u32) -> Vec<[u32; 3]> {
    assert!(nu >= 3 && nv >= 3, "a closed grid needs at least 3 x 3 cells, not {nu} x {nv}");
    assert!(nu.checked_mul(nv).is_some(), "the vertices of {nu} x {nv} cells do not fit a u32");
    let mut triangles = Vec::with_capacity(2 * nu as usize * nv as usize);
    for u in 0..nu {
        for v in 0..nv {
            let (a, b) = (vertex(u, v), vertex(u + 1, v));
            let (c, d) = (vertex(u + 1, v + 1), vertex(u, v + 1));
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    triangles
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::{assert_distinct_positions, assert_oriented, degrees, signed_volume};
    use crate::classic::octahedron;

    #[test]
    fn spheres_of_every_size() {
        for n in [1, 2, 3, 4, 7, 20] {
            let surface = sphere(n);
            assert_eq!(surface.positions.len() as u32, 4 * n * n + 2);
            assert_eq!(surface.triangles.len() as u32, 8 * n * n);
            assert_oriented(&surface, 0);
            assert_distinct_positions(&surface);
            let mut degrees = degrees(&surface);
            degrees.sort_unstable();
            assert_eq!(degrees[..6], [4; 6]);
            assert!(degrees[6..].iter().all(|&degree| degree == 6));
        }
    }

    #[test]
    fn spheres_are_round_and_fill_the_ball() {
        let surface = sphere(50);
        for [x, y, z] in &surface.positions {
            assert!((x * x + y * y + z * z - 1.0).abs() < 1e-15);
        }
        let ball = 4.0 / 3.0 * std::f64::consts::PI;
        assert!((signed_volume(&surface) / ball - 1.0).abs() < 1e-2);
    }

    #[test]
    fn the_smallest_sphere_is_the_octahedron() {
        let volume = signed_volume(&octahedron());
        assert!((signed_volume(&sphere(1)) - volume).abs() < 1e-15);
    }

    #[test]
    fn tori_of_every_size() {
        for (nu, nv) in [(3, 3), (3, 4), (4, 3), (5, 3), (7, 11), (16, 9)] {
            let surface = torus(nu, nv);
            assert_eq!(surface.triangles.len() as u32, 2 * nu * nv);
            assert_oriented(&surface, 1);
            assert_distinct_positions(&surface);
            assert!(degrees(&surface).iter().all(|&degree| degree == 6));
            assert!(signed_volume(&surface) > 0.0);
        }
    }

    #[test]
    fn neighbouring_triangles_of_a_sphere_have_neighbouring_numbers() {
        let n = 30;
        for triangle in sphere(n).triangles {
            let [low, high] = [triangle.iter().min(), triangle.iter().max()].map(Option::unwrap);
            assert!(high - low <= 8 * n);
        }
    }

    #[test]
    #[should_panic(expected = "at least 3 x 3 cells")]
    fn a_torus_of_two_columns_is_refused() {
        torus(2, 5);
    }
}
