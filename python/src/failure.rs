//! Failures on their way to Python exceptions. Elements count from 0, as arrays do.

use std::io;
use std::path::PathBuf;

use pyo3::exceptions::{PyKeyboardInterrupt, PyValueError};
use pyo3::prelude::*;
use triquad::counted::counted;
use triquad::mesh::{MeshError, Place};
use triquad::{CheckError, ConvertError, Element, Law, Survey, Violation};

/// A reason why a call has no result.
#[derive(Debug)]
pub enum Failure {
    /// `triquad.MeshError`: something is wrong with a mesh.
    Mesh(Box<MeshFailure>),
    /// `triquad.InfeasibleError`: no perfect matching; holds the nodes of a barrier.
    Infeasible(Vec<u32>),
    /// `ValueError`: something is wrong with another argument.
    Value(String),
    /// `OSError` of a file.
    File(io::Error, PathBuf),
    /// The caller has gone.
    Stopped,
}

/// The attributes of a `triquad.MeshError`.
#[derive(Debug)]
pub struct MeshFailure {
    pub message: String,
    pub law: &'static str,
    pub element: PythonElement,
    pub count: usize,
    pub remedy: String,
}

/// Kind and indices of an element.
pub type PythonElement = (&'static str, Vec<u64>);

impl From<Failure> for PyErr {
    fn from(failure: Failure) -> Self {
        match failure {
            Failure::Mesh(failure) => {
                let MeshFailure { message, law, element, count, remedy } = *failure;
                raise("mesh_error", (message, law, element, count, remedy))
            }
            Failure::Infeasible(barrier) => raise("infeasible_error", (barrier,)),
            Failure::Value(message) => PyValueError::new_err(message),
            Failure::File(error, path) => match error.raw_os_error() {
                Some(code) => raise("file_error", (code, error.to_string(), path)),
                None => raise("file_error", (code_name(&error), error.to_string(), path)),
            },
            Failure::Stopped => PyKeyboardInterrupt::new_err(()),
        }
    }
}

/// Returns the name of the code of an error that has lost it.
fn code_name(error: &io::Error) -> Option<&'static str> {
    match error.kind() {
        io::ErrorKind::NotFound => Some("ENOENT"),
        io::ErrorKind::PermissionDenied => Some("EACCES"),
        io::ErrorKind::IsADirectory => Some("EISDIR"),
        io::ErrorKind::NotADirectory => Some("ENOTDIR"),
        io::ErrorKind::ReadOnlyFilesystem => Some("EROFS"),
        _ => None,
    }
}

/// Returns the exception that a function of `triquad._errors` makes.
fn raise(maker: &str, arguments: impl for<'py> pyo3::call::PyCallArgs<'py>) -> PyErr {
    Python::attach(|py| {
        let made = py.import("triquad._errors").and_then(|errors| errors.getattr(maker));
        match made.and_then(|maker| maker.call1(arguments)) {
            Ok(exception) => PyErr::from_value(exception),
            Err(error) => error,
        }
    })
}

impl From<Box<Survey>> for Failure {
    fn from(survey: Box<Survey>) -> Self {
        Self::refusal(&survey, "")
    }
}

impl Failure {
    /// Makes the failure of a check of `quads` quads and triangles left over behind them.
    pub fn of_check(mismatch: CheckError, quads: usize) -> Self {
        let (law, element) = place(mismatch);
        let argument = match (law, element.1.first()) {
            ("bad-triangle" | "triangle-twice" | "triangle-unused", _) => "triangles",
            (_, Some(&face)) if element.0 == "face" && face >= quads as u64 => "leftover",
            _ => "quads",
        };
        let message = format!("{argument}: {mismatch} (counted from 1)");
        let remedy = String::new();
        Self::Mesh(Box::new(MeshFailure { message, law, element, count: 1, remedy }))
    }

    /// Makes the failure of a mesh that is refused: names the first broken law, the number of
    /// others, and a second remedy.
    fn refusal(survey: &Survey, other_remedy: &str) -> Self {
        let first = &survey.violations[0];
        let others = match survey.violations.len() - 1 {
            0 => String::new(),
            more => {
                let more = counted(more, "other law is", "other laws are");
                format!(" ({more} broken, see triquad.survey)")
            }
        };
        let argument = if first.law == Law::FiniteCoordinate { "vertices" } else { "triangles" };
        let remedy = remedy(first.law).to_owned() + other_remedy;
        Self::Mesh(Box::new(MeshFailure {
            message: format!("{argument}: {}{others}; {remedy}", sentence(first)),
            law: first.law.name(),
            element: element(first.element),
            count: first.count,
            remedy,
        }))
    }

    /// Makes the failure of a conversion with the options `open` and `orient`.
    pub fn of_conversion(error: ConvertError, open: bool, orient: bool) -> Self {
        match error {
            ConvertError::Refused(survey) if !open && survey.is_open_surface(orient) => {
                Self::refusal(
                    &survey,
                    "; open=True converts it and leaves over as few triangles as possible",
                )
            }
            ConvertError::Refused(survey) => survey.into(),
            ConvertError::Stopped(_) => Self::Stopped,
            ConvertError::NoSuchEdge(edge) => {
                let [a, b] = edge.ends;
                let problem = format!("({a}, {b}) is no edge of the mesh");
                Self::Value(format!("keep_edges: row {}: {problem}", edge.position))
            }
            ConvertError::CostCount(_) | ConvertError::Costs(_) => {
                Self::Value(format!("cost: {error}"))
            }
            ConvertError::NeedsBest { .. } | ConvertError::NeedsClosed(_) => {
                Self::Value(format!("algorithm: {error}"))
            }
            error => Self::Value(error.to_string()),
        }
    }

    /// Makes the failure of a file that could not be read or written.
    pub fn of_file(error: MeshError, path: PathBuf) -> Self {
        let error = error.without_path();
        let (law, place) = match &error {
            MeshError::Malformed { place, .. } => ("malformed-file", Some(*place)),
            MeshError::Truncated { place, .. } => ("truncated-file", Some(*place)),
            MeshError::TooLarge => (Law::NotTooLarge.name(), None),
            MeshError::ReadOnly(_) => ("read-only-format", None),
            MeshError::Foreign { .. } => ("foreign-content", None),
            MeshError::Expanded(_) => ("expands-too-far", None),
            _ => ("unknown-format", None),
        };
        let remedy = match &error {
            MeshError::Expanded(_) => "decompress the file first".to_owned(),
            error => error.remedy().to_owned(),
        };
        let element = match place {
            Some(Place::Line(line)) => ("line", vec![line as u64]),
            Some(Place::Byte(byte)) => ("byte", vec![byte as u64]),
            _ => ("file", vec![]),
        };
        let message = format!("{}: {error}; {remedy}", path.display());
        match error {
            MeshError::Io(error) => Self::File(error, path),
            _ => Self::Mesh(Box::new(MeshFailure { message, law, element, count: 1, remedy })),
        }
    }

    /// Makes the failure of an index that no vertex can have, in row `row` of an array.
    pub fn index(message: String, row: usize, count: usize) -> Self {
        let remedy = "number vertices from 0 to len(vertices) - 1".to_owned();
        Self::Mesh(Box::new(MeshFailure {
            message: format!("{message}; {remedy}"),
            law: Law::IndexInRange.name(),
            element: ("face", vec![row as u64]),
            count,
            remedy,
        }))
    }
}

/// Returns kind and indices of an element.
pub fn element(element: Element) -> PythonElement {
    match element {
        Element::Mesh => ("mesh", vec![]),
        Element::Vertex(v) => ("vertex", vec![v.into()]),
        Element::Edge(a, b) => ("edge", vec![a.into(), b.into()]),
        Element::Face(face) => ("face", vec![face as u64]),
    }
}

/// Words a violation with indices that count from 0.
pub fn sentence(violation: &Violation) -> String {
    let (kind, indices) = element(violation.element);
    let subject = match indices[..] {
        [] => format!("the {kind}"),
        [index] => format!("{kind} {index}"),
        _ => format!("{kind} {indices:?}"),
    };
    format!("{subject} {}{}", violation.law.complaint(), violation.notes(0))
}

/// Returns the remedy, with options of this package where the library has a function.
pub fn remedy(law: Law) -> &'static str {
    match law {
        Law::Triangle => "triangulate=True cuts larger faces into triangles; remove smaller ones",
        Law::DistinctCorners => "triquad.clean drops degenerate triangles",
        Law::DistinctFaces => "triquad.clean drops triangles that are there twice",
        Law::NoBoundary => "close the holes, or use triquad.weld if the gaps are seams",
        Law::ConsistentOrientation => "orient=True flips faces until they agree",
        law => law.remedy(),
    }
}

/// Returns the name of what a check found and the element that it is about.
fn place(mismatch: CheckError) -> (&'static str, PythonElement) {
    use CheckError as E;
    let face = |face: usize| ("face", vec![face as u64]);
    let vertex = |vertex: usize| ("vertex", vec![vertex as u64]);
    let edge = |a: u32, b: u32| ("edge", vec![a.into(), b.into()]);
    match mismatch {
        E::BadTriangle(triangle, _) => ("bad-triangle", face(triangle)),
        E::NotAQuad(quad, _) => ("not-a-quad", face(quad)),
        E::NotATriangleOrQuad(quad, _) => ("not-a-triangle-or-quad", face(quad)),
        E::NotATriangle(left) => ("not-a-triangle", face(left)),
        E::Turned(quad) => ("turned", face(quad)),
        E::RepeatedCorner(quad) => ("repeated-corner", face(quad)),
        E::Reversed(quad) => ("reversed", face(quad)),
        E::NotAPair(quad) => ("not-a-pair", face(quad)),
        E::TriangleTwice(triangle) => ("triangle-twice", face(triangle)),
        E::TriangleUnused(triangle) => ("triangle-unused", face(triangle)),
        E::EdgeTwice(a, b) => ("edge-twice", edge(a, b)),
        E::EdgeOpen(a, b) => ("edge-open", edge(a, b)),
        E::Moved(v) => ("moved", vertex(v)),
        E::VertexUse(v) => ("vertex-use", vertex(v)),
        E::Fans(v) => ("several-fans", vertex(v)),
        E::Component(v) => ("component", vertex(v)),
        E::EulerCharacteristic { .. } => ("euler-characteristic", ("mesh", vec![])),
        _ => ("vertex-count", ("mesh", vec![])),
    }
}
