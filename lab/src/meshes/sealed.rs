//! Mesh files beside which stands what they must hash to, so that nothing else is taken for them.

use std::fs;
use std::path::{Path, PathBuf};

use triquad::mesh::{Format, Mesh, MeshError, Output};

use crate::file_hash::{hash_of_bytes, hash_of_words};
use crate::whole_file;

/// Returns the mesh in `path`, a PLY file, if it is the one that was sealed under this name. A link
/// is not followed.
pub(super) fn read(path: &Path) -> Option<Mesh> {
    let is_file = |path: &Path| path.symlink_metadata().is_ok_and(|found| found.is_file());
    if !is_file(path) || !is_file(&seal_of(path)) {
        return None;
    }
    let bytes = fs::read(path).ok()?;
    let sealed = fs::read_to_string(seal_of(path)).ok()?;
    let mesh = Mesh::parse(&bytes, Format::Ply).ok()?;
    (sealed.trim_end() == seal(path, &bytes)).then_some(mesh)
}

/// Opens `path` for a mesh that is sealed when it is written. A link in its place is removed.
///
/// # Errors
/// Those of the file system.
pub(super) fn create(path: PathBuf) -> Result<SealedOutput, MeshError> {
    for file in [&path, &seal_of(&path)] {
        if file.is_symlink() {
            fs::remove_file(file)?;
        }
    }
    let output = Output::create(&path)?;
    Ok(SealedOutput { path, output })
}

/// A mesh file that is being written.
pub(super) struct SealedOutput {
    path: PathBuf,
    output: Output,
}

impl SealedOutput {
    /// Writes the mesh, then its seal.
    ///
    /// # Errors
    /// Those of the file system.
    pub fn write(self, mesh: &Mesh) -> Result<(), MeshError> {
        self.output.write(mesh)?;
        let text = seal(&self.path, &fs::read(&self.path)?) + "\n";
        Ok(whole_file::write(&seal_of(&self.path), text.as_bytes())?)
    }
}

fn seal_of(path: &Path) -> PathBuf {
    path.with_extension("seal")
}

/// Returns the seal of these bytes under the name of `path`.
fn seal(path: &Path, bytes: &[u8]) -> String {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    hash_of_words(&[&name, &hash_of_bytes(bytes)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use triquad_generators::classic;

    #[test]
    fn only_what_was_sealed_under_its_name_is_read() {
        let folder = tempfile::tempdir().unwrap();
        let [one, two] = ["one.ply", "two.ply"].map(|name| folder.path().join(name));
        let mesh = |surface: triquad_generators::Surface| {
            Mesh::from_triangles(surface.positions, surface.triangles)
        };
        let [tetrahedron, octahedron] = [mesh(classic::tetrahedron()), mesh(classic::octahedron())];
        create(one.clone()).unwrap().write(&tetrahedron).unwrap();
        create(two.clone()).unwrap().write(&octahedron).unwrap();
        assert_eq!(read(&one), Some(tetrahedron.clone()));
        // A changed coordinate.
        let mut bytes = fs::read(&one).unwrap();
        let place = bytes.len() - 70;
        bytes[place] ^= 1;
        fs::write(&one, bytes).unwrap();
        assert_eq!(read(&one), None);
        // Another mesh, with its seal.
        fs::copy(&two, &one).unwrap();
        fs::copy(seal_of(&two), seal_of(&one)).unwrap();
        assert_eq!(read(&one), None);
        create(one.clone()).unwrap().write(&tetrahedron).unwrap();
        assert_eq!(read(&one), Some(tetrahedron));
    }

    #[cfg(unix)]
    #[test]
    fn a_link_in_place_of_a_mesh_is_replaced_not_followed() {
        let folder = tempfile::tempdir().unwrap();
        let [victim, link] = ["victim", "link.ply"].map(|name| folder.path().join(name));
        fs::write(&victim, "kept").unwrap();
        std::os::unix::fs::symlink(&victim, &link).unwrap();
        let surface = classic::octahedron();
        let mesh = Mesh::from_triangles(surface.positions, surface.triangles);
        create(link.clone()).unwrap().write(&mesh).unwrap();
        assert_eq!(fs::read_to_string(&victim).unwrap(), "kept");
        assert_eq!(read(&link), Some(mesh));
    }
}
