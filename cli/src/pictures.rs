//! Pictures of the quads that the algorithms make of one mesh of an experiment.

use std::path::Path;

use triquad::{Algorithm, Converter, Expansion, Mesh};
use triquad_lab::experiment::machine::hash_of_words;
use triquad_lab::experiment::plan::{PlannedMesh, Source};
use triquad_lab::meshes::Cache;
use triquad_lab::report::gallery::{self, Shown};

use crate::failure::Failure;

/// The algorithms of Figures 5.11 to 5.14, and what came after them.
const DRAWN: [(&str, Algorithm); 6] = [
    ("sg", Algorithm::SimpleGreedy),
    ("ps", Algorithm::PulliSegal),
    ("ds", Algorithm::DiksStanczyk),
    ("lrs", Algorithm::Lrs(Expansion::Printed)),
    ("lrs few-flips", Algorithm::Lrs(Expansion::FewFlips)),
    ("tq", Algorithm::EagerRescue),
];

/// Draws into `pictures` in `out`, which takes seconds and is told to `say`, unless these pictures are
/// there already.
pub fn draw(
    out: &Path,
    mesh: &PlannedMesh,
    cache: Option<&Path>,
    program_hash: &str,
    say: impl FnOnce(&str),
) -> Result<(), Failure> {
    let folder = out.join("pictures");
    let list = read_or_make(mesh, cache)?;
    let key = hash_of_words(&[program_hash, &mesh.name, &format!("{:?}", mesh.source)]);
    let known = gallery::read(&folder);
    let is_there = |row: &Shown| row.key == key && folder.join(&row.file).is_file();
    if known.len() == 2 * DRAWN.len() + 2 && known.iter().all(is_there) {
        return Ok(());
    }
    say(&format!("drawing the pictures of {}", mesh.name));
    let failure = |problem: String| Failure::bad(format!("{}: {problem}", folder.display()));
    std::fs::create_dir_all(&folder).map_err(|error| failure(error.to_string()))?;
    let about = Shown { key, ..Shown::default() };
    let mut rows =
        gallery::draw_box(&folder, &about).map_err(|error| failure(error.to_string()))?;
    for (name, algorithm) in DRAWN {
        let about = Shown {
            mesh: mesh.name.clone(),
            mesh_kind: mesh.kind().into(),
            algorithm: name.into(),
            ..about.clone()
        };
        let converted = Converter::new().algorithm(algorithm).run(&list);
        let quads = converted.map_err(|error| failure(error.to_string()))?;
        let drawn = gallery::draw_quads(&folder, &about, quads.mesh(), &list);
        rows.extend(drawn.map_err(|error| failure(error.to_string()))?);
    }
    gallery::write(&folder, &rows).map_err(|error| failure(error.to_string()))
}

fn read_or_make(mesh: &PlannedMesh, cache: Option<&Path>) -> Result<Mesh, Failure> {
    let name = &mesh.name;
    match &mesh.source {
        Source::File(path, _) => crate::input::read(path),
        Source::Made(made, _) => match cache {
            Some(folder) => Cache::new(folder).get(&made.recipe),
            None => made.recipe.make(),
        }
        .map_err(|error| Failure::bad(format!("{name} cannot be drawn: {error}"))),
    }
}
