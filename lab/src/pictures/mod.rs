//! Pictures of the quads that the algorithms of an experiment make of one of its meshes, and of the
//! box.

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
use crate::experiment::plan::Pictured;
use crate::experiment::planned_mesh::{PlannedMesh, Source};
use crate::meshes::{Cache, GenerateError, paper};
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

/// Draws the quads that algorithms make of a mesh into `pictures` in `out`, and the box if the mesh
/// is one of the papers, unless these pictures are there.
///
/// Takes seconds; `begin` is called before. Meshes that take long to make are kept in `cache`.
///
/// # Errors
/// The mesh cannot be had, converted or drawn, or a file cannot be written.
pub fn draw(
    out: &Path,
    Pictured { mesh, algorithms }: &Pictured,
    cache: Option<&Path>,
    program_hash: &str,
    begin: impl FnOnce(),
) -> Result<(), DrawError> {
    let folder = out.join("pictures");
    let has_box = paper::named(&mesh.name).is_some();
    let source = format!("{:?}", mesh.source);
    let mut words = vec![program_hash, &mesh.name, &source];
    words.extend(algorithms.iter().map(|facts| facts.name));
    let key = hash_of_words(&words);
    let known = PictureRecord::read_all(&folder);
    let is_there = |row: &PictureRecord| row.key == key && folder.join(&row.file).is_file();
    let count = View::ALL.len() * (algorithms.len() + usize::from(has_box));
    if known.len() == count && known.iter().all(is_there) {
        return Ok(());
    }
    begin();
    let input = read_or_make(mesh, cache)?;
    std::fs::create_dir_all(&folder)?;
    let about = PictureRecord { key, ..PictureRecord::default() };
    let mut rows = if has_box { draw_box(&folder, &about)? } else { Vec::new() };
    for facts in algorithms {
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
