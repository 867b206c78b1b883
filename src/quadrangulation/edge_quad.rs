//! The quad that two triangles make when their common edge is removed, and its geometry.

use super::quality::scaled_jacobian;
use crate::prefetch::prefetch;
use crate::triangulation::{HalfEdgeId, Surface, TriangleId, Triangulation, VertexId};
use crate::vector::{ORDINARY, cross, difference, dot, to_unit_size};

/// Two triangles with a common edge, seen as one quad.
///
/// ```text
///     p
///    / \        Triangles a b p and b a o share the edge a - b.
///   a - b       Without it they are the quad a o b p, counter-clockwise.
///    \ /
///     o
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeQuad {
    /// The vertices a, o, b, p: the first and the third are the ends of the removed edge.
    pub vertices: [VertexId; 4],
    /// The positions of a, o, b, p.
    pub corners: [[f64; 3]; 4],
}

impl EdgeQuad {
    /// Returns the quad that appears when the edge of side `side`, from a to b, is removed; `None`
    /// on the boundary.
    ///
    /// It is oriented as the triangle of `side`.
    ///
    /// # Panics
    /// If a vertex of it has no position.
    #[inline]
    pub fn beyond(
        surface: &impl Surface,
        positions: &[[f64; 3]],
        side: HalfEdgeId,
    ) -> Option<Self> {
        surface.across(side).map(|twin| Self::between(surface, positions, [side, twin]))
    }

    /// Returns the quad of the triangles on the two sides of an edge.
    #[inline]
    pub(super) fn between(
        surface: &impl Surface,
        positions: &[[f64; 3]],
        sides: [HalfEdgeId; 2],
    ) -> Self {
        let vertices = quad_corners(sides).map(|h| surface.origin(h));
        Self { vertices, corners: vertices.map(|v| positions[v.index()]) }
    }

    /// Returns the quad that appears when the edge of side `side`, from a to b, is removed.
    ///
    /// # Panics
    /// If a vertex of it has no position.
    #[inline]
    pub fn across(triangulation: &Triangulation, positions: &[[f64; 3]], side: HalfEdgeId) -> Self {
        Self::between(triangulation, positions, [side, triangulation.twin(side)])
    }

    /// Returns the scaled Jacobian of the quad, from -1 to 1, see
    /// [`scaled_jacobian`](super::quality::scaled_jacobian).
    #[inline]
    pub fn scaled_jacobian(&self) -> f64 {
        scaled_jacobian(self.corners)
    }

    /// Returns the cosine of the angle between the normals of the two triangles.
    ///
    /// It is 1 if the quad is flat, 0 if it is bent by a right angle, -1 if one triangle lies on
    /// the other. It is 0 if a triangle has no area.
    #[inline]
    pub fn fold_cosine(&self) -> f64 {
        self.cosine().unwrap_or(0.0)
    }

    /// Returns whether both triangles have an area and the cosine of their normals' angle is less.
    #[inline]
    pub(super) fn is_bent_beyond(&self, cosine: f64) -> bool {
        let [below, above] = self.normals();
        let (product, scale) = (dot(below, above), dot(below, below) * dot(above, above));
        // Squares tell it without a root, unless they are nearly equal.
        let excess = product * product.abs() - cosine * cosine.abs() * scale;
        if excess.abs() > 1e-9 * scale {
            return excess < 0.0 && scale > 0.0;
        }
        cosine_between(below, above).is_some_and(|own| own < cosine)
    }

    /// Returns the cosine of the angle between the normals, if both triangles have an area.
    #[inline]
    fn cosine(&self) -> Option<f64> {
        let [below, above] = self.normals();
        cosine_between(below, above)
    }

    /// Returns the normals of both triangles, of any length.
    #[inline]
    fn normals(&self) -> [[f64; 3]; 2] {
        let [a, o, b, p] = self.corners;
        // Taken at the corners o and p, as in the scaled Jacobian: nothing is computed twice, and
        // the quad b p a o has the same bits.
        let sides = [difference(o, a), difference(b, o), difference(p, b), difference(a, p)];
        let normals = |[ao, ob, bp, pa]: [[f64; 3]; 4]| [cross(ao, ob), cross(bp, pa)];
        let ordinary = normals(sides);
        if ordinary.into_iter().all(|normal| ORDINARY.contains(&dot(normal, normal))) {
            ordinary
        } else {
            normals(to_unit_size(sides))
        }
    }
}

#[inline]
fn cosine_between(below: [f64; 3], above: [f64; 3]) -> Option<f64> {
    let scale = (dot(below, below) * dot(above, above)).sqrt();
    (scale > 0.0).then(|| (dot(below, above) / scale).clamp(-1.0, 1.0))
}

/// Has the cache fetch what the quads over the edges of later triangles are made of, in two steps:
/// a triangle's own corners and the sides across, then the corners that those lead to. Scattered
/// numbering takes four times as long without.
///
/// In the second step `other` can fetch more: it is called with the sides across.
#[inline]
pub(super) fn prefetch_ahead(
    surface: &impl Surface,
    positions: &[[f64; 3]],
    f: TriangleId,
    other: impl Fn(HalfEdgeId),
) {
    const AHEAD: usize = 8;
    let ahead = |steps| {
        let index = f.index() + steps * AHEAD;
        let sides = (index < surface.triangle_count()).then(|| TriangleId::new(index).half_edges());
        sides.into_iter().flatten()
    };
    for side in ahead(2) {
        if let Some(twin) = surface.across(side) {
            surface.prefetch(twin);
        }
        prefetch(positions, surface.origin(side).index());
    }
    for twin in ahead(1).filter_map(|side| surface.across(side)) {
        prefetch(positions, surface.origin(twin.prev()).index());
        other(twin);
    }
}

/// Returns the half-edges at the corners of the quad between a side and its twin.
///
/// ```text
///     c              side runs a -> b in triangle abc; its twin is a side of triangle bad.
///    / \
///   a - b            The quad is a d b c, oriented as abc, whichever way the twin runs.
///    \ /
///     d
/// ```
#[inline]
pub(super) fn quad_corners([side, twin]: [HalfEdgeId; 2]) -> [HalfEdgeId; 4] {
    [side, twin.prev(), side.next(), side.prev()]
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::samples::{sculpted, triangulation};
    use crate::triangulation::TriangleId;

    fn coordinate() -> impl Strategy<Value = f64> {
        prop_oneof![(-2..3i8).prop_map(f64::from), -1.0..1.0, -1e-60..1e-60, -1e80..1e80]
    }

    proptest! {
        /// Squares decide as the cosine does, at its own value and beside it, too.
        #[test]
        fn a_quad_is_bent_beyond_what_its_cosine_is_less_than(
            corners in prop::array::uniform4(prop::array::uniform3(coordinate())),
        ) {
            let quad = EdgeQuad { vertices: [0, 1, 2, 3].map(VertexId), corners };
            let own = quad.fold_cosine();
            let near = [-1e-6, -1e-9, -1e-15, 0.0, 1e-15, 1e-9, 1e-6].map(|step| own + step);
            for bound in near.into_iter().chain([-0.9, -0.5, 0.0, 0.5, 0.866_025_4, 1.0]) {
                let expected = quad.cosine().is_some_and(|own| own < bound);
                prop_assert_eq!(quad.is_bent_beyond(bound), expected, "{} and {}", own, bound);
            }
        }
    }

    proptest! {
        #[test]
        fn every_side_has_the_quad_of_its_two_triangles(surface in sculpted()) {
            let triangulation = triangulation(&surface);
            for side in triangulation.triangles().flat_map(TriangleId::half_edges) {
                let quad = EdgeQuad::across(&triangulation, &surface.positions, side);
                let [a, o, b, p] = quad.vertices;
                prop_assert_eq!([a, b], triangulation.ends(side));
                let has_corners = |h: HalfEdgeId, corners: [VertexId; 3]| {
                    let mut turned = triangulation.corners(h.triangle());
                    turned.rotate_left(h.index() % 3);
                    turned == corners
                };
                prop_assert!(has_corners(side, [a, b, p]));
                prop_assert!(has_corners(triangulation.twin(side), [b, a, o]));
                prop_assert_eq!(quad.corners, quad.vertices.map(|v| surface.positions[v.index()]));
            }
        }
    }
}
