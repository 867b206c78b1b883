//! Thousands of damaged experiment files and records: no reader panics, what is refused is refused
//! in one line that names the file, and no result is larger than its file allows.

use std::path::Path;

use triquad_generators::testing::{damaged, draws};
use triquad_lab::experiment::Results;
use triquad_lab::experiment::results::DamagedRow;
use triquad_lab::experiment::spec::Experiment;

/// Damaged files of each kind.
const FILES: u32 = 8000;

const EXPERIMENT: &str = include_str!("../../experiments/irreducible.toml");

/// Two runs, as the program writes them.
const RUNS: &str = include_str!("../golden/scripted_runs.csv");

/// Calls `read` with the path of one damaged copy of `valid` after the other, and with its length.
fn damage(valid: &str, other: &str, name: &str, mut read: impl FnMut(&Path, usize)) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    let mut below = draws(valid.len() as u64);
    for _ in 0..FILES {
        let bytes = damaged(valid.as_bytes(), other.as_bytes(), &mut below);
        std::fs::write(&path, &bytes).unwrap();
        read(&path, bytes.len());
        // Some file systems flush a file that is overwritten, which takes longer than all the rest.
        std::fs::remove_file(&path).unwrap();
    }
}

#[test]
fn damaged_experiment_files_are_refused_in_one_line_or_read() {
    let mut refused = 0;
    damage(EXPERIMENT, RUNS, "damaged.toml", |path, length| match Experiment::read(path) {
        Ok(experiment) => {
            let runs = experiment.groups.iter().map(|group| 1 + group.meshes.len());
            assert!(runs.sum::<usize>() <= length);
        }
        Err(error) => {
            refused += 1;
            let message = error.to_string();
            assert_eq!(message.lines().count(), 1, "{message:?}");
            assert!(message.contains("damaged.toml: "), "{message:?}");
        }
    });
    assert!((FILES / 10..FILES).contains(&refused), "{refused} of {FILES} were refused");
}

fn assert_named(row: &DamagedRow, lines: usize) {
    assert!((1..=lines as u64 + 1).contains(&row.line), "{row:?}");
    assert!(!row.problem.is_empty() && !row.text.contains('\n'), "{row:?}");
}

#[test]
fn damaged_records_are_set_aside_line_by_line() {
    let mut spoilt = 0;
    damage(RUNS, EXPERIMENT, "runs.csv", |path, length| {
        let results = match Results::read(path.parent().unwrap()) {
            Ok(results) => results,
            // Nothing is left of what makes it a file of ours.
            Err(error) => return assert_eq!(error.to_string().lines().count(), 1),
        };
        let lines =
            length.min(String::from_utf8_lossy(&std::fs::read(path).unwrap()).lines().count());
        assert!(results.records.len() + results.damaged.len() <= lines);
        results.damaged.iter().for_each(|row| assert_named(row, lines));
        spoilt += u32::from(!results.damaged.is_empty());
    });
    assert!((FILES / 10..FILES).contains(&spoilt), "{spoilt} of {FILES} had damaged rows");
}

/// `plan.csv` is read as a whole: one bad row makes it unreadable.
#[test]
fn damaged_plans_are_refused_in_one_line_or_read() {
    let plan = "experiment,scale,group,mesh,algorithm,lrs_variant,augmentation,order,repetitions\n\
                comparison,demo,scans,botijo,lrs,printed,tarjan,,3\n\
                irreducible,full,\"A, B\",ir-B0,rs,,,file,10\n";
    let mut refused = 0;
    damage(plan, RUNS, "plan.csv", |path, length| {
        let folder = path.parent().unwrap();
        let _ = std::fs::File::create_new(folder.join("runs.csv"));
        match Results::read(folder) {
            Ok(results) => assert!(results.planned.len() <= length),
            Err(error) => {
                refused += 1;
                let message = error.to_string();
                assert!(message.contains("plan.csv: "), "{message:?}");
            }
        }
    });
    assert!((FILES / 10..FILES).contains(&refused), "{refused} of {FILES} were refused");
}
