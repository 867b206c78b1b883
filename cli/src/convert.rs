//! `triquad convert`.

use std::path::{Path, PathBuf};

use serde::Serialize;
use triquad::clock::{Clock, SystemClock};
use triquad::{
    Algorithm, Augmentation, ConvertError, Converter, Cost, DefaultCost, Expansion, Report,
    ShapeCost,
};

use crate::failure::Failure;
use crate::formats::{may_write, reads};
use crate::input::{self, Repairs};
use crate::machine;
use crate::names::one_of;
use crate::progress::StatusLine;
use crate::targets::{Paths, Targets};

/// Convert a closed triangle mesh into quads on the same vertices
///
/// Every quad is the union of two triangles of the input (of another triangulation for lrs, which
/// flips edges); no vertex is added, removed or moved, and the result is checked before it is
/// written. Texture coordinates, normals, groups and materials of an OBJ file are carried over to
/// OBJ output.
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  triquad convert bunny.ply.gz -o quads.obj\n  \
                        triquad convert scan.obj --algorithm ps --seed 7 --stats -\n  \
                        cat part.obj | triquad convert - -o - > quads.obj")]
pub struct Arguments {
    #[arg(value_name = "IN", help = reads("The triangle mesh"))]
    input: PathBuf,
    #[arg(short, long, value_name = "OUT", help = may_write("Where the quads go"))]
    output: Option<PathBuf>,
    /// How triangles are paired: best (the best-shaped quads, provably), tq (fastest, without
    /// regard to shape); of the papers, sg (simple greedy), ps (Pulli-Segal greedy), ds
    /// (Diks-Stanczyk), gw (Gawrychowski-Wasylkiewicz, the faster of the two); lrs (contraction and
    /// expansion) flips edges
    #[arg(long, default_value = "best", value_name = "NAME")]
    #[arg(value_parser = one_of(Algorithm::ALL, Algorithm::id))]
    algorithm: Algorithm,
    /// What best minimises the sum of: default (shape, folded quads and sharp edges weighed) or
    /// shape (10000 times 1 less the scaled Jacobian, rounded)
    #[arg(long, default_value = "default", value_name = "NAME")]
    #[arg(value_parser = ["default", "shape"])]
    cost: String,
    /// How lrs expands: printed (as published) or few-flips (ours: looks for another pairing before
    /// it flips an edge)
    #[arg(long, default_value = "printed", value_name = "NAME")]
    #[arg(value_parser = one_of(Expansion::ALL, Expansion::id))]
    lrs_variant: Expansion,
    /// How the pairing is made perfect: local (ours) or tarjan (as published, slow on purpose)
    #[arg(long, default_value = "local", value_name = "NAME")]
    #[arg(value_parser = one_of(Augmentation::ALL, Augmentation::id))]
    augmentation: Augmentation,
    /// Seed of the random choices of sg and ps (the others make none); the same seed gives the same
    /// bytes
    #[arg(long, default_value_t = 0, value_name = "N")]
    seed: u64,
    /// Write counts and times as JSON to FILE, '-' for standard output
    #[arg(long, value_name = "FILE")]
    stats: Option<PathBuf>,
    /// Give up after N augmenting paths, for estimates: nothing but counts and times comes of it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    #[arg(conflicts_with_all = ["output", "write_triangulation"])]
    stop_after_paths: Option<u64>,
    /// Write the triangulation whose triangles were paired: that of the input, but for lrs
    #[arg(long, value_name = "FILE")]
    write_triangulation: Option<PathBuf>,
    #[command(flatten)]
    repairs: Repairs,
}

impl Arguments {
    /// Returns the algorithm with the variant of lrs.
    fn algorithm(&self) -> Algorithm {
        match self.algorithm {
            Algorithm::Lrs(_) => Algorithm::Lrs(self.lrs_variant),
            other => other,
        }
    }

    fn cost(&self) -> &'static dyn Cost {
        if self.cost == "shape" { &ShapeCost } else { &DefaultCost }
    }
}

/// The record of one conversion; times in seconds.
#[derive(Serialize)]
struct Stats<'a> {
    schema: &'static str,
    input: String,
    #[serde(flatten)]
    report: &'a Report,
    read_seconds: f64,
    write_seconds: f64,
    peak_memory_bytes: Option<u64>,
    left_out: &'a [String],
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
    let (mesh, read_seconds) =
        clock.time(|| input::read(&arguments.input, arguments.repairs.reading));
    let mut mesh = mesh?;
    input::triangulate(&arguments.input, &mut mesh, arguments.repairs)?;
    let unknown_lines = mesh.unknown_lines().map(String::from);
    status.stop_after(arguments.stop_after_paths.map_or(usize::MAX, |paths| paths as usize));
    let converted = Converter::new()
        .algorithm(arguments.algorithm())
        .augmentation(arguments.augmentation)
        .seed(arguments.seed)
        .cost(arguments.cost())
        .orient(arguments.repairs.orient)
        .progress(&mut status)
        .run(mesh);
    let stats = |report, write_seconds, left_out| Stats {
        schema: "triquad-convert-1",
        input: arguments.input.display().to_string(),
        report,
        read_seconds,
        write_seconds,
        peak_memory_bytes: machine::peak_memory_bytes(),
        left_out,
    };
    let quads = match converted {
        Ok(quads) => quads,
        Err(ConvertError::Stopped(report)) => {
            drop(status);
            let stats = stats(&report, 0.0, &[]);
            return targets.finish_without_mesh(&stats, &[], &report.to_string());
        }
        Err(error) => {
            return Err(conversion_failure(&arguments.input, &error, unknown_lines.as_deref()));
        }
    };
    status.say("writing the quads");
    let (written, write_seconds) = clock.time(|| targets.write_mesh(quads.mesh()));
    written?;
    let report = quads.report().clone();
    let (mut left_out, mut losses) = (quads.mesh().left_out().to_vec(), quads.losses().notes());
    if targets.drops_attributes() {
        left_out = input::left_out_of_faces(quads.mesh());
        losses.clear();
    }
    if arguments.write_triangulation.is_some() {
        status.say("writing the triangles");
        targets.write_triangles(&quads.into_triangle_mesh())?;
    }
    drop(status);
    let all_left_out = [&left_out[..], &losses].concat();
    let stats = stats(&report, write_seconds, &all_left_out);
    let mut summary = report.to_string();
    if !losses.is_empty() {
        summary = format!("{summary}; lost: {}", losses.join(", "));
    }
    targets.finish(&stats, &left_out, &summary)
}

fn conversion_failure(input: &Path, error: &ConvertError, unknown: Option<&str>) -> Failure {
    match error {
        ConvertError::Refused(survey) => input::refusal(input, survey, unknown),
        _ => Failure::no(format!("{}: {error}", input.display())),
    }
}
