//! `triquad simplify`.

use std::path::PathBuf;

use serde::Serialize;
use triquad::Mesh;
use triquad::Triangulation;
use triquad::clock::{Clock, SystemClock};
use triquad::simplify::{Shape, Simplifier, SimplifyError};

use crate::failure::Failure;
use crate::input::{self, Repairs};
use crate::machine;
use crate::progress::StatusLine;
use crate::targets::{Paths, Targets};

/// Simplify a closed triangle mesh to an exact number of vertices
///
/// Edges are contracted in order of quadric error, only where that keeps the topology: genus and
/// components stay what they are, and the result is a triangulation again. Vertices that no triangle
/// uses are dropped; so are texture coordinates, normals, groups and materials.
#[derive(clap::Args)]
#[command(
    after_help = "Examples:\n  triquad simplify scan.ply.gz --vertices 10000 -o small.obj\n  \
                        triquad simplify box.obj --vertices 172354 -o a5.obj --stats -"
)]
pub struct Arguments {
    /// The triangle mesh: .obj .ply .off .stl, each also with .gz; '-' reads OBJ from standard input
    #[arg(value_name = "IN")]
    input: PathBuf,
    /// How many vertices are to be left
    #[arg(long, value_name = "V")]
    vertices: usize,
    /// Where the triangles go: .obj .ply .off, each also with .gz; '-' writes OBJ to standard output.
    /// May be IN itself. Without it nothing is written but the summary
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    /// Write counts and times as JSON to FILE, '-' for standard output
    #[arg(long, value_name = "FILE")]
    stats: Option<PathBuf>,
    #[command(flatten)]
    repairs: Repairs,
}

/// The record of one simplification.
#[derive(Serialize)]
struct Stats {
    schema: &'static str,
    input: String,
    vertices: usize,
    edges: usize,
    triangles: usize,
    genus: usize,
    components: usize,
    result_vertices: usize,
    result_edges: usize,
    result_triangles: usize,
    contractions: usize,
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
    let status = StatusLine::new("reading the mesh");
    let mut targets = Targets::open(Paths {
        input: &arguments.input,
        output: arguments.output.as_deref(),
        triangles: None,
        stats: arguments.stats.as_deref(),
    })?;
    let (list, read_seconds) = clock.time(|| input::read(&arguments.input));
    let mut list = list?;
    status.say("building the triangulation");
    let (built, build_seconds) =
        clock.time(|| input::build(&arguments.input, &mut list, arguments.repairs));
    let triangulation = built?;
    let mut stats = Stats::of_input(arguments, &triangulation);
    let left_out = input::left_out_of_triangles(&list);
    status.say("contracting edges");
    let (simplified, seconds) = clock.time(|| simplified(triangulation, list, arguments.vertices));
    let (list, triangulation) = simplified.map_err(|error| failure(arguments, &error))?;
    stats.describe(&list, &triangulation);
    status.say("writing the triangles");
    let (written, write_seconds) = clock.time(|| targets.write_mesh(&list));
    written?;
    drop(status);
    stats = Stats {
        read_seconds,
        build_seconds,
        seconds,
        write_seconds,
        peak_memory_bytes: machine::peak_memory_bytes(),
        ..stats
    };
    targets.write_stats(&stats)?;
    // Not before success: a failure is told in one line.
    input::tell_left_out(&arguments.input, &left_out);
    targets.report(&summary_line(arguments, &stats))
}

/// The faces are not needed any more, the positions only to begin with.
fn simplified(
    triangulation: Triangulation,
    list: Mesh,
    vertices: usize,
) -> Result<(Mesh, Triangulation), SimplifyError> {
    let mut simplifier = Simplifier::new(triangulation, list.positions());
    drop(list);
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

impl Stats {
    /// What is known before the work starts.
    fn of_input(arguments: &Arguments, triangulation: &Triangulation) -> Self {
        Self {
            schema: "triquad-simplify-1",
            input: arguments.input.display().to_string(),
            vertices: triangulation.vertex_count(),
            edges: triangulation.edge_count(),
            triangles: triangulation.triangle_count(),
            genus: triangulation.genus(),
            components: triangulation.component_count(),
            result_vertices: 0,
            result_edges: 0,
            result_triangles: 0,
            contractions: 0,
            largest_degree: 0,
            smallest_angle_degrees: 0.0,
            largest_angle_degrees: 0.0,
            read_seconds: 0.0,
            build_seconds: 0.0,
            seconds: 0.0,
            write_seconds: 0.0,
            peak_memory_bytes: None,
        }
    }

    /// What the result is like.
    fn describe(&mut self, list: &Mesh, triangulation: &Triangulation) {
        let shape = Shape::new(list);
        self.result_vertices = triangulation.vertex_count();
        self.result_edges = triangulation.edge_count();
        self.result_triangles = triangulation.triangle_count();
        self.contractions = self.vertices - self.result_vertices;
        self.largest_degree = shape.largest_degree;
        self.smallest_angle_degrees = shape.smallest_angle();
        self.largest_angle_degrees = shape.largest_angle();
    }
}

fn summary_line(arguments: &Arguments, stats: &Stats) -> String {
    let target = match &arguments.output {
        Some(path) if path.as_os_str() != "-" => format!(" -> {}", path.display()),
        _ => String::new(),
    };
    format!(
        "{}{target}: {} -> {} vertices, {} triangles (genus {}), largest degree {}, angles from \
         {:.1} to {:.1} degrees; simplified in {:.3} s",
        stats.input,
        stats.vertices,
        stats.result_vertices,
        stats.result_triangles,
        stats.genus,
        stats.largest_degree,
        stats.smallest_angle_degrees,
        stats.largest_angle_degrees,
        stats.seconds,
    )
}
