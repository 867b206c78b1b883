//! `triquad simplify`.

use std::path::{Path, PathBuf};

use serde::Serialize;
use triquad::clock::{Clock, SystemClock};
use triquad::counted::counted;
use triquad::simplify::{Rule, Shape, Simplifier, SimplifyError};
use triquad::{Mesh, Triangulation};

use crate::failure::Failure;
use crate::formats::{may_write, reads};
use crate::machine;
use crate::reduction::{Opened, Options, Sizes};

/// Simplify a closed triangle mesh to an exact number of vertices
///
/// Contracts edges in order of quadric error, where the link condition holds: genus and number of
/// components stay, and the result is a triangulation. Unused vertices, texture coordinates,
/// normals, groups and materials are dropped.
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  \
    triquad simplify scan.ply.gz --vertices 10000 -o small.obj\n  \
    triquad simplify box.obj --vertices 172354 -o a5.obj --stats -")]
pub struct Arguments {
    #[arg(value_name = "IN", help = reads("The triangle mesh"))]
    input: PathBuf,
    /// Number of vertices in the result, met exactly
    #[arg(long, value_name = "V")]
    vertices: usize,
    /// Contract by quadric error alone, into the better end, ties in file order. Angles and degrees
    /// are not limited. The papers' hierarchies are made so
    #[arg(long)]
    plain: bool,
    #[arg(short, long, value_name = "OUT", help = may_write("Where the triangles go"))]
    output: Option<PathBuf>,
    #[command(flatten)]
    options: Options,
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
    read_seconds: f64,
    build_seconds: f64,
    seconds: f64,
    write_seconds: f64,
    peak_memory_bytes: Option<u64>,
}

/// Reads, simplifies, writes.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let clock = SystemClock::default();
    let Arguments { input, vertices, plain, output, options } = arguments;
    let rule = if *plain { Rule::Plain } else { Rule::Guarded };
    let mut opened = Opened::open(input, output.as_deref(), options, &clock)?;
    opened.status.say("contracting edges");
    let (simplified, seconds) =
        clock.time(|| simplified(opened.triangulation, opened.mesh, rule, *vertices));
    let (mesh, triangulation) = simplified.map_err(|error| failure(input, &error))?;
    opened.status.say("writing the triangles");
    let (written, write_seconds) = clock.time(|| opened.targets.write_mesh(&mesh));
    written?;
    drop(opened.status);
    let shape = Shape::new(&mesh);
    let stats = Stats {
        schema: "triquad-simplify-1",
        input: input.display().to_string(),
        sizes: Sizes::new(opened.size, &triangulation),
        largest_degree: shape.largest_degree,
        smallest_angle_degrees: shape.smallest_angle(),
        largest_angle_degrees: shape.largest_angle(),
        read_seconds: opened.read_seconds,
        build_seconds: opened.build_seconds,
        seconds,
        write_seconds,
        peak_memory_bytes: machine::peak_memory_bytes(),
    };
    opened.targets.finish(&stats, &opened.fate, &summary(&stats))
}

/// Simplifies to `vertices` vertices. Drops `mesh` early: only its positions are needed, at first.
fn simplified(
    triangulation: Triangulation,
    mesh: Mesh,
    rule: Rule,
    vertices: usize,
) -> Result<(Mesh, Triangulation), SimplifyError> {
    let mut simplifier = Simplifier::with_rule(triangulation, mesh.positions(), rule);
    drop(mesh);
    simplifier.reduce_to(vertices)?;
    Ok(simplifier.result())
}

fn failure(input: &Path, error: &SimplifyError) -> Failure {
    let input = input.display();
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
        "{} -> {}, {} (genus {}), largest degree {}, angles from {:.1} to {:.1} degrees; \
         simplified in {:.3} s",
        input.vertices,
        counted(result_vertices, "vertex", "vertices"),
        counted(result_triangles, "triangle", "triangles"),
        input.genus,
        stats.largest_degree,
        stats.smallest_angle_degrees,
        stats.largest_angle_degrees,
        stats.seconds,
    )
}
