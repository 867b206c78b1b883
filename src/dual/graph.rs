//! The dual graph: a node for each triangle, joined to those across its three edges.

use crate::mesh::MAX_CORNERS;
use crate::triangulation::{Id, TriangleId, Triangulation};

/// For each triangle its three neighbours, or none where there is a boundary.
///
/// Needs no orientation and no vertices; all that matching has to know. 12 bytes a triangle.
/// On a closed surface the graph is 3-regular and, as the triangulation is simple, bridgeless.
#[derive(Clone, Debug, PartialEq)]
pub struct DualGraph {
    neighbours: Vec<[TriangleId; 3]>,
    has_boundary: bool,
}

/// A list of edges that is no graph of maximum degree 3 without loops.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NotADualGraph {
    /// An edge joins a node to itself.
    #[error("node {0} is joined to itself")]
    Loop(u32),
    /// A node has more than three edges.
    #[error("node {0} has more than three edges")]
    Degree(u32),
    /// There are more nodes than 2^31 half-edges allow.
    #[error("more than 2^31 / 3 nodes")]
    TooLarge,
    /// An edge names a node that does not exist.
    #[error("node {0} does not exist")]
    OutOfRange(u32),
}

impl DualGraph {
    /// The dual graph of a triangulation: neighbour `i` of a triangle lies across its side `i`. O(n).
    pub fn of(triangulation: &Triangulation) -> Self {
        let (sides, _) = triangulation.twins().as_chunks::<3>();
        let neighbours = sides.iter().map(|twins| twins.map(|twin| twin.triangle())).collect();
        Self { neighbours, has_boundary: false }
    }

    /// A graph of `nodes` nodes, at most three edges each; parallel edges are allowed. O(n).
    ///
    /// # Errors
    /// Names the node that has a loop, too many edges, or does not exist.
    pub fn from_edges(nodes: usize, edges: &[(u32, u32)]) -> Result<Self, NotADualGraph> {
        if nodes > MAX_CORNERS / 3 {
            return Err(NotADualGraph::TooLarge);
        }
        let mut neighbours = vec![[TriangleId::NONE; 3]; nodes];
        for &(a, b) in edges {
            if a == b {
                return Err(NotADualGraph::Loop(a));
            }
            for (from, to) in [(a, b), (b, a)] {
                let row =
                    neighbours.get_mut(from as usize).ok_or(NotADualGraph::OutOfRange(from))?;
                let free = row.iter_mut().find(|slot| **slot == TriangleId::NONE);
                *free.ok_or(NotADualGraph::Degree(from))? = TriangleId(to);
            }
        }
        let has_boundary = neighbours.as_flattened().contains(&TriangleId::NONE);
        Ok(Self { neighbours, has_boundary })
    }

    /// Number of triangles.
    pub fn len(&self) -> usize {
        self.neighbours.len()
    }

    /// Whether there is no triangle.
    pub fn is_empty(&self) -> bool {
        self.neighbours.is_empty()
    }

    /// All triangles in order.
    pub fn triangles(&self) -> impl ExactSizeIterator<Item = TriangleId> + use<> {
        (0..self.len()).map(TriangleId::new)
    }

    /// The triangles across the three sides of `f`; [`TriangleId::NONE`] across a boundary.
    #[inline]
    pub fn sides(&self, f: TriangleId) -> [TriangleId; 3] {
        self.neighbours[f.index()]
    }

    /// The triangles that share an edge with `f`, in the order of its sides.
    #[inline]
    pub fn neighbours(&self, f: TriangleId) -> impl Iterator<Item = TriangleId> + use<> {
        self.sides(f).into_iter().filter(|&g| g != TriangleId::NONE)
    }

    /// Whether some triangle has a side without a neighbour.
    pub fn has_boundary(&self) -> bool {
        self.has_boundary
    }
}
