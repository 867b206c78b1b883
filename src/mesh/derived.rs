//! Faces made from those of a mesh, for its attributes to follow.

use super::faces::Faces;
use super::polygon_mesh::Mesh;

/// Faces that are left, and where they come from.
#[derive(Default)]
pub(super) struct Derived {
    faces: Faces,
    /// The old corner of each corner.
    sources: Vec<usize>,
    /// The first face left of each old one.
    first_new: Vec<usize>,
    /// The face of the file of each face.
    origins: Vec<u32>,
}

impl Derived {
    /// Goes on to the next old face.
    pub(super) fn begin_face(&mut self) {
        self.first_new.push(self.faces.len());
    }

    /// Keeps these corners of old face `index` of `mesh`, each at vertex `target` of what it was.
    pub(super) fn keep(
        &mut self,
        mesh: &Mesh,
        index: usize,
        corners: impl IntoIterator<Item = usize>,
        target: impl Fn(u32) -> u32,
    ) {
        let (face, start) = (&mesh.faces()[index], mesh.faces().range(index).start);
        let before = self.sources.len();
        self.sources.extend(corners.into_iter().map(|corner| start + corner));
        let kept = self.sources[before..].iter().map(|source| target(face[source - start]));
        self.faces.push(&kept.collect::<Vec<_>>());
        self.origins.push(mesh.face_in_file(index) as u32);
    }

    /// Makes these the faces of `mesh`. Returns the number of old faces of which none is left.
    pub(super) fn replace_faces_of(mut self, mesh: &mut Mesh) -> usize {
        self.first_new.push(self.faces.len());
        let dropped = self.first_new.windows(2).filter(|pair| pair[0] == pair[1]).count();
        mesh.set_derived_faces(self.faces, &self.sources, &self.first_new, self.origins);
        dropped
    }
}
