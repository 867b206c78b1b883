//! A check that one triangle mesh triangulates the same surface as another, from the two alone.

use super::check::{check_positions, require_triangles};
use super::check_error::CheckError;
use crate::disjoint_sets::DisjointSets;
use crate::mesh::{Faces, Mesh};

/// Checks that `triangles` triangulates the surface that `given` does, on the same vertices.
///
/// Each component must have the same vertices and the same number of triangles, so the same genus.
/// Both meshes must be triangulations, see [`Triangulation::build`](crate::Triangulation::build).
///
/// # Errors
/// The first difference found.
///
/// # Cost
/// O(n log n), linear in practice; 26 bytes a vertex.
pub fn check_retriangulation(triangles: &Mesh, given: &Mesh) -> Result<(), CheckError> {
    let counts = [triangles, given].map(|mesh| mesh.positions().len());
    if counts[0] != counts[1] {
        return Err(CheckError::TriangulationVertexCount { paired: counts[0], given: counts[1] });
    }
    check_positions(triangles.positions(), given.positions())?;
    check_retriangulated_faces(triangles.faces(), given.faces(), given.positions().len())
}

/// Returns how many edges of `triangles` are edges of `given` too, and how many it has.
///
/// # Cost
/// O(n log n) time; 8 bytes a corner.
pub fn common_edges(triangles: &Mesh, given: &Mesh) -> (usize, usize) {
    let [ours, theirs] = [triangles, given].map(|mesh| edges(mesh.faces()));
    let common = ours.iter().filter(|edge| theirs.binary_search(edge).is_ok()).count();
    (common, ours.len())
}

/// Returns all edges once, in ascending order.
fn edges(faces: &Faces) -> Vec<[u32; 2]> {
    let sides = |face: &[u32]| {
        let next = face.iter().cycle().skip(1);
        face.iter().zip(next).map(|(&a, &b)| [a.min(b), a.max(b)]).collect::<Vec<_>>()
    };
    let mut edges: Vec<_> = faces.iter().flat_map(sides).collect();
    edges.sort_unstable();
    edges.dedup();
    edges
}

/// Checks like [`check_retriangulation`], for meshes over the same `vertices` positions.
///
/// # Errors
/// The first difference found.
pub(crate) fn check_retriangulated_faces(
    triangles: &Faces,
    given: &Faces,
    vertices: usize,
) -> Result<(), CheckError> {
    for faces in [triangles, given] {
        require_triangles(faces, vertices)?;
    }
    let [mut one, mut other] = [triangles, given].map(|faces| Components::of(faces, vertices));
    for v in 0..vertices as u32 {
        let [root, root_given] = [&mut one, &mut other].map(|side| side.sets.find(v));
        // That each root of one mesh is in the set of that of the other makes the sets equal.
        let same_set = one.sets.find(root_given) == root && other.sets.find(root) == root_given;
        if one.used[v as usize] != other.used[v as usize] {
            return Err(CheckError::VertexUse(v as usize));
        }
        if !same_set || one.triangles[root as usize] != other.triangles[root_given as usize] {
            return Err(CheckError::Component(v as usize));
        }
    }
    Ok(())
}

/// The connected components of a mesh.
struct Components {
    sets: DisjointSets,
    used: Vec<bool>,
    /// Number of triangles of each component, at its root.
    triangles: Vec<u32>,
}

impl Components {
    fn of(faces: &Faces, vertices: usize) -> Self {
        let mut sets = DisjointSets::new(vertices);
        let mut used = vec![false; vertices];
        for face in faces {
            face.iter().for_each(|&v| used[v as usize] = true);
            face.windows(2).for_each(|side| {
                sets.join(side[0], side[1]);
            });
        }
        let mut triangles = vec![0; vertices];
        faces.iter().for_each(|face| triangles[sets.find(face[0]) as usize] += 1);
        Self { sets, used, triangles }
    }
}
