//! The shapes of quads: the scaled Jacobian, as in the Verdict library.
//!
//! Stimpson et al., *The Verdict Geometric Quality Library*, SAND2007-1751. No rounding differs
//! between machines.

use crate::mesh::Mesh;
use crate::parallel::collect;
use crate::vector::{ORDINARY, cross, difference, dot, to_unit_size};

/// Number of classes in [`Quality::histogram`], of equal width from -1 to 1.
pub const CLASSES: usize = 20;

/// The shapes of the quads of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Quality {
    /// The least scaled Jacobian; 0 if there is no quad.
    pub minimum: f64,
    /// The mean of all; 0 if there is no quad.
    pub mean: f64,
    /// The greatest of the worst 1 % of the quads, rounded up; 0 if there is no quad.
    pub one_percent: f64,
    /// Number of quads folded or not convex, those of scaled Jacobian 0 and less.
    pub folded: usize,
    /// Number of quads in each class: class i has those from i / 10 - 1 to (i + 1) / 10 - 1.
    pub histogram: [usize; CLASSES],
}

impl Quality {
    /// Measures all faces of four corners of `mesh`. O(n); 16 bytes a face while it runs.
    ///
    /// # Panics
    /// If such a face names a vertex that does not exist.
    pub fn new(mesh: &Mesh) -> Self {
        let values = collect(mesh.faces().len(), |face| value(mesh, face));
        Self::of(values.into_iter().flatten().collect())
    }

    /// Describes these values. They are added up in order, on any number of threads.
    fn of(mut values: Vec<f64>) -> Self {
        let mut histogram = [0; CLASSES];
        let (mut minimum, mut sum, mut folded) = (f64::INFINITY, 0.0, 0);
        for &value in &values {
            let class = ((value + 1.0) * (CLASSES as f64 / 2.0)) as usize;
            histogram[class.min(CLASSES - 1)] += 1;
            folded += usize::from(value <= 0.0);
            minimum = minimum.min(value);
            sum += value;
        }
        if values.is_empty() {
            return Self { minimum: 0.0, mean: 0.0, one_percent: 0.0, folded, histogram };
        }
        let (mean, worst) = (sum / values.len() as f64, values.len().div_ceil(100));
        let (_, &mut one_percent, _) = values.select_nth_unstable_by(worst - 1, f64::total_cmp);
        Self { minimum, mean, one_percent, folded, histogram }
    }
}

/// Returns the scaled Jacobian of a face of four corners.
fn value(mesh: &Mesh, face: usize) -> Option<f64> {
    let quad: &[u32; 4] = mesh.faces().get(face)?.try_into().ok()?;
    Some(scaled_jacobian(quad.map(|v| mesh.positions()[v as usize])))
}

/// Returns the least sine of the angles at the corners, as seen along the normal in the middle.
///
/// 1 for rectangles, 0 where three corners are on a line, negative where a quad is not convex.
/// It is 0 if the quad has no normal or a side no length.
#[inline]
pub fn scaled_jacobian(corners: [[f64; 3]; 4]) -> f64 {
    let [p, q, r, s] = corners;
    let sides = [difference(q, p), difference(r, q), difference(s, r), difference(p, s)];
    let normal = normal_of(sides);
    if ORDINARY.contains(&dot(normal, normal)) {
        least_sine(sides, normal)
    } else {
        extreme_least_sine(sides)
    }
}

/// Returns the least sine where products of the coordinates leave the range of numbers.
#[cold]
fn extreme_least_sine(sides: [[f64; 3]; 4]) -> f64 {
    let sides = to_unit_size(sides);
    least_sine(sides, normal_of(sides))
}

/// Returns the normal in the middle of a quad with these sides, four times its area long.
#[inline]
fn normal_of(sides: [[f64; 3]; 4]) -> [f64; 3] {
    cross(difference(sides[0], sides[2]), difference(sides[1], sides[3]))
}

#[inline(always)]
fn least_sine([a, b, c, d]: [[f64; 3]; 4], normal: [f64; 3]) -> f64 {
    let area = dot(normal, normal);
    let sine = |before: [f64; 3], after: [f64; 3]| {
        let scale = (area * dot(before, before) * dot(after, after)).sqrt();
        if scale > 0.0 { dot(cross(before, after), normal) / scale } else { 0.0 }
    };
    // Written out: a loop over the corners takes twice as long. Rounding may take a right angle a
    // little too far.
    1_f64.min(sine(d, a)).min(sine(a, b)).min(sine(b, c)).min(sine(c, d)).max(-1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Faces;

    fn flat(corners: [[f64; 2]; 4]) -> [[f64; 3]; 4] {
        corners.map(|[x, y]| [x, y, 7.0])
    }

    #[test]
    fn known_shapes_have_known_values() {
        let rectangle = flat([[0.0, 0.0], [5.0, 0.0], [5.0, 1.0], [0.0, 1.0]]);
        let rhombus = flat([[0.0, 0.0], [5.0, 0.0], [8.0, 4.0], [3.0, 4.0]]);
        let triangle = flat([[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [0.0, 2.0]]);
        let dart = flat([[0.0, 0.0], [4.0, 3.0], [0.0, 1.0], [-4.0, 3.0]]);
        let collapsed = flat([[1.0, 1.0]; 4]);
        assert_eq!(scaled_jacobian(rectangle), 1.0);
        assert!((scaled_jacobian(rhombus) - 0.8).abs() < 1e-12);
        assert_eq!(scaled_jacobian(triangle), 0.0);
        assert!(scaled_jacobian(dart) < -0.7);
        assert_eq!(scaled_jacobian(collapsed), 0.0);
    }

    #[test]
    fn shapes_do_not_depend_on_the_size_from_1e_300_to_1e300() {
        let quad = [[0.0, 0.1, 0.2], [1.0, 0.0, -0.3], [1.1, 0.9, 0.4], [-0.2, 1.3, 0.0]];
        let value = scaled_jacobian(quad);
        for size in [1e-300, 1e-160, 1e-80, 1e-40, 1e-13, 1e13, 1e40, 1e80, 1e160, 1e300] {
            let same = scaled_jacobian(quad.map(|corner| corner.map(|x| x * size)));
            assert!((same - value).abs() < 1e-12, "{size}");
        }
    }

    #[test]
    fn neither_first_corner_nor_size_nor_side_matters() {
        let quad = [[0.0, 0.1, 0.2], [1.0, 0.0, -0.3], [1.1, 0.9, 0.4], [-0.2, 1.3, 0.0]];
        let value = scaled_jacobian(quad);
        let [p, q, r, s] = quad;
        for same in [[q, r, s, p], [s, r, q, p], quad.map(|p| p.map(|x| 4.0 * x))] {
            assert!((scaled_jacobian(same) - value).abs() < 1e-12);
        }
    }

    #[test]
    fn all_quads_are_counted_once() {
        let positions = vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        let faces = Faces::uniform(4, vec![0, 1, 2, 3, 0, 0, 0, 0]);
        let quality = Quality::new(&Mesh::new(positions, faces));
        let mut histogram = [0; CLASSES];
        (histogram[19], histogram[10]) = (1, 1);
        let expected = Quality { minimum: 0.0, mean: 0.5, one_percent: 0.0, folded: 1, histogram };
        assert_eq!(quality, expected);
        let none = Quality::new(&Mesh::default());
        assert_eq!((none.minimum, none.mean, none.one_percent), (0.0, 0.0, 0.0));
    }

    #[test]
    fn the_worst_hundredth_ends_at_one_percent() {
        let of = |count: usize| {
            // Every value from 1 / count to 1, in another order.
            Quality::of((0..count).map(|i| (7 * i % count + 1) as f64 / count as f64).collect())
        };
        let cases = [(1, 1.0), (2, 0.5), (100, 0.01), (101, 2.0 / 101.0), (1000, 0.01)];
        for (count, expected) in cases {
            assert_eq!(of(count).one_percent, expected, "{count}");
        }
    }
}
