//! `triquad simplify`.

use std::path::PathBuf;

use serde::Serialize;
use triquad::clock::{Clock, SystemClock};
use triquad::simplify::{Shape, Simplifier, SimplifyError};
use triquad::{Mesh, Triangulation};

use crate::failure::Failure;
use crate::formats::{may_write, reads};
use crate::input::Repairs;
use crate::machine;
use crate::reduction::{InputTimes, Opened, Sizes};
use crate::targets::Paths;

/// Simplify a closed triangle mesh to an exact number of vertices
///
/// Edges are contracted in order of quadric error, only where that keeps the topology: genus and
/// components stay what they are, and the result is a triangulation again. Vertices that no
/// triangle uses are dropped; so are texture coordinates, normals, groups and materials.
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  \
    triquad simplify scan.ply.gz --vertices 10000 -o small.obj\n  \
    triquad simplify box.obj --vertices 172354 -o a5.obj --stats -")]
pub struct Arguments {
    #[arg(value_name = "IN", help = reads("The triangle mesh"))]
    input: PathBuf,
    /// How many vertices are to be left
    #[arg(long, value_name = "V")]
    vertices: usize,
    #[arg(short, long, value_name = "OUT", help = may_write("Where the triangles go"))]
    output: Option<PathBuf>,
    /// Write counts and times as JSON to FILE, '-' for standard output
    #[arg(long, value_name = "FILE")]
    stats: Option<PathBuf>,
    #[command(flatten)]
    repairs: Repairs,
}

/// The record of one simplification; angles in degrees, times in seconds.
#[derive(Serialize)]
struct Stats {
    schema: &'static str,
    input: String,
    #[serde(flatten)]
    sizes: Sizes,
    largest_degree: u32,
    smallest_angle_degrees: f64,
    largest_angle_degrees: f64,
    #[serde(flatten)]
    input_times: InputTimes,
    seconds: f64,
    write_seconds: f64,
    peak_memory_bytes: Option<u64>,
}

/// Reads, simplifies, writes.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let clock = SystemClock::default();
    let paths = Paths {
        input: &arguments.input,
        output: arguments.output.as_deref(),
        triangles: None,
        stats: arguments.stats.as_deref(),
    };
    let Opened { status, mut targets, mesh, triangulation, size, times, left_out } =
        Opened::open(paths, arguments.repairs, &clock)?;
    status.say("contracting edges");
    let (simplified, seconds) = clock.time(|| simplified(triangulation, mesh, arguments.vertices));
    let (mesh, triangulation) = simplified.map_err(|error| failure(arguments, &error))?;
    status.say("writing the triangles");
    let (written, write_seconds) = clock.time(|| targets.write_mesh(&mesh));
    written?;
    drop(status);
    let shape = Shape::new(&mesh);
    let stats = Stats {
        schema: "triquad-simplify-1",
        input: arguments.input.display().to_string(),
        sizes: Sizes::new(size, &triangulation),
        largest_degree: shape.largest_degree,
        smallest_angle_degrees: shape.smallest_angle(),
        largest_angle_degrees: shape.largest_angle(),
        input_times: times,
        seconds,
        write_seconds,
        peak_memory_bytes: machine::peak_memory_bytes(),
    };
    targets.finish(&stats, &left_out, &summary(&stats))
}

/// Simplifies to `vertices` vertices. Drops `mesh` early: only its positions are needed, at first.
fn simplified(
    triangulation: Triangulation,
    mesh: Mesh,
    vertices: usize,
) -> Result<(Mesh, Triangulation), SimplifyError> {
    let mut simplifier = Simplifier::new(triangulation, mesh.positions());
    drop(mesh);
    simplifier.reduce_to(vertices)?;
    Ok(simplifier.result())
}

fn failure(arguments: &Arguments, error: &SimplifyError) -> Failure {
    let input = arguments.input.display();
    let remedy = match error {
        SimplifyError::TooMany { present, .. } => format!("ask for {present} or fewer"),
        SimplifyError::Irreducible { reached, .. } => format!("ask for {reached} or more"),
        _ => return Failure::bad(format!("{input}: {error}")),
    };
    Failure::bad(format!("{input}: {error}; {remedy}"))
}

fn summary(stats: &Stats) -> String {
    let Sizes { input, result_vertices, result_triangles, .. } = stats.sizes;
    format!(
        "{} -> {result_vertices} vertices, {result_triangles} triangles (genus {}), largest degree \
         {}, angles from {:.1} to {:.1} degrees; simplified in {:.3} s",
        input.vertices,
        input.genus,
        stats.largest_degree,
        stats.smallest_angle_degrees,
        stats.largest_angle_degrees,
        stats.seconds,
    )
}
