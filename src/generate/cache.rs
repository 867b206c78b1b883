//! Generated meshes kept in a folder, so that none is made twice.

use std::path::PathBuf;

use super::{GenerateError, Recipe, into_list, paper, simplified};
use crate::mesh::{self, FaceList, MeshError, Output};

/// Increased whenever a recipe's bytes change: what was kept before is then no longer found.
const EDITION: u32 = 1;

/// A folder of generated meshes, each under the key of its recipe.
///
/// Only what takes longer to make than to read is kept: not the boxes themselves.
#[derive(Clone, Debug)]
pub struct Cache {
    folder: PathBuf,
}

impl Cache {
    /// The cache in `folder`, which is made when it is needed.
    pub fn new(folder: impl Into<PathBuf>) -> Self {
        Self { folder: folder.into() }
    }

    /// The mesh of `recipe`, read if it is there, else made and kept.
    ///
    /// Of the papers' hierarchies, every mesh passed on the way to a smaller one is kept too.
    ///
    /// # Errors
    /// There is no such mesh, or it could not be kept.
    pub fn get(&self, recipe: &Recipe) -> Result<FaceList, GenerateError> {
        if !recipe.is_costly() {
            return recipe.make();
        }
        // What cannot be read, damaged perhaps, is made anew.
        if let Ok(list) = mesh::read(&self.file(recipe)) {
            return Ok(list);
        }
        let list = self.make(recipe)?;
        self.keep(recipe, &list)?;
        Ok(list)
    }

    /// The file in which the mesh of `recipe` is kept.
    pub fn file(&self, recipe: &Recipe) -> PathBuf {
        self.folder.join(format!("{}-e{EDITION}.ply", recipe.key()))
    }

    fn keep(&self, recipe: &Recipe, list: &FaceList) -> Result<(), MeshError> {
        std::fs::create_dir_all(&self.folder)?;
        Output::create(&self.file(recipe))?.write(list)
    }

    fn make(&self, recipe: &Recipe) -> Result<FaceList, GenerateError> {
        let Recipe::SimplifiedBox { of, vertices } = *recipe else { return recipe.make() };
        let passed = |mesh: paper::PaperMesh| match mesh.recipe {
            Recipe::SimplifiedBox { of: other, vertices } if other == of => Some(vertices),
            _ => None,
        };
        let mut targets: Vec<u32> = paper::ALL.into_iter().filter_map(passed).collect();
        targets.retain(|&target| target > vertices);
        targets.push(vertices);
        targets.sort_unstable_by(|a, b| b.cmp(a));
        let mut sizes = targets.clone().into_iter();
        simplified(&into_list(of.surface()?), &targets, |list| {
            let vertices = sizes.next().expect("one mesh a target");
            Ok(self.keep(&Recipe::SimplifiedBox { of, vertices }, &list)?)
        })
    }
}
