//! A mesh that is planned to be run: its counts, and where it comes from.

use std::path::PathBuf;

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

impl PlannedMesh {
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

    /// Returns the kind of the mesh in records.
    pub fn kind(&self) -> MeshKind {
        match &self.source {
            Source::File(..) => MeshKind::Real,
            Source::Made(mesh, _) => mesh.kind(),
        }
    }
}
