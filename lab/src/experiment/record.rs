//! One row of `runs.csv`: what was run and what came of it.

use serde::{Deserialize, Serialize};

/// Version of the columns.
pub const SCHEMA: &str = "triquad-run-1";

/// How a run ended.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Outcome {
    /// With a result that passed its check.
    #[default]
    Ok,
    /// Stopped when its time was up.
    Timeout,
    /// Stopped for want of memory.
    OutOfMemory,
    /// By a signal or an error that nobody foresaw.
    Crash,
    /// With a result that failed its check, or on a mesh that is not the one meant.
    Invalid,
    /// Not begun: the algorithm had timed out on a smaller mesh of the group.
    Skipped,
}

/// One run, raw: times in seconds, sizes in what the name says; empty where a run has no such number.
///
/// The columns that `triquad convert --stats` and `triquad irreducible --stats` have too mean what
/// they mean there.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct RunRecord {
    /// [`SCHEMA`].
    pub schema: String,
    /// What makes this run this run: equal keys, equal work.
    pub key: String,
    /// Name of the experiment file.
    pub experiment: String,
    /// `full`, `small` or `demo`.
    pub scale: String,
    /// Group of meshes within the experiment.
    pub group: String,
    /// Name of the mesh.
    pub mesh: String,
    /// `real`, `generated`, `simplified` or `stand-in`.
    pub mesh_kind: String,
    /// SHA-256 of the mesh file, in hexadecimal digits.
    pub mesh_sha256: String,
    /// `sg ps ds gw lrs tq`, or `rs schipper brute-force`.
    pub algorithm: String,
    /// For `lrs`: `printed` or `few-flips`.
    pub lrs_variant: Option<String>,
    /// For conversions: `tarjan` or `local`.
    pub augmentation: Option<String>,
    /// For irreducible triangulations: `file` or `random`.
    pub order: Option<String>,
    /// From 0.
    pub repetition: u32,
    /// Seed given to the run.
    pub seed: u64,
    /// How it ended.
    pub outcome: Outcome,
    /// Why it ended so, where that is not `ok`.
    pub reason: String,
    /// Runs at the same time on the same machine: times of rows above 1 are not ranked.
    pub parallel_jobs: u32,
    /// The augmentation was stopped after so many paths; `augmentation_seconds` is theirs alone.
    pub stopped_after_paths: Option<u64>,
    /// Version and commit of the program.
    pub program: String,
    /// Name of the machine's description in `machines.json`.
    pub machine: String,
    /// What was run, to be run again.
    pub command: String,
    /// Wall-clock time of the whole process.
    pub process_seconds: f64,

    /// n_v.
    pub vertices: Option<u64>,
    /// n_e.
    pub edges: Option<u64>,
    /// n_f.
    pub triangles: Option<u64>,
    /// Summed over components.
    pub genus: Option<u64>,
    /// Connected components.
    pub components: Option<u64>,
    /// Quads of the result.
    pub quads: Option<u64>,
    /// Column (c): k, or ℓ for `lrs`.
    pub unpaired_triangles: Option<u64>,
    /// Column (b).
    pub paired_percent: Option<f64>,
    /// Edges of the triangulation that was paired that the input does not have.
    pub edge_flips: Option<u64>,
    /// Augmenting paths made.
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
    /// Edges contracted.
    pub contractions: Option<u64>,
    /// ℓ: tests of the link condition.
    pub link_condition_tests: Option<u64>,
    /// ε: edges tested more than once.
    pub edges_tested_more_than_once: Option<u64>,

    /// Reading the mesh.
    pub read_seconds: Option<f64>,
    /// Adjacency and validation.
    pub build_seconds: Option<f64>,
    /// Column (a).
    pub pairing_seconds: Option<f64>,
    /// Column (d).
    pub augmentation_seconds: Option<f64>,
    /// Column (e): (a) + (d).
    pub total_seconds: Option<f64>,
    /// Time of RS, S or BF.
    pub seconds: Option<f64>,
    /// The check of the result.
    pub check_seconds: Option<f64>,
    /// Most memory of the process at once.
    pub peak_memory_bytes: Option<u64>,
}

impl RunRecord {
    /// Whether its numbers count.
    pub fn is_ok(&self) -> bool {
        self.outcome == Outcome::Ok
    }

    /// Whether `other` is a run of the same job on the same mesh for the same repetition.
    pub fn is_same_run(&self, other: &Self) -> bool {
        self.mesh == other.mesh
            && (&self.algorithm, &self.lrs_variant, &self.augmentation, &self.order)
                == (&other.algorithm, &other.lrs_variant, &other.augmentation, &other.order)
            && (self.repetition, &self.scale, &self.experiment, &self.group)
                == (other.repetition, &other.scale, &other.experiment, &other.group)
    }

    /// Whether the augmentation was stopped before the pairing was perfect.
    pub fn is_extrapolated(&self) -> bool {
        self.stopped_after_paths.is_some()
    }

    /// Column (d), by rule of three over the paths where the augmentation was stopped.
    pub fn whole_augmentation_seconds(&self) -> Option<f64> {
        let seconds = self.augmentation_seconds?;
        match self.stopped_after_paths {
            Some(made) if made > 0 => {
                Some(seconds * (self.unpaired_triangles? as f64 / 2.0) / made as f64)
            }
            _ => Some(seconds),
        }
    }

    /// Column (e), with [`RunRecord::whole_augmentation_seconds`].
    pub fn whole_total_seconds(&self) -> Option<f64> {
        Some(self.pairing_seconds? + self.whole_augmentation_seconds()?)
    }
}
