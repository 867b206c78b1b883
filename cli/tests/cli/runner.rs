//! What the runner does when something goes wrong: no row is lost, nothing is silent.

use std::collections::BTreeSet;
use std::process::Stdio;
use std::time::{Duration, Instant};

use crate::experiments::Workshop;
use triquad_lab::experiment::{Outcome, RunRecord};

fn rows(shop: &Workshop, folder: &str) -> usize {
    let runs = std::fs::read_to_string(shop.path(folder).join("runs.csv"));
    runs.map_or(0, |text| text.lines().count().saturating_sub(1))
}

fn wait_for_rows(shop: &Workshop, folder: &str, enough: usize) {
    let start = Instant::now();
    while rows(shop, folder) < enough {
        assert!(start.elapsed() < Duration::from_secs(120), "it does not get there");
        std::thread::sleep(Duration::from_millis(2));
    }
}

#[cfg(unix)]
#[test]
fn a_second_runner_is_refused_until_the_first_is_dead_and_no_row_is_lost() {
    let shop = Workshop::new();
    let run = "run tiny.toml --scale demo --out out";
    let mut first = shop.command(run).stderr(Stdio::null()).stdout(Stdio::null()).spawn().unwrap();
    wait_for_rows(&shop, "out", 3);
    // Stopped, it keeps its lock.
    let signal = |name: &str| {
        let process = first.id().to_string();
        std::process::Command::new("kill").args([name, &process]).status().unwrap()
    };
    signal("-STOP");
    let refused = shop.refused(run);
    assert!(refused.contains(&format!("process {} on ", first.id())), "{refused}");
    std::fs::write(shop.path("rows.csv"), "mesh,seconds\nbotijo,1\n").unwrap();
    assert!(shop.refused("import rows.csv --algorithm x --out out").contains("writes into"));
    std::fs::write(shop.path("out/.triquad-left.tmp"), "half a file").unwrap();
    signal("-KILL");
    first.wait().unwrap();
    let before = shop.results("out").records;
    shop.succeed(run);
    let after = shop.results("out").records;
    assert!(before.iter().all(|row| after.contains(row)), "a finished row is lost");
    assert!(after.iter().all(RunRecord::is_ok));
    assert_eq!(rows(&shop, "out"), after.len(), "no run has two rows");
    assert!(!shop.path("out/.triquad-left.tmp").exists() && !shop.path("out/meshes").exists());
}

#[test]
fn what_cannot_be_begun_is_told_and_tried_again() {
    let shop = Workshop::new();
    shop.ask_for_pictures();
    let mut broken = shop.command("run tiny.toml --scale demo --out out");
    // Where meshes cannot be kept.
    std::fs::write(shop.path("file"), "").unwrap();
    let output = broken.env("TRIQUAD_CACHE", shop.path("file")).output().unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("the mesh could not be made"), "{said}");
    assert!(said.contains("runs did not end well"), "{said}");
    assert!(said.contains("botijo cannot be drawn"), "{said}");
    let bad = |records: &[RunRecord]| records.iter().filter(|row| row.is_bad()).count();
    assert!(bad(&shop.results("out").records) > 0);
    shop.succeed("run tiny.toml --scale demo --out out");
    assert_eq!(bad(&shop.results("out").records), 0);
}

/// Rows of other seeds or builds, which the folder keeps, are none of the plan's.
#[test]
fn progress_counts_the_runs_of_this_plan() {
    let shop = Workshop::new();
    let counts = |said: &str| -> Vec<(usize, usize)> {
        let lines = said.lines().filter_map(|line| line.split(" done: ").nth(1));
        let counts = lines.map(|line| line.split(" run").next().unwrap().split_once(" of "));
        let number = |text: &str| text.parse().unwrap();
        counts.map(|count| count.map(|(done, all)| (number(done), number(all))).unwrap()).collect()
    };
    let said = shop.succeed("run tiny.toml --scale demo --out out");
    assert!(said.lines().any(|line| line.contains("tiny: botijo done: ")), "{said}");
    let text = std::fs::read_to_string(shop.path("tiny.toml")).unwrap();
    std::fs::write(shop.path("tiny.toml"), text.replacen("seed = ", "seed = 1", 1)).unwrap();
    let found = counts(&shop.succeed("run tiny.toml --scale demo --out out"));
    assert!(found.len() > 1 && found.windows(2).all(|two| two[0].0 < two[1].0), "{found:?}");
    assert!(found.last().is_some_and(|(done, all)| done == all), "{found:?}");
}

#[test]
fn merging_names_bad_runs_and_keeps_the_good_ones() {
    let shop = Workshop::new();
    shop.succeed("run tiny.toml --scale demo --out good");
    let text = std::fs::read_to_string(shop.path("good/runs.csv")).unwrap();
    std::fs::create_dir(shop.path("bad")).unwrap();
    std::fs::write(shop.path("bad/runs.csv"), text.replace(",ok,,", ",invalid,why,")).unwrap();
    shop.succeed("merge good bad --out merged");
    assert!(shop.results("merged").records.iter().all(RunRecord::is_ok));
    let said = shop.failed("merge bad --out alone");
    assert!(said.contains("invalid: why") && said.contains("51 runs did not end well"), "{said}");
    // Alike runs are one line: 51 of them have a handful of jobs.
    let alike = said.lines().filter(|line| line.contains("invalid: why")).count();
    let jobs: BTreeSet<String> =
        shop.results("alone").records.iter().map(|record| record.id.job.name()).collect();
    assert_eq!(alike, jobs.len(), "{said}");
    assert!(said.contains("invalid: why (and "), "{said}");
    let alone = shop.results("alone").records;
    assert!(alone.len() == 51 && alone.iter().all(|row| row.outcome == Outcome::Invalid));
}

#[test]
fn a_foreign_file_is_refused_untouched() {
    let shop = Workshop::new();
    std::fs::create_dir(shop.path("out")).unwrap();
    std::fs::write(shop.path("out/runs.csv"), "date,km\n2020-01-01,5\n").unwrap();
    for verb in ["run tiny.toml --scale demo --out out", "report out", "merge out --out merged"] {
        let said = shop.refused(verb);
        assert!(said.contains("no list of runs of triquad"), "{verb}: {said}");
    }
    let runs = std::fs::read_to_string(shop.path("out/runs.csv")).unwrap();
    assert_eq!(runs, "date,km\n2020-01-01,5\n");
    assert!(!shop.path("out/damaged.csv").exists());
}

#[cfg(unix)]
#[test]
fn links_in_a_results_folder_are_not_followed() {
    let shop = Workshop::new();
    std::fs::create_dir(shop.path("out")).unwrap();
    std::fs::write(shop.path("victim"), "kept").unwrap();
    std::os::unix::fs::symlink(shop.path("victim"), shop.path("out/plan.csv")).unwrap();
    let said = shop.refused("run least.toml --scale demo --out out");
    assert!(said.contains("plan.csv is a link and is not followed"), "{said}");
    assert_eq!(std::fs::read_to_string(shop.path("victim")).unwrap(), "kept");
}

#[test]
fn data_that_is_not_used_is_told() {
    let shop = Workshop::new();
    std::fs::create_dir(shop.path("empty")).unwrap();
    let plan = |folder: &str| {
        let output = shop.run(&format!("plan tiny.toml --scale demo --data {folder}"));
        String::from_utf8(output.stderr).unwrap()
    };
    assert!(plan("empty").contains("empty: there is no mesh file in it"));
    std::fs::create_dir(shop.path("data")).unwrap();
    let off = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
    std::fs::write(shop.path("data/scan_0.25.off"), off).unwrap();
    let said = plan("data");
    assert!(said.contains("--data: not used: data/scan_0.25.off"), "{said}");
    assert!(said.contains("at scale full only"), "{said}");
}
