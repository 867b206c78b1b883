//! Generated meshes kept in a folder, so that none is made twice.

use std::path::PathBuf;

use super::paper::{self, PaperMesh, Scale};
use super::recipe::{GenerateError, Recipe, paper_box, simplified};
use super::sealed::{self, SealedOutput};
use triquad::mesh::{Mesh, MeshError};
use triquad::simplify::Rule;
use triquad_generators::box_mesh::{PaperBox, Walls};

/// Increased whenever a recipe's bytes change: what was kept before is then no longer found.
const EDITION: u32 = 3;

/// A folder of generated meshes, each under the key of its recipe.
///
/// Only what takes longer to make than to read is kept: not the boxes themselves.
#[derive(Clone, Debug)]
pub struct Cache {
    folder: PathBuf,
}

impl Cache {
    /// Returns the cache in `folder`, which is made when it is needed.
    pub fn new(folder: impl Into<PathBuf>) -> Self {
        Self { folder: folder.into() }
    }

    /// Returns the mesh of `recipe` if it is kept. What is damaged, or another mesh, is not.
    pub fn kept(&self, recipe: &Recipe) -> Option<Mesh> {
        if recipe.is_costly() { sealed::read(&self.file(recipe)) } else { None }
    }

    /// Returns the mesh of `recipe`, read if it is kept, else made and kept.
    ///
    /// Of the papers' hierarchies, every mesh passed on the way to a smaller one is kept too.
    ///
    /// # Errors
    /// There is no such mesh, or it could not be kept.
    pub fn get(&self, recipe: &Recipe) -> Result<Mesh, GenerateError> {
        if !recipe.is_costly() {
            return recipe.make();
        }
        if let Some(list) = self.kept(recipe) {
            return Ok(list);
        }
        // Before the work starts, so that it is not in vain.
        let output = self.open(recipe)?;
        let list = match *recipe {
            Recipe::SimplifiedBox { of, vertices } => {
                self.make(of, &on_the_way(of, vertices), vertices)?
            }
            _ => recipe.make()?,
        };
        output.write(&list).map_err(|error| self.failure(error))?;
        Ok(list)
    }

    /// Returns the file in which the mesh of `recipe` is kept.
    pub fn file(&self, recipe: &Recipe) -> PathBuf {
        self.folder.join(format!("{}-e{EDITION}.ply", recipe.key()))
    }

    fn open(&self, recipe: &Recipe) -> Result<SealedOutput, GenerateError> {
        let folder = std::fs::create_dir_all(&self.folder).map_err(MeshError::from);
        folder.and_then(|()| sealed::create(self.file(recipe))).map_err(|error| self.failure(error))
    }

    fn failure(&self, error: MeshError) -> GenerateError {
        GenerateError::Cache { folder: self.folder.clone(), error }
    }

    /// Simplifies a box to `vertices`, and keeps what it is at each of `stops`, descending.
    fn make(&self, of: PaperBox, stops: &[u32], vertices: u32) -> Result<Mesh, GenerateError> {
        let source = paper_box(of, Walls::default(), 0)?;
        simplified(&source, Rule::Plain, stops, vertices, |stop, list| {
            let output = self.open(&Recipe::SimplifiedBox { of, vertices: stop })?;
            output.write(&list).map_err(|error| self.failure(error))
        })
    }
}

/// Returns the sizes above `vertices` of the papers' meshes from a box, descending.
fn on_the_way(of: PaperBox, vertices: u32) -> Vec<u32> {
    let passed = |mesh: PaperMesh| match mesh.recipe {
        Recipe::SimplifiedBox { of: other, vertices } if other == of => Some(vertices),
        _ => None,
    };
    let meshes = Scale::ALL.into_iter().flat_map(|scale| paper::ALL.map(|mesh| mesh.at(scale)));
    let mut stops: Vec<u32> = meshes.filter_map(passed).collect();
    stops.retain(|&stop| stop > vertices);
    stops.sort_unstable_by(|a, b| b.cmp(a));
    stops.dedup();
    stops
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_way_to_a_mesh_leads_through_all_larger_ones_of_its_box() {
        let recipe = |name| paper::named(name).unwrap().recipe;
        let [a1, b1] = ["A1", "B1"].map(|name| match recipe(name) {
            Recipe::PaperBox { shape, .. } => shape,
            other => panic!("{other:?} is no box"),
        });
        assert_eq!(on_the_way(a1, 745_697), [1_097_150, 991_416]);
        assert_eq!(on_the_way(b1, 604_150), [1_104_150, 994_979, 748_496]);
        assert!(on_the_way(PaperBox { holes: 7, ..a1 }, 10).is_empty());
    }

    #[test]
    fn what_is_kept_on_the_way_is_what_would_be_made() {
        let folder = tempfile::tempdir().unwrap();
        let cache = Cache::new(folder.path());
        let of = PaperBox { shafts: 2, depth: 30, holes: 2 };
        let smallest = cache.make(of, &[500, 300], 200).unwrap();
        let made = |vertices| Recipe::SimplifiedBox { of, vertices }.make().unwrap();
        assert_eq!(smallest, made(200));
        for stop in [500, 300] {
            let kept = cache.file(&Recipe::SimplifiedBox { of, vertices: stop });
            assert_eq!(Mesh::read(&kept).unwrap(), made(stop));
        }
    }
}
