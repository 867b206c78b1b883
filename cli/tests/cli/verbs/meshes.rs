//! Small meshes and damaged files.

use crate::surfaces::face_list;
use crate::workshop::Workshop;
use triquad::mesh::{Faces, Format, Mesh};
use triquad_generators::random::Mix;
use triquad_generators::testing::random_of;
use triquad_generators::{Surface, grids};

pub const TETRAHEDRON: &str =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

pub const TETRAHEDRON_OFF: &str =
    "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

pub const CUBE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n\
                    f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

pub fn bytes_of(surface: &Surface, format: Format) -> Vec<u8> {
    let mut bytes = Vec::new();
    face_list(surface).write_to(&mut bytes, format).unwrap();
    bytes
}

pub fn without_end(mut bytes: Vec<u8>, missing: usize) -> Vec<u8> {
    bytes.truncate(bytes.len() - missing);
    bytes
}

pub fn ascii_ply(faces: &str) -> String {
    let count = faces.lines().count();
    format!(
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
         element face {count}\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n{faces}"
    )
}

/// Two triangles, of which the second is cut off.
pub fn truncated_binary_stl() -> Vec<u8> {
    let mut bytes = vec![b' '; 80];
    bytes.extend(2u32.to_le_bytes());
    bytes.extend([0; 99]);
    bytes
}

pub fn truncated_ascii_stl() -> &'static str {
    "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
}

pub fn truncated_gzip() -> Vec<u8> {
    let workshop = Workshop::new();
    workshop.put_surface("a.obj.gz", &grids::sphere(6));
    without_end(workshop.get("a.obj.gz"), 300)
}

/// A mesh of more than 500 triangles for which the greedy algorithms have many choices.
pub fn irregular_mesh() -> Surface {
    random_of(1, 400, Mix::Balanced, 5)
}

/// The vertices of `mesh` with its faces changed.
pub fn with_faces(mesh: &Mesh, change: impl FnOnce(&mut Vec<Vec<u32>>)) -> Mesh {
    let mut faces: Vec<Vec<u32>> = mesh.faces().iter().map(<[u32]>::to_vec).collect();
    change(&mut faces);
    mesh.clone().with_faces(Faces::from_iter(faces))
}

pub fn tetrahedron_of([a, b, c, d]: [usize; 4]) -> String {
    format!("f {a} {c} {b}\nf {a} {b} {d}\nf {b} {c} {d}\nf {c} {a} {d}\n")
}
