//! The cost of a quad: an integer for every edge whose removal makes one.
//!
//! The two costs here use +, −, ×, ÷ and √ only, so they have the same value on every machine.

use std::sync::atomic::{AtomicI32, Ordering};

use super::edge_quad::{EdgeQuad, prefetch_ahead};
use crate::parallel::{collect, map, ranges};
use crate::prefetch::prefetch;
use crate::triangulation::{HalfEdgeId, Surface, TriangleId};

/// A price for every quad that two triangles can make; the less, the better the quad.
///
/// Costs may be negative. A function or closure is a cost, too:
///
/// ```
/// use triquad::quadrangulation::{Cost, EdgeQuad};
///
/// /// Returns the squared length of the removed edge, in thousandths.
/// fn shortest_edge(quad: &EdgeQuad) -> i32 {
///     let [a, _, b, _] = quad.corners;
///     let squares = (0..3).map(|axis| (b[axis] - a[axis]) * (b[axis] - a[axis]));
///     (1000.0 * squares.sum::<f64>()) as i32
/// }
/// # fn wants_a_cost(cost: impl Cost) {}
/// # wants_a_cost(shortest_edge);
/// ```
pub trait Cost: Sync {
    /// Returns the cost of making `quad` out of its two triangles.
    ///
    /// Called once for every edge, in no particular order, possibly from several threads. Equal
    /// quads must have equal costs, or results differ from run to run.
    fn cost(&self, quad: &EdgeQuad) -> i32;
}

impl<F: Fn(&EdgeQuad) -> i32 + Sync> Cost for F {
    #[inline]
    fn cost(&self, quad: &EdgeQuad) -> i32 {
        self(quad)
    }
}

/// Well-shaped quads, few folded ones, and few across sharp edges.
///
/// With the scaled Jacobian J of the quad and the angle θ between the normals of its triangles:
///
/// ```text
/// c = (1 − J) + ½ clamp(1 − 50 J, 0, 1) + 3 max(0, −J) + 0.55 (1 − cos θ)
/// ```
///
/// The cost is c in units of 2⁻¹⁶, rounded: 0 for a flat rectangle, 432,538 at most.
///
/// * The first term is the shape: least in sum where the mean of J is greatest.
/// * The second is the price of a folded quad, J ≤ 0. It begins at J = 0.02, so that rounding does
///   not decide about corners of exactly 180°.
/// * The third makes a quad that is folded further cost more.
/// * The last keeps sharp edges: a bend by 30° costs 0.07, by 60° 0.28, by 90° 0.55.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DefaultCost;

impl DefaultCost {
    /// The cost that c = 1 stands for.
    pub const UNIT: f64 = 65536.0;
}

impl Cost for DefaultCost {
    #[inline]
    fn cost(&self, quad: &EdgeQuad) -> i32 {
        let jacobian = quad.scaled_jacobian();
        let shape = 1.0 - jacobian;
        let folded = 0.5 * (1.0 - 50.0 * jacobian).clamp(0.0, 1.0) + 3.0 * (-jacobian).max(0.0);
        let bend = 0.55 * (1.0 - quad.fold_cosine());
        nearest(Self::UNIT * (shape + folded + bend))
    }
}

/// The shape of the quad and nothing else, to compare with other programs.
///
/// The cost is 10⁴ (1 − J) for the scaled Jacobian J, rounded: from 0 to 20,000.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ShapeCost;

impl ShapeCost {
    /// The cost of a quad of scaled Jacobian 0.
    pub const UNIT: f64 = 1e4;
}

impl Cost for ShapeCost {
    #[inline]
    fn cost(&self, quad: &EdgeQuad) -> i32 {
        nearest(Self::UNIT * (1.0 - quad.scaled_jacobian()))
    }
}

/// Returns the integer nearest to `value`, which is not negative.
#[inline]
fn nearest(value: f64) -> i32 {
    (value + 0.5) as i32
}

/// Returns the cost of every edge, at both of its sides.
///
/// Row `f`, column `i` belongs to side `i` of triangle `f`, as in
/// [`DualGraph::sides`](crate::DualGraph::sides); it is 0 on the boundary. O(n); 12 bytes a
/// triangle.
///
/// # Panics
/// If a vertex of the surface has no position.
pub fn edge_costs(
    surface: &impl Surface,
    positions: &[[f64; 3]],
    cost: &(impl Cost + ?Sized),
) -> Vec<[i32; 3]> {
    let triangles = surface.triangle_count();
    let rows: Vec<[AtomicI32; 3]> = collect(triangles, |_| Default::default());
    let valuation = Valuation { surface, positions, cost, of_side: rows.as_flattened() };
    map(ranges(triangles), |range| {
        range.map(TriangleId::new).for_each(|f| valuation.set_costs(f));
    });
    rows.into_iter().map(|row| row.map(AtomicI32::into_inner)).collect()
}

/// Costs on their way into the array over all sides.
///
/// Each cell is written once, by whichever thread has the lower of the two triangles, and read when
/// all is done: no order between threads is needed.
struct Valuation<'a, S, C: ?Sized> {
    surface: &'a S,
    positions: &'a [[f64; 3]],
    cost: &'a C,
    of_side: &'a [AtomicI32],
}

impl<S: Surface, C: Cost + ?Sized> Valuation<'_, S, C> {
    /// Sets the costs of those edges of `f` whose other triangle comes later.
    #[inline]
    fn set_costs(&self, f: TriangleId) {
        let prefetch_cost = |twin: HalfEdgeId| prefetch(self.of_side, twin.index());
        prefetch_ahead(self.surface, self.positions, f, prefetch_cost);
        for side in f.half_edges() {
            let Some(twin) = self.surface.across(side).filter(|&twin| side < twin) else {
                continue;
            };
            let quad = EdgeQuad::between(self.surface, self.positions, [side, twin]);
            let value = self.cost.cost(&quad);
            for h in [side, twin] {
                self.of_side[h.index()].store(value, Ordering::Relaxed);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::AtomicUsize;

    use proptest::prelude::*;

    use super::*;
    use crate::DualGraph;
    use crate::samples::{sculpted, triangulation};
    use crate::triangulation::VertexId;

    fn quad(corners: [[f64; 3]; 4]) -> EdgeQuad {
        EdgeQuad { vertices: [0, 1, 2, 3].map(VertexId), corners }
    }

    /// The costs of a quad: default and shape.
    fn costs(corners: [[f64; 3]; 4]) -> [i32; 2] {
        let quad = quad(corners);
        [DefaultCost.cost(&quad), ShapeCost.cost(&quad)]
    }

    #[test]
    fn known_quads_have_known_costs() {
        let flat = |corners: [[f64; 2]; 4]| costs(corners.map(|[x, y]| [x, y, 7.0]));
        let rectangle = [[0.0, 0.0], [5.0, 0.0], [5.0, 1.0], [0.0, 1.0]];
        let rhombus = [[0.0, 0.0], [5.0, 0.0], [8.0, 4.0], [3.0, 4.0]];
        let triangle = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [0.0, 2.0]];
        let bow_tie = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]];
        assert_eq!(flat(rectangle), [0, 0]);
        // J = 0.8, c = 0.2.
        assert_eq!(flat(rhombus), [13_107, 2_000]);
        // J = 0, c = 1 + 0.5, and 0.55 more for the triangle a o b without area.
        assert_eq!(flat(triangle), [134_349, 10_000]);
        // J = 0 as there is no normal, c = 1.5 + 1.1 for triangles that face opposite ways.
        assert_eq!(flat(bow_tie), [170_394, 10_000]);
    }

    #[test]
    fn a_right_angle_at_the_edge_costs_0_55_more() {
        // Two equilateral triangles over an edge of length 2, one in the plane and one upright.
        let height = 3.0_f64.sqrt();
        let corners = |p| quad([[-1.0, 0.0, 0.0], [0.0, -height, 0.0], [1.0, 0.0, 0.0], p]);
        let [flat, upright] = [corners([0.0, height, 0.0]), corners([0.0, 0.0, height])];
        assert_eq!([flat.fold_cosine(), upright.fold_cosine()], [1.0, 0.0]);
        // Rhombus of 60 and 120 degrees: J = √3 / 2, c = 0.13397.
        assert_eq!(DefaultCost.cost(&flat), 8_780);
        let shape = 1.0 - upright.scaled_jacobian();
        assert_eq!(DefaultCost.cost(&upright), (65_536.0 * (shape + 0.55)).round() as i32);
    }

    #[test]
    fn a_quad_without_size_has_a_cost() {
        assert_eq!(costs([[1.0, 2.0, 3.0]; 4]), [134_349, 10_000]);
    }

    #[test]
    fn functions_and_closures_are_costs() {
        let bias = 5;
        let biased = |quad: &EdgeQuad| ShapeCost.cost(quad) + bias;
        let any: &dyn Cost = &biased;
        let square = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        assert_eq!(any.cost(&quad(square)), 5);
    }

    /// Coordinates of all sizes, many of them equal.
    fn coordinate() -> impl Strategy<Value = f64> {
        prop_oneof![(-2..3i8).prop_map(f64::from), -1.0..1.0, -1e6..1e6]
    }

    fn corners() -> impl Strategy<Value = [[f64; 3]; 4]> {
        prop::array::uniform4(prop::array::uniform3(coordinate()))
    }

    fn assert_close(one: [i32; 2], other: [i32; 2]) -> Result<(), TestCaseError> {
        let far = (0..2).any(|k| one[k].abs_diff(other[k]) > 1);
        prop_assert!(!far, "{one:?} and {other:?}");
        Ok(())
    }

    proptest! {
        #[test]
        fn both_sides_of_an_edge_have_the_same_bits([a, o, b, p] in corners()) {
            prop_assert_eq!(costs([a, o, b, p]), costs([b, p, a, o]));
        }

        #[test]
        fn orientation_does_not_matter([a, o, b, p] in corners()) {
            assert_close(costs([a, o, b, p]), costs([a, p, b, o]))?;
        }

        #[test]
        fn powers_of_two_and_mirrors_change_no_bit(corners in corners(), exponent in -20..20i32) {
            let scale = 2.0_f64.powi(exponent);
            prop_assert_eq!(costs(corners.map(|p| p.map(|x| scale * x))), costs(corners));
            prop_assert_eq!(costs(corners.map(|[x, y, z]| [x, -y, z])), costs(corners));
            // A quarter turn about the third axis.
            prop_assert_eq!(costs(corners.map(|[x, y, z]| [-y, x, z])), costs(corners));
        }

        #[test]
        fn the_order_of_the_axes_does_not_matter(corners in corners()) {
            assert_close(costs(corners.map(|[x, y, z]| [y, z, x])), costs(corners))?;
        }

        #[test]
        fn the_default_cost_follows_its_formula(corners in corners()) {
            let [a, o, b, p] = corners;
            let jacobian = quad(corners).scaled_jacobian();
            let bend = 1.0 - cosine(normal(a, b, p), normal(b, a, o));
            let folded = match jacobian {
                ..=0.0 => 0.5 - 3.0 * jacobian,
                0.0..0.02 => 0.5 - 25.0 * jacobian,
                _ => 0.0,
            };
            let expected = 65_536.0 * (1.0 - jacobian + folded + 0.55 * bend);
            prop_assert!((f64::from(costs(corners)[0]) - expected).abs() < 1.0);
        }

        #[test]
        fn every_finite_quad_has_a_cost_within_bounds(
            bits in prop::array::uniform4(prop::array::uniform3(any::<u64>()))
        ) {
            let finite = |bits: u64| Some(f64::from_bits(bits)).filter(|x| x.is_finite());
            let [default, shape] = costs(bits.map(|p| p.map(|x| finite(x).unwrap_or(f64::MAX))));
            prop_assert!((0..=432_538).contains(&default), "{default}");
            prop_assert!((0..=20_000).contains(&shape), "{shape}");
        }

        #[test]
        fn each_edge_is_evaluated_once_for_both_sides(surface in sculpted()) {
            let triangulation = triangulation(&surface);
            let calls = AtomicUsize::new(0);
            // The number of the removed edge, as an unordered pair of vertices.
            let number = |quad: &EdgeQuad| {
                calls.fetch_add(1, Ordering::Relaxed);
                let [a, _, b, _] = quad.vertices.map(|v| v.index() as i32);
                a.min(b) << 16 | a.max(b)
            };
            let rows = edge_costs(&triangulation, &surface.positions, &number);
            prop_assert_eq!(calls.load(Ordering::Relaxed), 3 * triangulation.triangle_count() / 2);
            let graph = DualGraph::new(&triangulation);
            for f in triangulation.triangles() {
                let [p, q, r] = triangulation.corners(f).map(|v| v.index() as i32);
                let expected = [(p, q), (q, r), (r, p)].map(|(a, b)| a.min(b) << 16 | a.max(b));
                prop_assert_eq!(rows[f.index()], expected);
                for (g, cost) in graph.sides_or_none(f).into_iter().zip(expected) {
                    prop_assert!(rows[g.index()].contains(&cost));
                }
            }
        }
    }

    fn normal(p: [f64; 3], q: [f64; 3], r: [f64; 3]) -> [f64; 3] {
        let [u, v] = [q, r].map(|s| [s[0] - p[0], s[1] - p[1], s[2] - p[2]]);
        [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    }

    fn cosine(u: [f64; 3], v: [f64; 3]) -> f64 {
        let length = |u: [f64; 3]| u.into_iter().map(|x| x * x).sum::<f64>().sqrt();
        let product: f64 = (0..3).map(|k| u[k] * v[k]).sum();
        if length(u) * length(v) > 0.0 { product / (length(u) * length(v)) } else { 0.0 }
    }
}
