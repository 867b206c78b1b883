//! One row of `runs.csv`: what was run and what came of it.

use csv::StringRecord;
use serde::{Deserialize, Serialize};

use super::measured::Measured;
use super::run_id::RunId;
use crate::meshes::MeshKind;

/// Version of the columns.
pub const SCHEMA: &str = "triquad-run-1";

/// Begins the machine of a run that was measured elsewhere.
pub(super) const IMPORTED: &str = "imported ";

/// Outcome of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Outcome {
    /// With a result that passed its check.
    #[default]
    Ok,
    /// Stopped when its time was up.
    Timeout,
    /// Stopped at the memory limit.
    OutOfMemory,
    /// By a signal or an unforeseen error.
    Crash,
    /// With a result that failed its check, or on a mesh that is not the one meant.
    Invalid,
    /// Not begun: the algorithm had timed out on a smaller mesh of the group, or the program is not
    /// installed.
    Skipped,
}

impl Outcome {
    /// All outcomes, in the order in which they are counted.
    pub const ALL: [Self; 6] =
        [Self::Ok, Self::Timeout, Self::OutOfMemory, Self::Crash, Self::Invalid, Self::Skipped];

    /// Returns the name in records.
    pub fn id(self) -> &'static str {
        match self {
            Self::Ok => "ok",
            Self::Timeout => "timeout",
            Self::OutOfMemory => "out-of-memory",
            Self::Crash => "crash",
            Self::Invalid => "invalid",
            Self::Skipped => "skipped",
        }
    }
}

/// One run, raw: times in seconds, sizes in the unit of their name.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct RunRecord {
    /// Key of the run; runs with equal keys are interchangeable.
    #[serde(skip)]
    pub key: String,
    /// The job.
    #[serde(skip)]
    pub id: RunId,
    /// Origin of the mesh.
    #[serde(skip)]
    pub mesh_kind: MeshKind,
    /// SHA-256 of the mesh file, in hexadecimal digits.
    #[serde(skip)]
    pub mesh_sha256: String,
    /// Repetition, from 0.
    pub repetition: u32,
    /// Seed of the run.
    pub seed: u64,
    /// Outcome.
    pub outcome: Outcome,
    /// Reason of the outcome, if that is not `ok`.
    pub reason: String,
    /// Runs at the same time on the same machine: times of rows above 1 are not ranked.
    pub parallel_jobs: u32,
    /// Paths after which the augmentation was stopped; `augmentation_seconds` is theirs alone.
    pub stopped_after_paths: Option<u64>,
    /// Version and commit of the program.
    pub program: String,
    /// Name of the machine's description in `machines.json`.
    pub machine: String,
    /// Command that runs it again.
    pub command: String,
    /// Wall-clock time of the whole process; `None` where there was none, or nobody timed it.
    pub process_seconds: Option<f64>,
    /// The numbers that it measured.
    #[serde(skip)]
    pub measured: Measured,
}

/// The first columns.
#[derive(Serialize, Deserialize)]
struct RowHead {
    schema: String,
    key: String,
}

/// The columns between those of the mesh's place and those of the job.
#[derive(Serialize, Deserialize)]
struct MeshColumns {
    mesh_kind: MeshKind,
    mesh_sha256: String,
}

/// Reason why a line of `runs.csv` is no record.
#[derive(Debug, thiserror::Error)]
pub(super) enum RowError {
    #[error("it is cut off")]
    CutOff,
    #[error("an empty line")]
    Empty,
    #[error("its schema is {0:?} instead of {SCHEMA:?}")]
    Schema(String),
    #[error(transparent)]
    Columns(#[from] csv::Error),
}

impl RunRecord {
    /// Returns the record in the columns of `runs.csv`.
    pub fn to_row(&self) -> impl Serialize {
        let Self { key, id, mesh_kind, mesh_sha256, measured, .. } = self;
        let head = RowHead { schema: SCHEMA.into(), key: key.clone() };
        let mesh = MeshColumns { mesh_kind: *mesh_kind, mesh_sha256: mesh_sha256.clone() };
        (head, &id.mesh, mesh, id.job, self, measured)
    }

    /// Reads a row under these column names.
    pub(super) fn from_row(row: &StringRecord, names: &StringRecord) -> Result<Self, RowError> {
        let names = Some(names);
        let RowHead { schema, key } = row.deserialize(names)?;
        if schema != SCHEMA {
            return Err(RowError::Schema(schema));
        }
        let MeshColumns { mesh_kind, mesh_sha256 } = row.deserialize(names)?;
        let id = RunId { mesh: row.deserialize(names)?, job: row.deserialize(names)? };
        let (rest, measured): (Self, _) = (row.deserialize(names)?, row.deserialize(names)?);
        Ok(Self { key, id, mesh_kind, mesh_sha256, measured, ..rest })
    }

    /// Returns whether its numbers count.
    pub fn is_ok(&self) -> bool {
        self.outcome == Outcome::Ok
    }

    /// Returns whether it failed: neither `ok`, nor not begun with good reason.
    pub fn is_bad(&self) -> bool {
        !matches!(self.outcome, Outcome::Ok | Outcome::Skipped)
    }

    /// Returns whether its process was started.
    pub fn has_begun(&self) -> bool {
        self.is_ok() || self.process_seconds.is_some_and(|seconds| seconds > 0.0)
    }

    /// Returns whether the augmentation was stopped before the pairing was perfect.
    pub fn is_extrapolated(&self) -> bool {
        self.stopped_after_paths.is_some()
    }

    /// Returns column (d), by rule of three over the paths where the augmentation was stopped.
    pub fn whole_augmentation_seconds(&self) -> Option<f64> {
        let seconds = self.measured.augmentation_seconds?;
        match self.stopped_after_paths {
            Some(made) if made > 0 => {
                let paths = self.measured.unpaired_triangles? as f64 / 2.0;
                Some(seconds * paths / made as f64)
            }
            _ => Some(seconds),
        }
    }

    /// Returns whether it was measured elsewhere.
    pub fn is_imported(&self) -> bool {
        self.machine.starts_with(IMPORTED)
    }

    /// Returns column (e): the sum of [`RunRecord::whole_augmentation_seconds`] and (a) where both
    /// are known. What was imported keeps its total, which may be rounded.
    pub fn whole_total_seconds(&self) -> Option<f64> {
        let total = self.measured.total_seconds;
        if total.is_some() && self.is_imported() && !self.is_extrapolated() {
            return total;
        }
        let parts = self.measured.pairing_seconds.zip(self.whole_augmentation_seconds());
        parts.map(|(pairing, augmentation)| pairing + augmentation).or(total)
    }
}
