//! The results in the repository are what their records make of them, byte for byte.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Every file under `folder`, by its path in it.
fn content(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut files = BTreeMap::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(next) = folders.pop() {
        for entry in std::fs::read_dir(next).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else {
                let name = path.strip_prefix(folder).unwrap().to_owned();
                files.insert(name, std::fs::read(&path).unwrap());
            }
        }
    }
    files
}

fn is_record(name: &Path) -> bool {
    let records = ["runs.csv", "plan.csv", "machines.json"];
    name.starts_with("pictures") || records.iter().any(|record| name == Path::new(record))
}

#[test]
fn a_report_made_anew_is_the_one_in_the_repository() {
    let results = Path::new(env!("CARGO_MANIFEST_DIR")).join("../results");
    let folders = std::fs::read_dir(results).unwrap().map(|entry| entry.unwrap().path());
    let is_kept = |path: &PathBuf| {
        // What starts with a year, not what somebody has just run.
        let name = path.file_name().unwrap().to_str().unwrap();
        path.is_dir() && name.trim_start_matches("quality-").starts_with("20")
    };
    let mut reports = 0;
    for kept in folders.filter(is_kept) {
        let anew = tempfile::tempdir().unwrap();
        let kept = content(&kept);
        for (name, bytes) in kept.iter().filter(|(name, _)| is_record(name)) {
            let path = anew.path().join(name);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, bytes).unwrap();
        }
        let mut report = Command::new(env!("CARGO_BIN_EXE_triquad"));
        assert!(report.arg("report").arg(anew.path()).output().unwrap().status.success());
        let anew = content(anew.path());
        assert!(kept.keys().any(|name| name.to_str().unwrap().starts_with("table_")));
        // Page and plots need not be kept.
        if kept.contains_key(Path::new("index.html")) {
            assert!(anew.keys().eq(kept.keys()));
        }
        for (name, bytes) in &kept {
            assert!(anew.get(name) == Some(bytes), "{} has changed", name.display());
        }
        assert!(anew[Path::new("index.html")].len() < 5_000_000);
        reports += 1;
    }
    assert!(reports > 0, "there are results in the repository");
}
