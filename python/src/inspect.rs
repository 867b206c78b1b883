//! The check of quads, and the survey of a mesh.

use pyo3::prelude::*;
use serde_json::{Value, json};
use triquad::mesh::Faces;
use triquad::quadrangulation::check_mixed;
use triquad::{Mesh, Survey, Violation};

use crate::arrays::{faces_alone, indices, positions};
use crate::failure::{Failure, element, remedy, sentence};
use crate::typed::AnyArray;
use crate::worker;

/// Checks quads, and triangles left over, against triangles on the same vertices. Returns counts as
/// JSON. With `open` the surface may have a boundary or one side.
#[pyfunction]
pub fn check(
    py: Python<'_>,
    quads: AnyArray<'_>,
    triangles: AnyArray<'_>,
    leftover: AnyArray<'_>,
    open: bool,
) -> PyResult<String> {
    let quads = indices::<4>("quads", &quads)?;
    let triangles = faces_alone("triangles", indices::<3>("triangles", &triangles)?)?;
    let leftover = indices::<3>("leftover", &leftover)?;
    worker::run(py, 0, move |_| {
        let (count, mixed) = (quads.len(), open || !leftover.is_empty());
        let mut faces = Faces::uniform(4, quads.into_flattened());
        faces.extend(leftover);
        let vertices = triangles.positions().to_vec();
        let quads = Mesh::new(vertices, faces);
        let report = if mixed {
            check_mixed(&quads, &triangles).map(|check| check.report)
        } else {
            triquad::check(&quads, &triangles)
        };
        let report = report.map_err(|mismatch| Failure::of_check(mismatch, count))?;
        let counts = json!({
            "quads": report.quads,
            "triangles": report.triangles,
            "vertices": report.vertices,
            "degree_two_vertices": report.degree_two_vertices,
            "euler_characteristic": report.euler_characteristic,
        });
        Ok(counts.to_string())
    })
}

/// Counts a mesh and the laws that it breaks. Returns JSON.
#[pyfunction]
pub fn survey(py: Python<'_>, vertices: AnyArray<'_>, triangles: AnyArray<'_>) -> PyResult<String> {
    let mesh = Mesh::from_triangles(positions(&vertices)?, indices("triangles", &triangles)?);
    worker::run(py, 0, move |_| Ok(described(&Survey::new(&mesh)).to_string()))
}

fn described(survey: &Survey) -> Value {
    json!({
        "vertices": survey.vertices,
        "unreferenced_vertices": survey.unreferenced_vertices,
        "edges": survey.edges,
        "triangles": survey.triangles,
        "euler_characteristic": survey.euler_characteristic,
        "genus": survey.filled_genus(),
        "non_orientable_genus": survey.non_orientable_genus(),
        "components": survey.components,
        "boundary_loops": survey.boundary_loops,
        "orientable": survey.orientable,
        "closed": survey.closed,
        "violations": survey.violations.iter().map(violation).collect::<Vec<_>>(),
        "faces_to_flip": survey.faces_to_flip,
    })
}

fn violation(violation: &Violation) -> Value {
    json!({
        "law": violation.law.name(),
        "element": element(violation.element),
        "count": violation.count,
        "faces": violation.faces,
        "absent_vertex": violation.absent_vertex.map(|(vertex, _)| vertex),
        "remedy": remedy(violation.law),
        "message": sentence(violation),
    })
}
