//! What a plan will take, roughly: enough to decide whether to start it.
//!
//! The coefficients were measured on two cores at 2 to 3 GHz; progress corrects them as it goes.

use super::job::Job;
use super::plan::{Plan, PlannedMesh, PlannedRun, Source};
use crate::meshes::Recipe;
use triquad::augmentation::Augmentation;
use triquad::irreducible::Contractor;
use triquad::pairing::{Algorithm, Expansion};

/// Time, memory and disk.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Estimate {
    /// Wall-clock time, one run after another.
    pub seconds: f64,
    /// Most memory of one process.
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

/// What one run takes.
pub fn run_seconds(mesh: &PlannedMesh, run: &PlannedRun) -> f64 {
    let n = f64::from(mesh.triangles);
    let work = match run.job {
        Job::Convert { algorithm, augmentation } => {
            let unpaired = unpaired(algorithm, n, f64::from(mesh.genus));
            let paths = run.stop_after_paths.map_or(unpaired / 2.0, |most| most as f64);
            let paths = paths.min(unpaired / 2.0);
            pairing_seconds(algorithm) * n
                + match augmentation {
                    Augmentation::Tarjan => paths * TREE_SECONDS * n,
                    _ => 10e-6 * paths,
                }
        }
        Job::Reduce { method, .. } => reduction_seconds(method) * n,
    };
    START_SECONDS + FRAME_SECONDS * n + work
}

/// Column (c) as the paper has it.
fn unpaired(algorithm: Algorithm, triangles: f64, genus: f64) -> f64 {
    match algorithm {
        Algorithm::SimpleGreedy => 0.125 * triangles,
        Algorithm::PulliSegal => 0.001 * triangles,
        Algorithm::Lrs(_) => 4.0 + 12.0 * genus,
        Algorithm::DiksStanczyk | Algorithm::GawrychowskiWasylkiewicz => 0.0,
        _ => 2.0,
    }
}

/// For each triangle.
fn pairing_seconds(algorithm: Algorithm) -> f64 {
    match algorithm {
        Algorithm::Lrs(Expansion::Printed) => 0.5e-6,
        Algorithm::Lrs(Expansion::FewFlips) => 0.8e-6,
        Algorithm::GawrychowskiWasylkiewicz => 2.4e-6,
        Algorithm::DiksStanczyk => 25e-6,
        _ => 0.15e-6,
    }
}

/// For each triangle.
fn reduction_seconds(method: Contractor) -> f64 {
    match method {
        Contractor::RamaswamiSiqueira => 0.15e-6,
        Contractor::Schipper => 0.7e-6,
        _ => 1.0e-6,
    }
}

fn run_memory(mesh: &PlannedMesh, job: Job) -> f64 {
    let a_triangle = match job {
        Job::Convert { algorithm: Algorithm::DiksStanczyk, .. } => 450.0,
        Job::Convert { algorithm: Algorithm::Lrs(_), .. } => 160.0,
        _ => 120.0,
    };
    5e6 + a_triangle * f64::from(mesh.triangles)
}

/// Time, memory and disk to make a mesh.
fn making(mesh: &PlannedMesh) -> Estimate {
    let file = 25.0 * f64::from(mesh.triangles);
    let Source::Made(made, _) = &mesh.source else { return Estimate::default() };
    let vertices = match made.recipe {
        Recipe::Box(_) => {
            let seconds = 0.3e-6 * f64::from(mesh.triangles);
            let memory_bytes = 60.0 * f64::from(mesh.triangles);
            return Estimate { seconds, memory_bytes, disk_bytes: file };
        }
        Recipe::SimplifiedBox { of, .. } => f64::from(of.vertices),
        Recipe::StandIn { vertices, .. } => 3.0 * f64::from(vertices),
    };
    // A box is simplified once for all the meshes on the way: a share each.
    Estimate { seconds: 3e-6 * vertices, memory_bytes: 300.0 * vertices, disk_bytes: file }
}

impl Estimate {
    /// What `plan` takes.
    pub fn of(plan: &Plan) -> Self {
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
                total.seconds += run_seconds(&block.mesh, run);
                total.memory_bytes = total.memory_bytes.max(run_memory(&block.mesh, run.job));
            }
        }
        total
    }
}
