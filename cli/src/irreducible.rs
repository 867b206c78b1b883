//! `triquad irreducible`.

use std::path::PathBuf;

use serde::Serialize;
use triquad::Mesh;
use triquad::clock::{Clock, SystemClock};
use triquad::counted::counted;
use triquad::irreducible::{Contractor, Counts, Order, check_irreducible};
use triquad::mesh::Faces;

use crate::failure::Failure;
use crate::formats::{may_write, reads};
use crate::machine;
use crate::names::one_of;
use crate::reduction::{Opened, Options, Sizes};

/// Contract edges of a closed triangle mesh until the triangulation is irreducible
///
/// A component of genus 0 ends as a tetrahedron, one of genus g > 0 with at most 26 g - 4 vertices.
/// These keep their positions and their order; nothing else of the input is kept.
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  \
    triquad irreducible torus.obj -o least.obj\n  \
    triquad irreducible scan.ply.gz --algorithm brute-force --seed 7 --stats -")]
pub struct Arguments {
    #[arg(value_name = "IN", help = reads("The triangle mesh"))]
    input: PathBuf,
    #[arg(short, long, value_name = "OUT", help = may_write("Where the result goes"))]
    output: Option<PathBuf>,
    /// Search for contractible edges: rs (Ramaswami-Siqueira, each edge tested once), schipper,
    /// brute-force
    #[arg(long, default_value = "rs", value_name = "NAME")]
    #[arg(value_parser = one_of(Contractor::ALL, Contractor::id))]
    algorithm: Contractor,
    /// The order in which rs processes vertices: file or random
    #[arg(long, default_value = "file", value_name = "NAME")]
    #[arg(value_parser = one_of(Order::ALL, Order::id))]
    order: Order,
    /// Seed of schipper, brute-force and --order random; the same seed gives the same bytes
    #[arg(long, default_value_t = 0, value_name = "N")]
    seed: u64,
    /// Refused: only convert takes surfaces with boundary
    #[arg(long, hide = true)]
    open: bool,
    #[command(flatten)]
    options: Options,
}

/// The record of one run; times in seconds.
#[derive(Serialize)]
struct Stats {
    schema: &'static str,
    input: String,
    algorithm: Contractor,
    order: Order,
    seed: u64,
    #[serde(flatten)]
    sizes: Sizes,
    #[serde(flatten)]
    tests: Counts,
    read_seconds: f64,
    build_seconds: f64,
    seconds: f64,
    check_seconds: f64,
    peak_memory_bytes: Option<u64>,
}

/// Reads, contracts, checks, writes.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let clock = SystemClock::default();
    let Arguments { input, output, algorithm, order, seed, open, options } = arguments;
    if *open {
        return Err(Failure::bad(format!(
            "{}: --open is for convert: irreducible triangulations are those of closed surfaces, \
             and the contraction of an edge relies on a closed ring of triangles round each vertex",
            input.display()
        )));
    }
    let mut opened = Opened::open(input, output.as_deref(), options, &clock)?;
    let size = opened.size;
    // The triangulation has the faces too: 12 bytes a triangle less while edges are contracted.
    let (positions, _) = opened.mesh.into_parts();
    let points = Mesh::new(positions, Faces::uniform(3, Vec::new()));
    opened.status.say("contracting edges");
    let (irreducible, seconds) =
        clock.time(|| algorithm.reduce(opened.triangulation, *order, *seed));
    opened.status.say("checking what is left");
    let left = irreducible.mesh(&points);
    let (verdict, check_seconds) =
        clock.time(|| check_irreducible(&left, size.components, size.genus));
    let input = input.display().to_string();
    verdict.map_err(|problem| {
        Failure::no(format!("{input}: the result failed its check, please report this: {problem}"))
    })?;
    opened.status.say("writing what is left");
    opened.targets.write_mesh(&left)?;
    drop(opened.status);
    let stats = Stats {
        schema: "triquad-irreducible-1",
        input,
        algorithm: *algorithm,
        order: *order,
        seed: *seed,
        sizes: Sizes::new(size, &irreducible.triangulation),
        tests: irreducible.counts,
        read_seconds: opened.read_seconds,
        build_seconds: opened.build_seconds,
        seconds,
        check_seconds,
        peak_memory_bytes: machine::peak_memory_bytes(),
    };
    opened.targets.finish(&stats, &opened.fate, &summary(&stats))
}

fn summary(stats: &Stats) -> String {
    let Sizes { input, result_vertices, result_triangles, .. } = stats.sizes;
    format!(
        "{} and {} (genus {}) -> {} and {}, irreducible; {} made {}; {:.3} s",
        counted(input.vertices, "vertex", "vertices"),
        counted(input.triangles, "triangle", "triangles"),
        input.genus,
        counted(result_vertices, "vertex", "vertices"),
        counted(result_triangles, "triangle", "triangles"),
        stats.algorithm,
        counted(stats.tests.link_condition_tests, "link condition test", "link condition tests"),
        stats.seconds,
    )
}
