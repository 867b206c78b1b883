//! Folders with the user's own meshes.

use std::io;
use std::path::{Path, PathBuf};

use super::machine::hash_of_file;
use crate::meshes::paper::{self, PaperMesh};
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
    /// Reason why it cannot be converted, if it cannot.
    pub problem: Option<String>,
}

/// A data folder that cannot be read.
#[derive(Debug, thiserror::Error)]
#[error("{}: {error}", folder.display())]
pub struct DataFolderError {
    folder: PathBuf,
    error: io::Error,
}

/// The meshes of data folders, and remarks on the folders.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct DataSurvey {
    /// The meshes, in the order of triangles.
    pub meshes: Vec<DataMesh>,
    /// Files that are left out, and folders without any.
    pub remarks: Vec<String>,
}

/// Reads every mesh file in `folders`; of equal names the first. Builds each mesh to count its
/// genus.
///
/// # Errors
/// A folder cannot be read.
pub fn survey(folders: &[PathBuf]) -> Result<DataSurvey, DataFolderError> {
    let mut survey = DataSurvey::default();
    for folder in folders {
        let failure = |error| DataFolderError { folder: folder.clone(), error };
        let mut files = mesh_files(folder).map_err(failure)?;
        files.sort();
        if files.is_empty() {
            survey.remarks.push(format!("{}: there is no mesh file in it", folder.display()));
        }
        files.into_iter().for_each(|path| survey.add(path));
    }
    survey.meshes.sort_by(|a, b| (a.triangles, &a.name).cmp(&(b.triangles, &b.name)));
    Ok(survey)
}

impl DataSurvey {
    fn add(&mut self, path: PathBuf) {
        let name = name_of(&path);
        let mut leave_out =
            |why: String| self.remarks.push(format!("{} is left out: {why}", path.display()));
        if !path.is_file() {
            leave_out("it is a link that leads to no file".into());
        } else if name.contains(char::is_control) {
            leave_out("its name has a line break or another control character".into());
        } else if let Some(known) = self.meshes.iter().find(|mesh| mesh.name == name) {
            if known.path != path {
                leave_out(format!("{} has the same name; rename one", known.path.display()));
            }
        } else {
            self.meshes.push(DataMesh::read(name, path));
        }
    }
}

/// Returns the files that are called like meshes, and links that lead nowhere.
fn mesh_files(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let entries: io::Result<Vec<_>> = std::fs::read_dir(folder)?.collect();
    let paths = entries?.into_iter().map(|entry| entry.path());
    let is_meant = |path: &PathBuf| path.is_file() || path.is_symlink() && !path.exists();
    Ok(paths.filter(|path| is_meant(path) && Format::from_path(path).is_ok()).collect())
}

/// Returns the name of a mesh, known endings removed: `scan_0.25` for `folder/scan_0.25.obj.gz`.
pub(super) fn name_of(path: &Path) -> String {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let without = |name: &str, ending: fn(&str) -> bool| match name.rsplit_once('.') {
        Some((stem, last)) if !stem.is_empty() && ending(last) => stem.to_owned(),
        _ => name.to_owned(),
    };
    let name = without(&name, |last| last.eq_ignore_ascii_case("gz"));
    without(&name, |last| last.parse::<Format>().is_ok())
}

impl DataMesh {
    /// Reads a file under the name that it has without endings.
    pub fn of_file(path: PathBuf) -> Self {
        Self::read(name_of(&path), path)
    }

    fn read(name: String, path: PathBuf) -> Self {
        let sha256 = hash_of_file(&path).unwrap_or_default();
        let mut mesh =
            Self { name, path, sha256, vertices: 0, triangles: 0, genus: 0, problem: None };
        match triquad::Mesh::read(&mesh.path) {
            Err(error) => mesh.problem = Some(error.without_path().to_string()),
            Ok(list) => match Triangulation::build(&list) {
                Err(survey) => {
                    let why = "experiments take closed triangle meshes";
                    mesh.problem = Some(format!("{survey}; {why}"));
                }
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
        let name = self.name.to_lowercase().replace(['_', ' ', '.'], "-");
        let called = paper::called(&name).is_some_and(|mesh| mesh.name == paper);
        called || name.strip_prefix(paper).is_some_and(|rest| rest.starts_with('-'))
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
        assert_eq!(name_of(Path::new("scan_0.25.ply")), "scan_0.25");
        assert_eq!(name_of(Path::new("v1.2.OFF.GZ")), "v1.2");
        let called = |name: &str, paper| {
            let mesh = DataMesh::read(name.into(), PathBuf::from("missing.ply"));
            assert!(mesh.problem.is_some());
            mesh.is_called(paper)
        };
        assert!(called("Happy_Buddha", "happy-buddha"));
        assert!(called("happybuddha", "happy-buddha"));
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
        std::fs::write(folder.path().join("b.obj"), "").unwrap();
        let DataSurvey { meshes: found, remarks } = survey(&twice).unwrap();
        assert!(
            remarks[0].contains("b.off is left out") && remarks[0].contains("b.obj"),
            "{remarks:?}"
        );
        std::fs::remove_file(folder.path().join("b.obj")).unwrap();
        assert_eq!(found.len(), 2);
        let DataSurvey { meshes: found, remarks } = survey(&twice).unwrap();
        assert_eq!(remarks, Vec::<String>::new());
        assert_eq!(found.iter().map(|mesh| &mesh.name[..]).collect::<Vec<_>>(), ["a", "b"]);
        assert!(found[0].problem.is_some());
        assert_eq!((found[1].vertices, found[1].triangles, found[1].genus), (4, 4, 0));
        assert_eq!(found[1].problem, None);
        assert!(survey(&[folder.path().join("missing")]).is_err());
        let empty = tempfile::tempdir().unwrap();
        let said = survey(&[empty.path().to_owned()]).unwrap().remarks;
        assert!(said[0].contains("there is no mesh file"), "{said:?}");
    }
}
