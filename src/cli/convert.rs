//! `triquad convert`.

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::builder::PossibleValuesParser;
use clap::builder::TypedValueParser;
use serde::Serialize;
use triquad::atomic_file::AtomicFile;
use triquad::clock::{Clock, SystemClock};
use triquad::mesh::{FaceList, Output};
use triquad::{Algorithm, Augmentation, ConvertError, Settings, Summary, convert_list};

use super::input::{self, Repairs};
use super::progress::StatusLine;
use super::{Failure, machine, stdio};

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
    /// tq (ours, fastest), sg (simple greedy), ps (Pulli-Segal greedy)
    #[arg(long, default_value = "tq", value_name = "NAME", value_parser = algorithms())]
    algorithm: Algorithm,
    /// How the pairing is made perfect: local (ours) or tarjan (as published, slow on purpose)
    #[arg(long, default_value = "local", value_name = "NAME", value_parser = augmentations())]
    augmentation: Augmentation,
    /// Seed of the random choices of sg and ps; the same seed gives the same bytes
    #[arg(long, default_value_t = 0, value_name = "N")]
    seed: u64,
    /// Write counts and times as JSON to FILE, '-' for standard output
    #[arg(long, value_name = "FILE")]
    stats: Option<PathBuf>,
    #[command(flatten)]
    repairs: Repairs,
}

fn algorithms() -> impl TypedValueParser<Value = Algorithm> {
    PossibleValuesParser::new(Algorithm::ALL.map(Algorithm::id)).map(|id| {
        let named = Algorithm::ALL.into_iter().find(|algorithm| algorithm.id() == id);
        named.expect("one of the possible values")
    })
}

fn augmentations() -> impl TypedValueParser<Value = Augmentation> {
    PossibleValuesParser::new(Augmentation::ALL.map(Augmentation::id)).map(|id| {
        let named = Augmentation::ALL.into_iter().find(|augmentation| augmentation.id() == id);
        named.expect("one of the possible values")
    })
}

/// The record of one conversion.
#[derive(Serialize)]
struct Stats<'a> {
    schema: &'static str,
    input: String,
    algorithm: &'static str,
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
    left_out: &'a [String],
}

/// Reads, converts, checks, writes.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let clock = SystemClock::default();
    let mut status = StatusLine::new("reading the mesh");
    let mut targets = Targets::open(arguments)?;
    let (list, read_seconds) = clock.time(|| input::read(&arguments.input));
    let mut list = list?;
    if arguments.repairs.triangulate {
        list.triangulate();
    }
    let settings = Settings {
        algorithm: arguments.algorithm,
        augmentation: arguments.augmentation,
        seed: arguments.seed,
    };
    let converted = convert_list(list, arguments.repairs.orient, &settings, &clock, &mut status);
    let (quads, summary) =
        converted.map_err(|error| conversion_failure(&arguments.input, &error))?;
    status.say("writing the quads");
    let (written, write_seconds) = clock.time(|| targets.write_quads(&quads));
    written?;
    drop(status);
    let stats = stats(arguments, &summary, &quads.left_out, read_seconds, write_seconds);
    targets.write_stats(&stats)?;
    // Not before success: a failure is told in one line.
    input::tell_left_out(&arguments.input, &quads.left_out);
    targets.report(&summary_line(arguments, &stats))
}

fn conversion_failure(input: &Path, error: &ConvertError) -> Failure {
    match error {
        ConvertError::Refused(survey) => input::refusal(input, survey),
        ConvertError::Wrong(_) => Failure::no(format!("{}: {error}", input.display())),
    }
}

/// The files to be written, opened before the work starts.
struct Targets<'a> {
    arguments: &'a Arguments,
    quads: Option<Output>,
    stats: Option<AtomicFile>,
}

impl<'a> Targets<'a> {
    fn open(arguments: &'a Arguments) -> Result<Self, Failure> {
        let open_quads = |path: &PathBuf| {
            Output::create(path).map_err(|error| input::mesh_failure(path, &error))
        };
        let open_stats =
            |path: &PathBuf| AtomicFile::create(path).map_err(|error| stats_failure(path, &error));
        refuse_shared_files(arguments)?;
        Ok(Self {
            arguments,
            quads: arguments.output.as_ref().map(open_quads).transpose()?,
            stats: arguments
                .stats
                .as_ref()
                .filter(|path| path.as_os_str() != "-")
                .map(open_stats)
                .transpose()?,
        })
    }

    fn write_quads(&mut self, quads: &FaceList) -> Result<(), Failure> {
        match (self.quads.take(), &self.arguments.output) {
            (Some(output), Some(path)) => {
                output.write(quads).map_err(|error| input::mesh_failure(path, &error))
            }
            _ => Ok(()),
        }
    }

    fn write_stats(&mut self, stats: &Stats<'_>) -> Result<(), Failure> {
        let Some(path) = &self.arguments.stats else { return Ok(()) };
        let json = serde_json::to_string_pretty(stats)
            .map_err(|error| Failure::bad(format!("{}: {error}", path.display())))?;
        match self.stats.take() {
            None => stdio::say(&json),
            Some(mut file) => {
                let written = writeln!(file, "{json}").and_then(|()| file.commit());
                written.map_err(|error| stats_failure(path, &error))
            }
        }
    }

    /// Says the summary where it does not mix with what was asked for on standard output.
    fn report(&self, line: &str) -> Result<(), Failure> {
        if is_stdio(self.arguments.output.as_ref()) || is_stdio(self.arguments.stats.as_ref()) {
            stdio::complain(line);
            Ok(())
        } else {
            stdio::say(line)
        }
    }
}

/// Statistics may neither mix with the quads nor replace them or the input.
fn refuse_shared_files(arguments: &Arguments) -> Result<(), Failure> {
    let Some(stats) = &arguments.stats else { return Ok(()) };
    let same = |path: &PathBuf| identity(path).is_some_and(|one| Some(one) == identity(stats));
    if is_stdio(Some(stats)) {
        return match &arguments.output {
            Some(output) if output == stats => Err(Failure::bad(
                "-o - and --stats - would mix on standard output; send one of them to a file"
                    .into(),
            )),
            _ => Ok(()),
        };
    }
    if same(&arguments.input) || arguments.output.as_ref().is_some_and(same) {
        let problem =
            "--stats would overwrite the mesh of the same name; give it a file of its own";
        return Err(Failure::bad(format!("{}: {problem}", stats.display())));
    }
    Ok(())
}

/// The file that `path` means, whichever way there it takes.
fn identity(path: &Path) -> Option<PathBuf> {
    let through_folder = || {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
        Some(folder.unwrap_or(Path::new(".")).canonicalize().ok()?.join(path.file_name()?))
    };
    path.canonicalize().ok().or_else(through_folder)
}

fn is_stdio(path: Option<&PathBuf>) -> bool {
    path.is_some_and(|path| path.as_os_str() == "-")
}

fn stats_failure(path: &Path, error: &std::io::Error) -> Failure {
    Failure::bad(format!("{}: {error}; check the path and its permissions", path.display()))
}

fn stats<'a>(
    arguments: &Arguments,
    summary: &Summary,
    left_out: &'a [String],
    read_seconds: f64,
    write_seconds: f64,
) -> Stats<'a> {
    Stats {
        schema: "triquad-convert-1",
        input: arguments.input.display().to_string(),
        algorithm: arguments.algorithm.id(),
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
