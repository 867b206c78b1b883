//! Experiments as their users meet them: planned, run, interrupted, damaged, shared out, merged.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

use crate::experiment_text::experiment;
use crate::repeatable::repeatable;
use tempfile::TempDir;
use triquad::mesh::{Mesh, Output as MeshOutput};
use triquad_generators::{Surface, classic, grids};
use triquad_lab::experiment::{Outcome, Results, RunRecord};

const EXPERIMENT: &str = experiment!(
    "tiny",
    "convert",
    r#"["botijo", "A5", "B5"]"#,
    r#"algorithms = ["sg", "ps"]
        augmentations = ["tarjan", "local"]
        repetitions = { full = 3, small = 3, demo = 3 }"#,
    r#"algorithms = ["lrs", "lrs few-flips", "ds", "gw", "tq"]
        augmentations = ["local"]
        repetitions = { full = 1, small = 1, demo = 1 }"#,
);
/// Three meshes, four jobs three times and five once.
const RUNS: usize = 3 * (4 * 3 + 5);

const REDUCTION: &str = experiment!(
    "least",
    "irreducible",
    r#"["ir-B9", "ir-C7"]"#,
    r#"algorithms = ["rs", "schipper", "brute-force"]
        orders = ["file", "random"]
        repetitions = { full = 2, small = 2, demo = 2 }"#,
);

/// A folder of its own for each test, in which the tool runs.
pub struct Workshop(TempDir);

impl Workshop {
    pub fn new() -> Self {
        let shop = Self(tempfile::tempdir().unwrap());
        std::fs::write(shop.path("tiny.toml"), EXPERIMENT).unwrap();
        std::fs::write(shop.path("least.toml"), REDUCTION).unwrap();
        shop
    }

    /// Makes runs of `tiny.toml` draw their quads, which takes four times as long.
    pub fn ask_for_pictures(&self) {
        let experiment = EXPERIMENT.replacen("[limits]", "pictures = \"botijo\"\n[limits]", 1);
        std::fs::write(self.path("tiny.toml"), experiment).unwrap();
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub fn command(&self, arguments: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_triquad"));
        command.args(arguments.split_whitespace()).current_dir(self.0.path());
        command.env("TRIQUAD_CACHE", self.path("cache")).stdin(Stdio::null());
        command
    }

    pub fn run(&self, arguments: &str) -> Output {
        self.command(arguments).output().unwrap()
    }

    /// Runs what has to succeed, and tells what it said on standard error.
    pub fn succeed(&self, arguments: &str) -> String {
        let output = self.run(arguments);
        let stderr = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.success(), "{arguments}: {stderr}");
        stderr
    }

    /// Runs what has to end with exit code 1, and tells what it said on standard error.
    pub fn failed(&self, arguments: &str) -> String {
        let output = self.run(arguments);
        let stderr = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(1), "{arguments}: {stderr}");
        stderr
    }

    /// What is refused with one line and exit code 2.
    pub fn refused(&self, arguments: &str) -> String {
        let output = self.run(arguments);
        let stderr = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments}: {stderr}");
        assert_eq!(stderr.lines().count(), 1, "{stderr}");
        stderr
    }

    pub fn results(&self, folder: &str) -> Results {
        Results::read(&self.path(folder)).unwrap()
    }

    fn put_mesh(&self, name: &str, surface: &Surface) {
        let list = Mesh::from_triangles(surface.positions.clone(), surface.triangles.clone());
        std::fs::create_dir_all(self.path("data")).unwrap();
        MeshOutput::create(self.path(name)).unwrap().write(&list).unwrap();
    }
}

pub fn repeatable_rows(results: &Results) -> BTreeSet<String> {
    results.records.iter().map(|record| format!("{:?}", repeatable(record))).collect()
}

#[test]
fn the_record_names_the_build_and_not_what_lies_round_it_when_it_runs() {
    let shop = Workshop::new();
    // Without PATH there is no git.
    let output = shop.command("run least.toml --scale demo --out out").env("PATH", "").output();
    assert!(output.unwrap().status.success());
    let machines = shop.results("out").machines;
    let facts = machines.values().next().unwrap();
    let commit = Some(env!("TRIQUAD_COMMIT")).filter(|commit| !commit.is_empty());
    assert_eq!(facts.get("commit").map(String::as_str), commit);
    // Cargo has a folder for each profile: debug, release, fast.
    let folder = Path::new(env!("CARGO_BIN_EXE_triquad")).parent().unwrap().file_name();
    assert_eq!(facts.get("profile").map(String::as_str), folder.unwrap().to_str());
}

#[test]
fn an_open_mesh_is_refused_with_what_experiments_take() {
    let shop = Workshop::new();
    let text = EXPERIMENT.replace(r#"meshes = ["botijo", "A5", "B5"]"#, "files = [\"open.off\"]");
    std::fs::write(shop.path("open.toml"), text).unwrap();
    std::fs::write(shop.path("open.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").unwrap();
    let said = shop.refused("plan open.toml");
    assert!(said.contains(" open.toml: line 10: open.off: edge "), "no ./ before it: {said}");
    assert!(said.ends_with("; experiments take closed triangle meshes\n"), "{said}");
}

#[test]
fn every_planned_run_has_a_row_and_none_is_done_twice() {
    let shop = Workshop::new();
    shop.ask_for_pictures();
    shop.succeed("run tiny.toml least.toml --scale demo --out out");
    let results = shop.results("out");
    assert_eq!(results.records.len(), RUNS + 2 * 6 * 2);
    assert!(results.records.iter().all(RunRecord::is_ok), "{:?}", results.records);
    let planned: u32 = results.planned.iter().map(|row| row.repetitions).sum();
    assert_eq!(planned as usize, results.records.len());
    for record in &results.records {
        assert!(results.machines.contains_key(&record.machine));
        assert!(record.mesh_sha256.len() == 64 && record.process_seconds > Some(0.0));
        assert!(record.command.starts_with("triquad generate paper "), "{}", record.command);
    }
    assert!(!shop.path("out/meshes").exists(), "meshes are removed when they are done with");
    assert!(shop.path("out/pictures/quads-lrs-few-flips-close-up.png").exists());

    // The run made its report from memory: it is that from the folder.
    let report = || {
        let files = ["index.html", "compare.csv", "table_memory.csv"];
        files.map(|name| std::fs::read(shop.path("out").join(name)).unwrap())
    };
    let from_memory = report();
    shop.succeed("report out");
    assert!(report() == from_memory);

    let before = std::fs::read(shop.path("out/runs.csv")).unwrap();
    let said = shop.succeed("run tiny.toml least.toml --scale demo --out out");
    assert!(said.contains("0 runs to do"), "{said}");
    assert_eq!(std::fs::read(shop.path("out/runs.csv")).unwrap(), before);
}

#[test]
fn the_command_of_a_row_gives_the_same_row() {
    let shop = Workshop::new();
    shop.succeed("run tiny.toml --scale demo --out out");
    let results = shop.results("out");
    for record in results.records.iter().filter(|record| record.id.mesh.name == "A5").take(6) {
        let (make, convert) = record.command.split_once(" && ").unwrap();
        shop.succeed(make.strip_prefix("triquad ").unwrap());
        let output = shop.run(convert.strip_prefix("triquad ").unwrap());
        let stats: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(stats["unpaired_triangles"].as_u64(), record.measured.unpaired_triangles);
        assert_eq!(
            stats["augmenting_path_length_mean"].as_f64(),
            record.measured.augmenting_path_length_mean
        );
        assert_eq!(stats["edge_flips"].as_u64(), record.measured.edge_flips);
        assert_eq!(stats["quality_mean"].as_f64(), record.measured.quality_mean);
    }
}

/// Kills the tool without warning once `rows` rows are there.
fn kill_after(shop: &Workshop, arguments: &str, folder: &str, rows: usize) {
    let mut child = shop.command(arguments).stderr(Stdio::null()).spawn().unwrap();
    let path = shop.path(folder).join("runs.csv");
    let start = Instant::now();
    while std::fs::read_to_string(&path).map_or(0, |text| text.lines().count()) <= rows {
        assert!(start.elapsed() < Duration::from_secs(120), "it does not get there");
        std::thread::sleep(Duration::from_millis(2));
    }
    child.kill().unwrap();
    child.wait().unwrap();
}

#[test]
fn what_was_killed_goes_on_to_the_same_rows() {
    let shop = Workshop::new();
    shop.succeed("run tiny.toml --scale demo --out undisturbed");
    for rows in [0, 5, 23] {
        kill_after(&shop, "run tiny.toml --scale demo --out killed", "killed", rows);
        assert!(shop.results("killed").records.len() < RUNS, "it was over before");
    }
    shop.succeed("run tiny.toml --scale demo --out killed");
    let [killed, undisturbed] = ["killed", "undisturbed"].map(|name| shop.results(name));
    assert_eq!(killed.records.len(), RUNS);
    assert_eq!(repeatable_rows(&killed), repeatable_rows(&undisturbed));
}

#[test]
fn a_damaged_row_is_told_of_and_run_again() {
    let shop = Workshop::new();
    shop.succeed("run tiny.toml --scale demo --out out");
    let whole = repeatable_rows(&shop.results("out"));
    let path = shop.path("out/runs.csv");
    let text = std::fs::read_to_string(&path).unwrap();
    let mut lines: Vec<&str> = text.lines().collect();
    lines[7] = "triquad-run-1,half a row";
    let damaged = lines.join("\n");
    std::fs::write(&path, &damaged[..damaged.len() - 3]).unwrap();
    let said = shop.succeed("run tiny.toml --scale demo --out out");
    assert!(said.contains("runs.csv, line 8: "), "{said}");
    assert!(said.contains(&format!("runs.csv, line {}: it is cut off", RUNS + 1)), "{said}");
    assert!(said.contains("2 runs to do"), "{said}");
    assert_eq!(repeatable_rows(&shop.results("out")), whole);
    let aside = std::fs::read_to_string(shop.path("out/damaged.csv")).unwrap();
    assert!(aside.starts_with("triquad-run-1,half a row\n") && aside.lines().count() == 2);
}

#[test]
fn parts_of_several_machines_make_the_whole() {
    let shop = Workshop::new();
    shop.succeed("run tiny.toml --scale demo --out whole");
    for part in 1..=3 {
        shop.succeed(&format!("run tiny.toml --scale demo --out part-{part} --shard {part}/3"));
    }
    let parts = [1, 2, 3].map(|part| shop.results(&format!("part-{part}")).records.len());
    assert!(parts.iter().all(|&rows| rows > 0), "{parts:?}");
    // Part 2 twice: nothing is counted double.
    let output = shop.run("merge part-1 part-2 part-3 part-2 --out merged");
    let said = String::from_utf8(output.stdout).unwrap();
    let expected = format!(
        "merged: {RUNS} runs of 1 machine\nfor tables, plots and page: triquad report merged\n"
    );
    assert_eq!((output.status.code(), said), (Some(0), expected));
    assert!(!shop.path("merged/table_4_3.csv").exists());
    shop.succeed("report merged");
    assert!(shop.path("merged/table_4_3.csv").exists());
    let [merged, whole] = ["merged", "whole"].map(|name| shop.results(name));
    assert_eq!(merged.records.len(), RUNS);
    assert_eq!(repeatable_rows(&merged), repeatable_rows(&whole));
    let planned: u32 = merged.planned.iter().map(|row| row.repetitions).sum();
    assert_eq!(planned as usize, RUNS);
    // A run on the merged folder has nothing left to do.
    let said = shop.succeed("run tiny.toml --scale demo --out merged");
    assert!(said.contains("0 runs to do"), "{said}");
}

#[test]
fn several_at_a_time_are_marked() {
    let shop = Workshop::new();
    shop.succeed("run tiny.toml --scale demo --out one");
    shop.succeed("run tiny.toml --scale demo --out four --jobs 4");
    let [one, four] = ["one", "four"].map(|name| shop.results(name));
    assert!(four.records.iter().all(|record| record.parallel_jobs == 4));
    let unmarked = |mut results: Results| {
        results.records.iter_mut().for_each(|record| record.parallel_jobs = 1);
        repeatable_rows(&results)
    };
    assert_eq!(unmarked(four), repeatable_rows(&one));
}

#[test]
fn what_timed_out_is_not_tried_on_larger_meshes() {
    let shop = Workshop::new();
    let groups = r#"
        [[group]]
        name = "data"
        other_data = true
        [[group.run]]
        algorithms = ["sg", "tq"]
        augmentations = ["rebuild"]
        repetitions = { full = 1, small = 1, demo = 1 }
    "#;
    let head = &REDUCTION[..REDUCTION.find("[[group]]").unwrap()];
    let experiment = format!("{head}{groups}").replace("irreducible\"", "convert\"");
    std::fs::write(shop.path("slow.toml"), experiment).unwrap();
    shop.put_mesh("data/small.ply", &classic::octahedron());
    // Tens of thousands of paths that take minutes together, on any machine.
    shop.put_mesh("data/medium.ply", &grids::torus(400, 500));
    shop.put_mesh("data/large.ply", &grids::torus(420, 500));
    std::fs::write(shop.path("data/torn.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
        .unwrap();
    let said = shop.failed("run slow.toml --data data --timeout 2 --out out");
    assert!(said.contains("torn.off is left out: "), "{said}");
    assert!(said.contains("medium, sg rebuild, repetition 0: timeout: "), "{said}");
    let results = shop.results("out");
    let row = |mesh: &str, algorithm: &str| {
        let mut rows = results.records.iter();
        rows.find(|row| row.id.mesh.name == mesh && row.id.job.algorithm() == algorithm).unwrap()
    };
    assert_eq!(row("small", "sg").outcome, Outcome::Ok);
    assert_eq!(row("medium", "sg").outcome, Outcome::Timeout);
    assert_eq!(row("large", "sg").outcome, Outcome::Skipped);
    assert!(row("large", "sg").reason.contains("medium"), "{:?}", row("large", "sg"));
    assert!(row("medium", "tq").is_ok() && row("large", "tq").is_ok());
    assert_eq!(row("medium", "tq").command.split(" --").next(), Some("triquad convert medium.ply"));
    // What is edited runs again, what is not does not.
    shop.put_mesh("data/small.ply", &classic::tetrahedron());
    let said = shop.failed("run slow.toml --data data --timeout 2 --out out");
    assert!(said.contains("2 runs to do"), "{said}");
    assert!(said.ends_with(": 1 run did not end well\n"), "{said}");
    assert_eq!(shop.results("out").records.len(), 6);
}

#[test]
fn a_plan_tells_what_it_would_take() {
    let shop = Workshop::new();
    let output = shop.run("plan tiny.toml least.toml --scale small");
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(output.status.success());
    assert!(text.contains("tiny / all\n  botijo") && text.contains("3 x sg tarjan"), "{text}");
    assert!(text.contains(&format!("{} runs: about ", RUNS + 24)), "{text}");
    assert!(!Path::exists(&shop.path("results")), "nothing was run");
}

#[test]
fn what_cannot_be_planned_or_run_is_refused_in_one_line() {
    let shop = Workshop::new();
    let bad = EXPERIMENT.replace("\"A5\"", "\"A9\"");
    std::fs::write(shop.path("bad.toml"), bad).unwrap();
    let said = shop.refused("run bad.toml");
    assert!(said.contains("bad.toml: line 10: \"A9\" is no mesh of the papers"), "{said}");
    assert_eq!(said.matches("--data").count(), 1, "{said}");
    for (from, to, fault) in [
        ("\"A5\"", "\"A55\"", "line 10: \"A55\" is no mesh of the papers"),
        ("\"A5\"", "\"a5\"", "or take it out, or \"A5\" is meant"),
        ("\"gw\"", "\"gww\"", "line 16: \"gww\" is none of "),
        ("\"gw\"", "\"gww\"", "; the nearest is \"gw\""),
        ("lrs few-flips", "lrs few-flip", "line 16: \"few-flip\" is none of printed, few-flips"),
        ("meshes = ", "files = [\"no.obj\"]\nmeshes = ", "bad.toml: line 10: no.obj: "),
    ] {
        std::fs::write(shop.path("bad.toml"), EXPERIMENT.replacen(from, to, 1)).unwrap();
        let said = shop.refused("plan bad.toml");
        assert!(said.contains("bad.toml: line ") && said.contains(fault), "{said}");
    }
    let tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    for folder in ["before", "after"] {
        std::fs::create_dir(shop.path(folder)).unwrap();
        std::fs::write(shop.path(folder).join("part.obj"), tetrahedron).unwrap();
    }
    let of_both = "files = [\n\"before/part.obj\",\n\"after/part.obj\"]\nmeshes = ";
    let same = "files = [\"before/part.obj\", \"before/part.obj\"]\nmeshes = ";
    for (from, to, line, files) in [
        ("meshes = ", of_both, 12, ", of before/part.obj and after/part.obj;"),
        ("meshes = ", same, 10, ", of before/part.obj and before/part.obj;"),
        ("\"A5\"", "\"A5\", \"A5\"", 10, "\"A5\"; name a mesh once, rename a file, or make two"),
    ] {
        std::fs::write(shop.path("bad.toml"), EXPERIMENT.replacen(from, to, 1)).unwrap();
        for verb in ["plan", "run"] {
            let said = shop.refused(&format!("{verb} bad.toml"));
            let fault = format!("bad.toml: line {line}: group \"all\" has two meshes named ");
            assert!(said.contains(&fault) && said.contains(files), "{said}");
        }
    }
    std::fs::write(shop.path("torn.toml"), "name = ").unwrap();
    assert!(shop.refused("plan torn.toml").contains("torn.toml: line 1: "));
    assert!(shop.refused("run missing.toml").contains("missing.toml: "));
    assert!(shop.refused("run tiny.toml --data missing").contains("missing: "));
    assert!(shop.refused("run tiny.toml --shard 3/2").contains("I from 1 to N"));
    assert!(shop.refused("merge missing --out merged").contains("runs.csv"));
    for limit in ["timeout_seconds = 60", "memory_gigabytes = 4"] {
        let (name, _) = limit.split_once(' ').unwrap();
        let zero = EXPERIMENT.replace(limit, &format!("{name} = 0"));
        std::fs::write(shop.path("zero.toml"), zero).unwrap();
        assert!(shop.refused("run zero.toml").contains(&format!("{name} = 0: must be from 1")));
    }
    std::fs::write(shop.path("file"), "").unwrap();
    let said = shop.refused("run tiny.toml --scale demo --out file");
    assert!(said.starts_with("triquad: file: "), "{said}");
}
