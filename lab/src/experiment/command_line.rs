//! The command line of a run: as it is executed, and as a reader repeats it.

use std::ffi::OsString;
use std::path::Path;

use super::plan::{Block, PlannedRun};
use super::planned_mesh::{PlannedMesh, Source};
use super::program_spec::{Places, ProgramFormat, ProgramSpec};
use crate::meshes::paper::Scale;

/// Returns the arguments of the run on that file; `result` is where its result goes, if anywhere.
pub(super) fn arguments(
    mesh_file: &Path,
    run: &PlannedRun,
    result: Option<&Path>,
) -> Vec<OsString> {
    let mut arguments = vec![run.job.task().id().into(), mesh_file.into()];
    arguments.extend(options(run).into_iter().map(OsString::from));
    if let Some(result) = result {
        arguments.extend(["-o".into(), result.into()]);
    }
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
pub(super) fn command(block: &Block, run: &PlannedRun) -> String {
    let mesh = &block.mesh;
    if let Some(program) = block.program(run.job) {
        return foreign_command(mesh, run, program);
    }
    let (make, file) = mesh_file(mesh, "ply");
    let result = match block.leaves_file(run) {
        true => {
            let name = result_name(mesh, ProgramFormat::default().extension());
            format!(" -o {}", quoted(&name))
        }
        false => String::new(),
    };
    let (task, options) = (run.job.task().id(), options(run).join(" "));
    format!("{make}triquad {task} {} {options}{result}", quoted(&file))
}

/// Returns the command of a program that is not ours. A file in another format is to be converted.
fn foreign_command(mesh: &PlannedMesh, run: &PlannedRun, program: &ProgramSpec) -> String {
    let ending = program.format.extension();
    let (make, file) = mesh_file(mesh, ending);
    let result = result_name(mesh, ending);
    let places = Places {
        mesh: Path::new(&file),
        result: Path::new(&result),
        stats: &Path::new(&mesh.name).with_extension("json"),
        seed: run.seed,
    };
    let words = program.command(places);
    let line: Vec<String> = words.iter().map(|word| quoted(word)).collect();
    format!("{make}{}", line.join(" "))
}

/// Returns `word` as a shell takes it for one word. A control character becomes a blank.
pub fn quoted(word: &str) -> String {
    let plain: String =
        word.chars().map(|letter| if letter.is_control() { ' ' } else { letter }).collect();
    shlex::try_quote(&plain).map_or_else(|_| plain.clone(), |word| word.into_owned())
}

/// Returns the name of the file with the result on a mesh.
fn result_name(mesh: &PlannedMesh, ending: &str) -> String {
    format!("{}.result.{ending}", mesh.name)
}

/// Returns the command that makes the mesh, if it is made, and the name of its file.
fn mesh_file(mesh: &PlannedMesh, ending: &str) -> (String, String) {
    match &mesh.source {
        Source::File(path, _) => {
            (String::new(), path.file_name().unwrap_or_default().to_string_lossy().into_owned())
        }
        Source::Made(made, scale) => {
            let file = format!("{}.{ending}", made.name);
            let scale = match scale {
                Scale::Full => String::new(),
                other => format!(" --scale {}", other.id()),
            };
            let (name, target) = (quoted(made.name), quoted(&file));
            (format!("triquad generate paper {name}{scale} -o {target} && "), file)
        }
    }
}
