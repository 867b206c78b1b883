//! Surfaces on which some algorithms take longer than on others, in linear time.

use crate::circle::circle;
use crate::classic::seven_vertex_torus;
use crate::surface::Surface;

/// A closed prism over a regular triangle: `side` edges along each side of its two ends, `length`
/// edges from one end to the other. `6 · side · length + 2 · side²` triangles, outward. O(result).
///
/// Six vertices have degree 4, all others 6. With even degrees the dual graph is bipartite, and
/// every perfect matching crosses every ring of edges round the prism `side` times. A pairing that
/// spreads in rings crosses none: it leaves `side` triangles at either end, far from the others.
///
/// # Panics
/// If `side` or `length` is 0, or if a `u32` cannot number the vertices.
pub fn prism(side: u32, length: u32) -> Surface {
    assert!(side > 0 && length > 0, "a prism needs edges, not {side} by {length}");
    let ring = 3 * side;
    let count = u64::from(ring) * (u64::from(length) + 1) + u64::from(side).pow(2);
    assert!(count < u64::from(u32::MAX), "{count} vertices cannot be numbered");
    let end = End { side };
    let mut positions = Vec::new();
    for z in 0..=length {
        positions.extend((0..ring).map(|place| end.position(end.on_rim(place), z)));
    }
    let mut triangles = Vec::new();
    for z in 0..length {
        for place in 0..ring {
            let [a, b] = [place, (place + 1) % ring].map(|place| z * ring + place);
            triangles.extend([[a, b, a + ring], [b, b + ring, a + ring]]);
        }
    }
    for (z, is_top) in [(0, false), (length, true)] {
        let inner = positions.len() as u32;
        positions.extend(end.inner_nodes().map(|node| end.position(node, z)));
        triangles.extend(end.triangles().map(|corners| {
            let [a, b, c] = corners.map(|node| end.number(node, z * ring, inner));
            if is_top { [a, b, c] } else { [a, c, b] }
        }));
    }
    Surface { positions, triangles }
}

/// [`prism`] with *lobes*: at both ends, each triangle that points the way of the end itself is
/// replaced by the three sides of a flat pyramid. `6 · side · length + 4 · side² + 2 · side`
/// triangles, outward. O(result).
///
/// A lobe has an odd number of triangles, so pairs within it leave one for a triangle outside.
/// Every perfect matching still crosses every ring of edges round the prism at least `side` times.
/// But the dual graph is not bipartite: searches meet blossoms.
///
/// # Panics
/// If `side` or `length` is 0, or if a `u32` cannot number the vertices.
pub fn prism_with_lobes(side: u32, length: u32) -> Surface {
    let Surface { mut positions, mut triangles } = prism(side, length);
    let ends = triangles.split_off(6 * side as usize * length as usize);
    let apexes = u64::from(side) * (u64::from(side) + 1);
    let count = positions.len() as u64 + apexes;
    assert!(count < u64::from(u32::MAX), "{count} vertices cannot be numbered");
    let (bottom, top) = ends.split_at(ends.len() / 2);
    for (end, height) in [(bottom, -0.25), (top, f64::from(length) + 0.25)] {
        for (&[a, b, c], nodes) in end.iter().zip((End { side }).triangles()) {
            if !is_upright(nodes) {
                triangles.push([a, b, c]);
                continue;
            }
            let apex = positions.len() as u32;
            let corners = [a, b, c].map(|corner| positions[corner as usize]);
            let middle = |axis| corners.iter().map(|p| p[axis]).sum::<f64>() / 3.0;
            positions.push([middle(0), middle(1), height]);
            triangles.extend([[a, b, apex], [b, c, apex], [c, a, apex]]);
        }
    }
    Surface { positions, triangles }
}

/// The end of a prism: a triangle cut into `side`² equal ones.
#[derive(Clone, Copy)]
struct End {
    side: u32,
}

/// A node of an end: its distances from the three sides in rows, which add up to `side`.
type Node = [u32; 3];

/// Returns whether one of [`End::triangles`] points the way of the end itself.
fn is_upright([_, [second, ..], [third, ..]]: [Node; 3]) -> bool {
    second == third
}

impl End {
    /// Returns the node at a place on the rim, counter-clockwise from the first corner.
    fn on_rim(self, place: u32) -> Node {
        let (corner, step) = (place / self.side, place % self.side);
        let mut node = [0; 3];
        node[corner as usize] = self.side - step;
        node[(corner as usize + 1) % 3] = step;
        node
    }

    /// Returns the vertex at `node`, where the rim begins with vertex `rim` and the nodes inside
    /// with vertex `inner`.
    fn number(self, [i, j, k]: Node, rim: u32, inner: u32) -> u32 {
        let side = self.side;
        match [i, j, k] {
            [_, _, 0] => rim + j,
            [0, _, _] => rim + side + k,
            [_, 0, _] => rim + (2 * side + i) % (3 * side),
            // Row j has side - j - 1 nodes inside.
            _ => inner + (j - 1) * (side - 1) - j * (j - 1) / 2 + (k - 1),
        }
    }

    /// Iterates over the nodes that are not on the rim, in the order of their numbers.
    fn inner_nodes(self) -> impl Iterator<Item = Node> {
        let side = self.side;
        (1..side).flat_map(move |j| (1..side - j).map(move |k| [side - j - k, j, k]))
    }

    /// Iterates over the triangles, counter-clockwise seen from above.
    fn triangles(self) -> impl Iterator<Item = [Node; 3]> {
        let side = self.side;
        let rows = (0..side).flat_map(move |j| (0..side - j).map(move |k| [side - j - k, j, k]));
        rows.flat_map(|[i, j, k]| {
            let upright = [[i, j, k], [i - 1, j + 1, k], [i - 1, j, k + 1]];
            let inverted =
                (i > 1).then(|| [[i - 1, j + 1, k], [i - 2, j + 1, k + 1], [i - 1, j, k + 1]]);
            std::iter::once(upright).chain(inverted)
        })
    }

    fn position(self, node: Node, z: u32) -> [f64; 3] {
        let corners = [0, 1, 2].map(|corner| circle(corner, 3));
        let sum = |axis| (0..3).map(|c| f64::from(node[c]) * corners[c][axis]).sum::<f64>();
        let scale = 1.0 / 3f64.sqrt();
        [scale * sum(0), scale * sum(1), f64::from(z)]
    }
}

/// A bipyramid over a `genus`-gon with a torus of seven vertices in place of every triangle at its
/// first pole: `14 · genus` triangles. O(result).
///
/// No edge at that pole can be contracted, and the pole is a neighbour of every vertex but one. So
/// each test of such an edge visits `5 · genus` vertices. The pole has the highest number; numbered
/// so, all edges at it are tested from their other ends. The surface passes through itself.
///
/// # Panics
/// If `genus` is less than 3, or if a `u32` cannot number the vertices.
pub fn tori_round_a_pole(genus: u32) -> Surface {
    assert!((3..1 << 28).contains(&genus), "a bipyramid has 3 to 2^28 sides, not {genus}");
    let (south, pole) = (genus, 5 * genus + 1);
    let around = |k| circle(k % genus, genus);
    let mut positions: Vec<_> = (0..genus).map(|k| [around(k)[0], around(k)[1], 0.0]).collect();
    positions.push([0.0, 0.0, -1.0]);
    let mut triangles = Vec::new();
    for k in 0..genus {
        let next = (k + 1) % genus;
        triangles.push([next, k, south]);
        let first = positions.len() as u32;
        let [[x, y], [u, v]] = [around(k), around(k + 1)];
        for height in [0.2, 0.4, 0.6, 0.8] {
            positions.push([0.5 * (x + u), 0.5 * (y + v), height]);
        }
        let torus = seven_vertex_torus().triangles;
        let [a, b, c] = torus[0];
        // The triangle that is left out is (k, next, pole), from its other side.
        let number = |corner: u32| match corner {
            _ if corner == a => next,
            _ if corner == b => k,
            _ if corner == c => pole,
            _ => first + (0..corner).filter(|v| ![a, b, c].contains(v)).count() as u32,
        };
        triangles.extend(torus[1..].iter().map(|corners| corners.map(number)));
    }
    positions.push([0.0, 0.0, 1.0]);
    Surface { positions, triangles }
}

/// A flat slab: two sheets of `2 · side²` equilateral triangles each, with edges of length 1, one
/// above the other, and `8 · side` triangles round their rim. Every coordinate is moved by up to
/// 1/1000, drawn. `4 · side² + 8 · side` triangles, outward. O(result).
///
/// Nearly all perfect matchings of the dual graph then cost nearly the same if costs depend on the
/// shape: what is best here depends on what is best far away.
///
/// # Panics
/// If `side` is 0, or if a `u32` cannot number the vertices.
pub fn slab(side: u32, draw: &mut impl FnMut(u32) -> u32) -> Surface {
    assert!((1..1 << 15).contains(&side), "a slab has 1 to 2^15 - 1 edges a side, not {side}");
    let number = |sheet, i, j| (sheet * (side + 1) + i) * (side + 1) + j;
    let mut moved = |x: f64| x + f64::from(draw(2001)) * 1e-6 - 1e-3;
    let mut positions = Vec::new();
    let mut triangles = Vec::new();
    for sheet in 0..2 {
        for (i, j) in (0..=side).flat_map(|i| (0..=side).map(move |j| (i, j))) {
            let [row, place] = [i, j].map(f64::from);
            let position = [place + row / 2.0, row * (3f64.sqrt() / 2.0), f64::from(sheet)];
            positions.push(position.map(&mut moved));
        }
        for (i, j) in (0..side).flat_map(|i| (0..side).map(move |j| (i, j))) {
            let [a, b] = [number(sheet, i, j), number(sheet, i, j + 1)];
            let [c, d] = [a, b].map(|corner| corner + side + 1);
            let upward = [[a, b, c], [b, d, c]];
            triangles.extend(if sheet == 1 { upward } else { upward.map(|[a, b, c]| [a, c, b]) });
        }
    }
    let rim = |place: u32| match (place / side % 4, place % side) {
        (0, step) => (0, step),
        (1, step) => (step, side),
        (2, step) => (side, side - step),
        (_, step) => (side - step, 0),
    };
    for place in 0..4 * side {
        let [(i, j), (k, l)] = [rim(place), rim(place + 1)];
        let [a, b, c, d] = [number(0, i, j), number(0, k, l), number(1, i, j), number(1, k, l)];
        triangles.extend([[a, b, c], [b, d, c]]);
    }
    Surface { positions, triangles }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::signed_volume;
    use crate::check::{assert_distinct_positions, assert_embedded, assert_oriented, degrees};

    #[test]
    fn prisms_of_every_size() {
        for (side, length) in [(1, 1), (1, 5), (2, 1), (2, 3), (3, 2), (5, 7), (8, 20)] {
            let surface = prism(side, length);
            let expected = 6 * side * length + 2 * side * side;
            assert_eq!(surface.triangles.len() as u32, expected);
            assert_oriented(&surface, 0);
            assert_distinct_positions(&surface);
            assert_embedded(&surface);
            let area = 3f64.sqrt() / 4.0 * f64::from(side * side);
            let volume = area * f64::from(length);
            assert!((signed_volume(&surface) / volume - 1.0).abs() < 1e-12);
            assert!(degrees(&surface).into_iter().all(|degree| degree == 4 || degree == 6));
        }
    }

    #[test]
    fn prisms_with_lobes_of_every_size() {
        for (side, length) in [(1, 1), (1, 5), (2, 1), (2, 3), (3, 2), (5, 7), (8, 20)] {
            let surface = prism_with_lobes(side, length);
            let expected = 6 * side * length + 4 * side * side + 2 * side;
            assert_eq!(surface.triangles.len() as u32, expected);
            assert_oriented(&surface, 0);
            assert_distinct_positions(&surface);
            assert_embedded(&surface);
            let lobes = degrees(&surface).into_iter().filter(|&degree| degree == 3).count() as u32;
            assert_eq!(lobes, side * (side + 1));
            // A prism of length 1 has this volume for each side squared, a lobe a twelfth of it.
            let base = 3f64.sqrt() / 4.0;
            let volume = base * (f64::from(side * side * length) + f64::from(lobes) / 12.0);
            assert!((signed_volume(&surface) / volume - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn slabs_of_every_size() {
        for side in [1, 2, 3, 10] {
            let mut last = 0;
            let surface = slab(side, &mut |bound| {
                last = (last + 700) % bound;
                last
            });
            assert_eq!(surface.triangles.len() as u32, 4 * side * side + 8 * side);
            assert_oriented(&surface, 0);
            assert_distinct_positions(&surface);
            assert_embedded(&surface);
            let volume = 3f64.sqrt() / 2.0 * f64::from(side * side);
            assert!((signed_volume(&surface) / volume - 1.0).abs() < 0.02);
        }
    }

    #[test]
    fn tori_round_a_pole_of_every_size() {
        for genus in [3, 4, 5, 12, 40] {
            let surface = tori_round_a_pole(genus);
            assert_eq!(surface.triangles.len() as u32, 14 * genus);
            assert_oriented(&surface, genus as usize);
            assert_distinct_positions(&surface);
            assert_eq!(degrees(&surface).last(), Some(&(5 * genus as usize)));
        }
    }
}
