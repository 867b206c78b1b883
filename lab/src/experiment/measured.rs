//! The numbers that a run measures of itself: the same in its JSON, in its record and in claims.

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

/// Numbers of a run, times in seconds; `None` where it has no such number.
///
/// Fields are the columns of `runs.csv` and those of `--stats` of the same names.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Measured {
    /// n_v.
    pub vertices: Option<u64>,
    /// n_e.
    pub edges: Option<u64>,
    /// n_f.
    pub triangles: Option<u64>,
    /// Genus, summed over components.
    pub genus: Option<u64>,
    /// Connected components.
    pub components: Option<u64>,
    /// Quads of the result.
    pub quads: Option<u64>,
    /// Column (c): k, or ℓ for `lrs`.
    pub unpaired_triangles: Option<u64>,
    /// Column (b).
    pub paired_percent: Option<f64>,
    /// Edges of the paired triangulation that the input does not have.
    pub edge_flips: Option<u64>,
    /// Augmenting paths.
    pub augmenting_paths: Option<u64>,
    /// Mean length of a path, in dual edges.
    pub augmenting_path_length_mean: Option<f64>,
    /// Length of the longest path, in dual edges.
    pub augmenting_path_length_max: Option<u64>,
    /// Triangles that entered a search tree.
    pub augmentation_triangles_visited: Option<u64>,
    /// Least scaled Jacobian of a quad.
    pub quality_minimum: Option<f64>,
    /// Mean scaled Jacobian of the quads.
    pub quality_mean: Option<f64>,

    /// n_v of the irreducible triangulation.
    pub result_vertices: Option<u64>,
    /// n_e of the irreducible triangulation.
    pub result_edges: Option<u64>,
    /// n_f of the irreducible triangulation.
    pub result_triangles: Option<u64>,
    /// Contracted edges.
    pub contractions: Option<u64>,
    /// ℓ: tests of the link condition.
    pub link_condition_tests: Option<u64>,
    /// ε: edges tested more than once.
    pub edges_tested_more_than_once: Option<u64>,

    /// Time to read the mesh.
    pub read_seconds: Option<f64>,
    /// Time for adjacency and validation.
    pub build_seconds: Option<f64>,
    /// Column (a).
    pub pairing_seconds: Option<f64>,
    /// Column (d).
    pub augmentation_seconds: Option<f64>,
    /// Column (e): (a) + (d).
    pub total_seconds: Option<f64>,
    /// Time of RS, S or BF.
    pub seconds: Option<f64>,
    /// Time to check the result.
    pub check_seconds: Option<f64>,
    /// Most memory of the process at once.
    pub peak_memory_bytes: Option<u64>,

    /// Vertices of links that RS, S or BF went over.
    pub link_vertices_visited: Option<u64>,
    /// Sum of `d_u · d_v` over the tests of edges `uv`: the cost of tests without marks.
    pub degree_products: Option<u64>,
    /// The part of `pairing_seconds` that is the shuffle of SG or PS.
    pub shuffle_seconds: Option<f64>,

    /// Greatest scaled Jacobian of the worst 1 % of the quads.
    pub quality_one_percent: Option<f64>,
    /// Quads of scaled Jacobian 0 and less.
    pub folded_quads: Option<u64>,
    /// Edges at which the surface bends by more than 30 degrees.
    pub sharp_edges: Option<u64>,
    /// Those of them that no quad lies across.
    pub sharp_edges_kept: Option<u64>,
    /// Vertices at which two quads share two sides.
    pub degree_two_vertices: Option<u64>,
}

impl Measured {
    /// Returns the names of the numbers that are there.
    pub fn names(&self) -> Vec<String> {
        self.fields().into_iter().map(|(name, _)| name).collect()
    }

    /// Returns the numbers that are there, by name.
    fn fields(&self) -> Map<String, Value> {
        let Ok(Value::Object(fields)) = serde_json::to_value(self) else {
            unreachable!("a structure is an object")
        };
        fields.into_iter().filter(|(_, value)| !value.is_null()).collect()
    }

    /// Returns these numbers with those of `above` in place of their own.
    pub(super) fn overlaid(&self, above: &Self) -> Self {
        let mut all = self.fields();
        all.extend(above.fields());
        serde_json::from_value(Value::Object(all)).expect("both have these fields")
    }
}

/// Numbers that a run prints with `--stats`, as far as records have it.
#[derive(Deserialize)]
pub(super) struct RunStats {
    /// Paths after which the augmentation was stopped.
    pub stopped_after_paths: Option<u64>,
    #[serde(flatten)]
    pub measured: Measured,
}
