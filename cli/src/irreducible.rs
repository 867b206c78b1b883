//! `triquad irreducible`.

use std::path::PathBuf;

use serde::Serialize;
use triquad::Triangulation;
use triquad::clock::{Clock, SystemClock};
use triquad::irreducible::{Contractor, Irreducible, Order, check_irreducible};

use crate::failure::Failure;
use crate::input::{self, Repairs};
use crate::machine;
use crate::names::one_of;
use crate::progress::StatusLine;
use crate::targets::{Paths, Targets};

/// Contract edges of a closed triangle mesh until none can be without changing the surface
///
/// What is left is the tetrahedron for every component without handles, and at most 26 g - 4 vertices
/// for one of genus g. They stay where they are, in the order of the input; nothing else of the input
/// is kept.
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  triquad irreducible torus.obj -o least.obj\n  \
                        triquad irreducible scan.ply.gz --algorithm brute-force --seed 7 --stats -")]
pub struct Arguments {
    /// The triangle mesh: .obj .ply .off .stl, each also with .gz; '-' reads OBJ from standard input
    #[arg(value_name = "IN")]
    input: PathBuf,
    /// Where the result goes: .obj .ply .off, each also with .gz; '-' writes OBJ to standard output.
    /// May be IN itself. Without it nothing is written but the summary
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    /// How contractible edges are found:
    /// rs (Ramaswami-Siqueira, each edge tested once), schipper, brute-force
    #[arg(long, default_value = "rs", value_name = "NAME", value_parser = one_of(Contractor::ALL, Contractor::id))]
    algorithm: Contractor,
    /// The order in which rs processes vertices: file or random
    #[arg(long, default_value = "file", value_name = "NAME", value_parser = one_of(Order::ALL, Order::id))]
    order: Order,
    /// Seed of brute-force and of --order random; the same seed gives the same bytes
    #[arg(long, default_value_t = 0, value_name = "N")]
    seed: u64,
    /// Write counts and times as JSON to FILE, '-' for standard output
    #[arg(long, value_name = "FILE")]
    stats: Option<PathBuf>,
    #[command(flatten)]
    repairs: Repairs,
}

/// The record of one run.
#[derive(Serialize)]
struct Stats {
    schema: &'static str,
    input: String,
    algorithm: &'static str,
    order: &'static str,
    seed: u64,
    vertices: usize,
    edges: usize,
    triangles: usize,
    genus: usize,
    components: usize,
    result_vertices: usize,
    result_edges: usize,
    result_triangles: usize,
    contractions: usize,
    link_condition_tests: usize,
    edges_tested_more_than_once: usize,
    read_seconds: f64,
    build_seconds: f64,
    seconds: f64,
    check_seconds: f64,
    peak_memory_bytes: Option<u64>,
}

impl Stats {
    /// What is known before the work starts.
    fn of_input(arguments: &Arguments, triangulation: &Triangulation) -> Self {
        Self {
            schema: "triquad-irreducible-1",
            input: arguments.input.display().to_string(),
            algorithm: arguments.algorithm.id(),
            order: arguments.order.id(),
            seed: arguments.seed,
            vertices: triangulation.vertex_count(),
            edges: triangulation.edge_count(),
            triangles: triangulation.triangle_count(),
            genus: triangulation.genus(),
            components: triangulation.component_count(),
            result_vertices: 0,
            result_edges: 0,
            result_triangles: 0,
            contractions: 0,
            link_condition_tests: 0,
            edges_tested_more_than_once: 0,
            read_seconds: 0.0,
            build_seconds: 0.0,
            seconds: 0.0,
            check_seconds: 0.0,
            peak_memory_bytes: None,
        }
    }

    /// What the work led to.
    fn describe(&mut self, irreducible: &Irreducible) {
        self.result_vertices = irreducible.triangulation.vertex_count();
        self.result_edges = irreducible.triangulation.edge_count();
        self.result_triangles = irreducible.triangulation.triangle_count();
        self.contractions = irreducible.contractions;
        self.link_condition_tests = irreducible.counts.link_condition_tests;
        self.edges_tested_more_than_once = irreducible.counts.edges_tested_more_than_once;
    }
}

/// Reads, contracts, writes.
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
    status.say("contracting edges");
    let Arguments { algorithm, order, seed, .. } = *arguments;
    let (irreducible, seconds) = clock.time(|| algorithm.reduce(triangulation, order, seed));
    stats.describe(&irreducible);
    status.say("checking what is left");
    let left = irreducible.mesh(&list);
    let Stats { components, genus, .. } = stats;
    let (verdict, check_seconds) = clock.time(|| check_irreducible(&left, components, genus));
    verdict.map_err(|problem| {
        let input = arguments.input.display();
        Failure::no(format!("{input}: the result failed its check, please report this: {problem}"))
    })?;
    status.say("writing what is left");
    targets.write_mesh(&left)?;
    drop(status);
    stats = Stats {
        read_seconds,
        build_seconds,
        seconds,
        check_seconds,
        peak_memory_bytes: machine::peak_memory_bytes(),
        ..stats
    };
    targets.write_stats(&stats)?;
    // Not before success: a failure is told in one line.
    input::tell_left_out(&arguments.input, &input::left_out_of_triangles(&list));
    targets.report(&summary_line(arguments, &stats))
}

fn summary_line(arguments: &Arguments, stats: &Stats) -> String {
    let target = match &arguments.output {
        Some(path) if path.as_os_str() != "-" => format!(" -> {}", path.display()),
        _ => String::new(),
    };
    format!(
        "{}{target}: {} vertices and {} triangles (genus {}) -> {} vertices and {} triangles, \
         irreducible; {} made {} link condition tests; {:.3} s",
        stats.input,
        stats.vertices,
        stats.triangles,
        stats.genus,
        stats.result_vertices,
        stats.result_triangles,
        stats.algorithm,
        stats.link_condition_tests,
        stats.seconds,
    )
}
