//! `triquad generate`.

use std::path::{Path, PathBuf};

use clap::{Args, Subcommand};
use triquad::clock::{Clock, SystemClock};
use triquad::counted::counted;
use triquad::mesh::Output;
use triquad::simplify::{Shape, SimplifyError};
use triquad_lab::meshes::paper::{PaperMesh, Scale};
use triquad_lab::meshes::{
    BoxShape, Cache, GenerateError, ImpossibleBoxError, ImpossiblePaperBoxError, PaperBox, Recipe,
    Walls,
};

use crate::failure::Failure;
use crate::formats::writes;
use crate::names::{MeshOfPapers, one_of};
use crate::progress::StatusLine;
use crate::{input, stdio};

/// Make a mesh of chosen size and genus
///
/// The same arguments make the same bytes on every machine.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
                  triquad generate box --vertices 5000 --cavities 20 --holes 5 -o box.obj\n  \
                  triquad generate paper-box --shafts 20 --holes 30 -o box.obj\n  \
                  triquad generate stand-in --vertices 20000 --genus 5 --seed 1 -o blob.ply\n  \
                  triquad generate paper A1 -o a1.obj")]
pub struct Arguments {
    #[command(subcommand)]
    mesh: MeshCommand,
}

#[derive(Subcommand)]
enum MeshCommand {
    Box(BoxArguments),
    PaperBox(PaperBoxArguments),
    StandIn(StandInArguments),
    Paper(PaperArguments),
}

/// A box with a square array of square shafts, each a cavity or a hole
///
/// Nearly all vertices have degree 6. The genus is the number of holes.
#[derive(Args)]
#[command(after_help = "Example: triquad generate box --vertices 5000 --holes 16 -o box.obj")]
struct BoxArguments {
    /// Number of vertices, met exactly
    #[arg(long, value_name = "V")]
    vertices: u32,
    /// Shafts that end inside the box
    #[arg(long, value_name = "C", default_value_t = 0)]
    cavities: u32,
    /// Shafts that go through: the genus
    #[arg(long, value_name = "H", default_value_t = 0)]
    holes: u32,
    // Scripts may give all generators a seed.
    #[arg(long, value_name = "N", hide = true)]
    seed: Option<u64>,
    #[command(flatten)]
    target: Target,
}

/// A box like the papers': deep shafts one cell wide, one cell apart, on a square lattice
///
/// With the default options it is A1, with --holes 3500 it is B1. The box is 2 M + 1 by 2 M + 3 by
/// D + 2 cells; horizontal cells are cut in four, the others in two. A hole in place of a cavity
/// adds 2 vertices and 8 triangles.
#[derive(Args)]
#[command(
    after_help = "Example: triquad generate paper-box --shafts 20 --depth 40 --holes 30 -o box.obj"
)]
struct PaperBoxArguments {
    /// Shafts in a row of the array, and rows
    #[arg(long, value_name = "M", default_value_t = PaperBox::PUBLISHED.shafts)]
    shafts: u32,
    /// Depth of a cavity in cells
    #[arg(long, value_name = "D", default_value_t = PaperBox::PUBLISHED.depth)]
    depth: u32,
    /// Shafts that go through: the genus
    #[arg(long, value_name = "H", default_value_t = 0)]
    holes: u32,
    /// Diagonals of the four walls of a shaft: alternating, equal, paired (parallel in opposite
    /// walls) or drawn (for each wall, by --seed)
    #[arg(long, default_value = "alternating", value_name = "NAME")]
    #[arg(value_parser = one_of(Walls::ALL, Walls::id))]
    walls: Walls,
    /// Seed of --walls drawn; the same seed gives the same bytes [default: 0]
    #[arg(long, value_name = "N")]
    seed: Option<u64>,
    #[command(flatten)]
    target: Target,
}

/// An organic surface with the irregular connectivity of a simplified scan
///
/// Simplifies a smooth random surface of at least three times as many vertices. The mesh is kept in
/// the cache.
#[derive(Args)]
#[command(after_help = "Example: triquad generate stand-in --vertices 20000 --genus 5 -o blob.obj")]
struct StandInArguments {
    /// Number of vertices, met exactly
    #[arg(long, value_name = "V")]
    vertices: u32,
    /// Genus
    #[arg(long, value_name = "G")]
    genus: u32,
    /// Seed of the shape; the same seed gives the same bytes
    #[arg(long, value_name = "N", default_value_t = 0)]
    seed: u64,
    #[command(flatten)]
    target: Target,
    #[command(flatten)]
    cache: CacheOption,
}

/// A mesh with the vertices, edges, triangles and genus of one of the papers' meshes
///
/// A and B are the boxes of Table 4.2 of the comparison paper and their simplifications. ir-B, ir-C
/// and ir-D are those of Tables 3 to 5 of the paper on irreducible triangulations. Scans are
/// stand-ins: at full scale they have the scan's counts and genus, not its shape. Simplified meshes
/// are kept in the cache.
#[derive(Args)]
#[command(after_help = "Example: triquad generate paper ir-B4 -o ir-b4.ply")]
struct PaperArguments {
    /// The mesh
    #[arg(value_name = "NAME", value_parser = MeshOfPapers)]
    mesh: PaperMesh,
    /// Size: full, small (a twentieth) or demo (a hundredth)
    #[arg(long, default_value = "full", value_name = "SCALE")]
    #[arg(value_parser = one_of(Scale::ALL, Scale::id))]
    scale: Scale,
    #[command(flatten)]
    target: Target,
    #[command(flatten)]
    cache: CacheOption,
}

#[derive(Args)]
struct Target {
    #[arg(short, long, value_name = "OUT", help = writes("Where the mesh goes"))]
    output: PathBuf,
}

/// The option that names the cache.
#[derive(Args)]
pub struct CacheOption {
    /// Folder for meshes that take long to make [default: 'triquad' in the user's folder for
    /// caches]
    #[arg(long, value_name = "DIR", env = "TRIQUAD_CACHE")]
    cache: Option<PathBuf>,
}

/// Makes the mesh and writes it.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let (recipe, genus, target, cache) = match &arguments.mesh {
        MeshCommand::Box(BoxArguments { vertices, cavities, holes, seed, target }) => {
            if seed.is_some() {
                stdio::note("note: --seed has no effect: nothing about a box is random");
            }
            let shape = BoxShape { cavities: *cavities, holes: *holes, vertices: *vertices };
            (Recipe::Box(shape), *holes, target, None)
        }
        MeshCommand::PaperBox(PaperBoxArguments { shafts, depth, holes, walls, seed, target }) => {
            let shape = PaperBox { shafts: *shafts, depth: *depth, holes: *holes };
            if seed.is_some() && *walls != Walls::Drawn {
                stdio::note("note: --seed has no effect without --walls drawn");
            }
            (
                Recipe::PaperBox { shape, walls: *walls, seed: seed.unwrap_or(0) },
                *holes,
                target,
                None,
            )
        }
        MeshCommand::StandIn(StandInArguments { vertices, genus, seed, target, cache }) => {
            let recipe = Recipe::StandIn { vertices: *vertices, genus: *genus, seed: *seed };
            (recipe, *genus, target, cache.folder())
        }
        MeshCommand::Paper(PaperArguments { mesh, scale, target, cache }) => {
            let PaperMesh { recipe, genus, .. } = mesh.at(*scale);
            (recipe, genus, target, cache.folder())
        }
    };
    make(&recipe, genus, &target.output, cache.map(Cache::new))
}

impl CacheOption {
    /// Returns the folder of the cache, if the system has a place for one.
    pub fn folder(&self) -> Option<PathBuf> {
        let usual = || dirs::cache_dir().map(|folder| folder.join("triquad"));
        self.cache.clone().or_else(usual)
    }
}

/// Makes the mesh of `recipe`, from `cache` if there is one, and writes it to `path`.
fn make(recipe: &Recipe, genus: u32, path: &Path, cache: Option<Cache>) -> Result<(), Failure> {
    let clock = SystemClock::default();
    let output = Output::create(path).map_err(|error| input::mesh_failure(path, &error))?;
    let status = StatusLine::new("making the mesh");
    let (kept, read_seconds) = clock.time(|| cache.as_ref()?.kept(recipe));
    let (mesh, origin) = match kept {
        Some(mesh) => (mesh, format!("read from the cache in {read_seconds:.3} s")),
        None => {
            let (made, seconds) = clock.time(|| match &cache {
                Some(cache) => cache.get(recipe),
                None => recipe.make(),
            });
            let mesh = made.map_err(|error| failure(recipe, &error))?;
            (mesh, format!("made in {seconds:.3} s"))
        }
    };
    status.say("writing the mesh");
    let shape = Shape::new(&mesh);
    let (written, write_seconds) = clock.time(|| output.write(&mesh));
    written.map_err(|error| input::mesh_failure(path, &error))?;
    drop(status);
    let line = format!(
        "{}: {}, {}, genus {genus}; largest degree {}, angles {:.1} to {:.1} degrees; {origin}, \
         written in {write_seconds:.3} s",
        path.display(),
        counted(mesh.positions().len(), "vertex", "vertices"),
        counted(mesh.faces().len(), "triangle", "triangles"),
        shape.largest_degree,
        shape.smallest_angle(),
        shape.largest_angle(),
    );
    if path.as_os_str() == "-" {
        stdio::complain(&line);
        return Ok(());
    }
    stdio::say(&line)
}

fn failure(recipe: &Recipe, error: &GenerateError) -> Failure {
    let wanted = match recipe {
        Recipe::Box(_) => "a box",
        Recipe::PaperBox { .. } | Recipe::SimplifiedBox { .. } => "a box of the papers' kind",
        Recipe::StandIn { .. } => "a stand-in",
        Recipe::StarredBipyramid { .. } => "a bipyramid",
    };
    let from = |least: u64| format!("ask for {least} or more");
    let remedy = match error {
        GenerateError::Box(ImpossibleBoxError::TooFewVertices { minimum, .. }) => from(*minimum),
        GenerateError::Simplify(SimplifyError::Irreducible { reached, .. }) => {
            possible(recipe, *reached).map_or("ask for more vertices".into(), from)
        }
        error => general_remedy(error).into(),
    };
    Failure::bad(format!("{wanted}: {error}; {remedy}"))
}

/// Returns a number of vertices, `reached` or not much more, with which the stand-in can be made.
/// Each number has draws of its own, so that this takes trials.
fn possible(recipe: &Recipe, reached: usize) -> Option<u64> {
    const TRIALS: usize = 8;
    let Recipe::StandIn { genus, seed, .. } = *recipe else { return None };
    let mut vertices = u32::try_from(reached).ok()?;
    for _ in 0..TRIALS {
        match (Recipe::StandIn { vertices, genus, seed }).make() {
            Ok(_) => return Some(vertices.into()),
            Err(_) => vertices += 1 + vertices / 16,
        }
    }
    None
}

fn general_remedy(error: &GenerateError) -> &'static str {
    match error {
        GenerateError::Box(_) => "ask for fewer vertices",
        GenerateError::PaperBox(ImpossiblePaperBoxError::NoDepth) => "ask for a depth of 1 or more",
        GenerateError::PaperBox(ImpossiblePaperBoxError::TooManyHoles { .. }) => {
            "ask for fewer holes or more shafts"
        }
        GenerateError::PaperBox(_) => "ask for fewer shafts or less depth",
        GenerateError::TooLarge { .. } => "ask for fewer vertices or a smaller genus",
        GenerateError::Simplify(_) => "ask for more vertices",
        GenerateError::Cache { .. } => "check its permissions, or name another folder with --cache",
        _ => "ask for another mesh",
    }
}
