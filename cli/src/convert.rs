//! `triquad convert`.

use std::path::{Path, PathBuf};

use serde::Serialize;
use triquad::clock::{Clock, SystemClock};
use triquad::irreducible::Discipline;
use triquad::pairing::LRS_ORDER;
use triquad::{Algorithm, Augmentation, ConvertError, Converter, Expansion, Mesh, Report};

use crate::aims::{AimOptions, ReadAims};
use crate::failure::Failure;
use crate::formats::{may_write, reads};
use crate::input::{self, Fate, OpenWay, Repairs};
use crate::names::one_of;
use crate::progress::StatusLine;
use crate::remedies::Refused;
use crate::several::Several;
use crate::targets::{Paths, Targets};
use crate::welding::may_have_seams;
use crate::{certificate, comparison, machine, stdio};

/// Convert a triangle mesh into quads on the same vertices
///
/// Every quad is the union of two triangles of the input (of another triangulation for lrs, which
/// flips edges). No vertex is added, removed or moved. On a closed surface no triangle is left
/// over. The result is checked before it is written. Texture coordinates, normals, groups and
/// materials of an OBJ file are carried over to OBJ output.
#[derive(clap::Args, Clone)]
#[command(after_help = "Examples:\n  triquad convert bunny.ply.gz -o quads.obj\n  \
                        triquad convert scan.obj --algorithm ps --seed 7 --stats -\n  \
                        triquad convert scans/*.stl --out-dir quads --format obj\n  \
                        triquad convert part.obj --keep-sharp 30 -o quads.obj --given-up lost.txt\n  \
                        triquad convert terrain.obj --open -o mixed.obj\n  \
                        cat part.obj | triquad convert - -o - > quads.obj")]
pub struct Arguments {
    #[arg(value_name = "IN", help = reads("The triangle mesh"))]
    input: PathBuf,
    #[arg(short, long, value_name = "OUT", help = may_write("Where the quads go"))]
    output: Option<PathBuf>,
    #[arg(long, default_value = "best", value_name = "NAME", help = algorithms())]
    #[arg(value_parser = one_of(Algorithm::ALL, Algorithm::id))]
    algorithm: Algorithm,
    /// Expansion of lrs: printed (the default, as published) or few-flips (ours: flips an edge only
    /// if a search for another pairing fails)
    #[arg(long, value_name = "NAME")]
    #[arg(value_parser = one_of(Expansion::ALL, Expansion::id))]
    lrs_variant: Option<Expansion>,
    /// Order in which lrs tests the edges at a vertex: stack (the default: new ones first; fewer
    /// edges are flipped) or queue (as printed)
    #[arg(long, value_name = "NAME")]
    #[arg(value_parser = one_of(Discipline::ALL, Discipline::id))]
    lrs_order: Option<Discipline>,
    /// Search for augmenting paths: local (ours), tarjan (as published, slow on purpose) or rebuild
    /// (as tarjan, with the graph set up anew for each path)
    #[arg(long, default_value = "local", value_name = "NAME")]
    #[arg(value_parser = one_of(Augmentation::ALL, Augmentation::id))]
    augmentation: Augmentation,
    /// Seed of the random choices, such as those of sg and ps; the same seed gives the same bytes
    #[arg(long, default_value_t = 0, value_name = "N")]
    seed: u64,
    /// Write counts and times as JSON to FILE, '-' for standard output
    #[arg(long, value_name = "FILE")]
    stats: Option<PathBuf>,
    /// Stop after N augmenting paths and print counts and times only, for estimates
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    #[arg(conflicts_with_all = ["output", "write_triangulation"])]
    stop_after_paths: Option<u64>,
    /// Write the triangulation whose triangles were paired; differs from the input for lrs only
    #[arg(long, value_name = "FILE")]
    write_triangulation: Option<PathBuf>,
    #[command(flatten)]
    repairs: Repairs,
    #[arg(long, help = open_surfaces())]
    open: bool,
    /// Print a table of all algorithms with the quality and the time of each; write no mesh
    #[arg(long, conflicts_with_all = [
        "output", "stats", "write_triangulation", "certificate", "given_up", "stop_after_paths",
        "algorithm",
    ])]
    compare: bool,
    #[command(flatten)]
    several: Several,
    // Last: the options after it stand under its heading.
    #[command(flatten)]
    aims: AimOptions,
    /// Write the proof that the pairing is the best, for check --certificate. For best
    #[arg(long, value_name = "FILE")]
    certificate: Option<PathBuf>,
    /// Write the edges to keep that were given up: two vertex numbers a line
    #[arg(long, value_name = "FILE")]
    given_up: Option<PathBuf>,
}

/// Help of `--algorithm`.
fn algorithms() -> String {
    let each = Algorithm::ALL.map(|one| format!("{} ({})", one.id(), one.description()));
    format!("Initial pairing: {}", each.join(", "))
}

/// Help of `--open`.
fn open_surfaces() -> String {
    let each = Algorithm::ALL.into_iter().filter(|algorithm| algorithm.works_on_open());
    format!(
        "Accept surfaces with boundary and one-sided ones. The fewest triangles are left over, \
         provably, and written as triangles. For {}",
        each.map(Algorithm::id).collect::<Vec<_>>().join(", ")
    )
}

impl Arguments {
    /// Returns `algorithm` with the variant of lrs.
    fn in_full(&self, algorithm: Algorithm) -> Algorithm {
        match algorithm {
            Algorithm::Lrs(_) => Algorithm::Lrs(self.lrs_variant.unwrap_or_default()),
            other => other,
        }
    }

    /// Returns a converter with all options but the algorithm and the aims of best.
    fn converter<'a>(&self, progress: &'a mut StatusLine) -> Converter<'a> {
        Converter::new()
            .lrs_order(self.lrs_order.unwrap_or(LRS_ORDER))
            .augmentation(self.augmentation)
            .seed(self.seed)
            .orient(self.repairs.orient)
            .open(self.open)
            .progress(progress)
    }

    /// Returns the first given option that takes one mesh only.
    fn alone(&self) -> Option<&'static str> {
        let options = [
            ("-o", self.output.is_some()),
            ("--stats", self.stats.is_some()),
            ("--write-triangulation", self.write_triangulation.is_some()),
            ("--stop-after-paths", self.stop_after_paths.is_some()),
            ("--certificate", self.certificate.is_some()),
            ("--given-up", self.given_up.is_some()),
            ("--compare", self.compare),
        ];
        options.into_iter().find(|&(_, is_given)| is_given).map(|(option, _)| option)
    }

    /// Refuses options that mean nothing together.
    fn check(&self) -> Result<(), Failure> {
        self.aims.check()?;
        let is_lrs = matches!(self.algorithm, Algorithm::Lrs(_)) || self.compare;
        let options =
            [("variant", self.lrs_variant.is_some()), ("order", self.lrs_order.is_some())];
        if let Some((option, _)) = options.into_iter().find(|&(_, is_given)| is_given && !is_lrs) {
            let algorithm = self.algorithm;
            return Err(Failure::bad(format!(
                "--lrs-{option}: {algorithm} has no such thing; use --algorithm lrs"
            )));
        }
        if self.certificate.is_some() && self.algorithm != Algorithm::Best {
            let algorithm = self.algorithm;
            return Err(Failure::bad(format!(
                "--certificate: {algorithm} proves nothing about costs; use --algorithm best"
            )));
        }
        Ok(())
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

/// Converts one mesh, or several.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let Arguments { input, output, several, .. } = arguments;
    several.each(input, output.as_deref(), arguments.alone(), |input, output| {
        let (input, output) = (input.to_owned(), output.map(Path::to_owned));
        convert(&Arguments { input, output, ..arguments.clone() })
    })
}

/// Reads, converts, checks, writes.
fn convert(arguments: &Arguments) -> Result<(), Failure> {
    arguments.check()?;
    let clock = SystemClock::default();
    let mut status = StatusLine::new("reading the mesh");
    let mut targets = Targets::open(Paths {
        input: &arguments.input,
        output: arguments.output.as_deref(),
        triangles: arguments.write_triangulation.as_deref(),
        stats: arguments.stats.as_deref(),
        certificate: arguments.certificate.as_deref(),
        given_up: arguments.given_up.as_deref(),
    })?;
    let aims = arguments.aims.read()?;
    let reading = arguments.repairs.reading;
    let (mesh, read_seconds) = clock.time(|| input::read(&arguments.input, reading));
    let mut mesh = mesh?;
    input::repair(&arguments.input, &mut mesh, arguments.repairs)?;
    if arguments.compare {
        return compare(arguments, &mesh, &aims, status);
    }
    status.stop_after(arguments.stop_after_paths.map_or(usize::MAX, |paths| paths as usize));
    let converted = arguments
        .converter(&mut status)
        .algorithm(arguments.in_full(arguments.algorithm))
        .aims(aims.aims.clone())
        .keep_proof(arguments.certificate.is_some())
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
            return targets.finish_without_mesh(&stats, &Fate::default(), &report.to_string());
        }
        Err(error) => {
            return Err(conversion_failure(arguments, &aims, &error, None));
        }
    };
    status.say("writing the quads");
    let (written, write_seconds) = clock.time(|| targets.write_mesh(quads.mesh()));
    written?;
    if let Some(proof) = quads.proof() {
        targets.write_certificate(|mut out| certificate::write(&mut out, &aims, proof))?;
    }
    targets.write_given_up(quads.given_up())?;
    let report = quads.report().clone();
    let (mut fate, mut losses) = (Fate::of(quads.mesh()), quads.losses().notes());
    if targets.drops_attributes() {
        fate = Fate::of_faces(quads.mesh());
        losses.clear();
    }
    let triangles = quads.into_triangle_mesh();
    if arguments.write_triangulation.is_some() {
        status.say("writing the triangles");
        targets.write_triangles(&triangles)?;
    }
    drop(status);
    let all_left_out = [fate.all(), losses.clone()].concat();
    let stats = stats(&report, write_seconds, &all_left_out);
    let mut summary = report.to_string();
    if !losses.is_empty() {
        summary = format!("{summary}; lost: {}", losses.join(", "));
    }
    targets.finish(&stats, &fate, &summary)?;
    tell_of_seams(arguments, &report, &triangles);
    Ok(())
}

/// Prints a note if the boundary of an open surface is partly one of seams that welding closes.
fn tell_of_seams(arguments: &Arguments, report: &Report, triangles: &Mesh) {
    /// Below, looking for seams takes no time to speak of.
    const FEW_TRIANGLES: usize = 100_000;
    /// The least share of boundary edges, so that looking is worth its time.
    const SHARE: usize = 100;
    let Arguments { input, repairs, .. } = arguments;
    let is_open = report.boundary_loops.is_some_and(|loops| loops > 0);
    // Every edge of an open surface has one face or two.
    let boundary_edges = (2 * report.edges).saturating_sub(3 * report.triangles);
    let may_look = report.triangles < FEW_TRIANGLES || SHARE * boundary_edges >= report.triangles;
    if !is_open || repairs.reading.weld.is_some() || !may_look || !may_have_seams(triangles) {
        return;
    }
    let refused = Refused::new(triangles, input, *repairs);
    if let Some(welding) = refused.welding_to_a_surface() {
        stdio::note(&format!("{}: note: {welding}", input.display()));
    }
}

/// Converts by every algorithm and prints a table.
fn compare(
    arguments: &Arguments,
    mesh: &Mesh,
    aims: &ReadAims,
    mut status: StatusLine,
) -> Result<(), Failure> {
    let mut table = comparison::Table::new(&aims.aims);
    for algorithm in Algorithm::ALL {
        let named = arguments.in_full(algorithm);
        let mut converter = arguments.converter(&mut status).algorithm(named);
        if named == Algorithm::Best {
            converter = converter.aims(aims.aims.clone());
        }
        match converter.run(mesh) {
            Ok(converted) => table.add(converted),
            Err(ConvertError::NeedsClosed(_)) => table.skip(named),
            Err(error) => {
                return Err(conversion_failure(arguments, aims, &error, Some(mesh)));
            }
        }
    }
    if let Some((deeds, options)) = arguments.aims.for_best_alone() {
        let mut converter = arguments.converter(&mut status).aims(aims.cost_alone());
        match converter.run(mesh) {
            Ok(without) => table.explain_best(&deeds, &options, without),
            Err(error) => {
                return Err(conversion_failure(arguments, aims, &error, Some(mesh)));
            }
        }
    }
    drop(status);
    stdio::say(&table.to_string())
}

/// Words a failure. The conversion has taken `mesh`, if it is none; then the file is read again.
fn conversion_failure(
    arguments: &Arguments,
    aims: &ReadAims,
    error: &ConvertError,
    mesh: Option<&Mesh>,
) -> Failure {
    let input = &arguments.input;
    if let Some(failure) = aims.failure(input, error) {
        return failure;
    }
    match error {
        ConvertError::Refused(survey) => {
            let open = (!arguments.open).then_some(OpenWay::Convert);
            let again = if mesh.is_none() { read_again(arguments) } else { None };
            input::refusal(input, mesh.or(again.as_ref()), survey, arguments.repairs, open)
        }
        ConvertError::NeedsClosed(_) | ConvertError::NeedsBest { .. } => {
            Failure::bad(format!("{}: {error}", input.display()))
        }
        _ => Failure::no(format!("{}: {error}", input.display())),
    }
}

/// Reads the input a second time, if it is a file.
fn read_again(arguments: &Arguments) -> Option<Mesh> {
    let Arguments { input, repairs, .. } = arguments;
    let mut mesh = (input.as_os_str() != "-").then(|| input::read(input, repairs.reading))?.ok()?;
    input::repair(input, &mut mesh, *repairs).ok()?;
    Some(mesh)
}
