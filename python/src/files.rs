//! Mesh files.

use std::path::PathBuf;

use pyo3::prelude::*;
use triquad::Mesh;
use triquad::mesh::{CutError, Faces};

use crate::arrays::{MeshArrays, indices, positions, table};
use crate::failure::{Failure, MeshFailure};
use crate::repair::welded;
use crate::typed::AnyArray;
use crate::worker;

/// Reads a mesh file and repairs it, in this order. Returns positions and faces of one size.
#[pyfunction]
pub fn read(
    py: Python<'_>,
    path: PathBuf,
    weld: Option<f64>,
    clean: bool,
    triangulate: bool,
) -> PyResult<MeshArrays<'_>> {
    let (mesh, arity) = worker::run(py, 0, move |_| {
        let mut mesh = Mesh::read(&path).map_err(|error| Failure::of_file(error, path.clone()))?;
        if let Some(distance) = weld {
            welded("weld", &mut mesh, distance)?;
        }
        if clean {
            mesh.clean();
        }
        if triangulate {
            mesh.triangulate().map_err(|error| no_cut(&path, error))?;
        }
        let arity = mesh.faces().arity().ok_or_else(|| mixed(&path))?;
        Ok((mesh, arity))
    })?;
    let (positions, faces) = mesh.into_parts();
    Ok((table(py, positions.into_flattened(), 3)?, table(py, faces.into_corners(), arity)?))
}

fn no_cut(path: &std::path::Path, error: CutError) -> Failure {
    let remedy = "the mesh may be sound: cut this face in another program".to_owned();
    Failure::Mesh(Box::new(MeshFailure {
        message: format!("{}: {error}; {remedy}", path.display()),
        law: "no-cut",
        element: ("face", vec![error.face as u64]),
        count: 1,
        remedy,
    }))
}

fn mixed(path: &std::path::Path) -> Failure {
    let remedy = "triangulate=True cuts larger faces into triangles".to_owned();
    Failure::Mesh(Box::new(MeshFailure {
        message: format!("{}: faces differ in size; {remedy}", path.display()),
        law: "mixed-faces",
        element: ("file", vec![]),
        count: 1,
        remedy,
    }))
}

/// Writes a mesh file of triangles or quads, and triangles left over behind them.
#[pyfunction]
pub fn write(
    py: Python<'_>,
    path: PathBuf,
    vertices: AnyArray<'_>,
    faces: AnyArray<'_>,
    arity: usize,
    leftover: Option<AnyArray<'_>>,
) -> PyResult<()> {
    let positions = positions(&vertices)?;
    let corners = match arity {
        3 => indices::<3>("faces", &faces)?.into_flattened(),
        _ => indices::<4>("faces", &faces)?.into_flattened(),
    };
    let leftover = leftover.map(|array| indices::<3>("leftover", &array)).transpose()?;
    worker::run(py, 0, move |_| {
        let mut faces = Faces::uniform(arity, corners);
        faces.extend(leftover.unwrap_or_default());
        let mesh = Mesh::new(positions, faces);
        mesh.write(&path).map_err(|error| Failure::of_file(error, path))
    })
}
