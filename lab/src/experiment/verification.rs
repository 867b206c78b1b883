//! A check of the result of a run, and its counts and shape: from the two meshes alone.
//!
//! A conversion may leave triangles: each must be one of the input, each quad two of them, and
//! together they must cover the input once. A result without triangles passes [`triquad::check`]
//! too, as the quads of `triquad convert` do. Such a result may also consist of pairs of triangles
//! of another triangulation of the surface, as that of LRS; then the edges flipped are counted.

use std::collections::HashSet;

use triquad::irreducible::{IrreducibleError, check_irreducible};
use triquad::quadrangulation::quality::Quality;
use triquad::quadrangulation::{SharpEdges, check_mixed};
use triquad::triangulation::{HalfEdgeId, Surface};
use triquad::{
    CheckError, CheckReport, Mesh, Survey, Triangulation, check, check_retriangulation,
    common_edges,
};

use super::flips;
use super::measured::Measured;
use super::task::Task;

/// Fault of a result. Faces and vertices count from 1.
#[derive(Debug, thiserror::Error)]
pub enum ResultError {
    /// The input is no triangulation.
    #[error("its input is no triangulation: {0}")]
    Input(Box<Survey>),
    /// It is no pairing of the input's triangles.
    #[error(transparent)]
    Quads(#[from] CheckError),
    /// It is no irreducible triangulation of the surface.
    #[error(transparent)]
    Reduced(#[from] IrreducibleError),
}

/// Checks the result of `task` on `input` and counts it.
///
/// # Errors
/// The first defect found.
///
/// # Cost
/// O(n log n) time, O(n) memory.
pub fn verify(task: Task, input: &Mesh, result: &Mesh) -> Result<Measured, ResultError> {
    let built = Triangulation::build(input).map_err(ResultError::Input)?;
    let counts = Measured {
        vertices: Some(built.vertex_count() as u64),
        edges: Some(built.triangle_count() as u64 / 2 * 3),
        triangles: Some(built.triangle_count() as u64),
        genus: Some(built.genus() as u64),
        components: Some(built.component_count() as u64),
        ..Measured::default()
    };
    match task {
        Task::Convert => verify_quads(&built, input, result, counts),
        Task::Irreducible => verify_reduced(&built, result, counts),
    }
}

fn verify_reduced(
    input: &Triangulation,
    result: &Mesh,
    counts: Measured,
) -> Result<Measured, ResultError> {
    check_irreducible(result, input.component_count(), input.genus())?;
    let triangles = result.faces().len() as u64;
    let edges = triangles / 2 * 3;
    let used = result.faces().corners().iter().collect::<HashSet<_>>().len();
    Ok(Measured {
        result_vertices: Some(used as u64),
        result_edges: Some(edges),
        result_triangles: Some(triangles),
        ..counts
    })
}

fn verify_quads(
    surface: &Triangulation,
    input: &Mesh,
    result: &Mesh,
    counts: Measured,
) -> Result<Measured, ResultError> {
    let (report, flips) = match check_mixed(result, input) {
        Ok(checked) => (checked.report, 0),
        Err(mismatch) => check_flipped(input, result).ok_or(mismatch)?,
    };
    let (quads, left) = (report.quads, report.triangles);
    if left == 0 && flips == 0 {
        check(result, input)?;
    }
    let triangles = input.faces().len();
    let sharp = SharpEdges::new(surface, input.positions(), &removed(surface, result));
    let shape = (quads > 0).then(|| Quality::new(result));
    Ok(Measured {
        quads: Some(quads as u64),
        unpaired_triangles: Some(left as u64),
        paired_percent: Some(100.0 * (triangles - left) as f64 / triangles as f64),
        edge_flips: Some(flips as u64),
        quality_minimum: shape.map(|shape| shape.minimum),
        quality_mean: shape.map(|shape| shape.mean),
        quality_one_percent: shape.map(|shape| shape.one_percent),
        folded_quads: shape.map(|shape| shape.folded as u64),
        sharp_edges: Some(sharp.all as u64),
        sharp_edges_kept: Some(sharp.kept as u64),
        degree_two_vertices: Some(report.degree_two_vertices as u64),
        ..counts
    })
}

/// Checks quads as pairs of triangles of another triangulation of the surface of `input`; returns
/// their counts and how many of its edges `input` does not have.
fn check_flipped(input: &Mesh, result: &Mesh) -> Option<(CheckReport, usize)> {
    if result.faces().iter().any(|face| face.len() != 4) {
        return None;
    }
    let paired = flips::cut(result, input);
    Triangulation::build(&paired).ok()?;
    check_retriangulation(&paired, input).ok()?;
    let report = check(result, &paired).ok()?;
    let (common, all) = common_edges(&paired, input);
    Some((report, all - common))
}

/// Returns the edges of the surface that `result` does not have.
fn removed(surface: &Triangulation, result: &Mesh) -> Vec<HalfEdgeId> {
    let left = flips::edges(result);
    let is_removed = |&side: &HalfEdgeId| {
        let [u, v] = surface.ends(side).map(u32::from);
        !left.contains(&flips::sorted(u, v))
    };
    surface.edges().filter(is_removed).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use triquad::mesh::Faces;
    use triquad::{Algorithm, Converter, Expansion, Mesh};
    use triquad_generators::grids;

    fn input() -> Mesh {
        let torus = grids::torus(7, 9);
        Mesh::from_triangles(torus.positions, torus.triangles)
    }

    fn with_faces(faces: &[Vec<u32>]) -> Mesh {
        let mut list = Faces::default();
        faces.iter().for_each(|face| list.push(face));
        input().with_faces(list)
    }

    fn converted() -> Vec<Vec<u32>> {
        let quads = Converter::new().run(input()).unwrap().into_mesh();
        quads.faces().into_iter().map(<[u32]>::to_vec).collect()
    }

    #[test]
    fn whole_and_partial_pairings_are_counted() {
        let faces = converted();
        let whole = verify(Task::Convert, &input(), &with_faces(&faces)).unwrap();
        assert_eq!((whole.unpaired_triangles, whole.quads), (Some(0), Some(63)));
        assert_eq!(
            (whole.edges, whole.genus, whole.paired_percent),
            (Some(189), Some(1), Some(100.0))
        );
        let unpaired = input().faces().into_iter().map(<[u32]>::to_vec).collect::<Vec<_>>();
        let none = verify(Task::Convert, &input(), &with_faces(&unpaired)).unwrap();
        assert_eq!((none.unpaired_triangles, none.quads), (Some(126), Some(0)));
        assert_eq!((none.quality_mean, none.folded_quads), (None, None));
        assert_eq!(none.sharp_edges, none.sharp_edges_kept);
    }

    #[test]
    fn quads_of_another_triangulation_are_counted_with_their_flips() {
        let algorithm = Algorithm::Lrs(Expansion::Printed);
        let converted = Converter::new().algorithm(algorithm).run(input()).unwrap();
        let flips = converted.report().edge_flips;
        let found = verify(Task::Convert, &input(), converted.mesh()).unwrap();
        assert!(flips > 0 && found.edge_flips > Some(0), "{found:?}");
        // An edge that was flipped and removed afterwards does not show.
        assert!(found.edge_flips <= Some(flips as u64));
        assert_eq!((found.unpaired_triangles, found.quads), (Some(0), Some(63)));
        assert!(found.sharp_edges_kept < found.sharp_edges);
    }

    #[test]
    fn what_is_no_pairing_is_named() {
        let faces = converted();
        let fault = |change: &dyn Fn(&mut Vec<Vec<u32>>)| {
            let mut faces = faces.clone();
            change(&mut faces);
            verify(Task::Convert, &input(), &with_faces(&faces)).unwrap_err().to_string()
        };
        assert!(fault(&|faces| drop(faces.pop())).contains("lies in no face"));
        assert!(fault(&|faces| faces.push(faces[0].clone())).contains("lies in two faces"));
        assert!(fault(&|faces| faces[3].reverse()).starts_with("face 4 is turned"));
        assert!(fault(&|faces| faces[3].swap(0, 1)).starts_with("quad 4 is not two"));
        assert!(fault(&|faces| faces[3].push(0)).starts_with("face 4 has 5 corners"));
        let moved = input().positions().iter().map(|&[x, y, z]| [x, y, z + 1e-9]).collect();
        let moved = Mesh::from_triangles(moved, Vec::new());
        let found = verify(Task::Convert, &input(), &moved).unwrap_err().to_string();
        assert!(found.starts_with("vertex 1 has other coordinates"), "{found}");
    }

    #[test]
    fn what_can_still_be_contracted_is_no_reduction() {
        let found = verify(Task::Irreducible, &input(), &input()).unwrap_err().to_string();
        assert!(found.contains("could still be contracted"), "{found}");
    }
}
