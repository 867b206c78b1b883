//! A mesh that is planned to be run: its counts, and where it comes from.

use std::path::{Path, PathBuf};

use super::data_folder::DataMesh;
use crate::meshes::MeshKind;
use crate::meshes::paper::{PaperMesh, Scale};

/// A mesh, and where it comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlannedMesh {
    /// Its name in records.
    pub name: String,
    /// n_v.
    pub vertices: u32,
    /// n_f.
    pub triangles: u32,
    /// Genus.
    pub genus: u32,
    /// Origin.
    pub source: Source,
}

/// Origin of a mesh.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Source {
    /// A file of the user's, and its SHA-256.
    File(PathBuf, String),
    /// Made to order, at a scale.
    Made(PaperMesh, Scale),
}

/// A mesh of an experiment that is not at hand, or there twice.
#[derive(Debug, PartialEq, Eq, thiserror::Error)]
pub enum PlannedMeshError {
    /// A name is neither that of a mesh of the papers nor that of a file in a data folder.
    #[error(
        "{place}: {name:?} is no mesh of the papers and in no data folder; name its folder with \
         --data, or take it out{}",
        .nearest.as_ref().map_or(String::new(), |one| format!(", or {one:?} is meant"))
    )]
    Unknown {
        /// File and line, or the experiment.
        place: String,
        /// The name.
        name: String,
        /// The known mesh that is probably meant.
        nearest: Option<String>,
    },
    /// The mesh whose results are to be drawn is in no group.
    #[error("{place}: pictures is {name:?}, and no group has it; add it to one, or name another")]
    NotRun {
        /// File and line, or the experiment.
        place: String,
        /// The mesh.
        name: String,
    },
    /// Two meshes of a group have one name: their runs would have the same rows.
    #[error(
        "{place}: group {group:?} has two meshes named {name:?}{files}; name a mesh once, rename a \
         file, or make two groups"
    )]
    Twice {
        /// File and line, or the experiment.
        place: String,
        /// The group.
        group: String,
        /// The name of both.
        name: String,
        /// The files, as they follow in a sentence.
        files: String,
    },
    /// A file that an experiment names is no mesh that can be converted.
    #[error("{place}: {}: {problem}", path.display())]
    File {
        /// File and line, or the experiment.
        place: String,
        /// The file.
        path: PathBuf,
        /// The fault.
        problem: String,
    },
}

impl PlannedMesh {
    /// Reads the mesh that an experiment names by its file; `place` says where it does.
    ///
    /// # Errors
    /// The file cannot be read, or is no mesh that can be converted.
    pub fn of_file(path: &Path, place: impl FnOnce() -> String) -> Result<Self, PlannedMeshError> {
        let mesh = DataMesh::of_file(path.to_owned());
        match mesh.problem {
            None => Ok(Self::real(&mesh)),
            Some(problem) => {
                Err(PlannedMeshError::File { place: place(), path: path.to_owned(), problem })
            }
        }
    }

    /// Returns the mesh of a file.
    pub fn real(mesh: &DataMesh) -> Self {
        Self {
            name: mesh.name.clone(),
            vertices: mesh.vertices,
            triangles: mesh.triangles,
            genus: mesh.genus,
            source: Source::File(mesh.path.clone(), mesh.sha256.clone()),
        }
    }

    /// Returns a mesh of the papers, made at a scale.
    pub fn made(paper: PaperMesh, scale: Scale) -> Self {
        let mesh = paper.at(scale);
        Self {
            name: mesh.name.into(),
            vertices: mesh.vertices,
            triangles: mesh.triangles(),
            genus: mesh.genus,
            source: Source::Made(mesh, scale),
        }
    }

    /// Returns its file, if it is from one.
    pub fn path(&self) -> Option<&Path> {
        match &self.source {
            Source::File(path, _) => Some(path),
            Source::Made(..) => None,
        }
    }

    /// Returns the kind of the mesh in records.
    pub fn kind(&self) -> MeshKind {
        match &self.source {
            Source::File(..) => MeshKind::Real,
            Source::Made(mesh, _) => mesh.kind(),
        }
    }
}
