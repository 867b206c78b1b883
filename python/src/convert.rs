//! Conversion with and without coordinates.

use numpy::PyReadonlyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use triquad::convert::Aims;
use triquad::mesh::Faces;
use triquad::{
    Algorithm, Augmentation, Converter, DefaultCost, Mesh, Report, ShapeCost, Triangulation,
    UnknownNameError,
};

use crate::arrays::{faces_alone, indices, positions, table};
use crate::failure::Failure;
use crate::typed::{AnyArray, NewArray};
use crate::worker;

/// The options of a conversion, checked for type by the Python half.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Options<'py> {
    algorithm: String,
    augmentation: String,
    orient: bool,
    seed: u64,
    threads: usize,
    /// The name of a cost, or one for each edge.
    cost: Costs<'py>,
    keep_sharp: Option<f64>,
    keep_edges: Option<AnyArray<'py>>,
    strict: bool,
    open: bool,
    quad_dominant: Option<f64>,
}

#[derive(FromPyObject)]
enum Costs<'py> {
    Named(String),
    Listed(PyReadonlyArray1<'py, i32>),
}

/// What comes of a conversion: a dictionary in Python.
#[derive(IntoPyObject)]
pub struct Converted<'py> {
    quads: NewArray<'py, u32>,
    leftover: NewArray<'py, u32>,
    given_up: NewArray<'py, u32>,
    /// The triangles paired, if edges were flipped.
    triangulation: Option<NewArray<'py, u32>>,
    /// JSON.
    report: String,
    summary: String,
}

/// Converts arrays.
#[pyfunction]
#[pyo3(signature = (vertices, triangles, options: "dict[str, Any]") -> "dict[str, Any]")]
pub fn convert<'py>(
    py: Python<'py>,
    vertices: AnyArray<'py>,
    triangles: AnyArray<'py>,
    options: Options<'py>,
) -> PyResult<Converted<'py>> {
    let algorithm: Algorithm = named("algorithm", &options.algorithm)?;
    let augmentation: Augmentation = named("augmentation", &options.augmentation)?;
    let aims = options.aims()?;
    let mesh = Mesh::from_triangles(positions(&vertices)?, indices("triangles", &triangles)?);
    let Options { orient, open, seed, threads, .. } = options;
    let (faces, given_up, flipped, report) = worker::run(py, threads, move |cancel| {
        let mut progress = cancel.clone();
        let mut converter = Converter::new().algorithm(algorithm).augmentation(augmentation);
        converter = converter.orient(orient).open(open).seed(seed).aims(aims);
        let converted = converter.progress(&mut progress).run(mesh);
        let converted = converted.map_err(|error| Failure::of_conversion(error, open, orient))?;
        let report = converted.report().clone();
        let given_up = converted.given_up().to_vec();
        let flips = report.edge_flips > 0;
        let flipped = flips.then(|| converted.triangles().corners().to_vec());
        Ok((by_arity(converted.into_mesh().into_parts().1), given_up, flipped, report))
    })?;
    Ok(Converted {
        quads: table(py, faces.0, 4)?,
        leftover: table(py, faces.1, 3)?,
        given_up: table(py, given_up.into_flattened(), 2)?,
        triangulation: flipped.map(|flipped| table(py, flipped, 3)).transpose()?,
        report: json(&report)?,
        summary: report.to_string(),
    })
}

impl Options<'_> {
    /// Returns what `best` aims at.
    fn aims(&self) -> PyResult<Aims<'static>> {
        let mut aims = Aims::default();
        let mut unit = DefaultCost::UNIT;
        match &self.cost {
            Costs::Named(name) if name == "default" => {}
            Costs::Named(name) if name == "shape" => {
                aims.cost = Some(&ShapeCost);
                unit = ShapeCost::UNIT;
            }
            Costs::Named(name) => {
                let problem = format!("cost: {name:?} is no cost; use default, shape or an array");
                return Err(PyValueError::new_err(problem));
            }
            Costs::Listed(costs) => {
                aims.listed_costs = Some(costs.as_array().to_vec());
                unit = 1.0;
            }
        }
        aims.keep.sharp = self.keep_sharp;
        if let Some(edges) = &self.keep_edges {
            aims.keep.edges = indices("keep_edges", edges)?;
        }
        aims.strict = self.strict;
        // A cast saturates: a price beyond 32 bits means that nothing is left that need not be.
        aims.price = self.quad_dominant.map(|price| (price * unit).round() as i32);
        Ok(aims)
    }
}

/// Returns the corners of all quads and those of all triangles.
fn by_arity(faces: Faces) -> (Vec<u32>, Vec<u32>) {
    if faces.arity() == Some(4) {
        return (faces.into_corners(), Vec::new());
    }
    let of = |arity| faces.iter().filter(|face| face.len() == arity).flatten().copied().collect();
    (of(4), of(3))
}

/// Pairs triangles without coordinates; row by row the lower and the upper triangle of a pair.
#[pyfunction]
#[pyo3(signature = (triangles, options: "dict[str, Any]"))]
pub fn pair<'py>(
    py: Python<'py>,
    triangles: AnyArray<'py>,
    options: Options<'py>,
) -> PyResult<(NewArray<'py, u32>, String, String)> {
    let algorithm: Algorithm = named("algorithm", &options.algorithm)?;
    let augmentation: Augmentation = named("augmentation", &options.augmentation)?;
    let mut mesh = faces_alone("triangles", indices::<3>("triangles", &triangles)?)?;
    let Options { orient, seed, threads, .. } = options;
    let (pairs, report) = worker::run(py, threads, move |cancel| {
        let built = if orient {
            Triangulation::build_oriented(&mut mesh)
        } else {
            Triangulation::build(&mesh)
        };
        let triangulation = built?;
        let mut progress = cancel.clone();
        let mut converter = Converter::new().algorithm(algorithm).augmentation(augmentation);
        converter = converter.seed(seed).progress(&mut progress);
        let paired = converter.quadrangulate(&triangulation);
        let paired = paired.map_err(|error| Failure::of_conversion(error, false, orient))?;
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

fn json(report: &Report) -> PyResult<String> {
    serde_json::to_string(report).map_err(|error| PyValueError::new_err(error.to_string()))
}
