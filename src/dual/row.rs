//! The neighbours of one triangle.

use crate::triangulation::{HalfEdgeId, TriangleId};

/// The triangles across the three sides of one, [`TriangleId::NONE`] across a boundary. 16 bytes.
///
/// Rows of 16 bytes never straddle two cache lines, as rows of 12 would.
#[derive(Clone, Copy, Debug)]
#[repr(align(16))]
pub(crate) struct Row {
    pub(crate) sides: [TriangleId; 3],
    /// Room that there is anyway, close to the neighbours: of a surface's graph two bits for each
    /// side, see [`backs`]; whatever an algorithm likes that owns the rows.
    pub(crate) beside: u32,
}

/// Packs which side of each neighbour leads back.
#[inline]
pub(crate) fn backs(twins: [Option<HalfEdgeId>; 3]) -> u32 {
    let [a, b, c] = twins.map(|twin| twin.map_or(0, |twin| twin.index() as u32 % 3));
    a | b << 2 | c << 4
}

impl Row {
    /// Returns what [`backs`] has packed.
    #[inline]
    pub(crate) fn backs(&self) -> [u8; 3] {
        [0, 2, 4].map(|shift| (self.beside >> shift & 3) as u8)
    }
}

impl PartialEq for Row {
    fn eq(&self, other: &Self) -> bool {
        self.sides == other.sides
    }
}

impl Eq for Row {}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use crate::dual::DualGraph;
    use crate::mesh::Mesh;
    use crate::samples::{sculpted, triangulation};
    use crate::triangulation::OpenTriangulation;

    proptest! {
        #[test]
        fn the_sides_that_lead_back_are_those_of_the_twins(surface in sculpted(), left in 1..9_usize) {
            let closed = triangulation(&surface);
            let graph = DualGraph::new(&closed);
            for f in closed.triangles() {
                let twins = f.half_edges().map(|side| (closed.twin(side).index() % 3) as u8);
                prop_assert_eq!(graph.backs(f), Some(twins));
            }
            let mut triangles = surface.triangles.clone();
            triangles.truncate(triangles.len() - left.min(triangles.len() - 1));
            let open = OpenTriangulation::join(&Mesh::from_triangles(surface.positions, triangles));
            let graph = DualGraph::new(&open);
            for f in graph.triangles() {
                for (g, back) in graph.sides(f).into_iter().zip(graph.backs(f).unwrap()) {
                    let leads_back = |g| graph.sides(g)[usize::from(back)] == Some(f);
                    prop_assert!(g.map_or(back == 0, leads_back));
                }
            }
        }
    }
}
