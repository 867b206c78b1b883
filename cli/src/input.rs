//! Reading an input mesh, and saying what is wrong with it.

use std::path::Path;

use triquad::mesh::{Format, MeshError};
use triquad::{Element, Mesh, Survey, Triangulation};

use crate::failure::Failure;
use crate::stdio;

/// What may be done to a mesh to make it a triangulation.
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

/// Tells on standard error what the file held and is not carried over.
pub fn tell_left_out(path: &Path, left_out: &[String]) {
    if !left_out.is_empty() {
        let what = left_out.join(", ");
        stdio::complain(&format!("{}: note: not carried over: {what}", path.display()));
    }
}

/// What a result that consists of positions and triangles alone does not carry over from `list`.
pub fn left_out_of_triangles(list: &Mesh) -> Vec<String> {
    let attributes = list.attributes().filter(|attributes| !attributes.is_empty());
    let attributes =
        attributes.map(|_| "texture coordinates, normals, groups and materials".to_owned());
    list.left_out().iter().cloned().chain(attributes).collect()
}

/// Reads a mesh and makes sure that it is a triangulation of closed surfaces.
pub fn read_triangulation(path: &Path, repairs: Repairs) -> Result<(Mesh, Triangulation), Failure> {
    let mut list = read(path)?;
    let triangulation = build(path, &mut list, repairs)?;
    Ok((list, triangulation))
}

/// Makes sure that a mesh read from `path` is a triangulation of closed surfaces.
pub fn build(path: &Path, list: &mut Mesh, repairs: Repairs) -> Result<Triangulation, Failure> {
    if repairs.triangulate {
        list.triangulate();
    }
    let triangulation = Triangulation::build_oriented(list, repairs.orient);
    triangulation.map_err(|survey| refusal(path, &survey))
}

/// A file that could not be read or written.
pub fn mesh_failure(path: &Path, error: &MeshError) -> Failure {
    Failure::bad(format!("{}: {error}; {}", path.display(), error.remedy()))
}

/// A mesh that is no triangulation: its first broken law, and how many others there are.
pub fn refusal(path: &Path, survey: &Survey) -> Failure {
    let first = survey.violations[0];
    let others = match survey.violations.len() - 1 {
        0 => String::new(),
        1 => " (and 1 other law is broken, see 'triquad info')".into(),
        more => format!(" (and {more} other laws are broken, see 'triquad info')"),
    };
    // In an OBJ file numbers count from 1 anyway.
    let from_one = match (Format::from_path(path), first.element) {
        (Ok(Format::Obj), _) | (_, Element::Mesh) => "",
        _ => ", counted from 1",
    };
    let (name, remedy) = (first.law.name(), first.law.remedy());
    Failure::bad(format!("{}: {first}{from_one} [{name}]{others}; {remedy}", path.display()))
}
