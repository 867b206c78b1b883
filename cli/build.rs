//! Names the sources and the profile of this build, for the records of its runs: `TRIQUAD_COMMIT`
//! (empty outside our repository) and `TRIQUAD_PROFILE`.

use std::path::{Path, PathBuf};
use std::process::Command;

/// What the program is made from, in the repository.
const SOURCES: [&str; 15] = [
    "Cargo.lock",
    "Cargo.toml",
    "cli/Cargo.toml",
    "cli/build.rs",
    "cli/src",
    "experiments/claims.toml",
    "experiments/origins.csv",
    "experiments/paper",
    "generators/Cargo.toml",
    "generators/src",
    "lab/Cargo.toml",
    "lab/src",
    "render/Cargo.toml",
    "render/src",
    "src",
];

fn main() {
    // Something must be named: without, every change of a file would count.
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rustc-env=TRIQUAD_PROFILE={}", profile());
    println!("cargo::rustc-env=TRIQUAD_COMMIT={}", commit().unwrap_or_default());
}

/// Returns the name of the profile. `PROFILE` has but debug and release; the folder has its own
/// name.
fn profile() -> String {
    let out = PathBuf::from(std::env::var_os("OUT_DIR").unwrap_or_default());
    let build = out.ancestors().find(|folder| folder.ends_with("build"));
    let folder = build.and_then(Path::parent).and_then(Path::file_name);
    let folder = folder.map(|name| name.to_string_lossy().into_owned());
    folder.or_else(|| std::env::var("PROFILE").ok()).unwrap_or_default()
}

/// Returns the commit of the sources, marked if they were changed since.
fn commit() -> Option<String> {
    // A package may lie in a repository of somebody else.
    if git(&["rev-parse", "--show-prefix"])? != "cli/" {
        return None;
    }
    let moves = ["HEAD", "refs", "packed-refs"].map(|name| git(&["rev-parse", "--git-path", name]));
    let sources = SOURCES.map(|source| format!("../{source}"));
    let watched = moves.iter().flatten().chain(&sources);
    for path in watched.filter(|path| Path::new(path).exists()) {
        println!("cargo::rerun-if-changed={path}");
    }
    let commit = git(&["describe", "--always", "--abbrev=12"])?;
    let mut status = vec!["status", "--porcelain", "--"];
    status.extend(sources.iter().map(String::as_str));
    let mark = if git(&status)?.is_empty() { "" } else { "-dirty" };
    Some(format!("{commit}{mark}"))
}

/// Returns what `git` answers in the folder of this file.
fn git(arguments: &[&str]) -> Option<String> {
    // The index is not written: others may be at it.
    let output =
        Command::new("git").env("GIT_OPTIONAL_LOCKS", "0").args(arguments).output().ok()?;
    output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
}
