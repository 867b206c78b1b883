//! The dual graph: a node for each triangle, joined to those across its three edges.

use super::row::{Row, backs};
use crate::mesh::MAX_CORNERS;
use crate::parallel::collect;
use crate::prefetch::prefetch;
use crate::triangulation::{HalfEdgeId, Surface, TriangleId};

/// For each triangle its three neighbours, or none across a boundary. 16 bytes a triangle.
///
/// The graph has neither orientation nor vertices of the mesh. That of a closed surface is
/// 3-regular and, as the triangulation is simple, bridgeless.
///
/// ```
/// use triquad::triangulation::TriangleId;
/// use triquad::{DualGraph, Matching};
///
/// // A path of four nodes.
/// let graph = DualGraph::from_edges(4, &[(0, 1), (1, 2), (2, 3)])?;
/// let node = TriangleId::new;
/// assert_eq!(graph.sides(node(1)), [Some(node(0)), Some(node(2)), None]);
///
/// let mut matching = Matching::empty(graph.len());
/// matching.pair(node(0), node(1));
/// matching.pair(node(2), node(3));
/// let perfect = matching.certify(&graph).expect("both pairs are edges");
/// assert_eq!(perfect.mate(node(3)), node(2));
/// # Ok::<(), triquad::dual::DualGraphError>(())
/// ```
#[derive(Clone, Debug)]
pub struct DualGraph {
    rows: Vec<Row>,
    has_boundary: bool,
    /// Whether the rows have [`backs`] in them.
    has_backs: bool,
}

impl PartialEq for DualGraph {
    fn eq(&self, other: &Self) -> bool {
        self.rows == other.rows
    }
}

impl Eq for DualGraph {}

/// A defect of a list of edges: it is no graph of maximum degree 3 without loops.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum DualGraphError {
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

/// Neighbours across the sides of triangles: what a search reads of a graph.
///
/// Algorithms that keep numbers of their own beside the neighbours search in those rows.
pub(crate) trait Sides {
    /// Returns the sides as [`DualGraph::sides`] does, with [`TriangleId::NONE`] across a boundary.
    fn sides_or_none(&self, f: TriangleId) -> [TriangleId; 3];
}

impl Sides for DualGraph {
    #[inline]
    fn sides_or_none(&self, f: TriangleId) -> [TriangleId; 3] {
        Self::sides_or_none(self, f)
    }
}

impl DualGraph {
    /// Returns the dual graph of a triangulation: neighbour `i` lies across side `i`. O(n).
    pub fn new(surface: &impl Surface) -> Self {
        let rows = Self::rows_of(surface, backs);
        Self { rows, has_boundary: !surface.is_closed(), has_backs: true }
    }

    /// Returns the rows of the dual graph of a surface, each with what `beside` makes of the twins
    /// of its sides. O(n).
    pub(crate) fn rows_of(
        surface: &impl Surface,
        beside: impl Fn([Option<HalfEdgeId>; 3]) -> u32 + Sync + Send,
    ) -> Vec<Row> {
        collect(surface.triangle_count(), |f| {
            let twins = TriangleId::new(f).half_edges().map(|side| surface.across(side));
            let across =
                |twin: Option<HalfEdgeId>| twin.map_or(TriangleId::NONE, HalfEdgeId::triangle);
            Row { sides: twins.map(across), beside: beside(twins) }
        })
    }

    /// Makes a graph of its rows; the numbers beside the neighbours lose their meaning.
    pub(crate) fn from_rows(rows: Vec<Row>, has_boundary: bool) -> Self {
        Self { rows, has_boundary, has_backs: false }
    }

    /// Makes a graph of `nodes` nodes with at most three edges each. O(n).
    ///
    /// Parallel edges are allowed.
    ///
    /// # Errors
    /// There are too many nodes. Else the first end, edge by edge, that does not exist, is both
    /// ends of its edge, or has three edges already.
    pub fn from_edges(nodes: usize, edges: &[(u32, u32)]) -> Result<Self, DualGraphError> {
        if nodes > MAX_CORNERS / 3 {
            return Err(DualGraphError::TooLarge);
        }
        let mut rows = vec![Row { sides: [TriangleId::NONE; 3], beside: 0 }; nodes];
        for &(a, b) in edges {
            for (from, to) in [(a, b), (b, a)] {
                let row = rows.get_mut(from as usize).ok_or(DualGraphError::OutOfRange(from))?;
                if from == to {
                    return Err(DualGraphError::Loop(from));
                }
                let free = row.sides.iter_mut().find(|slot| **slot == TriangleId::NONE);
                *free.ok_or(DualGraphError::Degree(from))? = TriangleId(to);
            }
        }
        let has_boundary = rows.iter().any(|row| row.sides.contains(&TriangleId::NONE));
        Ok(Self::from_rows(rows, has_boundary))
    }

    /// Returns the number of triangles.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Returns whether there is no triangle.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Iterates over all triangles in order.
    pub fn triangles(&self) -> impl ExactSizeIterator<Item = TriangleId> + use<> {
        (0..self.len()).map(TriangleId::new)
    }

    /// Returns the triangles across the three sides of `f`; `None` across a boundary.
    #[inline]
    pub fn sides(&self, f: TriangleId) -> [Option<TriangleId>; 3] {
        self.sides_or_none(f).map(TriangleId::some)
    }

    /// Returns the sides as [`DualGraph::sides`] does, with [`TriangleId::NONE`] across a boundary.
    #[inline]
    pub(crate) fn sides_or_none(&self, f: TriangleId) -> [TriangleId; 3] {
        self.rows[f.index()].sides
    }

    /// Returns the side of each neighbour that leads back to `f`, 0 across a boundary, if the graph
    /// was made of a surface.
    #[inline]
    pub(crate) fn backs(&self, f: TriangleId) -> Option<[u8; 3]> {
        self.has_backs.then(|| self.rows[f.index()].backs())
    }

    /// Returns the rows of all triangles in order.
    pub(crate) fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// Iterates over the triangles that share an edge with `f`, in the order of its sides.
    #[inline]
    pub fn neighbours(&self, f: TriangleId) -> impl Iterator<Item = TriangleId> + use<> {
        self.sides(f).into_iter().flatten()
    }

    /// Returns whether some triangle has a side without a neighbour.
    pub fn has_boundary(&self) -> bool {
        self.has_boundary
    }

    /// Prefetches the sides of `f`.
    #[inline]
    pub(crate) fn prefetch(&self, f: TriangleId) {
        prefetch(&self.rows, f.index());
    }

    /// Prefetches the sides of the neighbours of `f`.
    #[inline]
    pub(crate) fn prefetch_around(&self, f: TriangleId) {
        self.sides_or_none(f).into_iter().for_each(|g| prefetch(&self.rows, g.index()));
    }
}
