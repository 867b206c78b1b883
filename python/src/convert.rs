//! Conversion with and without coordinates.

use numpy::PyArray2;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use triquad::{
    Algorithm, Augmentation, Converter, Cost, DefaultCost, Mesh, Report, ShapeCost, Triangulation,
    UnknownNameError,
};

use crate::arrays::{faces_alone, indices, positions, table};
use crate::failure::Failure;
use crate::worker;

/// The options of a conversion, checked for type by the Python half.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Options {
    algorithm: String,
    augmentation: String,
    cost: String,
    orient: bool,
    seed: u64,
}

/// A quad array, JSON and a summary of the report, and the triangles paired if edges were flipped.
type Converted<'py> =
    (Bound<'py, PyArray2<u32>>, String, String, Option<Bound<'py, PyArray2<u32>>>);

/// Converts arrays.
#[pyfunction]
pub fn convert<'py>(
    py: Python<'py>,
    vertices: &Bound<'py, PyAny>,
    triangles: &Bound<'py, PyAny>,
    options: Options,
) -> PyResult<Converted<'py>> {
    let algorithm: Algorithm = named("algorithm", &options.algorithm)?;
    let augmentation: Augmentation = named("augmentation", &options.augmentation)?;
    let cost = cost(&options.cost)?;
    let positions = positions(vertices)?;
    let mesh = Mesh::from_triangles(positions, indices("triangles", triangles)?);
    let (quads, report, flipped) = worker::run(py, move |cancel| {
        let converted = Converter::new()
            .algorithm(algorithm)
            .augmentation(augmentation)
            .cost(cost)
            .orient(options.orient)
            .seed(options.seed)
            .progress(&mut cancel.clone())
            .run(mesh)?;
        let report = converted.report().clone();
        let flips = report.edge_flips > 0;
        let flipped = flips.then(|| converted.triangles().corners().to_vec());
        Ok((converted.into_mesh().into_parts().1.into_corners(), report, flipped))
    })?;
    let flipped = flipped.map(|flipped| table(py, flipped, 3)).transpose()?;
    Ok((table(py, quads, 4)?, json(&report)?, report.to_string(), flipped))
}

/// Pairs triangles without coordinates; row by row the lower and the upper triangle of a pair.
#[pyfunction]
pub fn pair<'py>(
    py: Python<'py>,
    triangles: &Bound<'py, PyAny>,
    options: Options,
) -> PyResult<(Bound<'py, PyArray2<u32>>, String, String)> {
    let algorithm: Algorithm = named("algorithm", &options.algorithm)?;
    let augmentation: Augmentation = named("augmentation", &options.augmentation)?;
    let mut mesh = faces_alone("triangles", indices::<3>("triangles", triangles)?)?;
    let (pairs, report) = worker::run(py, move |cancel| {
        let triangulation = Triangulation::build_oriented(&mut mesh, options.orient)?;
        let mut progress = cancel.clone();
        let mut converter = Converter::new().algorithm(algorithm).augmentation(augmentation);
        converter = converter.seed(options.seed).progress(&mut progress);
        let paired = converter.quadrangulate(&triangulation)?;
        let pair = |&side| [side, triangulation.twin(side)].map(|h| h.triangle().index() as u32);
        let pairs: Vec<u32> = paired.quadrangulation.removed().iter().flat_map(pair).collect();
        Ok((pairs, paired.report))
    })?;
    Ok((table(py, pairs, 2)?, json(&report)?, report.to_string()))
}

/// Reads the name of an algorithm or the like, given for an argument.
pub fn named<T: std::str::FromStr<Err = UnknownNameError>>(
    argument: &str,
    name: &str,
) -> PyResult<T> {
    name.parse().map_err(|error| PyValueError::new_err(format!("{argument}: {error}")))
}

fn cost(name: &str) -> Result<&'static dyn Cost, Failure> {
    match name {
        "default" => Ok(&DefaultCost),
        "shape" => Ok(&ShapeCost),
        _ => Err(Failure::Value(format!("cost: {name:?} is no cost; use one of: default, shape"))),
    }
}

fn json(report: &Report) -> PyResult<String> {
    serde_json::to_string(report).map_err(|error| PyValueError::new_err(error.to_string()))
}
