//! `triquad check`.

use std::path::PathBuf;

use triquad::{check, check_retriangulation, common_edges};

use crate::failure::Failure;
use crate::input::{self, Repairs};
use crate::progress::StatusLine;
use crate::stdio;

/// Check that a quad mesh is a quadrangulation of a triangle mesh
///
/// From the two files alone: the same vertices, every quad the union of two triangles across their
/// common edge, every triangle in exactly one quad, closed, oriented, one fan round every vertex,
/// the same Euler characteristic. Exit code 1 and one line if not.
#[derive(clap::Args)]
#[command(after_help = "Example: triquad check quads.obj --against bunny.obj")]
pub struct Arguments {
    /// The quad mesh
    #[arg(value_name = "QUADS")]
    quads: PathBuf,
    /// The triangle mesh that it was made from
    #[arg(long, value_name = "TRIANGLES")]
    against: PathBuf,
    /// The triangulation whose triangles were paired, as convert --write-triangulation writes it,
    /// if it is not TRIANGLES: the quads are checked against it, and it must triangulate the
    /// surface of TRIANGLES on the same vertices
    #[arg(long, value_name = "K")]
    triangulation: Option<PathBuf>,
    #[command(flatten)]
    repairs: Repairs,
}

/// Reads both meshes and compares them.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let inputs =
        [Some(&arguments.quads), Some(&arguments.against), arguments.triangulation.as_ref()];
    if inputs.into_iter().flatten().filter(|path| path.as_os_str() == "-").count() > 1 {
        let problem = "standard input can be one of the meshes only; give the others as files";
        return Err(Failure::bad(format!("-: {problem}")));
    }
    let status = StatusLine::new("reading the meshes");
    let quads = input::read(&arguments.quads, arguments.repairs.reading)?;
    let triangles = input::read_triangulation(&arguments.against, arguments.repairs)?;
    let mut shared = String::new();
    let paired = match &arguments.triangulation {
        Some(path) => {
            let paired = input::read_triangulation(path, arguments.repairs)?;
            status.say("checking");
            check_retriangulation(&paired, &triangles)
                .map_err(|mismatch| Failure::no(format!("{}: {mismatch}", path.display())))?;
            let (common, all) = common_edges(&paired, &triangles);
            let against = arguments.against.display();
            shared = format!("; {common} of the {all} edges of the triangulation are in {against}");
            paired
        }
        None => triangles,
    };
    status.say("checking");
    let report = check(&quads, &paired);
    drop(status);
    let name = arguments.quads.display();
    let report = report.map_err(|mismatch| Failure::no(format!("{name}: {mismatch}")))?;
    stdio::say(&stdio::one_line(&format!(
        "{name}: ok: {} quads on the {} vertices of {}, {} of them of degree 2, Euler \
         characteristic {}{shared}",
        report.quads,
        report.vertices,
        arguments.triangulation.as_ref().unwrap_or(&arguments.against).display(),
        report.degree_two_vertices,
        report.euler_characteristic,
    )))
}
