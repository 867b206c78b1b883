//! Experiments: what is run, how, and what is remembered of it.
//!
//! Data flows one way: an experiment file becomes a plan, a plan becomes runs, a run becomes one row
//! of `runs.csv`. Reports read those rows and nothing else.

pub mod data;
pub mod estimate;
pub mod job;
pub mod journal;
mod judge;
pub mod machine;
pub mod merge;
pub mod plan;
pub mod process;
pub mod record;
pub mod results;
pub mod run;
pub mod spec;

pub use record::{Outcome, RunRecord};
pub use results::Results;
