//! Options that `plan` and `run` share: experiment files, data folders, scale, shard.

use std::path::{Path, PathBuf};

use triquad_lab::experiment::data_folder::{self, DataMesh, DataSurvey};
use triquad_lab::experiment::estimate::Estimate;
use triquad_lab::experiment::plan::{Pictured, Plan};
use triquad_lab::experiment::spec::Experiment;
use triquad_lab::meshes::paper::Scale;

use crate::failure::Failure;
use crate::names::one_of;
use crate::stdio;

/// The runs to do.
#[derive(clap::Args)]
pub struct Selection {
    /// The experiment files
    #[arg(value_name = "EXPERIMENT.toml", required = true)]
    files: Vec<PathBuf>,
    /// Size of the papers' meshes: full, small (a twentieth) or demo (a hundredth)
    #[arg(long, default_value = "full", value_name = "SCALE")]
    #[arg(value_parser = one_of(Scale::ALL, Scale::id))]
    scale: Scale,
    /// A folder with meshes of your own: scans of the papers by name ('botijo.obj', 'eros.ply.gz'
    /// …) at scale full, others under the names of their files: at scale full in groups with
    /// other_data, at every scale where an experiment names them. May be given more than once
    #[arg(long, value_name = "DIR")]
    data: Vec<PathBuf>,
    /// Do the I-th of N parts only; other machines do the others
    #[arg(long, value_name = "I/N", value_parser = parse_shard)]
    shard: Option<(usize, usize)>,
    /// Seconds after which a run is stopped, instead of the limit in the experiment file
    #[arg(long, value_name = "S", value_parser = clap::value_parser!(u64).range(1..))]
    timeout: Option<u64>,
}

/// Reads `I/N` with I from 1 to N.
fn parse_shard(text: &str) -> Result<(usize, usize), String> {
    let parts = text.split_once('/');
    let numbers = parts.and_then(|(i, n)| Some((i.parse().ok()?, n.parse().ok()?)));
    match numbers {
        Some((i, n)) if (1..=n).contains(&i) => Ok((i, n)),
        _ => Err("a shard is I/N with I from 1 to N, 2/8 for example".into()),
    }
}

impl Selection {
    /// Returns the plan of the selected runs and prints its remarks on standard error.
    pub fn plan(&self) -> Result<Plan, Failure> {
        let mut experiments = Vec::new();
        for file in &self.files {
            let mut experiment = read(file)?;
            if let Some(seconds) = self.timeout {
                experiment.limits.timeout_seconds = seconds;
            }
            experiments.push(experiment);
        }
        let data = self.data()?;
        data.remarks.iter().for_each(|remark| stdio::complain(remark));
        let mut plan = plan_of(&experiments, self.scale, &data.meshes)?;
        if let Some((i, n)) = self.shard {
            plan.shard(i, n);
        }
        plan.remarks.iter().for_each(|remark| stdio::complain(remark));
        Ok(plan)
    }

    fn data(&self) -> Result<DataSurvey, Failure> {
        data_folder::survey(&self.data)
            .map_err(|error| Failure::bad(format!("{error}; --data names a folder with meshes")))
    }
}

/// Reads an experiment file.
fn read(file: &Path) -> Result<Experiment, Failure> {
    Experiment::read(file).map_err(|error| {
        Failure::bad(format!("{error}; see experiments/README.md for what such a file says"))
    })
}

fn plan_of(experiments: &[Experiment], scale: Scale, data: &[DataMesh]) -> Result<Plan, Failure> {
    Plan::new(experiments, scale, data).map_err(|error| Failure::bad(error.to_string()))
}

/// Returns the meshes whose pictures these experiment files show; they are the papers' meshes.
pub fn pictured(files: &[PathBuf], scale: Scale) -> Result<Vec<Pictured>, Failure> {
    let experiments: Vec<Experiment> =
        files.iter().map(|file| read(file)).collect::<Result<_, _>>()?;
    Ok(plan_of(&experiments, scale, &[])?.pictured)
}

/// Writes an estimate in words: `about 3 min, 2.5 GB of memory, …`.
pub fn in_words(estimate: &Estimate) -> String {
    format!(
        "about {}, {} of memory, {} of disk{}",
        duration(estimate.seconds),
        amount(estimate.memory_bytes),
        amount(estimate.disk_bytes),
        no_estimate(estimate.external_runs),
    )
}

/// Writes an amount of memory in words: `9 MB`, `2.5 GB`.
fn amount(bytes: f64) -> String {
    if bytes < 1e8 { format!("{:.0} MB", bytes / 1e6) } else { format!("{:.1} GB", bytes / 1e9) }
}

/// Returns the end of an estimate that is without so many runs of external programs.
pub fn no_estimate(external_runs: usize) -> &'static str {
    if external_runs == 0 { "" } else { "; no estimate for external programs" }
}

/// Writes a time in words: `40 s`, `3 min`, `2 h 05 min`.
pub fn duration(seconds: f64) -> String {
    let minutes = (seconds / 60.0).round() as u64;
    match minutes {
        _ if seconds < 90.0 => format!("{seconds:.0} s"),
        0..=119 => format!("{minutes} min"),
        _ => format!("{} h {:02} min", minutes / 60, minutes % 60),
    }
}
