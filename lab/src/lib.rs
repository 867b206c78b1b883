//! placeholder

pub mod experiment;
pub mod meshes;
pub mod report;
