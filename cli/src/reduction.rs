//! The common part of `irreducible` and `simplify`: a triangulation comes in, a smaller one goes
//! out.

use std::path::{Path, PathBuf};

use serde::Serialize;
use triquad::clock::{Clock, SystemClock};
use triquad::{Mesh, Size, Triangulation};

use crate::failure::Failure;
use crate::input::{self, Fate, Repairs};
use crate::progress::StatusLine;
use crate::targets::{Paths, Targets};

/// Options of both verbs.
#[derive(clap::Args)]
pub struct Options {
    /// Write counts and times as JSON to FILE, '-' for standard output
    #[arg(long, value_name = "FILE")]
    stats: Option<PathBuf>,
    #[command(flatten)]
    repairs: Repairs,
}

/// A triangulation that was read, and the files that the result goes to.
pub struct Opened<'a> {
    pub status: StatusLine,
    pub targets: Targets<'a>,
    pub mesh: Mesh,
    pub triangulation: Triangulation,
    pub size: Size,
    pub read_seconds: f64,
    pub build_seconds: f64,
    pub fate: Fate,
}

/// Counts of the input and of the result.
#[derive(Serialize)]
pub struct Sizes {
    #[serde(flatten)]
    pub input: Size,
    pub result_vertices: usize,
    pub result_edges: usize,
    pub result_triangles: usize,
    pub contractions: usize,
}

impl<'a> Opened<'a> {
    /// Opens the files to write, reads the mesh and builds its triangulation.
    pub fn open(
        input: &'a Path,
        output: Option<&'a Path>,
        options: &'a Options,
        clock: &SystemClock,
    ) -> Result<Self, Failure> {
        let status = StatusLine::new("reading the mesh");
        let stats = options.stats.as_deref();
        let targets = Targets::open(Paths { output, stats, ..Paths::of(input) })?;
        let (mesh, read_seconds) = clock.time(|| input::read(input, options.repairs.reading));
        let mut mesh = mesh?;
        status.say("building the triangulation");
        let (built, build_seconds) = clock.time(|| input::build(input, &mut mesh, options.repairs));
        let triangulation = built?;
        Ok(Self {
            size: Size::from(&triangulation),
            fate: Fate::of_faces(&mesh),
            status,
            targets,
            mesh,
            triangulation,
            read_seconds,
            build_seconds,
        })
    }
}

impl Sizes {
    /// Counts `result`; each contraction has removed one vertex.
    pub fn new(input: Size, result: &Triangulation) -> Self {
        let result_vertices = result.vertex_count();
        Self {
            input,
            result_vertices,
            result_edges: result.edge_count(),
            result_triangles: result.triangle_count(),
            contractions: input.vertices - result_vertices,
        }
    }
}
