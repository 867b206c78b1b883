//! Folders with the user's own meshes.

use std::io;
use std::path::{Path, PathBuf};

use super::machine::hash_of_file;
use crate::meshes::paper::PaperMesh;
use triquad::mesh::Format;
use triquad::triangulation::Triangulation;

/// A mesh file in a data folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DataMesh {
    /// Name of its file, without folder and extensions.
    pub name: String,
    /// The file.
    pub path: PathBuf,
    /// SHA-256 of the file, in hexadecimal digits.
    pub sha256: String,
    /// n_v, where it is a triangulation.
    pub vertices: u32,
    /// n_f.
    pub triangles: u32,
    /// Genus, where it is a triangulation.
    pub genus: u32,
    /// Why it cannot be converted, if it cannot.
    pub problem: Option<String>,
}

/// A data folder that cannot be read.
#[derive(Debug, thiserror::Error)]
#[error("{}: {error}", folder.display())]
pub struct DataFolderError {
    folder: PathBuf,
    error: io::Error,
}

/// Reads every mesh file in `folders`, in the order of triangles; of equal names the first
/// folder's. Builds each mesh to count its genus.
///
/// # Errors
/// A folder cannot be read.
pub fn survey(folders: &[PathBuf]) -> Result<Vec<DataMesh>, DataFolderError> {
    let mut found: Vec<DataMesh> = Vec::new();
    for folder in folders {
        let failure = |error| DataFolderError { folder: folder.clone(), error };
        let mut files = mesh_files(folder).map_err(failure)?;
        files.sort();
        for path in files {
            let name = name_of(&path);
            if !found.iter().any(|mesh| mesh.name == name) {
                found.push(DataMesh::read(name, path));
            }
        }
    }
    found.sort_by(|a, b| (a.triangles, &a.name).cmp(&(b.triangles, &b.name)));
    Ok(found)
}

fn mesh_files(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let entries: io::Result<Vec<_>> = std::fs::read_dir(folder)?.collect();
    let paths = entries?.into_iter().map(|entry| entry.path());
    Ok(paths.filter(|path| path.is_file() && Format::from_path(path).is_ok()).collect())
}

/// Returns the name of a mesh: `Happy_Buddha` for `folder/Happy_Buddha.obj.gz`.
fn name_of(path: &Path) -> String {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let end = name.find('.').filter(|&dot| dot > 0).unwrap_or(name.len());
    name[..end].to_owned()
}

impl DataMesh {
    fn read(name: String, path: PathBuf) -> Self {
        let sha256 = hash_of_file(&path).unwrap_or_default();
        let mut mesh =
            Self { name, path, sha256, vertices: 0, triangles: 0, genus: 0, problem: None };
        match triquad::Mesh::read(&mesh.path) {
            Err(error) => mesh.problem = Some(error.to_string()),
            Ok(list) => match Triangulation::build(&list) {
                Err(survey) => mesh.problem = Some(survey.to_string()),
                Ok(built) => {
                    mesh.vertices = built.vertex_count() as u32;
                    mesh.triangles = built.triangle_count() as u32;
                    mesh.genus = built.genus() as u32;
                }
            },
        }
        mesh
    }

    /// Returns whether its name is that of `paper`, or of a version of it.
    pub fn is_called(&self, paper: &str) -> bool {
        let name = self.name.to_lowercase().replace(['_', ' '], "-");
        name == paper || name.strip_prefix(paper).is_some_and(|rest| rest.starts_with('-'))
    }

    /// Returns whether it has the counts of `paper`.
    pub fn has_counts_of(&self, paper: &PaperMesh) -> bool {
        self.problem.is_none() && (self.vertices, self.genus) == (paper.vertices, paper.genus)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_come_from_files() {
        assert_eq!(name_of(Path::new("a/Happy_Buddha.obj.gz")), "Happy_Buddha");
        assert_eq!(name_of(Path::new("b.ply")), "b");
        let called = |name: &str, paper| {
            let mesh = DataMesh::read(name.into(), PathBuf::from("missing.ply"));
            assert!(mesh.problem.is_some());
            mesh.is_called(paper)
        };
        assert!(called("Happy_Buddha", "happy-buddha"));
        assert!(called("eros-400k", "eros"));
        assert!(!called("erosion", "eros"));
        assert!(!called("derived_eros", "eros"));
    }

    #[test]
    fn every_mesh_in_a_folder_is_found_once() {
        let folder = tempfile::tempdir().unwrap();
        let off = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
        std::fs::write(folder.path().join("b.off"), off).unwrap();
        std::fs::write(folder.path().join("a.off"), off.replace("3 2 0 3\n", "3 2 0 1\n")).unwrap();
        std::fs::write(folder.path().join("notes.txt"), "no mesh").unwrap();
        let twice = [folder.path().to_owned(), folder.path().to_owned()];
        let found = survey(&twice).unwrap();
        assert_eq!(found.iter().map(|mesh| &mesh.name[..]).collect::<Vec<_>>(), ["a", "b"]);
        assert!(found[0].problem.is_some());
        assert_eq!((found[1].vertices, found[1].triangles, found[1].genus), (4, 4, 0));
        assert_eq!(found[1].problem, None);
        assert!(survey(&[folder.path().join("missing")]).is_err());
    }
}
