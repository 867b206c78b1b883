//! Pictures of the quads that the algorithms make of one mesh of an experiment, and of the box.
//!
//! Which algorithms are drawn is decided in [`crate::algorithms`].

mod polygons;
mod quads;
mod record;
mod shaft_box;

use std::io;
use std::path::{Path, PathBuf};

use triquad::{ConvertError, Converter, Mesh, MeshError};
use triquad_render::PictureError;

pub use polygons::polygons;
pub use quads::{POOR, QuadScene};
pub use record::{PictureRecord, Subject, View};
pub use shaft_box::{DRAWN_DEPTH, box_picture};

use crate::algorithms::AlgorithmFacts;
use crate::experiment::job::{UnknownNameError, find_conversion};
use crate::experiment::machine::hash_of_words;
use crate::experiment::planned_mesh::{PlannedMesh, Source};
use crate::meshes::{Cache, GenerateError};
use crate::whole_file;

/// Reason why a mesh is not drawn.
#[derive(Debug, thiserror::Error)]
pub enum DrawError {
    /// Its file cannot be read.
    #[error("{}: {error}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// The fault.
        error: MeshError,
    },
    /// It cannot be made.
    #[error(transparent)]
    Make(#[from] GenerateError),
    /// It cannot be converted.
    #[error(transparent)]
    Convert(#[from] ConvertError),
    /// An algorithm is not known.
    #[error(transparent)]
    Algorithm(#[from] UnknownNameError),
    /// Its quads cannot be drawn.
    #[error(transparent)]
    Picture(#[from] PictureError),
    /// A file cannot be written.
    #[error(transparent)]
    Write(#[from] io::Error),
}

/// Returns whether the folder `pictures` in `out` has every picture that its list names.
pub fn are_complete(out: &Path) -> bool {
    let folder = out.join("pictures");
    let rows = PictureRecord::read_all(&folder);
    !rows.is_empty() && rows.iter().all(|row| folder.join(&row.file).is_file())
}

/// Draws the quads of `mesh` and the box into `pictures` in `out`, unless these pictures are there.
///
/// Takes seconds; `begin` is called before. Meshes that take long to make are kept in `cache`.
///
/// # Errors
/// The mesh cannot be had, converted or drawn, or a file cannot be written.
pub fn draw(
    out: &Path,
    mesh: &PlannedMesh,
    cache: Option<&Path>,
    program_hash: &str,
    begin: impl FnOnce(),
) -> Result<(), DrawError> {
    let folder = out.join("pictures");
    let drawn = AlgorithmFacts::all().iter().filter(|facts| facts.is_pictured);
    let key = hash_of_words(&[program_hash, &mesh.name, &format!("{:?}", mesh.source)]);
    let known = PictureRecord::read_all(&folder);
    let is_there = |row: &PictureRecord| row.key == key && folder.join(&row.file).is_file();
    let count = View::ALL.len() * (drawn.clone().count() + 1);
    if known.len() == count && known.iter().all(is_there) {
        return Ok(());
    }
    begin();
    let input = read_or_make(mesh, cache)?;
    std::fs::create_dir_all(&folder)?;
    let about = PictureRecord { key, ..PictureRecord::default() };
    let mut rows = draw_box(&folder, &about)?;
    for facts in drawn {
        let about = PictureRecord {
            mesh: mesh.name.clone(),
            mesh_kind: Some(mesh.kind()),
            algorithm: facts.name.into(),
            ..about.clone()
        };
        rows.extend(draw_quads(&folder, &about, &quads_of(&input, facts)?, &input)?);
    }
    Ok(PictureRecord::write_all(&folder, &rows)?)
}

fn read_or_make(mesh: &PlannedMesh, cache: Option<&Path>) -> Result<Mesh, DrawError> {
    match (&mesh.source, cache) {
        (Source::File(path, _), _) => Mesh::read(path)
            .map_err(|error| DrawError::Read { path: path.clone(), error: error.without_path() }),
        (Source::Made(made, _), Some(folder)) => Ok(Cache::new(folder).get(&made.recipe)?),
        (Source::Made(made, _), None) => Ok(made.recipe.make()?),
    }
}

fn quads_of(input: &Mesh, facts: &AlgorithmFacts) -> Result<Mesh, DrawError> {
    let algorithm = find_conversion(facts.name)?;
    Ok(Converter::new().algorithm(algorithm).run(input)?.into_mesh())
}

/// Draws quads in both views, as in Figures 5.11 to 5.14 of Lemos et al.
fn draw_quads(
    folder: &Path,
    about: &PictureRecord,
    quads: &Mesh,
    input: &Mesh,
) -> Result<Vec<PictureRecord>, DrawError> {
    let scene = QuadScene::new(quads, input);
    let draw = |view: View| {
        let file = format!("quads-{}-{}.png", about.algorithm.replace(' ', "-"), view.id());
        whole_file::write(&folder.join(&file), &scene.draw(view)?.small_png())?;
        Ok(PictureRecord {
            file,
            subject: Subject::Quads,
            view,
            quads: scene.quad_count(),
            edges: scene.edge_count(),
            flipped_edges: scene.flipped_count(),
            poor_quads: scene.poor_count(),
            ..about.clone()
        })
    };
    View::ALL.into_iter().map(draw).collect()
}

/// Draws the box in both views, as in Figure 14 of Ramaswami and Siqueira.
fn draw_box(folder: &Path, about: &PictureRecord) -> io::Result<Vec<PictureRecord>> {
    let draw = |view: View| {
        let file = format!("box-{}.png", view.id());
        whole_file::write(&folder.join(&file), &box_picture(view).small_png())?;
        Ok(PictureRecord { file, subject: Subject::Box, view, ..about.clone() })
    };
    View::ALL.into_iter().map(draw).collect()
}
