//! The noun that every generator hands back.

/// A triangulated surface as plain arrays.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// Coordinates of each vertex.
    pub positions: Vec<[f64; 3]>,
    /// The three vertices of each triangle, as indices into `positions`.
    pub triangles: Vec<[u32; 3]>,
}
