//! The command-line tool as its users meet it: files, exit codes, one line of reasons, no remains.

mod check;
mod conversions;
mod counted_nouns;
mod generate;
#[cfg(unix)]
mod interrupts;
mod meshes;
mod reductions;
mod refusals;
mod remedies;
mod statistics;
