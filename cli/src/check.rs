//! `triquad check`.

use std::path::{Path, PathBuf};

use serde::Serialize;
use triquad::counted::{counted, listed};
use triquad::pairing::Proof;
use triquad::quadrangulation::quality::Quality;
use triquad::quadrangulation::{FaceFault, MixedFaces, SharpEdges, check_mixed};
use triquad::triangulation::{Surface, Triangulation};
use triquad::{
    CheckError, CheckReport, DualGraph, Matching, Mesh, check, check_retriangulation, common_edges,
};

use crate::failure::Failure;
use crate::input::{self, Built, Fate, OpenWay, Repairs};
use crate::progress::StatusLine;
use crate::remedies::Refused;
use crate::targets::{Paths, Targets};
use crate::welding::Welding;
use crate::{aims, certificate};

/// Check that a quad mesh is a quadrangulation of a triangle mesh
///
/// Checks from the two files alone: same vertices, every quad the union of two triangles across
/// their common edge, every triangle in exactly one quad, closed, oriented, one fan round every
/// vertex, same Euler characteristic. On surfaces with boundary and one-sided ones triangles may be
/// left over, each a face of its own. Exit code 1 and one line if a check fails.
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  triquad check quads.obj --against bunny.obj\n  \
                        triquad check quads.obj --against bunny.obj --certificate proof.txt\n  \
                        triquad check mixed.obj --against bunny.obj --open --stats -")]
pub struct Arguments {
    /// The quad mesh
    #[arg(value_name = "QUADS")]
    quads: PathBuf,
    /// The triangle mesh that it was made from
    #[arg(long, value_name = "TRIANGLES")]
    against: PathBuf,
    /// The triangulation whose triangles were paired, if it is not TRIANGLES, from convert
    /// --write-triangulation. The quads are checked against it; it must triangulate the surface of
    /// TRIANGLES on the same vertices
    #[arg(long, value_name = "K", conflicts_with_all = ["open", "certificate"])]
    triangulation: Option<PathBuf>,
    /// Allow triangles that are left over, on closed surfaces, too
    #[arg(long)]
    open: bool,
    /// Verify the proof of convert --certificate that no other pairing is better under the aims in
    /// the file. Costs, edges to keep and the bound are computed anew
    #[arg(long, value_name = "FILE")]
    certificate: Option<PathBuf>,
    /// The costs, one integer an edge, if the certificate is about a file of costs
    #[arg(long, value_name = "FILE")]
    cost: Option<PathBuf>,
    /// Write counts and the shape of the quads as JSON to FILE, '-' for standard output
    #[arg(long, value_name = "FILE")]
    stats: Option<PathBuf>,
    #[command(flatten)]
    repairs: Repairs,
}

/// Counts and shape of a mesh that passed the check, from the files alone, whoever made them.
#[derive(Serialize)]
struct Stats {
    schema: &'static str,
    quads: usize,
    leftover_triangles: usize,
    vertices: usize,
    degree_two_vertices: usize,
    euler_characteristic: i64,
    #[serde(skip_serializing_if = "Option::is_none")]
    quality_minimum: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    quality_one_percent: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    quality_mean: Option<f64>,
    folded_quads: usize,
    quality_histogram: Vec<usize>,
    sharp_edges: usize,
    sharp_edges_kept: usize,
}

/// Reads both meshes and compares them.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let inputs =
        [Some(&arguments.quads), Some(&arguments.against), arguments.triangulation.as_ref()];
    if inputs.into_iter().flatten().filter(|path| path.as_os_str() == "-").count() > 1 {
        let problem = "standard input can be one of the meshes only; give the others as files";
        return Err(Failure::bad(format!("-: {problem}")));
    }
    if let (Some(costs), None) = (&arguments.cost, &arguments.certificate) {
        let remedy = "give --certificate FILE, too, or leave it out";
        let costs = costs.display();
        return Err(Failure::bad(format!("--cost {costs}: belongs to a certificate; {remedy}")));
    }
    let status = StatusLine::new("reading the meshes");
    let paths = Paths { stats: arguments.stats.as_deref(), ..Paths::of(&arguments.quads) };
    let targets = Targets::open(paths)?;
    let quads = input::read(&arguments.quads, arguments.repairs.reading)?;
    let (triangles, surface) = input::read_surface(&arguments.against, arguments.repairs)?;
    let statement = match &arguments.certificate {
        Some(path) => Some(Statement::read(path, arguments.cost.as_deref())?),
        None => None,
    };
    let mut shared = String::new();
    let paired = match &arguments.triangulation {
        Some(path) => {
            let paired = read_paired(path, arguments, &triangles, &surface)?;
            let (common, all) = common_edges(&paired, &triangles);
            let against = arguments.against.display();
            shared = format!("; edges of the triangulation in {against}: {common} of {all}");
            paired
        }
        None => triangles,
    };
    status.say("checking");
    let may_leave = arguments.open || statement.as_ref().is_some_and(Statement::may_leave);
    let all_quads = matches!(surface, Built::Closed(_)) && !may_leave;
    let needs_pairs = statement.is_some() || arguments.stats.is_some();
    let (report, matching) = compare(&quads, &paired, all_quads, needs_pairs)
        .map_err(|mismatch| failure(arguments, &surface, &quads, &paired, &mismatch))?;
    let proof = match (&statement, &matching) {
        (Some(statement), Some(matching)) => match &surface {
            Built::Closed(surface) => statement.verify(surface, &paired, matching)?,
            Built::Open(surface, _) => statement.verify(surface, &paired, matching)?,
        },
        _ => String::new(),
    };
    let stats = match (&arguments.stats, &matching) {
        (Some(_), Some(matching)) => Some(Stats::new(report, &quads, &paired, &surface, matching)),
        _ => None,
    };
    drop(status);
    targets.finish_without_mesh(
        &stats,
        &Fate::default(),
        &(describe(arguments, &report) + &shared + &proof),
    )
}

impl Stats {
    /// Measures `quads`, pairs of the triangles of `paired`, which triangulates `surface`.
    fn new(
        report: CheckReport,
        quads: &Mesh,
        paired: &Mesh,
        surface: &Built,
        matching: &Matching,
    ) -> Self {
        // Another triangulation may have been paired than that of the surface.
        let sharp = match (Triangulation::build(paired), surface) {
            (Ok(paired_surface), _) => sharp_edges(&paired_surface, paired, matching),
            (Err(_), Built::Open(surface, _)) => sharp_edges(surface, paired, matching),
            (Err(_), Built::Closed(surface)) => sharp_edges(surface, paired, matching),
        };
        let shape = Quality::new(quads);
        let if_any = |value| (report.quads > 0).then_some(value);
        Self {
            schema: "triquad-check-1",
            quads: report.quads,
            leftover_triangles: report.triangles,
            vertices: report.vertices,
            degree_two_vertices: report.degree_two_vertices,
            euler_characteristic: report.euler_characteristic,
            quality_minimum: if_any(shape.minimum),
            quality_one_percent: if_any(shape.one_percent),
            quality_mean: if_any(shape.mean),
            folded_quads: shape.folded,
            quality_histogram: shape.histogram.into(),
            sharp_edges: sharp.all,
            sharp_edges_kept: sharp.kept,
        }
    }
}

fn sharp_edges(surface: &impl Surface, triangles: &Mesh, matching: &Matching) -> SharpEdges {
    let pairing = MixedFaces::new(surface, matching);
    SharpEdges::new(surface, triangles.positions(), pairing.removed())
}

/// Reads the triangulation whose triangles were paired; that of a closed surface.
fn read_paired(
    path: &Path,
    arguments: &Arguments,
    given: &Mesh,
    surface: &Built,
) -> Result<Mesh, Failure> {
    if let Built::Open(_, survey) = surface {
        return Err(input::refusal(
            &arguments.against,
            Some(given),
            survey,
            arguments.repairs,
            None,
        ));
    }
    let paired = input::read_triangulation(path, arguments.repairs)?;
    check_retriangulation(&paired, given).map_err(|mismatch| {
        let where_it_is = match mismatch {
            CheckError::Moved(v) => displacement(v, &paired, given),
            _ => String::new(),
        };
        Failure::no(format!("{}: {mismatch}{where_it_is}", path.display()))
    })?;
    Ok(paired)
}

/// Compares the meshes; returns the counts and, where they are found or needed, the pairs.
fn compare(
    quads: &Mesh,
    triangles: &Mesh,
    all_quads: bool,
    needs_pairs: bool,
) -> Result<(CheckReport, Option<Matching>), CheckError> {
    let report = if all_quads { Some(check(quads, triangles)?) } else { None };
    let mixed = match report.is_none() || needs_pairs {
        true => Some(check_mixed(quads, triangles)?),
        false => None,
    };
    let counted = mixed.as_ref().map(|mixed| mixed.report);
    let report = report.or(counted).expect("one check or the other");
    Ok((report, mixed.map(|mixed| mixed.matching)))
}

/// Words what the check found.
fn failure(
    arguments: &Arguments,
    surface: &Built,
    quads: &Mesh,
    triangles: &Mesh,
    mismatch: &CheckError,
) -> Failure {
    let remedy = match (mismatch, surface) {
        // On other vertices, QUADS was not made from TRIANGLES, and --open not meant.
        (CheckError::VertexCount { .. } | CheckError::Moved(_), Built::Open(_, survey))
            if !arguments.open =>
        {
            let Arguments { against, repairs, .. } = arguments;
            let open = Some(OpenWay::Check);
            return input::refusal(against, Some(triangles), survey, *repairs, open);
        }
        (CheckError::VertexCount { quads, triangles: all }, _) => {
            let refused = Refused::new(triangles, &arguments.against, arguments.repairs);
            let welding = refused.welding();
            let welding = welding.filter(|welding| quads + welding.attempt.joined == *all);
            let remedy = |welding: &Welding| format!("; with {} it has as many", welding.option());
            welding.map(remedy).unwrap_or_default()
        }
        (CheckError::NotAQuad(_, FaceFault::Corners(3)), _) => {
            "; --open allows triangles that are left over".into()
        }
        (CheckError::Moved(v), _) => displacement(*v, quads, triangles),
        (CheckError::NotAPair(_), Built::Closed(_)) if arguments.triangulation.is_none() => {
            "; lrs flips edges first: write its triangles with convert --write-triangulation, and \
             give them with --triangulation"
                .into()
        }
        (CheckError::EdgeTwice(a, b) | CheckError::EdgeOpen(a, b), _) => {
            faces_where(quads, |from, to| [from, to] == [*a, *b] || [to, from] == [*a, *b])
        }
        (CheckError::Fans(v), _) => faces_where(quads, |from, _| from as usize == *v),
        _ => String::new(),
    };
    Failure::no(format!("{}: {mismatch}{remedy}", arguments.quads.display()))
}

/// Names the faces with a side, from one corner to the next, that fits.
fn faces_where(mesh: &Mesh, fits: impl Fn(u32, u32) -> bool) -> String {
    /// Of more faces only the number is named.
    const SHOWN: usize = 8;
    let has_side = |face: &[u32]| {
        let next = face.iter().cycle().skip(1);
        face.iter().zip(next).any(|(&from, &to)| fits(from, to))
    };
    let faces = mesh.faces().iter().enumerate().filter(|(_, face)| has_side(face));
    let mut names: Vec<String> = faces.map(|(face, _)| (face + 1).to_string()).collect();
    if names.len() > SHOWN {
        let more = names.split_off(SHOWN).len();
        names.push(format!("{more} more"));
    }
    let word = if names.len() == 1 { "face" } else { "faces" };
    if names.is_empty() { String::new() } else { format!(" ({word} {})", listed(&names)) }
}

/// Words where vertex `v` is in both meshes, and what may have moved it.
fn displacement(v: usize, quads: &Mesh, triangles: &Mesh) -> String {
    let [ours, given] = [quads, triangles].map(|mesh| mesh.positions()[v]);
    let single = |at: [f64; 3]| at.map(|coordinate| coordinate as f32);
    let remedy = match single(ours) == single(given) {
        true => {
            "the same in single precision, such as STL has: one file is rounded; compare with \
             the file that was converted"
        }
        false => "compare with the file that was converted",
    };
    let [ours, given] = [ours, given].map(|at| at.map(|coordinate| coordinate.to_string()));
    format!(": ({}) for ({}); {remedy}", ours.join(" "), given.join(" "))
}

/// Writes what was found to be right.
fn describe(arguments: &Arguments, report: &CheckReport) -> String {
    let left = match report.triangles {
        0 => String::new(),
        left => format!(" and {}", counted(left, "triangle", "triangles")),
    };
    format!(
        "ok: {}{left} on the {} of {}, {} of them of degree 2, Euler characteristic {}",
        counted(report.quads, "quad", "quads"),
        counted(report.vertices, "vertex", "vertices"),
        arguments.triangulation.as_ref().unwrap_or(&arguments.against).display(),
        report.degree_two_vertices,
        report.euler_characteristic,
    )
}

/// A certificate and the file that it was read from.
struct Statement<'a> {
    path: &'a Path,
    stated: certificate::Stated,
}

impl<'a> Statement<'a> {
    fn read(path: &'a Path, costs: Option<&Path>) -> Result<Self, Failure> {
        let mut stated = certificate::read(path)?;
        let name = path.display();
        match (costs, stated.costs_are_listed) {
            (Some(costs), true) => stated.aims.listed_costs = Some(aims::read_costs(costs)?),
            (None, false) => {}
            (None, true) => {
                return Err(Failure::bad(format!("{name}: is about costs in a file; add --cost")));
            }
            (Some(_), false) => {
                let remedy = "leave --cost out";
                return Err(Failure::bad(format!("{name}: is about costs of its own; {remedy}")));
            }
        }
        Ok(Self { path, stated })
    }

    /// Returns whether triangles may be left on closed surfaces.
    fn may_leave(&self) -> bool {
        self.stated.aims.strict || self.stated.aims.price.is_some()
    }

    /// Verifies that the pairing is the best; returns words for what is proved.
    fn verify(
        &self,
        surface: &impl Surface,
        triangles: &Mesh,
        matching: &Matching,
    ) -> Result<String, Failure> {
        let certificate::Stated { aims, certificate, barrier, .. } = &self.stated;
        let name = self.path.display();
        let objective = aims.objective(surface, triangles);
        let objective = objective.map_err(|error| Failure::no(format!("{name}: {error}")))?;
        let dual = DualGraph::new(surface);
        let kept = objective.kept().len();
        let proof = Proof::new(objective, certificate.clone(), barrier.clone(), &dual, matching);
        let verdict = proof.verify(&dual, matching);
        verdict.map_err(|error| Failure::no(format!("{name}: does not prove it: {error}")))?;
        let fewest = match (aims.price, matching.unpaired_count()) {
            (None, left) if left > 0 => {
                let left = counted(left, "triangle", "triangles");
                format!("no pairing leaves fewer than {left}, ")
            }
            _ => String::new(),
        };
        let given_up = match kept {
            0 => String::new(),
            all => {
                let all = counted(all, "edge", "edges");
                format!("none gives up fewer than {} of {all}, ", proof.given_up.len())
            }
        };
        Ok(format!("; proved: {fewest}{given_up}none costs less than {}", proof.cost))
    }
}
