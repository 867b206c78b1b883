//! Counts: vertices, edges, triangles, components, Euler characteristic and genus.

use super::Triangulation;

impl Triangulation {
    /// Number of triangles n_f.
    pub fn triangle_count(&self) -> usize {
        self.sides.len() / 3
    }

    /// Number of edges n_e = 3 n_f / 2.
    pub fn edge_count(&self) -> usize {
        self.sides.len() / 2
    }

    /// Number of vertices n_v that some triangle uses.
    pub fn vertex_count(&self) -> usize {
        self.vertices - self.unreferenced
    }

    /// Number of vertices that no triangle uses.
    pub fn unreferenced_vertex_count(&self) -> usize {
        self.unreferenced
    }

    /// Number of vertices in the file, unreferenced ones included; vertex ids are below it.
    pub fn vertex_id_count(&self) -> usize {
        self.vertices
    }

    /// Number of connected components.
    pub fn component_count(&self) -> usize {
        self.components
    }

    /// n_v - n_e + n_f, which is 2 (components - genus).
    pub fn euler_characteristic(&self) -> i64 {
        self.vertex_count() as i64 - self.edge_count() as i64 + self.triangle_count() as i64
    }

    /// Genus, summed over the components.
    pub fn genus(&self) -> usize {
        (self.components as i64 - self.euler_characteristic() / 2) as usize
    }
}
