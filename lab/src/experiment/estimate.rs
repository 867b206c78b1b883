//! Rough estimates of time, memory and disk: enough to decide whether to start a plan.
//!
//! The coefficients were measured on two cores at 2 to 3 GHz, those of algorithms are in
//! [`crate::algorithms`]; the progress bar corrects them as it goes.

use super::job::Job;
use super::plan::{Plan, PlannedRun};
use super::planned_mesh::{PlannedMesh, Source};
use crate::meshes::Recipe;
use triquad::augmentation::Augmentation;

/// Time, memory and disk.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Estimate {
    /// Wall-clock time, one run after another, without external programs.
    pub seconds: f64,
    /// Number of runs of external programs: nothing is known of these.
    pub external_runs: usize,
    /// Most memory of one process, without external programs.
    pub memory_bytes: f64,
    /// Most room for meshes at once, the cache included.
    pub disk_bytes: f64,
}

/// Starting a process, and what it does once.
const START_SECONDS: f64 = 0.02;
/// Reading, adjacency, check: for each triangle.
const FRAME_SECONDS: f64 = 0.6e-6;
/// A search tree of `tarjan`, for each triangle of the mesh.
const TREE_SECONDS: f64 = 2.0e-9;
/// The graph of `rebuild`, for each triangle of the mesh.
const GRAPH_SECONDS: f64 = 0.2e-6;

/// Returns the seconds that one run takes; `None` for an external program.
pub fn run_seconds(mesh: &PlannedMesh, run: &PlannedRun) -> Option<f64> {
    if run.job.is_program() {
        return None;
    }
    let n = f64::from(mesh.triangles);
    let facts = run.job.facts();
    let [a_triangle, a_handle, once] = facts.unpaired;
    let paths = (a_triangle * n + a_handle * f64::from(mesh.genus) + once) / 2.0;
    let paths = run.stop_after_paths.map_or(paths, |most| paths.min(most as f64));
    let a_path = match run.job {
        Job::Convert { augmentation: Augmentation::Tarjan, .. } => TREE_SECONDS * n,
        Job::Convert { augmentation: Augmentation::Rebuild, .. } => GRAPH_SECONDS * n,
        _ => 10e-6,
    };
    Some(START_SECONDS + (FRAME_SECONDS + facts.seconds) * n + paths * a_path)
}

fn run_memory(mesh: &PlannedMesh, job: Job) -> f64 {
    5e6 + job.facts().bytes * f64::from(mesh.triangles)
}

/// Returns time, memory and disk to make a mesh.
fn making(mesh: &PlannedMesh) -> Estimate {
    let file = 25.0 * f64::from(mesh.triangles);
    let Source::Made(made, _) = &mesh.source else { return Estimate::default() };
    let vertices = match made.recipe {
        Recipe::Box(_) | Recipe::PaperBox { .. } | Recipe::StarredBipyramid { .. } => {
            let seconds = 0.3e-6 * f64::from(mesh.triangles);
            let memory_bytes = 60.0 * f64::from(mesh.triangles);
            return Estimate { seconds, memory_bytes, disk_bytes: file, ..Estimate::default() };
        }
        Recipe::SimplifiedBox { of, .. } => of.vertices() as f64,
        Recipe::StandIn { vertices, .. } => 3.0 * f64::from(vertices),
    };
    // A box is simplified once for all the meshes on the way: a share each.
    Estimate {
        seconds: 3e-6 * vertices,
        memory_bytes: 300.0 * vertices,
        disk_bytes: file,
        ..Estimate::default()
    }
}

impl Estimate {
    /// Estimates `plan`. O(runs).
    pub fn new(plan: &Plan) -> Self {
        let mut total = Self::default();
        let mut kept = 0.0;
        for block in &plan.blocks {
            if block.repetition == 0 {
                let making = making(&block.mesh);
                total.seconds += making.seconds;
                total.memory_bytes = total.memory_bytes.max(making.memory_bytes);
                kept += making.disk_bytes;
                total.disk_bytes = kept;
            }
            for run in &block.runs {
                let Some(seconds) = run_seconds(&block.mesh, run) else {
                    total.external_runs += 1;
                    continue;
                };
                total.seconds += seconds;
                total.memory_bytes = total.memory_bytes.max(run_memory(&block.mesh, run.job));
            }
        }
        total
    }
}
