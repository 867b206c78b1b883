//! Reads input meshes; words what is wrong with them.

use std::path::Path;

use triquad::mesh::{Format, MeshError};
use triquad::triangulation::OpenTriangulation;
use triquad::{Element, Mesh, Survey, Triangulation};

use crate::failure::{Facts, Failure};
use crate::stdio;

/// Options that turn a mesh into a triangulation.
#[derive(clap::Args, Clone, Copy)]
pub struct Repairs {
    /// Flip faces until neighbours agree on orientation
    #[arg(long)]
    pub orient: bool,
    /// Cut faces of four or more corners into triangles first
    #[arg(long)]
    pub triangulate: bool,
}

/// Reads a mesh.
pub fn read(path: &Path) -> Result<Mesh, Failure> {
    Mesh::read(path).map_err(|error| mesh_failure(path, &error))
}

/// Prints on standard error the content of the file that is not carried over.
pub fn tell_left_out(path: &Path, left_out: &[String]) {
    if !left_out.is_empty() {
        let what = left_out.join(", ");
        stdio::note(&format!("{}: note: not carried over: {what}", path.display()));
    }
}

/// Returns the content of `mesh` that a result of positions and triangles alone leaves out.
pub fn left_out_of_triangles(mesh: &Mesh) -> Vec<String> {
    let attributes = mesh.attributes().filter(|attributes| !attributes.is_empty());
    let attributes =
        attributes.map(|_| "texture coordinates, normals, groups and materials".to_owned());
    mesh.left_out().iter().cloned().chain(attributes).collect()
}

/// Reads a mesh that must be a triangulation of closed surfaces, after its repairs.
pub fn read_triangulation(path: &Path, repairs: Repairs) -> Result<Mesh, Failure> {
    let mut mesh = read(path)?;
    build(path, &mut mesh, repairs)?;
    Ok(mesh)
}

/// Builds the triangulation of a mesh read from `path`, after its repairs.
pub fn build(path: &Path, mesh: &mut Mesh, repairs: Repairs) -> Result<Triangulation, Failure> {
    if repairs.triangulate {
        mesh.triangulate();
    }
    let triangulation = Triangulation::build_oriented(mesh, repairs.orient);
    triangulation.map_err(|survey| {
        let opens = survey.is_open_surface(repairs.orient);
        let remedy = opens.then_some("only 'convert --open' and check take it as it is");
        refusal(path, &survey, remedy)
    })
}

/// A surface with its mesh.
pub enum Built {
    Closed(Triangulation),
    /// With boundary or one-sided, and what makes it so.
    Open(OpenTriangulation, Box<Survey>),
}

/// Reads a mesh that must be a triangulation of surfaces, closed or not, after its repairs.
pub fn read_surface(path: &Path, repairs: Repairs) -> Result<(Mesh, Built), Failure> {
    let mut mesh = read(path)?;
    if repairs.triangulate {
        mesh.triangulate();
    }
    let survey = match Triangulation::build_oriented(&mut mesh, repairs.orient) {
        Ok(triangulation) => return Ok((mesh, Built::Closed(triangulation))),
        Err(survey) => survey,
    };
    if !survey.is_open_surface(repairs.orient) {
        return Err(refusal(path, &survey, None));
    }
    if repairs.orient {
        survey.orient(&mut mesh);
    }
    let open = OpenTriangulation::build(&mesh).map_err(|survey| refusal(path, &survey, None))?;
    Ok((mesh, Built::Open(open, survey)))
}

/// Makes the failure of a file that could not be read or written.
pub fn mesh_failure(path: &Path, error: &MeshError) -> Failure {
    let remedy = error.remedy().to_owned();
    let failure = Failure::bad(format!("{}: {error}; {remedy}", path.display()));
    let file = path.display().to_string();
    failure.with(Facts { file, law: None, element: None, count: None, remedy })
}

/// Makes the failure of a mesh that is no triangulation: its first broken law, the number of
/// others, and a second remedy if there is one.
pub fn refusal(path: &Path, survey: &Survey, other_remedy: Option<&str>) -> Failure {
    let first = survey.violations[0];
    let others = match survey.violations.len() - 1 {
        0 => String::new(),
        1 => " (and 1 other law is broken, see 'triquad info')".into(),
        more => format!(" (and {more} other laws are broken, see 'triquad info')"),
    };
    // Readers of OBJ files expect numbers that count from 1.
    let from_one = match (Format::from_path(path), first.element) {
        (Ok(Format::Obj), _) | (_, Element::Mesh) => "",
        _ => ", counted from 1",
    };
    let name = first.law.name();
    let remedies = [Some(first.law.remedy()), other_remedy];
    let remedy = remedies.into_iter().flatten().collect::<Vec<_>>().join("; ");
    let file = path.display().to_string();
    let message = format!("{file}: {first}{from_one} [{name}]{others}; {remedy}");
    let element = Some(first.element.to_string());
    let facts = Facts { file, law: Some(name), element, count: Some(first.count), remedy };
    Failure::bad(message).with(facts)
}
