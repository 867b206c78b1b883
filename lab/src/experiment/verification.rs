//! A check of what a program that is not ours has made, and the counts of it.
//!
//! A conversion may leave triangles: each must be one of the input, each quad two of them, and
//! together they must cover the input once. A result without triangles passes [`triquad::check`]
//! too, as the quads of `triquad convert` do.

use std::collections::{HashMap, HashSet};

use triquad::irreducible::{IrreducibleError, check_irreducible};
use triquad::quadrangulation::quality::Quality;
use triquad::{Mesh, Mismatch, Survey, Triangulation, check};

use super::measured::Measured;
use super::task::Task;

/// Fault of a result. Faces and vertices count from 1.
#[derive(Debug, thiserror::Error)]
pub enum ResultError {
    /// The input is no triangulation.
    #[error("its input is no triangulation: {0}")]
    Input(Box<Survey>),
    /// It has other vertices than the input.
    #[error("it has {result} vertices, its input {input}")]
    VertexCount {
        /// Vertices of the result.
        result: usize,
        /// Vertices of the input.
        input: usize,
    },
    /// A vertex has moved.
    #[error("vertex {} has other coordinates than in its input", .0 + 1)]
    Moved(usize),
    /// A face is neither a triangle of the input nor two that share an edge.
    #[error("face {} is neither a triangle of its input nor two that share an edge", .0 + 1)]
    Foreign(usize),
    /// A face covers what another one covers.
    #[error("face {} covers a triangle of its input that another face covers", .0 + 1)]
    Twice(usize),
    /// A triangle of the input is not covered.
    #[error("triangle {} of its input is not covered", .0 + 1)]
    Uncovered(usize),
    /// It is not what quads of this surface are.
    #[error(transparent)]
    Quads(#[from] Mismatch),
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
/// O(n) time and memory on average.
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
        Task::Convert => verify_quads(input, result, counts),
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

fn verify_quads(input: &Mesh, result: &Mesh, counts: Measured) -> Result<Measured, ResultError> {
    same_vertices(input, result)?;
    let left = cover(input, result)?;
    if left == 0 {
        check(result, input)?;
    }
    let triangles = input.faces().len();
    let quality = Quality::new(result);
    let quads = (result.faces().len() - left) as u64;
    Ok(Measured {
        quads: Some(quads),
        unpaired_triangles: Some(left as u64),
        paired_percent: Some(100.0 * (triangles - left) as f64 / triangles as f64),
        edge_flips: Some(0),
        quality_minimum: (quads > 0).then_some(quality.minimum),
        quality_mean: (quads > 0).then_some(quality.mean),
        ..counts
    })
}

fn same_vertices(input: &Mesh, result: &Mesh) -> Result<(), ResultError> {
    let (ours, given) = (result.positions(), input.positions());
    if ours.len() != given.len() {
        return Err(ResultError::VertexCount { result: ours.len(), input: given.len() });
    }
    let moved = (0..ours.len()).find(|&v| ours[v] != given[v]);
    moved.map_or(Ok(()), |v| Err(ResultError::Moved(v)))
}

/// Triangles of a mesh by their corners, and which of them are covered.
struct Cover {
    places: HashMap<[u32; 3], usize>,
    is_covered: Vec<bool>,
}

/// Returns the number of faces of `result` that are triangles, if its faces cover `input` once.
fn cover(input: &Mesh, result: &Mesh) -> Result<usize, ResultError> {
    let triangles =
        input.faces().into_iter().enumerate().filter_map(|(place, face)| {
            Some((first_least(*<&[u32; 3]>::try_from(face).ok()?), place))
        });
    let places = triangles.collect();
    let mut cover = Cover { places, is_covered: vec![false; input.faces().len()] };
    let mut left = 0;
    for (place, face) in result.faces().into_iter().enumerate() {
        let own = match *face {
            [a, b, c] => {
                left += 1;
                cover.free(&[[a, b, c]])
            }
            [a, b, c, d] => cover
                .free(&[[a, b, c], [c, d, a]])
                .or_else(|fault| cover.free(&[[b, c, d], [d, a, b]]).map_err(|_| fault)),
            _ => Err(Fault::Foreign),
        };
        match own {
            Ok(own) => own.into_iter().for_each(|triangle| cover.is_covered[triangle] = true),
            Err(Fault::Foreign) => return Err(ResultError::Foreign(place)),
            Err(Fault::Twice) => return Err(ResultError::Twice(place)),
        }
    }
    let uncovered = cover.is_covered.iter().position(|&is_covered| !is_covered);
    uncovered.map_or(Ok(left), |triangle| Err(ResultError::Uncovered(triangle)))
}

/// Fault of a face.
enum Fault {
    Foreign,
    Twice,
}

impl Cover {
    /// Returns the places of triangles of the input, if these are all of them and none is covered.
    fn free(&self, triangles: &[[u32; 3]]) -> Result<Vec<usize>, Fault> {
        let find = |&triangle: &[u32; 3]| self.places.get(&first_least(triangle)).copied();
        let found: Option<Vec<usize>> = triangles.iter().map(find).collect();
        let found = found.ok_or(Fault::Foreign)?;
        if found.iter().any(|&triangle| self.is_covered[triangle]) {
            return Err(Fault::Twice);
        }
        Ok(found)
    }
}

/// Turns a triangle until its least corner is first.
fn first_least([a, b, c]: [u32; 3]) -> [u32; 3] {
    if a < b && a < c {
        [a, b, c]
    } else if b < c {
        [b, c, a]
    } else {
        [c, a, b]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use triquad::mesh::Faces;
    use triquad::{Converter, Mesh};
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
        assert_eq!(none.quality_mean, None);
    }

    #[test]
    fn what_is_no_pairing_is_named() {
        let faces = converted();
        let fault = |change: &dyn Fn(&mut Vec<Vec<u32>>)| {
            let mut faces = faces.clone();
            change(&mut faces);
            verify(Task::Convert, &input(), &with_faces(&faces)).unwrap_err().to_string()
        };
        assert!(fault(&|faces| drop(faces.pop())).contains("is not covered"));
        assert!(fault(&|faces| faces.push(faces[0].clone())).contains("that another face covers"));
        assert!(fault(&|faces| faces[3].reverse()).starts_with("face 4 is neither"));
        assert!(fault(&|faces| faces[3].swap(0, 1)).starts_with("face 4 is neither"));
        assert!(fault(&|faces| faces[3].push(0)).starts_with("face 4 is neither"));
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
