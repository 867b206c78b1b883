//! The identity of runs: what is compared by it, found by it and counted by it.

use serde::{Deserialize, Serialize};

use super::job::Job;
use crate::meshes::paper::Scale;

/// A mesh in its place within the experiments.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct MeshId {
    /// Name of the experiment file.
    pub experiment: String,
    /// Size of the papers' meshes.
    pub scale: Scale,
    /// Group of meshes within the experiment.
    pub group: String,
    /// Name of the mesh.
    #[serde(rename = "mesh")]
    pub name: String,
}

/// Shared part of repetitions: a job on a mesh.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct RunId {
    /// The mesh.
    pub mesh: MeshId,
    /// The job.
    pub job: Job,
}
