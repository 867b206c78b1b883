//! Irreducible and simplified triangulations.

use pyo3::prelude::*;
use serde_json::json;
use triquad::irreducible::{Contractor, Irreducible, Order, check_irreducible};
use triquad::simplify::{Simplifier, SimplifyError};
use triquad::{Mesh, Triangulation};

use crate::arrays::{MeshArrays, faces_alone, indices, positions, table};
use crate::convert::named;
use crate::failure::Failure;
use crate::typed::{AnyArray, NewArray};
use crate::worker::{self, Cancel};

/// Vertices removed between two looks at the caller's word.
const STEP: usize = 1 << 14;

/// Contracts edges until none can be. Returns triangles on the vertices of the input, and counts.
#[pyfunction]
pub fn irreducible<'py>(
    py: Python<'py>,
    triangles: AnyArray<'py>,
    algorithm: &str,
    order: &str,
    seed: u64,
) -> PyResult<(NewArray<'py, u32>, String)> {
    let algorithm: Contractor = named("algorithm", algorithm)?;
    let order: Order = named("order", order)?;
    let mesh = faces_alone("triangles", indices::<3>("triangles", &triangles)?)?;
    let (left, counts) = worker::run(py, 0, move |_| {
        let triangulation = Triangulation::build(&mesh)?;
        let size = (triangulation.component_count(), triangulation.genus());
        let counts = input_counts(&triangulation);
        let result = algorithm.reduce(triangulation, order, seed);
        let report_this = |problem| Failure::Value(format!("please report this: {problem}"));
        check_irreducible(&result.mesh(&mesh), size.0, size.1).map_err(report_this)?;
        Ok((in_input(&result), with_result(counts, &result)))
    })?;
    Ok((table(py, left, 3)?, counts.to_string()))
}

/// Simplifies to a number of vertices. Returns the vertices and triangles left.
#[pyfunction]
pub fn simplify<'py>(
    py: Python<'py>,
    vertices: AnyArray<'py>,
    triangles: AnyArray<'py>,
    vertex_count: usize,
) -> PyResult<MeshArrays<'py>> {
    let mesh = Mesh::from_triangles(positions(&vertices)?, indices("triangles", &triangles)?);
    let simplified = worker::run(py, 0, move |cancel| {
        let triangulation = Triangulation::build(&mesh)?;
        let mut simplifier = Simplifier::new(triangulation, mesh.positions());
        drop(mesh);
        reduce_to(&mut simplifier, vertex_count, cancel)?;
        Ok(simplifier.result().0)
    })?;
    let (positions, faces) = simplified.into_parts();
    Ok((table(py, positions.into_flattened(), 3)?, table(py, faces.into_corners(), 3)?))
}

/// Simplifies step by step.
fn reduce_to(simplifier: &mut Simplifier, vertices: usize, cancel: &Cancel) -> Result<(), Failure> {
    while simplifier.vertex_count() > vertices.saturating_add(STEP) {
        if cancel.is_set() {
            return Err(Failure::Stopped);
        }
        if simplifier.reduce_to(simplifier.vertex_count() - STEP).is_err() {
            break;
        }
    }
    simplifier.reduce_to(vertices).map_err(|error| {
        let remedy = match error {
            SimplifyError::TooMany { present, .. } => format!("; ask for {present} or fewer"),
            SimplifyError::Irreducible { reached, .. } => format!("; ask for {reached} or more"),
            _ => String::new(),
        };
        Failure::Value(format!("vertex_count: {error}{remedy}"))
    })
}

/// Returns the triangles left, on the vertices of the input.
fn in_input(result: &Irreducible) -> Vec<u32> {
    let old = |v: triquad::triangulation::VertexId| result.vertices[v.index()].index() as u32;
    let corners = |f| result.triangulation.corners(f).map(old);
    result.triangulation.triangles().flat_map(corners).collect()
}

fn input_counts(triangulation: &Triangulation) -> serde_json::Value {
    json!({
        "vertices": triangulation.vertex_count(),
        "edges": triangulation.edge_count(),
        "triangles": triangulation.triangle_count(),
        "genus": triangulation.genus(),
        "components": triangulation.component_count(),
    })
}

fn with_result(mut counts: serde_json::Value, result: &Irreducible) -> serde_json::Value {
    counts["result_vertices"] = result.triangulation.vertex_count().into();
    counts["result_edges"] = result.triangulation.edge_count().into();
    counts["result_triangles"] = result.triangulation.triangle_count().into();
    counts["contractions"] = result.contractions.into();
    counts["link_condition_tests"] = result.counts.link_condition_tests.into();
    counts["edges_tested_more_than_once"] = result.counts.edges_tested_more_than_once.into();
    counts
}
