//! Repairs of triangles on their way to a triangulation.

use pyo3::prelude::*;
use triquad::Mesh;

use crate::arrays::{MeshArrays, faces_alone, indices, positions, table};
use crate::failure::Failure;
use crate::typed::{AnyArray, NewArray};
use crate::worker;

/// Joins vertices at most `distance` apart. Returns the vertices left and triangles on them.
#[pyfunction]
pub fn weld<'py>(
    py: Python<'py>,
    vertices: AnyArray<'py>,
    triangles: AnyArray<'py>,
    distance: f64,
) -> PyResult<MeshArrays<'py>> {
    let mut mesh = Mesh::from_triangles(positions(&vertices)?, indices("triangles", &triangles)?);
    let mesh = worker::run(py, 0, move |_| {
        welded("distance", &mut mesh, distance)?;
        Ok(mesh)
    })?;
    let (positions, faces) = mesh.into_parts();
    Ok((table(py, positions.into_flattened(), 3)?, table(py, faces.into_corners(), 3)?))
}

/// Drops degenerate triangles, and those that repeat an earlier one. Returns the others.
#[pyfunction]
pub fn clean<'py>(py: Python<'py>, triangles: AnyArray<'py>) -> PyResult<NewArray<'py, u32>> {
    let mut mesh = faces_alone("triangles", indices::<3>("triangles", &triangles)?)?;
    let mesh = worker::run(py, 0, move |_| {
        mesh.clean();
        Ok(mesh)
    })?;
    table(py, mesh.into_parts().1.into_corners(), 3)
}

/// Welds a mesh at the distance given for an argument.
///
/// # Errors
/// No face is left of those that there were.
pub fn welded(argument: &str, mesh: &mut Mesh, distance: f64) -> Result<(), Failure> {
    let dropped = mesh.weld(distance).dropped_faces;
    if dropped > 0 && mesh.faces().is_empty() {
        let problem = "leaves no face; give a smaller distance";
        return Err(Failure::Value(format!("{argument}: {distance} {problem}")));
    }
    Ok(())
}
