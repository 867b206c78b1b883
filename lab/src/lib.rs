//! The laboratory: meshes of two papers, experiments on them, and reports of the results.
//!
//! * [`meshes`]: the papers' meshes by name, made to order and cached;
//! * [`experiment`]: an experiment file becomes a plan, the plan runs, each run a row of `runs.csv`;
//! * [`report`]: from those rows tables, plots, a verdict on every claim, and the page.
//!
//! Data flows in that order. A run is a process of its own, so that its time and memory are its
//! own; what it executes is the command `triquad`, which crate `triquad-cli` provides.
//!
//! The laboratory uses the public items of `triquad`, as any program would. It may use
//! `triquad-generators` for meshes and `triquad-render` for pictures. Neither of the three uses the
//! laboratory. Experiment files, the papers' tables and their claims stand in `experiments/`; the
//! tables and claims are compiled in.

pub mod experiment;
pub mod meshes;
pub mod report;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
