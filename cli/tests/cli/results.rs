//! The results in the repository are what their records make of them, byte for byte.
//!
//! Records and tables are kept in git. Page, plots and pictures are made anew here, and their
//! hashes are compared with the kept ones.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

use triquad_lab::experiment::machine::hash_of_file;

/// The file with the hashes of what is not kept in git.
const HASHES: &str = "SHA256SUMS";

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn name(path: &Path) -> &str {
    path.file_name().unwrap().to_str().unwrap()
}

/// What is before the date in the names of folders with pairings side by side.
const SIDE_BY_SIDE: &str = "quality-";

/// Folders whose names start with a year; others are what somebody has just run.
fn kept_folders() -> Vec<PathBuf> {
    let folders = std::fs::read_dir(root().join("results")).unwrap();
    let folders = folders.map(|entry| entry.unwrap().path()).filter(|path| {
        path.is_dir() && name(path).trim_start_matches(SIDE_BY_SIDE).starts_with("20")
    });
    folders.collect()
}

/// Every file in a folder but the page, by name; plots and pictures have folders of their own.
fn tables(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let files = files.filter(|path| path.is_file() && !path.ends_with("index.html"));
    files.map(|path| (name(&path).to_owned(), std::fs::read(&path).unwrap())).collect()
}

/// Returns the name of each file beside the hash that the list has of it.
fn hashes(list: &[u8]) -> BTreeMap<&str, &str> {
    let lines = std::str::from_utf8(list).unwrap().lines();
    lines.map(|line| line.split_once("  ").map(|(hash, name)| (name, hash)).unwrap()).collect()
}

fn is_side_by_side(folder: &Path) -> bool {
    name(folder).starts_with(SIDE_BY_SIDE)
}

/// Makes tables, page, plots and pictures from the records of `kept` alone.
fn report_anew(kept: &Path) -> tempfile::TempDir {
    let anew = tempfile::tempdir().unwrap();
    for name in ["runs.csv", "plan.csv", "machines.json"] {
        std::fs::copy(kept.join(name), anew.path().join(name)).unwrap();
    }
    let mut report = Command::new(env!("CARGO_BIN_EXE_triquad"));
    report.arg("report").arg(anew.path()).env("TRIQUAD_CACHE", anew.path().join("cache"));
    if !is_side_by_side(kept) {
        report.arg("--pictures").arg(root().join("experiments/comparison.toml"));
    }
    let output = report.output().unwrap();
    assert!(output.status.success(), "{output:?}");
    anew
}

#[test]
fn a_report_made_anew_is_the_one_in_the_repository() {
    let folders = kept_folders();
    assert!(!folders.is_empty(), "there are results in the repository");
    for folder in folders {
        let anew = report_anew(&folder);
        let (made, kept) = (tables(anew.path()), tables(&folder));
        let (of_made, of_kept) = (hashes(&made[HASHES]), hashes(&kept[HASHES]));
        for (name, hash) in &of_made {
            assert_eq!(of_kept.get(name), Some(hash), "{name} has changed; see results/README.md");
            assert_eq!(hash_of_file(&anew.path().join(name)).unwrap(), *hash, "{name}");
        }
        assert_eq!(made.keys().collect::<Vec<_>>(), kept.keys().collect::<Vec<_>>());
        for (name, bytes) in &made {
            assert!(*bytes == kept[name], "{name} has changed; see results/README.md");
        }
        assert!(of_made.contains_key("index.html"), "{of_made:?}");
        assert!(of_made.keys().any(|name| name.starts_with("plots/")));
        let has_pictures = of_made.keys().any(|name| name.starts_with("pictures/quads-"));
        assert!(has_pictures || is_side_by_side(&folder));
        let page = std::fs::metadata(anew.path().join("index.html")).unwrap();
        assert!(page.len() < 5_000_000, "{} bytes", page.len());
    }
}
