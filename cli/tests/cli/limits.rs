//! Limits of the system (`ulimit`): the tool does its work within them, or ends with one line, exit
//! code 2 and nothing half-written.

use std::os::unix::fs::PermissionsExt;
use std::process::{Command, Stdio};

use triquad_generators::grids;

use crate::workshop::{Run, Workshop, assert_contains, finish};

const TOOL: &str = env!("CARGO_BIN_EXE_triquad");

/// Runs the tool in a shell that has set `limit`, by way of `through`.
fn run(workshop: &Workshop, through: &[&str], limit: &str, arguments: &str) -> Run {
    let script = format!("{limit}; exec \"$0\" {arguments}");
    let shell = ["bash", "-c", &script, TOOL];
    let words: Vec<&str> = through.iter().chain(&shell).copied().collect();
    let mut command = Command::new(words[0]);
    command.args(&words[1..]).current_dir(workshop.0.path()).env_remove("RUST_BACKTRACE");
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    finish(command.spawn().unwrap())
}

/// A mesh, and the quads that come of it without limits.
fn workshop() -> (Workshop, Vec<u8>) {
    let workshop = Workshop::new();
    workshop.put_surface("in.obj", &grids::sphere(80));
    workshop.succeed("convert in.obj -o expected.obj");
    let expected = workshop.get("expected.obj");
    std::fs::remove_file(workshop.path("expected.obj")).unwrap();
    (workshop, expected)
}

fn assert_refused(workshop: &Workshop, run: &Run, parts: &[&str], what: &str) {
    assert_eq!(run.code, Some(2), "{what}: {run:?}");
    assert_eq!(run.stderr.lines().count(), 1, "{what}: {run:?}");
    assert_contains(&run.stderr, parts, what);
    assert_eq!(workshop.names().len(), 1, "{what}: {:?}", workshop.names());
}

#[test]
fn too_little_memory_is_told_in_one_line() {
    let (workshop, expected) = workshop();
    let mut refused = 0;
    let mut kilobytes = 8_000;
    loop {
        let limit = format!("ulimit -v {kilobytes}");
        kilobytes += kilobytes / 4;
        if run(&workshop, &[], &limit, "--version").code != Some(0) {
            // The program itself does not fit.
            continue;
        }
        let run = run(&workshop, &[], &limit, "convert in.obj -o out.obj --threads 1");
        if run.code == Some(0) {
            assert_eq!(workshop.get("out.obj"), expected);
            break;
        }
        let remedy = "raise the limit for memory";
        assert_refused(&workshop, &run, &["memory allocation of", remedy], &limit);
        refused += 1;
    }
    assert!(refused > 0, "every limit suffices");
}

#[test]
fn too_large_a_file_is_told_in_one_line() {
    let (workshop, _) = workshop();
    for output in ["out.obj", "out.ply", "out.off"] {
        let run = run(&workshop, &[], "ulimit -f 100", &format!("convert in.obj -o {output}"));
        let parts = [output, "raise the limit for the size of files (ulimit -f)"];
        assert_refused(&workshop, &run, &parts, output);
    }
}

/// 64 kB is less than the decoder of a gzip file, the solver and the report need.
#[test]
fn the_stack_of_the_shell_does_not_matter() {
    let (workshop, expected) = workshop();
    let limit = "ulimit -s 64";
    for threads in ["", "--threads 1"] {
        let run = run(&workshop, &[], limit, &format!("convert in.obj -o out.obj {threads}"));
        assert_eq!((run.code, run.stderr.as_str()), (Some(0), ""), "{run:?}");
        assert_eq!(workshop.get("out.obj"), expected);
    }
    workshop.put_surface("in.obj.gz", &grids::sphere(9));
    for arguments in [
        "info in.obj.gz",
        "convert in.obj.gz -o out.ply.gz",
        "check out.ply.gz --against in.obj.gz",
        "convert in.obj.gz --algorithm lrs -o out.ply.gz",
        "irreducible in.obj -o least.obj",
        "simplify in.obj --vertices 500 -o few.obj",
        "draw in.obj -o picture.png",
        "--help",
    ] {
        let run = run(&workshop, &[], limit, arguments);
        assert_eq!((run.code, run.stderr.as_str()), (Some(0), ""), "{arguments}: {run:?}");
    }
    // Failures have their codes there, too.
    let run = run(&workshop, &[], limit, "convert absent.obj");
    assert_eq!(run.code, Some(2), "{run:?}");
}

#[test]
fn without_threads_one_does_everything() {
    let (workshop, expected) = workshop();
    let everybody = std::fs::Permissions::from_mode(0o777);
    std::fs::set_permissions(workshop.0.path(), everybody).unwrap();
    // Root has as many threads as it wants.
    let nobody = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"];
    let user = Command::new("id").arg("-u").output().unwrap().stdout;
    let through = if user == b"0\n" { &nobody[..] } else { &[] };
    let has = |program: &str| Command::new(program).arg("--version").output().is_ok();
    if !through.is_empty() && !has("setpriv") {
        println!("skipped: no setpriv to take root's rights away");
        return;
    }
    if run(&workshop, through, ":", "--version").code != Some(0) {
        println!("skipped: the program is in a folder of root's");
        return;
    }
    let run = run(&workshop, through, "ulimit -u 1", "convert in.obj -o out.obj");
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), ""), "{run:?}");
    assert_eq!(workshop.get("out.obj"), expected);
}
