//! Counts: vertices, edges, triangles, components, Euler characteristic and genus.

use super::half_edges::Triangulation;

impl Triangulation {
    /// Returns the number of triangles n_f.
    pub fn triangle_count(&self) -> usize {
        self.sides.len() / 3
    }

    /// Returns the number of edges n_e = 3 n_f / 2.
    pub fn edge_count(&self) -> usize {
        self.sides.len() / 2
    }

    /// Returns the number of vertices n_v that some triangle uses.
    pub fn vertex_count(&self) -> usize {
        self.vertices - self.unreferenced
    }

    /// Returns the number of vertices that no triangle uses.
    pub fn unreferenced_vertex_count(&self) -> usize {
        self.unreferenced
    }

    /// Returns the number of vertices in the file, unreferenced ones included; vertex ids are below
    /// it.
    pub fn vertex_id_count(&self) -> usize {
        self.vertices
    }

    /// Returns the number of connected components.
    pub fn component_count(&self) -> usize {
        self.components
    }

    /// Returns n_v - n_e + n_f, which is 2 (components - genus).
    pub fn euler_characteristic(&self) -> i64 {
        self.vertex_count() as i64 - self.edge_count() as i64 + self.triangle_count() as i64
    }

    /// Returns the genus, summed over the components.
    pub fn genus(&self) -> usize {
        (self.components as i64 - self.euler_characteristic() / 2) as usize
    }
}
