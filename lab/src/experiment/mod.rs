//! Experiments: what is run, how, and what is recorded of it.
//!
//! Data flows one way: an experiment file becomes a plan, a plan becomes runs, a run becomes one
//! row of `runs.csv`. Reports read those rows, and the pictures beside them.

pub mod command_line;
mod completion;
pub mod data_folder;
pub mod estimate;
pub mod external;
mod flips;
pub mod folder_lock;
pub mod import;
pub mod job;
pub mod journal;
pub mod machine;
pub mod measured;
pub mod merge;
mod own_run;
mod places;
pub mod plan;
pub mod planned_mesh;
pub mod process;
pub mod program_spec;
pub mod record;
mod result_file;
pub mod results;
mod results_files;
pub mod run;
pub mod run_id;
pub mod spec;
pub mod spec_error;
pub mod task;
mod unused_keys;
pub mod verification;
mod workshop;

pub use job::Job;
pub use measured::Measured;
pub use record::{Outcome, RunRecord};
pub use results::Results;
pub use run_id::{MeshId, RunId};
pub use task::Task;
