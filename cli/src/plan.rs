//! `triquad plan`.

use std::fmt::Write as _;

use triquad::counted::counted;
use triquad_lab::experiment::estimate::{Estimate, run_seconds};
use triquad_lab::experiment::plan::{Block, Plan, PlannedRun};

use crate::experiments::{Selection, duration, in_words};
use crate::failure::Failure;
use crate::stdio;

/// List the runs of an experiment, with an estimate of the time
#[derive(clap::Args)]
#[command(after_help = "Example: triquad plan experiments/comparison.toml --scale small")]
pub struct Arguments {
    #[command(flatten)]
    selection: Selection,
}

/// Prints the meshes, their runs and an estimate.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let plan = arguments.selection.plan()?;
    stdio::say(&matrix(&plan))
}

/// Writes a line a mesh, under the names of experiment and group.
fn matrix(plan: &Plan) -> String {
    let mut text = String::new();
    let mut heading = String::new();
    for block in plan.blocks.iter().filter(|block| is_first(plan, block)) {
        let group = format!("{} / {}", block.id.experiment, block.id.group);
        if group != heading {
            let _ = writeln!(text, "{group}");
            heading = group;
        }
        let seconds = same_mesh(plan, block)
            .flat_map(|block| block.runs.iter().filter_map(|run| run_seconds(&block.mesh, run)))
            .reduce(|sum, seconds| sum + seconds);
        let mesh = &block.mesh;
        let _ = writeln!(
            text,
            "  {:<28} {:<10} {:>9} triangles, genus {:<5} {:>9}  {}",
            mesh.name,
            mesh.kind().id(),
            mesh.triangles,
            mesh.genus,
            seconds.map_or("–".into(), duration),
            jobs(block),
        );
    }
    let runs: usize = plan.blocks.iter().map(|block| block.runs.len()).sum();
    let runs = counted(runs, "run", "runs");
    let _ = write!(text, "{runs}: {}", in_words(&Estimate::new(plan)));
    text
}

/// Returns the blocks of the same mesh, experiment and group.
fn same_mesh<'a>(plan: &'a Plan, block: &'a Block) -> impl Iterator<Item = &'a Block> {
    plan.blocks.iter().filter(move |other| other.id == block.id)
}

fn is_first(plan: &Plan, block: &Block) -> bool {
    same_mesh(plan, block).next().is_some_and(|first| std::ptr::eq(first, block))
}

/// Writes the jobs of a block: `10 x sg tarjan, 1 x gw local (first 9 paths)`.
fn jobs(block: &Block) -> String {
    let name = |run: &PlannedRun| {
        let first = |paths| counted(paths as usize, "path", "paths");
        let stopped = run.stop_after_paths.map(|paths| format!(" (first {})", first(paths)));
        format!("{} x {}{}", run.repetitions, run.job.name(), stopped.unwrap_or_default())
    };
    let mut jobs: Vec<String> = block.runs.iter().map(name).collect();
    jobs.sort();
    jobs.join(", ")
}
