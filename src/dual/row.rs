//! The neighbours of one triangle.

use crate::triangulation::TriangleId;

/// The triangles across the three sides of one, [`TriangleId::NONE`] across a boundary. 16 bytes.
///
/// Rows of 16 bytes never straddle two cache lines, as rows of 12 would.
#[derive(Clone, Copy, Debug)]
#[repr(align(16))]
pub(crate) struct Row {
    pub(crate) sides: [TriangleId; 3],
    /// Padding. An algorithm that owns the rows may keep a number here, close to the neighbours.
    pub(crate) beside: u32,
}

impl PartialEq for Row {
    fn eq(&self, other: &Self) -> bool {
        self.sides == other.sides
    }
}

impl Eq for Row {}
