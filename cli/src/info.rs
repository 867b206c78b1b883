//! `triquad info`.

use std::path::PathBuf;

use serde::Serialize;
use triquad::Mesh;
use triquad::{Survey, Triangulation, Violation};

use crate::failure::Failure;
use crate::progress::StatusLine;
use crate::{input, stdio};

/// Tell what a mesh is: counts, genus, components, and every law that it breaks
///
/// Exit code 2 if the mesh is not a triangulation of closed surfaces; everything is still told.
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  triquad info bunny.obj\n  triquad info scan.stl --json")]
pub struct Arguments {
    /// The mesh: .obj .ply .off .stl, each also with .gz; '-' reads OBJ from standard input
    #[arg(value_name = "IN")]
    input: PathBuf,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

#[derive(Serialize)]
struct Info {
    schema: &'static str,
    input: String,
    vertices: usize,
    unreferenced_vertices: usize,
    edges: usize,
    faces: usize,
    triangles: usize,
    euler_characteristic: i64,
    genus: Option<usize>,
    components: usize,
    boundary_loops: usize,
    orientable: bool,
    closed: bool,
    violations: Vec<Broken>,
}

#[derive(Serialize)]
struct Broken {
    law: &'static str,
    element: String,
    count: usize,
    remedy: &'static str,
    #[serde(skip)]
    message: String,
}

/// Reads the mesh and prints what it is.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let status = StatusLine::new("reading the mesh");
    let list = input::read(&arguments.input)?;
    status.say("examining the mesh");
    let mut info = examine(&list);
    drop(status);
    info.input = arguments.input.display().to_string();
    if arguments.json {
        let json =
            serde_json::to_string_pretty(&info).map_err(|error| Failure::bad(error.to_string()))?;
        stdio::say(&json)?;
    } else {
        stdio::say(&describe(&info))?;
    }
    match info.violations.len() {
        0 => Ok(()),
        1 => Err(Failure::bad(format!(
            "{}: breaks a law, it cannot be converted as it is",
            info.input
        ))),
        laws => Err(Failure::bad(format!(
            "{}: breaks {laws} laws, it cannot be converted as it is",
            info.input
        ))),
    }
}

fn examine(list: &Mesh) -> Info {
    match Triangulation::build(list) {
        Ok(triangulation) => of_triangulation(&triangulation),
        Err(survey) => of_survey(&survey),
    }
}

const SCHEMA: &str = "triquad-info-1";

fn of_triangulation(triangulation: &Triangulation) -> Info {
    Info {
        schema: SCHEMA,
        input: String::new(),
        vertices: triangulation.vertex_count(),
        unreferenced_vertices: triangulation.unreferenced_vertex_count(),
        edges: triangulation.edge_count(),
        faces: triangulation.triangle_count(),
        triangles: triangulation.triangle_count(),
        euler_characteristic: triangulation.euler_characteristic(),
        genus: Some(triangulation.genus()),
        components: triangulation.component_count(),
        boundary_loops: 0,
        orientable: true,
        closed: true,
        violations: Vec::new(),
    }
}

fn of_survey(survey: &Survey) -> Info {
    let broken = |violation: &Violation| Broken {
        law: violation.law.name(),
        element: violation.element.to_string(),
        count: violation.count,
        remedy: violation.law.remedy(),
        message: violation.to_string(),
    };
    Info {
        schema: SCHEMA,
        input: String::new(),
        vertices: survey.vertices,
        unreferenced_vertices: survey.unreferenced_vertices,
        edges: survey.edges,
        faces: survey.faces,
        triangles: survey.triangles,
        euler_characteristic: survey.euler_characteristic,
        genus: survey.genus(),
        components: survey.components,
        boundary_loops: survey.boundary_loops,
        orientable: survey.orientable,
        closed: survey.closed,
        violations: survey.violations.iter().map(broken).collect(),
    }
}

fn describe(info: &Info) -> String {
    let genus = info
        .genus
        .map_or("none (not a closed, two-sided surface)".into(), |genus| genus.to_string());
    let yes_no = |yes| if yes { "yes" } else { "no" };
    let mut text = format!(
        "{}\n  vertices               {}\n  unreferenced vertices  {}\n  edges                  {}\n  \
         faces                  {} ({} triangles)\n  Euler characteristic   {}\n  genus                  {}\n  \
         components             {}\n  boundary loops         {}\n  orientable             {}\n  \
         closed                 {}",
        info.input,
        info.vertices,
        info.unreferenced_vertices,
        info.edges,
        info.faces,
        info.triangles,
        info.euler_characteristic,
        genus,
        info.components,
        info.boundary_loops,
        yes_no(info.orientable),
        yes_no(info.closed),
    );
    for broken in &info.violations {
        text += &format!(
            "\n  broken: {} [{}]\n          {}",
            broken.message, broken.law, broken.remedy
        );
    }
    text
}
