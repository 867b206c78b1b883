//! `triquad convert`.

use std::path::{Path, PathBuf};

use serde::Serialize;
use triquad::clock::{Clock, SystemClock};
use triquad::quadrangulation::quality::{CLASSES, Quality};
use triquad::{
    Algorithm, Augmentation, ConvertError, ConvertedMesh, Expansion, Settings, Summary,
    convert_mesh, mesh::FaceList,
};

use crate::failure::Failure;
use crate::input::{self, Repairs};
use crate::machine;
use crate::names::one_of;
use crate::progress::StatusLine;
use crate::targets::{Paths, Targets};

/// Convert a closed triangle mesh into quads on the same vertices
///
/// Every quad is the union of two triangles of the input; no vertex is added, removed or moved, and
/// the result is checked before it is written. Texture coordinates, normals, groups and materials of
/// an OBJ file are carried over to OBJ output.
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  triquad convert bunny.ply.gz -o quads.obj\n  \
                        triquad convert scan.obj --algorithm ps --seed 7 --stats -\n  \
                        cat part.obj | triquad convert - -o - > quads.obj")]
pub struct Arguments {
    /// The triangle mesh: .obj .ply .off .stl, each also with .gz; '-' reads OBJ from standard input
    #[arg(value_name = "IN")]
    input: PathBuf,
    /// Where the quads go: .obj .ply .off, each also with .gz; '-' writes OBJ to standard output.
    /// May be IN itself. Without it nothing is written but the summary
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    /// How triangles are paired at first:
    /// tq (ours, fastest), sg (simple greedy), ps (Pulli-Segal greedy), or, perfect straight away,
    /// ds (Diks-Stanczyk) and gw (Gawrychowski-Wasylkiewicz, the faster of the two);
    /// lrs (contraction and expansion) flips edges
    #[arg(long, default_value = "tq", value_name = "NAME", value_parser = one_of(Algorithm::ALL, Algorithm::id))]
    algorithm: Algorithm,
    /// How lrs expands: printed (as published) or few-flips (ours: looks for another pairing before it
    /// flips an edge)
    #[arg(long, default_value = "printed", value_name = "NAME", value_parser = one_of(Expansion::ALL, Expansion::id))]
    lrs_variant: Expansion,
    /// How the pairing is made perfect: local (ours) or tarjan (as published, slow on purpose)
    #[arg(long, default_value = "local", value_name = "NAME", value_parser = one_of(Augmentation::ALL, Augmentation::id))]
    augmentation: Augmentation,
    /// Seed of the random choices of sg and ps (the others make none); the same seed gives the same bytes
    #[arg(long, default_value_t = 0, value_name = "N")]
    seed: u64,
    /// Write counts and times as JSON to FILE, '-' for standard output
    #[arg(long, value_name = "FILE")]
    stats: Option<PathBuf>,
    /// Give up after N augmenting paths, for estimates: nothing but counts and times comes of it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..), conflicts_with_all = ["output", "write_triangulation"])]
    stop_after_paths: Option<u64>,
    /// Write the triangulation whose triangles were paired: that of the input, but for lrs
    #[arg(long, value_name = "FILE")]
    write_triangulation: Option<PathBuf>,
    #[command(flatten)]
    repairs: Repairs,
}

impl Arguments {
    fn algorithm(&self) -> Algorithm {
        match self.algorithm {
            Algorithm::Lrs(_) => Algorithm::Lrs(self.lrs_variant),
            other => other,
        }
    }
}

/// The record of one conversion.
#[derive(Serialize)]
struct Stats<'a> {
    schema: &'static str,
    input: String,
    algorithm: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    lrs_variant: Option<&'static str>,
    augmentation: &'static str,
    seed: u64,
    vertices: usize,
    edges: usize,
    triangles: usize,
    genus: usize,
    components: usize,
    quads: usize,
    degree_two_vertices: usize,
    unpaired_triangles: usize,
    paired_percent: f64,
    edge_flips: usize,
    augmenting_paths: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    stopped_after_paths: Option<usize>,
    read_seconds: f64,
    build_seconds: f64,
    pairing_seconds: f64,
    augmentation_seconds: f64,
    total_seconds: f64,
    check_seconds: f64,
    write_seconds: f64,
    peak_memory_bytes: Option<u64>,
    augmenting_path_length_mean: f64,
    augmenting_path_length_max: usize,
    augmentation_triangles_visited: usize,
    #[serde(flatten)]
    quality: Option<Shapes>,
    left_out: &'a [String],
}

/// How the quads are shaped.
#[derive(Serialize)]
struct Shapes {
    quality_minimum: f64,
    quality_mean: f64,
    /// See [`Quality::histogram`].
    quality_histogram: [usize; CLASSES],
}

impl Shapes {
    fn of(quads: &FaceList) -> Self {
        let quality = Quality::of(quads);
        Self {
            quality_minimum: quality.minimum,
            quality_mean: quality.mean,
            quality_histogram: quality.histogram,
        }
    }
}

/// Reads, converts, checks, writes.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let clock = SystemClock::default();
    let mut status = StatusLine::new("reading the mesh");
    let mut targets = Targets::open(Paths {
        input: &arguments.input,
        output: arguments.output.as_deref(),
        triangles: arguments.write_triangulation.as_deref(),
        stats: arguments.stats.as_deref(),
    })?;
    let (list, read_seconds) = clock.time(|| input::read(&arguments.input));
    let mut list = list?;
    if arguments.repairs.triangulate {
        list.triangulate();
    }
    let settings = Settings {
        algorithm: arguments.algorithm(),
        augmentation: arguments.augmentation,
        seed: arguments.seed,
    };
    status.stop_after(arguments.stop_after_paths.map_or(usize::MAX, |paths| paths as usize));
    let converted = convert_mesh(list, arguments.repairs.orient, &settings, &clock, &mut status);
    if let Err(ConvertError::Stopped(summary)) = &converted {
        drop(status);
        let stats = stats(arguments, summary, None, &[], [read_seconds, 0.0]);
        targets.write_stats(&stats)?;
        return targets.report(&stopped_line(&stats));
    }
    let ConvertedMesh { mut quads, triangles, summary } =
        converted.map_err(|error| conversion_failure(&arguments.input, &error))?;
    let quality = Shapes::of(&quads);
    status.say("writing the quads");
    let (written, write_seconds) = clock.time(|| targets.write_mesh(&quads));
    written?;
    if arguments.write_triangulation.is_some() {
        status.say("writing the triangles");
        quads.faces = triangles;
        quads.attributes = None;
        targets.write_triangles(&quads)?;
    }
    drop(status);
    let stats =
        stats(arguments, &summary, Some(quality), &quads.left_out, [read_seconds, write_seconds]);
    targets.write_stats(&stats)?;
    // Not before success: a failure is told in one line.
    input::tell_left_out(&arguments.input, &quads.left_out);
    targets.report(&summary_line(arguments, &stats))
}

fn conversion_failure(input: &Path, error: &ConvertError) -> Failure {
    match error {
        ConvertError::Refused(survey) => input::refusal(input, survey),
        ConvertError::Wrong(_) | ConvertError::Stopped(_) => {
            Failure::no(format!("{}: {error}", input.display()))
        }
    }
}

fn stats<'a>(
    arguments: &Arguments,
    summary: &Summary,
    quality: Option<Shapes>,
    left_out: &'a [String],
    [read_seconds, write_seconds]: [f64; 2],
) -> Stats<'a> {
    Stats {
        schema: "triquad-convert-1",
        input: arguments.input.display().to_string(),
        algorithm: arguments.algorithm.id(),
        lrs_variant: match arguments.algorithm {
            Algorithm::Lrs(_) => Some(arguments.lrs_variant.id()),
            _ => None,
        },
        augmentation: arguments.augmentation.id(),
        seed: arguments.seed,
        vertices: summary.vertices,
        edges: summary.edges,
        triangles: summary.triangles,
        genus: summary.genus,
        components: summary.components,
        quads: summary.check.quads,
        degree_two_vertices: summary.check.degree_two_vertices,
        unpaired_triangles: summary.unpaired_triangles,
        paired_percent: summary.paired_percent(),
        edge_flips: summary.edge_flips,
        augmenting_paths: summary.augmentation.paths,
        stopped_after_paths: quality.is_none().then_some(summary.augmentation.paths),
        read_seconds,
        build_seconds: summary.build_seconds,
        pairing_seconds: summary.pairing_seconds,
        augmentation_seconds: summary.augmentation_seconds,
        total_seconds: summary.total_seconds(),
        check_seconds: summary.check_seconds,
        write_seconds,
        peak_memory_bytes: machine::peak_memory_bytes(),
        augmenting_path_length_mean: summary.augmentation.mean_length(),
        augmenting_path_length_max: summary.augmentation.longest,
        augmentation_triangles_visited: summary.augmentation.triangles_visited,
        quality,
        left_out,
    }
}

fn summary_line(arguments: &Arguments, stats: &Stats<'_>) -> String {
    let target = match &arguments.output {
        Some(path) if path.as_os_str() != "-" => format!(" -> {}", path.display()),
        _ => String::new(),
    };
    format!(
        "{}{target}: {} triangles (genus {}) -> {} quads on the same {} vertices; {} left {} unpaired \
         ({:.3} %), completed by {}; paired in {:.3} s",
        stats.input,
        stats.triangles,
        stats.genus,
        stats.quads,
        stats.vertices,
        stats.algorithm,
        stats.unpaired_triangles,
        100.0 - stats.paired_percent,
        stats.augmentation,
        stats.total_seconds,
    )
}

fn stopped_line(stats: &Stats<'_>) -> String {
    format!(
        "{}: {} triangles (genus {}), no quads; {} left {} unpaired ({:.3} %), stopped after {} of {} \
         augmenting paths by {}; paired in {:.3} s, augmented for {:.3} s",
        stats.input,
        stats.triangles,
        stats.genus,
        stats.algorithm,
        stats.unpaired_triangles,
        100.0 - stats.paired_percent,
        stats.augmenting_paths,
        stats.unpaired_triangles / 2,
        stats.augmentation,
        stats.pairing_seconds,
        stats.augmentation_seconds,
    )
}
