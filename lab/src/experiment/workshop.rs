//! Meshes while they are run on: made when they are needed, in the formats that programs read.

use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use triquad::mesh::{Mesh, MeshError};

use super::machine;
use super::planned_mesh::{PlannedMesh, Source};
use super::process::{self, Ending};
use super::program_spec::ProgramFormat;
use super::record::Outcome;
use super::run::Runner;
use super::spec::Limits;
use crate::meshes::paper::{PaperMesh, Scale};

/// Reason why a run has no mesh.
#[derive(Clone, Debug, thiserror::Error)]
pub(super) enum MeshFileError {
    #[error("the mesh could not be made: {0}")]
    Make(String),
    #[error("{} cannot be read: {problem}", path.display())]
    Read { path: PathBuf, problem: String },
}

/// A mesh file and its hash.
pub(super) struct MeshFile {
    pub path: PathBuf,
    pub sha256: String,
}

/// The mesh of the current block.
pub(super) struct AtHand {
    pub mesh: PlannedMesh,
    pub file: Result<MeshFile, MeshFileError>,
}

/// The folder of made meshes, and what makes them.
pub(super) struct Workshop<'a> {
    runner: &'a Runner,
    /// Held while a mesh is written in another format.
    converting: Mutex<()>,
}

impl<'a> Workshop<'a> {
    pub fn new(runner: &'a Runner) -> Self {
        Self { runner, converting: Mutex::new(()) }
    }

    pub fn folder(&self) -> &Path {
        &self.runner.workshop
    }

    /// Makes the mesh if it has no file yet, and hashes the file.
    pub fn prepare(&self, mesh: &PlannedMesh, limits: Limits) -> AtHand {
        let path = match &mesh.source {
            Source::File(path, _) => Ok(path.clone()),
            Source::Made(made, scale) => self.make(made, *scale, limits),
        };
        let file = path.and_then(|path| match machine::hash_of_file(&path) {
            Ok(sha256) => Ok(MeshFile { path, sha256 }),
            Err(error) => Err(MeshFileError::Read { path, problem: error.to_string() }),
        });
        AtHand { mesh: mesh.clone(), file }
    }

    /// Makes a mesh in a process of its own.
    fn make(
        &self,
        made: &PaperMesh,
        scale: Scale,
        limits: Limits,
    ) -> Result<PathBuf, MeshFileError> {
        let failure = |error: io::Error| MeshFileError::Make(error.to_string());
        fs::create_dir_all(self.folder()).map_err(failure)?;
        let path = self.folder().join(file_name(made, scale));
        let words = ["generate", "paper", made.name, "--scale", scale.id(), "-o"];
        let mut arguments: Vec<OsString> = words.map(Into::into).into();
        arguments.push(path.clone().into());
        if let Some(cache) = &self.runner.cache {
            arguments.extend(["--cache".into(), cache.into()]);
        }
        match process::run(&self.runner.program, &arguments, limits).map_err(failure)? {
            Ending { outcome: Outcome::Ok, .. } => Ok(path),
            Ending { reason, .. } => Err(MeshFileError::Make(reason)),
        }
    }

    /// Returns the mesh in a format, converted if it is in another one. O(n).
    ///
    /// # Errors
    /// The mesh cannot be read or written.
    pub fn in_format(&self, path: &Path, format: ProgramFormat) -> Result<PathBuf, MeshError> {
        let _turn = self.converting.lock().unwrap_or_else(PoisonError::into_inner);
        fs::create_dir_all(self.folder()).map_err(MeshError::from)?;
        let ending = format.extension();
        if path.extension().is_some_and(|own| own == ending) {
            return Ok(path.to_owned());
        }
        let stem = path.file_name().unwrap_or_default().to_string_lossy();
        let copy = self.folder().join(format!("{stem}.{ending}"));
        if !copy.exists() {
            Mesh::read(path)?.write(&copy)?;
        }
        Ok(copy)
    }

    /// Removes the files of `meshes` from the folder, and the folder if nothing is left.
    pub fn clear<'m>(&self, meshes: impl IntoIterator<Item = &'m PlannedMesh>) {
        for mesh in meshes {
            let name = match &mesh.source {
                Source::File(path, _) => {
                    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
                }
                Source::Made(made, scale) => file_name(made, *scale),
            };
            // What stays behind is replaced the next time.
            let _ = fs::remove_file(self.folder().join(&name));
            for ending in ["obj", "ply", "off"] {
                let _ = fs::remove_file(self.folder().join(format!("{name}.{ending}")));
            }
        }
        let _ = fs::remove_dir(self.folder());
    }
}

fn file_name(made: &PaperMesh, scale: Scale) -> String {
    format!("{}-{}.ply", made.name, scale.id())
}
