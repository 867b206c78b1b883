//! Tests of the program `triquad`, as a user calls it.

mod adversary;
mod aims;
mod cases_of_arguments;
mod cases_of_experiments;
mod cases_of_newcomers;
mod cases_of_readers;
mod conveniences;
mod defective_meshes;
#[cfg(unix)]
mod documents;
mod experiment_text;
mod experiments;
#[cfg(unix)]
mod kills;
#[cfg(target_os = "linux")]
mod limits;
#[cfg(unix)]
mod numbers;
mod open;
#[cfg(unix)]
mod option_tables;
mod own_results;
#[path = "../../../lab/tests/lab/records.rs"]
mod records;
mod repeatable;
mod report_files;
mod results;
mod runner;
#[cfg(target_os = "linux")]
mod slurm;
#[cfg(unix)]
mod stats_fields;
mod surfaces;
mod verbs;
mod workshop;
