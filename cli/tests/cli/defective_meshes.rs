//! The program refuses real defective meshes; the library's own verdict is what it must say.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use crate::documents::root;
use triquad::{Law, Mesh, Survey, Triangulation};

/// The folder of real defective meshes; none where it is absent.
fn folder() -> Option<PathBuf> {
    let named = std::env::var_os("TRIQUAD_MESHES").unwrap_or_else(|| "../shared/meshes".into());
    let folder = root().join(named).join("defective");
    if folder.is_dir() {
        return Some(folder);
    }
    println!("skipped: no real meshes at {}", folder.display());
    None
}

fn convert(mesh: &Path, output: &Path) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_triquad"));
    command.arg("convert").arg(mesh).arg("-o").arg(output).output().unwrap()
}

#[test]
fn defective_meshes_are_refused_with_one_line() {
    let Some(folder) = folder() else { return };
    let outputs = tempfile::tempdir().unwrap();
    let mut refused = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let output = outputs.path().join("quads.obj");
        let run = convert(&path, &output);
        let message = String::from_utf8(run.stderr).unwrap();
        let list = Mesh::read(&path).unwrap();
        if let Err(survey) = Triangulation::build(&list) {
            assert_refused(&name, run.status.code(), &message, &survey);
            refused += 1;
        } else {
            assert!(run.status.success() && std::fs::remove_file(&output).is_ok(), "{name}");
        }
        let left = std::fs::read_dir(outputs.path()).unwrap().count();
        assert_eq!(left, 0, "{name} left something behind");
    }
    assert!(refused > 0, "no defective mesh was refused");
}

fn assert_refused(name: &str, code: Option<i32>, message: &str, survey: &Survey) {
    assert_eq!((code, message.lines().count()), (Some(2), 1), "{name}: {message}");
    let law = survey.violations.first().expect("a refused mesh breaks a law").law;
    assert!([name, law.name()].iter().all(|part| message.contains(part)), "{message}");
    // What is advised depends on the mesh for these laws.
    let depends = [Law::Triangle, Law::NoBoundary].contains(&law);
    // The command names an option where the library names a function.
    let remedy = match law {
        Law::DistinctCorners | Law::DistinctFaces => "; --clean drops",
        Law::ConsistentOrientation => "; --orient flips faces",
        law => law.remedy(),
    };
    assert!(depends || message.contains(remedy), "{message}");
    assert!(message.contains("]; ") || message.contains("); "), "{message}");
}
