//! The command line of a run: as it is executed, and as a reader repeats it.

use std::ffi::OsString;
use std::path::Path;

use super::plan::PlannedRun;
use super::planned_mesh::{PlannedMesh, Source};
use crate::meshes::paper::Scale;

/// Returns the arguments of the run on that file.
pub(super) fn arguments(mesh_file: &Path, run: &PlannedRun) -> Vec<OsString> {
    let mut arguments = vec![run.job.verb().into(), mesh_file.into()];
    arguments.extend(options(run).into_iter().map(OsString::from));
    arguments
}

fn options(run: &PlannedRun) -> Vec<String> {
    let mut options: Vec<String> = run.job.options().into_iter().map(str::to_owned).collect();
    options.extend(["--seed".into(), run.seed.to_string()]);
    if let Some(paths) = run.stop_after_paths {
        options.extend(["--stop-after-paths".into(), paths.to_string()]);
    }
    options.extend(["--stats".into(), "-".into()]);
    options
}

/// Returns the command that repeats the run, the making of its mesh included.
pub(super) fn command(mesh: &PlannedMesh, run: &PlannedRun) -> String {
    let (make, file) = match &mesh.source {
        Source::File(path, _) => {
            (String::new(), path.file_name().unwrap_or_default().to_string_lossy().into_owned())
        }
        Source::Made(made, scale) => {
            let file = format!("{}.ply", made.name);
            let scale = match scale {
                Scale::Full => String::new(),
                other => format!(" --scale {}", other.id()),
            };
            (format!("triquad generate paper {}{scale} -o {file} && ", made.name), file)
        }
    };
    format!("{make}triquad {} {file} {}", run.job.verb(), options(run).join(" "))
}
