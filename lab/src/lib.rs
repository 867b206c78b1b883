//! The laboratory of `triquad`: it reproduces two papers.
//!
//! [`meshes`] makes the papers' meshes, [`experiment`] runs the algorithms on them and records each
//! run, [`pictures`] draws the quads, [`report`] turns records into tables, verdicts, plots and a
//! page, beside what [`paper`] has of the printed tables. [`algorithms`] holds what all of them
//! need of each algorithm, [`nearest`] guesses names.
//! Only public items of the library are used.

pub mod algorithms;
mod csv_text;
pub mod experiment;
mod file_hash;
pub mod meshes;
pub mod nearest;
pub mod paper;
pub mod pictures;
pub mod report;
mod whole_file;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
