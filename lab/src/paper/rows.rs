//! Rows of the files, by column; `experiments/paper/README.md` has the printed headings.

use serde::Deserialize;

use crate::experiment::Job;

/// Size of a mesh, Tables 4.1 and 4.2 and Tables 2 to 5.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct MeshRow {
    /// Name of the mesh, as in [`crate::meshes::paper`].
    pub mesh: String,
    /// Its name in the paper.
    pub mesh_printed: String,
    /// n_v.
    pub vertices: u32,
    /// n_e.
    pub edges: u32,
    /// n_f.
    pub triangles: u32,
    /// g.
    pub genus: u32,
    /// The error in the row, or empty.
    pub errata: String,
}

/// An algorithm on a mesh, Tables 4.3 and 4.4. `sg` and `ps` are means of ten runs.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct PairingRow {
    /// Name of the mesh, as in [`crate::meshes::paper`].
    pub mesh: String,
    /// Its name in the paper.
    pub mesh_printed: String,
    /// `sg`, `ps`, `ds` or `lrs`.
    pub algorithm: String,
    /// (a): the initial pairing.
    pub pairing_seconds: f64,
    /// (b): triangles in the initial pairing.
    pub paired_percent: f64,
    /// (c): triangles not in it, k or ℓ.
    pub unpaired_triangles: f64,
    /// (d): making it perfect.
    pub augmentation_seconds: f64,
    /// (e): (a) + (d).
    pub total_seconds: f64,
    /// The error in the row, or empty.
    pub errata: String,
}

/// Work of RS, Schipper's algorithm (S) and brute force (BF, means of ten runs) on a mesh, Tables
/// 6, 8 and 10.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct LinkTestRow {
    /// Name of the mesh, as in [`crate::meshes::paper`].
    pub mesh: String,
    /// Its name in the paper.
    pub mesh_printed: String,
    /// ℓ_rs.
    pub rs_link_condition_tests: f64,
    /// ℓ_s.
    pub schipper_link_condition_tests: f64,
    /// ℓ_bf.
    pub brute_force_link_condition_tests: f64,
    /// ε_s.
    pub schipper_edges_tested_more_than_once: f64,
    /// ε_bf.
    pub brute_force_edges_tested_more_than_once: f64,
    /// The error in the row, or empty.
    pub errata: String,
}

/// Ratios of tests and of times on a mesh, Tables 7, 9 and 11.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct RatioRow {
    /// Name of the mesh, as in [`crate::meshes::paper`].
    pub mesh: String,
    /// Its name in the paper.
    pub mesh_printed: String,
    /// ℓ_s/ℓ_rs.
    pub schipper_to_rs_tests: f64,
    /// ℓ_bf/ℓ_rs.
    pub brute_force_to_rs_tests: f64,
    /// ℓ_s/ℓ_bf.
    pub schipper_to_brute_force_tests: f64,
    /// t_s/t_rs.
    pub schipper_to_rs_seconds: f64,
    /// t_bf/t_rs.
    pub brute_force_to_rs_seconds: f64,
    /// t_s/t_bf.
    pub schipper_to_brute_force_seconds: f64,
    /// The error in the row, or empty.
    pub errata: String,
}

impl PairingRow {
    /// Returns the row of a mesh and an algorithm. O(rows).
    pub fn find<'r>(rows: &'r [Self], mesh: &str, job: Job) -> Option<&'r Self> {
        rows.iter().find(|row| row.mesh == mesh && row.algorithm == job.algorithm())
    }
}

impl LinkTestRow {
    /// Returns ℓ of RS, S and BF.
    pub fn link_condition_tests(&self) -> [f64; 3] {
        [
            self.rs_link_condition_tests,
            self.schipper_link_condition_tests,
            self.brute_force_link_condition_tests,
        ]
    }
}
