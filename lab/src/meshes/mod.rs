//! Meshes made to order: the boxes of both papers, what simplification makes of them, and stand-ins
//! for scans that are not at hand.
//!
//! A [`Recipe`] fixes every byte of its mesh. [`paper`] has the recipes of the papers' meshes by
//! name, and a [`Cache`] makes each mesh once.

mod cache;
mod origin;
pub mod paper;
mod recipe;
mod sealed;

pub use cache::Cache;
pub use origin::Origin;
pub use recipe::{GenerateError, MeshKind, Recipe};
pub use triquad_generators::box_mesh::{
    BoxShape, ImpossibleBoxError, ImpossiblePaperBoxError, PaperBox, Walls,
};
