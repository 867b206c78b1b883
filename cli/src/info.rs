//! `triquad info`.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use serde::Serialize;
use triquad::counted::counted;
use triquad::{Law, Mesh, Survey, Triangulation, Violation};

use crate::failure::Failure;
use crate::formats::reads;
use crate::input::{Fate, Repairs};
use crate::progress::StatusLine;
use crate::remedies::Refused;
use crate::{input, shell, stdio};

/// Print counts, genus and components of a mesh, and every law that it breaks
///
/// Exit code 2 if convert refuses the mesh without further options; all counts are printed anyway.
/// The options that help are named.
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  triquad info bunny.obj\n  triquad info scan.stl --json")]
pub struct Arguments {
    #[arg(value_name = "IN", help = reads("The mesh"))]
    input: PathBuf,
    #[command(flatten)]
    repairs: Repairs,
}

/// Everything that is printed of a mesh.
#[derive(Serialize)]
struct Info {
    schema: &'static str,
    input: String,
    vertices: usize,
    unreferenced_vertices: usize,
    edges: usize,
    faces: usize,
    triangles: usize,
    quads: usize,
    euler_characteristic: i64,
    /// Handles of the two-sided components, where the faces are surfaces with holes or without;
    /// none if there are no handles and a component is one-sided.
    genus: Option<usize>,
    non_orientable_genus: Option<usize>,
    components: usize,
    boundary_loops: usize,
    orientable: bool,
    closed: bool,
    /// Known where the mesh is not closed.
    closed_by_welding: Option<bool>,
    /// The least distance for `--weld` that closes the mesh.
    welding_distance: Option<f64>,
    /// Options with which `convert` takes the mesh, if there are any.
    convert_options: Option<String>,
    violations: Vec<Broken>,
    left_out: Vec<String>,
    /// Those of `left_out` that options have changed.
    #[serde(skip)]
    repairs: Vec<String>,
}

/// A broken law with its remedy.
#[derive(Serialize)]
struct Broken {
    law: Law,
    element: String,
    count: usize,
    /// Faces there, counted from 1 as elements are.
    faces: Vec<usize>,
    /// The vertex that the first face names and that does not exist, counted from 1.
    absent_vertex: Option<u64>,
    remedy: String,
    #[serde(skip)]
    message: String,
}

/// Reads the mesh and prints its counts and the laws that it breaks.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let status = StatusLine::new("reading the mesh");
    let Arguments { input, repairs } = arguments;
    let mut mesh = input::read(input, repairs.reading)?;
    status.say("examining the mesh");
    input::repair(input, &mut mesh, *repairs)?;
    if repairs.orient {
        Survey::new(&mesh).orient(&mut mesh);
    }
    let info = Info::new(input.display().to_string(), &mesh, *repairs);
    drop(status);
    let text = if stdio::voice().json {
        serde_json::to_string_pretty(&info).map_err(|error| Failure::bad(error.to_string()))?
    } else {
        describe(&info)
    };
    stdio::say(&text)?;
    let laws = match info.violations.len() {
        0 => return Ok(()),
        laws => counted(laws, "law", "laws"),
    };
    let way = match &info.convert_options {
        Some(options) => {
            let input = shell::word(input);
            format!("it can be converted with 'triquad convert {input} {options}'")
        }
        None => "it cannot be converted as it is".into(),
    };
    Err(Failure::bad(format!("{}: breaks {laws}, {way}", info.input)))
}

const SCHEMA: &str = "triquad-info-1";

impl Info {
    fn new(input: String, mesh: &Mesh, repairs: Repairs) -> Self {
        let mut info = match Triangulation::build(mesh) {
            Ok(triangulation) => Self::from_triangulation(input, &triangulation),
            Err(survey) => {
                let refused = Refused::new(mesh, Path::new(&input), repairs);
                Self::from_survey(input.clone(), &survey, &refused)
            }
        };
        info.quads = mesh.faces().iter().filter(|face| face.len() == 4).count();
        let fate = Fate::of(mesh);
        info.left_out = fate.all();
        info.repairs = fate.repairs;
        info
    }

    fn from_triangulation(input: String, triangulation: &Triangulation) -> Self {
        Self {
            schema: SCHEMA,
            input,
            vertices: triangulation.vertex_count(),
            unreferenced_vertices: triangulation.unreferenced_vertex_count(),
            edges: triangulation.edge_count(),
            faces: triangulation.triangle_count(),
            triangles: triangulation.triangle_count(),
            quads: 0,
            euler_characteristic: triangulation.euler_characteristic(),
            genus: Some(triangulation.genus()),
            non_orientable_genus: None,
            components: triangulation.component_count(),
            boundary_loops: 0,
            orientable: true,
            closed: true,
            closed_by_welding: None,
            welding_distance: None,
            convert_options: None,
            violations: Vec::new(),
            left_out: Vec::new(),
            repairs: Vec::new(),
        }
    }

    fn from_survey(input: String, survey: &Survey, refused: &Refused) -> Self {
        let welding_distance = refused.closing_distance().filter(|_| !survey.closed);
        let way = refused.options();
        let stays_open = way.as_ref().is_some_and(|way| way.is_open);
        let broken = |violation| Broken::new(violation, refused, stays_open);
        Self {
            schema: SCHEMA,
            input,
            vertices: survey.vertices,
            unreferenced_vertices: survey.unreferenced_vertices,
            edges: survey.edges,
            faces: survey.faces,
            triangles: survey.triangles,
            quads: 0,
            euler_characteristic: survey.euler_characteristic,
            genus: survey.filled_genus(),
            non_orientable_genus: survey.non_orientable_genus(),
            components: survey.components,
            boundary_loops: survey.boundary_loops,
            orientable: survey.orientable,
            closed: survey.closed,
            closed_by_welding: (!survey.closed).then_some(welding_distance.is_some()),
            welding_distance,
            convert_options: way.map(|way| way.to_string()),
            violations: survey.violations.iter().map(broken).collect(),
            left_out: Vec::new(),
            repairs: Vec::new(),
        }
    }
}

impl Broken {
    fn new(violation: &Violation, refused: &Refused, stays_open: bool) -> Self {
        let or_open = match violation.law {
            Law::NoBoundary if stays_open => "; or keep them with --open",
            Law::Orientable if stays_open => "; or keep it one-sided with --open",
            _ => "",
        };
        Self {
            law: violation.law,
            element: violation.element.to_string(),
            count: violation.count,
            faces: violation.faces.iter().map(|face| face + 1).collect(),
            absent_vertex: violation.absent_vertex.map(|(v, _)| u64::from(v) + 1),
            remedy: format!("{}{or_open}", refused.remedy(violation)),
            message: violation.to_string(),
        }
    }
}

/// Writes a line a count, then two lines a broken law.
fn describe(info: &Info) -> String {
    // As convert --open has it: holes count as filled, one-sided components apart.
    let filled = |genus: usize| match info.boundary_loops {
        0 => genus.to_string(),
        1 => format!("{genus} with its hole filled"),
        _ => format!("{genus} with its holes filled"),
    };
    let genus = match (info.genus, info.non_orientable_genus) {
        (Some(genus), _) => filled(genus),
        (None, Some(_)) => "none (the surface is one-sided)".into(),
        (None, None) => "none (the faces are no surface)".into(),
    };
    // The Euler characteristic counts the other faces.
    let counted_faces = info.euler_characteristic - info.vertices as i64 + info.edges as i64;
    let mut faces = format!("{} ({})", info.faces, kinds_of_faces(info));
    if counted_faces < info.faces as i64 {
        let _ = write!(faces, ", {} in no other count", info.faces as i64 - counted_faces);
    }
    let yes_no = |yes| String::from(if yes { "yes" } else { "no" });
    let cross_caps = info.non_orientable_genus.map(filled);
    let closed = match info.welding_distance {
        Some(0.0) => "no, but it is with --weld: vertices are at equal coordinates".into(),
        Some(distance) => format!("no, but it is with --weld {distance:e}"),
        None if info.closed || info.boundary_loops > 0 || info.faces == 0 => yes_no(info.closed),
        None if info.edges == 0 => "no: no face has three corners of its own".into(),
        None => "no: some edges belong to more than two faces".into(),
    };
    let rows = [
        ("vertices", info.vertices.to_string()),
        ("unreferenced vertices", info.unreferenced_vertices.to_string()),
        ("edges", info.edges.to_string()),
        ("faces", faces),
        ("Euler characteristic", info.euler_characteristic.to_string()),
        ("genus", genus),
        ("non-orientable genus", cross_caps.unwrap_or_default()),
        ("components", info.components.to_string()),
        ("boundary loops", info.boundary_loops.to_string()),
        ("orientable", yes_no(info.orientable)),
        ("closed", closed),
    ];
    let mut text = stdio::one_line(&info.input);
    for (name, value) in rows.into_iter().filter(|(_, value)| !value.is_empty()) {
        let _ = write!(text, "\n  {name:<21}  {value}");
    }
    let not_read = &info.left_out[..info.left_out.len() - info.repairs.len()];
    for what in &info.repairs {
        let _ = write!(text, "\n  {:<21}  {what}", "repaired");
    }
    for what in not_read {
        let _ = write!(text, "\n  {:<21}  {}", "not read", stdio::one_line(what));
    }
    for Broken { law, remedy, message, .. } in &info.violations {
        let _ = write!(text, "\n  broken: {message} [{law}]\n          {remedy}");
    }
    text
}

/// Returns the numbers of triangles, quads and larger faces, as far as there are any.
fn kinds_of_faces(info: &Info) -> String {
    let others = info.faces - info.triangles - info.quads;
    let mut kinds = Vec::new();
    if info.triangles > 0 || info.quads + others == 0 {
        kinds.push(counted(info.triangles, "triangle", "triangles"));
    }
    if info.quads > 0 {
        kinds.push(counted(info.quads, "quad", "quads"));
    }
    if others > 0 {
        kinds.push(counted(others, "other", "others"));
    }
    kinds.join(", ")
}
