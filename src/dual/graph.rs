//! The dual graph: a node for each triangle, joined to those across its three edges.

use crate::mesh::MAX_CORNERS;
use crate::prefetch::prefetch;
use crate::triangulation::{Id, Side, TriangleId, Triangulation};

/// For each triangle its three neighbours, or none where there is a boundary.
///
/// Needs no orientation and no vertices; all that matching has to know. 16 bytes a triangle.
/// On a closed surface the graph is 3-regular and, as the triangulation is simple, bridgeless.
#[derive(Clone, Debug, PartialEq)]
pub struct DualGraph {
    rows: Vec<Row>,
    has_boundary: bool,
}

/// What is read of a triangle, in one line of the cache.
#[derive(Clone, Copy, Debug)]
#[repr(align(16))]
struct Row {
    sides: [TriangleId; 3],
    /// A number that an algorithm keeps with the triangle while it runs; no part of the graph.
    note: u32,
}

impl Row {
    fn new(sides: [TriangleId; 3]) -> Self {
        Self { sides, note: 0 }
    }
}

impl PartialEq for Row {
    fn eq(&self, other: &Self) -> bool {
        self.sides == other.sides
    }
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
        let (sides, _) = triangulation.sides().as_chunks::<3>();
        let row = |sides: &[Side; 3]| Row::new(sides.map(|side| side.twin.triangle()));
        Self { rows: sides.iter().map(row).collect(), has_boundary: false }
    }

    /// A graph of `nodes` nodes, at most three edges each; parallel edges are allowed. O(n).
    ///
    /// # Errors
    /// Too many nodes; or names the first end, edge by edge, that does not exist, is both ends of its
    /// edge, or has three edges already.
    pub fn from_edges(nodes: usize, edges: &[(u32, u32)]) -> Result<Self, NotADualGraph> {
        if nodes > MAX_CORNERS / 3 {
            return Err(NotADualGraph::TooLarge);
        }
        let mut neighbours = vec![[TriangleId::NONE; 3]; nodes];
        for &(a, b) in edges {
            for (from, to) in [(a, b), (b, a)] {
                let row =
                    neighbours.get_mut(from as usize).ok_or(NotADualGraph::OutOfRange(from))?;
                if from == to {
                    return Err(NotADualGraph::Loop(from));
                }
                let free = row.iter_mut().find(|slot| **slot == TriangleId::NONE);
                *free.ok_or(NotADualGraph::Degree(from))? = TriangleId(to);
            }
        }
        let has_boundary = neighbours.as_flattened().contains(&TriangleId::NONE);
        Ok(Self { rows: neighbours.into_iter().map(Row::new).collect(), has_boundary })
    }

    /// Number of triangles.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether there is no triangle.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// All triangles in order.
    pub fn triangles(&self) -> impl ExactSizeIterator<Item = TriangleId> + use<> {
        (0..self.len()).map(TriangleId::new)
    }

    /// The triangles across the three sides of `f`; [`TriangleId::NONE`] across a boundary.
    #[inline]
    pub fn sides(&self, f: TriangleId) -> [TriangleId; 3] {
        self.rows[f.index()].sides
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

    /// Sets the notes of all triangles.
    pub(crate) fn set_notes(&mut self, note: u32) {
        self.rows.iter_mut().for_each(|row| row.note = note);
    }

    /// Sets the note of `f`.
    #[inline]
    pub(crate) fn set_note(&mut self, f: TriangleId, note: u32) {
        self.rows[f.index()].note = note;
    }

    /// The note of `f`; none for [`TriangleId::NONE`].
    #[inline]
    pub(crate) fn note(&self, f: TriangleId) -> Option<u32> {
        self.rows.get(f.index()).map(|row| row.note)
    }

    /// Has the cache fetch the sides of `f`.
    #[inline]
    pub(crate) fn prefetch(&self, f: TriangleId) {
        prefetch(&self.rows, f.index());
    }

    /// Has the cache fetch the sides and notes of the neighbours of `f`.
    #[inline]
    pub(crate) fn prefetch_around(&self, f: TriangleId) {
        self.sides(f).into_iter().for_each(|g| prefetch(&self.rows, g.index()));
    }
}
