//! Results of others: external programs, imported files, baselines, the papers' tables.

use std::path::Path;
use std::process::Command;

use crate::experiments::Workshop;
use triquad_lab::experiment::{Outcome, RunRecord};

const HEAD: &str = r#"
    name = "mine"
    title = "Programs of others"
    task = "convert"
    seed = 5
    [limits]
    timeout_seconds = 20
    memory_gigabytes = 4
"#;

const GROUP: &str = r#"
    [[group]]
    name = "any"
    meshes = ["botijo", "A5"]
    [[group.run]]
    algorithms = ["ps", "NAMES"]
    augmentations = ["tarjan"]
    repetitions = { full = 2, small = 2, demo = 2 }
"#;

/// An experiment with these programs: name and command, further lines after it.
fn experiment(programs: &[(&str, &str)]) -> String {
    let program = |(name, lines): &(&str, &str)| {
        format!("[[program]]\nname = \"{name}\"\ntask = \"convert\"\n{lines}\n")
    };
    let tables: String = programs.iter().map(program).collect();
    let names: Vec<&str> = programs.iter().map(|program| program.0).collect();
    format!("{HEAD}{tables}{}", GROUP.replace("NAMES", &names.join("\", \"")))
}

fn has_python() -> bool {
    let there = Command::new("python3").arg("--version").output().is_ok();
    if !there {
        eprintln!("skipped: python3 was not found");
    }
    there
}

fn greedy() -> String {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../experiments/peers/greedy.py");
    format!(
        "version = \"python3 --version\"\n\
         command = [\"python3\", '{}', \"{{mesh}}\", \"{{quads}}\", \"{{seed}}\"]",
        script.display()
    )
}

fn of<'r>(records: &'r [RunRecord], algorithm: &str) -> Vec<&'r RunRecord> {
    records.iter().filter(|record| record.id.job.algorithm() == algorithm).collect()
}

fn text(shop: &Workshop, file: &str) -> String {
    std::fs::read_to_string(shop.path(file)).unwrap()
}

#[test]
fn a_program_of_somebody_else_is_checked_and_stands_in_every_table() {
    if !has_python() {
        return;
    }
    let shop = Workshop::new();
    let absent = "command = [\"no-such-program\", \"{mesh}\", \"{quads}\"]";
    // What it leaves is no pairing: the input's last face is missing.
    let wrong = "command = ['sh', '-c', 'sed \"\\$d\" $1 > $2', 'sh', '{mesh}', '{quads}']";
    let programs = [("greedy", &greedy()[..]), ("absent", absent), ("wrong", wrong)];
    std::fs::write(shop.path("mine.toml"), experiment(&programs)).unwrap();
    let said = shop.failed("run mine.toml --scale demo --out out");
    assert!(said.contains("absent is not installed: \"no-such-program\" was not found"), "{said}");
    assert!(said.contains("4 runs did not end well"), "{said}");
    // Two meshes, twice each: what fails alike is named once.
    assert_eq!(said.matches("lies in no face").count(), 2, "{said}");
    assert_eq!(said.matches(": invalid, as above (and 1 more)\n").count(), 2, "{said}");
    let records = shop.results("out").records;
    assert_eq!(records.len(), 2 * 2 * 4);
    for record in of(&records, "greedy") {
        let measured = &record.measured;
        assert!(record.is_ok() && record.program.contains("Python 3"), "{record:?}");
        let (quads, left) = (measured.quads.unwrap(), measured.unpaired_triangles.unwrap());
        assert_eq!(Some(2 * quads + left), measured.triangles);
        assert!(left > 0 && measured.total_seconds == record.process_seconds);
        assert!(record.command.contains("generate paper") && record.command.contains("greedy.py"));
        #[cfg(target_os = "linux")]
        assert!(measured.peak_memory_bytes.is_some_and(|bytes| bytes > 1_000_000));
    }
    assert!(of(&records, "absent").iter().all(|record| record.outcome == Outcome::Skipped));
    for record in of(&records, "wrong") {
        assert_eq!(record.outcome, Outcome::Invalid);
        assert!(record.reason.contains("lies in no face"), "{}", record.reason);
    }
    for table in ["table_4_3.csv", "table_4_4_i.csv", "table_quality.csv", "table_memory.csv"] {
        assert!(text(&shop, &format!("out/{table}")).contains(",greedy,"), "{table}");
    }
    for plot in ["plots/total_scans.csv", "plots/stack_4_3.csv"] {
        assert!(text(&shop, &format!("out/{plot}")).contains("greedy"), "{plot}");
    }
    assert!(text(&shop, "out/index.html").contains("wall-clock time of its whole process"));
    assert!(!shop.path("out/meshes").exists(), "files of programs are removed");
    // The verdicts do not hang on the name of the experiment.
    let verdicts = text(&shop, "out/compare.csv");
    let verdict = verdicts.lines().find(|line| line.starts_with("ps-percent,")).unwrap();
    assert!(verdict.contains("botijo (stand-in) "), "{verdict}");
    // Only what was not begun is tried again.
    let said = shop.failed("run mine.toml --scale demo --out out");
    assert!(said.contains("4 runs to do"), "{said}");
    assert_eq!(shop.results("out").records, records);
}

#[test]
fn an_estimate_is_without_external_programs_and_says_so_once() {
    let shop = Workshop::new();
    let program = [("theirs", "command = [\"no-such-program\", \"{mesh}\", \"{quads}\"]")];
    let text = experiment(&program);
    let plan = |text: &str| {
        std::fs::write(shop.path("mine.toml"), text).unwrap();
        let output = shop.run("plan mine.toml --scale demo");
        String::from_utf8(output.stdout).unwrap()
    };
    let note = "no estimate for external programs";
    let both = plan(&text);
    assert_eq!(both.matches(note).count(), 1, "{both}");
    let total = |said: &str| said.lines().last().unwrap().to_owned();
    let ours = plan(&text.replace("\"ps\", \"theirs\"", "\"ps\""));
    assert!(!ours.contains(note), "{ours}");
    let expected = total(&ours).replace("4 runs", "8 runs") + "; " + note;
    assert_eq!(total(&both), expected, "the programs add nothing");
    let theirs = plan(&text.replace("\"ps\", \"theirs\"", "\"theirs\""));
    let line = theirs.lines().find(|line| line.contains("botijo")).unwrap();
    assert!(line.ends_with(" –  2 x theirs external"), "{line}");
    let said = String::from_utf8(shop.run("plan mine.toml --scale demo").stderr).unwrap();
    assert!(said.contains("mine.toml: line ") && said.contains("programs alone"), "{said}");
    let said = shop.succeed("run mine.toml --scale demo --out out");
    assert!(said.contains("4 runs to do, about 0 s; no estimate for external programs"), "{said}");
    assert!(said.contains("about 0 s and 2 runs of external programs left"), "{said}");
}

#[test]
fn ours_and_others_are_measured_alike_from_the_files_that_they_leave() {
    if !has_python() {
        return;
    }
    let shop = Workshop::new();
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/meshes");
    std::fs::copy(examples.join("plate.obj.gz"), shop.path("plate.obj.gz")).unwrap();
    let absent = "command = [\"no-such-program\", \"{mesh}\", \"{quads}\"]";
    let text = experiment(&[("greedy", &greedy()[..]), ("absent", absent)]);
    let text = text.replace("seed = 5", "seed = 5\nmeasured_from_files = true");
    let text = text.replace("meshes = [\"botijo\", \"A5\"]", "files = [\"plate.obj.gz\"]");
    let text = text.replace("\"ps\"", "\"best\", \"ps\"").replace("tarjan", "local");
    std::fs::write(shop.path("mine.toml"), text).unwrap();
    shop.succeed("run mine.toml --scale demo --out out");
    let records = shop.results("out").records;
    for record in of(&records, "best").into_iter().chain(of(&records, "greedy")) {
        let measured = &record.measured;
        assert!(record.is_ok(), "{}", record.reason);
        assert_eq!(measured.sharp_edges, Some(380));
        assert!(measured.quality_one_percent <= measured.quality_mean, "{measured:?}");
        assert!(measured.folded_quads.is_some() && measured.degree_two_vertices.is_some());
        assert_eq!(measured.peak_memory_bytes.is_some(), cfg!(target_os = "linux"));
    }
    let best = of(&records, "best")[0];
    assert!(best.command.ends_with(" --stats - -o plate.result.obj"), "{}", best.command);
    assert_eq!((best.measured.folded_quads, best.measured.sharp_edges_kept), (Some(16), Some(380)));
    assert!(best.measured.pairing_seconds.is_some());
    // Column (c) is that of the first stage, which the file does not show.
    assert!(of(&records, "ps")[0].measured.unpaired_triangles > Some(0));
    let table = self::text(&shop, "out/table_side_by_side.csv");
    let rows = |name: &str| table.lines().filter(|line| line.starts_with(name)).count();
    assert_eq!(
        (rows("plate,BEST local,"), rows("plate,greedy,"), rows("plate,absent,")),
        (1, 1, 1)
    );
    assert!(table.contains(",skipped 2\n"), "{table}");
    for plot in ["mean", "folded"] {
        let csv = self::text(&shop, &format!("out/plots/side_by_side_{plot}.csv"));
        assert!(csv.contains("greedy,plate,") && csv.contains("BEST local,plate,"), "{csv}");
    }
    assert!(!shop.path("out/meshes").exists(), "results are removed");
}

#[cfg(unix)]
#[test]
fn what_a_program_says_of_itself_is_taken_and_limits_hold() {
    let shop = Workshop::new();
    let triquad = env!("CARGO_BIN_EXE_triquad");
    let own = format!(
        "command = ['{triquad}', 'convert', '{{mesh}}', '-o', '{{quads}}', '--algorithm', 'sg', \
         '--seed', '{{seed}}', '--stats', '{{stats}}']\nstats = '{{stats}}'\nformat = 'ply'"
    );
    let slow = "command = ['sleep', '60', '{mesh}', '{quads}']";
    let programs = [("own", &own[..]), ("slow", slow)];
    std::fs::write(shop.path("mine.toml"), experiment(&programs)).unwrap();
    shop.failed("run mine.toml --scale demo --timeout 1 --out out");
    let records = shop.results("out").records;
    for record in of(&records, "own") {
        let measured = &record.measured;
        assert!(record.is_ok(), "{}", record.reason);
        assert!(measured.unpaired_triangles > Some(0) && measured.augmenting_paths > Some(0));
        assert!(measured.pairing_seconds.is_some());
        assert!(measured.total_seconds < record.process_seconds);
    }
    let slow = of(&records, "slow");
    // `sleep` refuses a name for a time, or does not end in time.
    assert!(slow.iter().all(|record| record.outcome != Outcome::Ok));
}

/// The time of the first stage alone: it is the total in every table, and no note speaks of whole
/// processes.
#[cfg(unix)]
#[test]
fn a_program_without_a_second_stage_has_one_time_in_all_tables() {
    let shop = Workshop::new();
    let script = "\"$1\" convert \"$2\" -o \"$3\" >&2 && echo '{\"pairing_seconds\": 0.001}'\n";
    std::fs::write(shop.path("own.sh"), script).unwrap();
    let triquad = env!("CARGO_BIN_EXE_triquad");
    let own = format!(
        "command = ['sh', '{{here}}/own.sh', '{triquad}', '{{mesh}}', '{{quads}}']\nstats = '-'"
    );
    let experiment = experiment(&[("own", &own[..])]);
    let experiment = experiment.replace("seed = 5", "seed = 5\nmeasured_from_files = true");
    std::fs::write(shop.path("mine.toml"), experiment).unwrap();
    shop.succeed("run mine.toml --scale demo --out out");
    let records = shop.results("out").records;
    for record in of(&records, "own") {
        assert_eq!(record.measured.total_seconds, Some(0.001), "{}", record.reason);
    }
    for table in ["table_4_3.csv", "table_side_by_side.csv"] {
        let table = text(&shop, &format!("out/{table}"));
        let row = table.lines().find(|line| line.starts_with("botijo,own,")).unwrap();
        assert!(row.contains(",0.00100000,"), "{row}");
    }
    assert!(!text(&shop, "out/index.html").contains("wall-clock time of its whole process"));
}

#[test]
fn two_columns_of_somebody_else_reach_the_tables() {
    let shop = Workshop::new();
    std::fs::write(shop.path("two.csv"), "graph,time\nBotijo,0.5\nHappy Buddha,7\n").unwrap();
    let import = "import two.csv --algorithm mymatch --out out --map ";
    shop.succeed(&format!("{import}graph=mesh,time=total_seconds"));
    assert!(text(&shop, "out/table_4_3.csv").contains("happy-buddha,mymatch,,,,,7.00000000,file,"));
    assert!(text(&shop, "out/index.html").contains("mymatch"));
    let refused = |mapping: &str| shop.refused(&format!("{import}{mapping}"));
    assert!(refused("graph=mesh,time=totalseconds").contains("nearest is \"total_seconds\""));
    assert!(refused("graf=mesh").contains("no column \"graf\"; it has graph, time"));
    assert!(refused("time=total_seconds").contains("\"graph\" is not known"));
    assert!(refused("graph=mesh,time=-").contains("no column has a number"));
    std::fs::write(shop.path("two.csv"), "mesh,seconds\nbotjo,0.5\n").unwrap();
    let refused = shop.refused("import two.csv --algorithm mymatch --out out");
    assert!(refused.contains("line 2: \"botjo\" is no mesh"), "{refused}");
    assert!(refused.ends_with("a mesh of your own, or \"botijo\" is meant\n"), "{refused}");
    std::fs::write(shop.path("far.csv"), "mesh,seconds\nmytorus,0.5\n").unwrap();
    let refused = shop.refused("import far.csv --algorithm mymatch --out out");
    assert!(refused.ends_with("--other-meshes takes it in as a mesh of your own\n"), "{refused}");
    let output = shop.run("import two.csv --algorithm mymatch --out out --other-meshes");
    let said = String::from_utf8(output.stdout).unwrap();
    let taken = "on 1 mesh taken in; seconds taken as total_seconds; ";
    assert!(said.ends_with(&format!("{taken}2 earlier rows of mymatch stay\n")), "{said}");
    assert!(text(&shop, "out/table_data.csv").contains("botjo,mymatch,"));
    std::fs::write(shop.path("tests.csv"), "mesh,link_condition_tests\nB0,2e6\n").unwrap();
    shop.succeed("import tests.csv --algorithm mine --out out");
    assert!(text(&shop, "out/table_6.csv").contains("mine_link_condition_tests"));
    assert!(text(&shop, "out/table_6.csv").contains("ir-B0,,,,,,,2000000.0,"));
}

#[test]
fn runs_counted_from_one_are_complete() {
    let shop = Workshop::new();
    let rows = "mesh,run,total_seconds\nbotijo,1,0.5\nbotijo,2,0.6\n";
    std::fs::write(shop.path("rows.csv"), rows).unwrap();
    let import = "import rows.csv --algorithm mine --map run=repetition --out out";
    let output = shop.run(import);
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success() && said.is_empty(), "{said}");
    assert!(text(&shop, "out/table_data.csv").contains(",ok 2,"));
    assert!(!text(&shop, "out/index.html").contains("planned run has no row"));
}

/// Meshes of one name in two sizes are no rows of one table.
#[test]
fn rows_of_another_scale_than_the_folder_has_are_refused() {
    let shop = Workshop::new();
    std::fs::write(shop.path("rows.csv"), "mesh,total_seconds\nbotijo,0.5\n").unwrap();
    let import = |options: &str| format!("import rows.csv --algorithm {options}");
    shop.succeed(&import("mine --scale demo --out demo"));
    shop.succeed(&import("mine --out full"));
    let before = text(&shop, "demo/runs.csv");
    let said = shop.refused(&import("yours --out demo"));
    assert_eq!(
        said,
        "triquad: rows.csv: its meshes are of scale full, those in demo of scale demo: one table \
         would have meshes of one name in two sizes; give --scale demo if that is their size, or \
         another folder with --out\n"
    );
    assert_eq!(text(&shop, "demo/runs.csv"), before);
    let said = shop.refused(&import("yours --scale small --out full"));
    assert!(said.contains("give --scale full if"), "{said}");
    shop.succeed(&import("yours --scale demo --out demo"));
    assert_eq!(shop.results("demo").records.len(), 2);
    // Other meshes have the size that they have.
    std::fs::write(shop.path("rows.csv"), "mesh,total_seconds\nmine.obj,0.5\n").unwrap();
    shop.succeed(&import("yours --out demo --other-meshes"));
}

#[test]
fn lines_of_rounded_counts_are_named() {
    let shop = Workshop::new();
    let import = |rows: &str| {
        std::fs::write(shop.path("rows.csv"), format!("mesh,unpaired_triangles\n{rows}")).unwrap();
        shop.succeed("import rows.csv --algorithm mine --out out")
    };
    let remedy = "give each run a row of its own, not their mean\n";
    assert_eq!(
        import("botijo,10\neros,10.6\n"),
        format!("triquad: rows.csv: line 3: 1 count is no whole number and was rounded; {remedy}")
    );
    let said = import(&"botijo,0.5\n".repeat(10));
    let lines = "lines 2, 3, 4, 5, 6, 7, 8, 9 and 2 more: 10 counts are no whole numbers";
    assert!(said.contains(lines), "{said}");
    // Nobody has the command of these runs.
    assert!(text(&shop, "out/index.html").contains("imported</code>"));
}

#[test]
fn what_an_import_changes_and_replaces_is_said() {
    let shop = Workshop::new();
    let import = |rows: &str, algorithm: &str| {
        std::fs::write(shop.path("rows.csv"), rows).unwrap();
        let output = shop.run(&format!("import rows.csv --algorithm {algorithm} --out out"));
        assert!(output.status.success(), "{output:?}");
        let texts = [output.stdout, output.stderr];
        texts.map(|text| String::from_utf8(text).unwrap())
    };
    let three = "mesh,total_seconds\nbotijo,0.5\nbotijo,0.6\neros,1\n";
    let [said, notes] = import(three, "mine");
    assert!(said.ends_with("on 2 meshes taken in\n") && notes.is_empty(), "{said}{notes}");
    let [said, _] = import(&three.replace("0.5", "0.7"), "mine");
    assert!(said.ends_with("taken in; 3 rows replace earlier ones\n"), "{said}");
    let [said, _] = import("mesh,repetition,total_seconds\neros,1,2\neros,1,3\n", "mine");
    let replaced = "taken in; 1 row replaces an earlier one; 3 earlier rows of mine stay\n";
    assert!(said.ends_with(replaced), "{said}");
    // Nobody timed these processes.
    let column = shop
        .results("out")
        .records
        .iter()
        .map(|record| record.process_seconds)
        .max_by(|one, other| one.partial_cmp(other).unwrap());
    assert_eq!(column, Some(None));
    assert!(!text(&shop, "out/runs.csv").contains(",0.0,"));
    // Both papers have a B1.
    let [_, notes] = import("mesh,seconds\nB1,2\nB1,3\nir-B0,4\nbotijo,1\n", "rs");
    assert_eq!(notes.lines().count(), 1, "{notes}");
    assert!(notes.contains("rows.csv: note: B1 is taken as ir-B1: "), "{notes}");
    let [_, notes] = import("mesh,total_seconds\nB1,2\n", "ps");
    assert!(notes.is_empty(), "{notes}");
    // A slip may be meant as a mesh of one's own; its row stays when it is corrected.
    let slips = "mesh,total_seconds\nBotjio,0.5\nBotjio,0.6\nchair,2\nEros,1\n";
    let [_, notes] = import(slips, "other --other-meshes");
    let note =
        "triquad: rows.csv: note: \"Botjio\" is taken as a mesh of your own; \"botijo\" is near\n";
    assert_eq!(notes, note);
    let [said, _] =
        import("mesh,total_seconds\nBotijo,0.5\nchair,2\nEros,1\n", "other --other-meshes");
    assert!(said.ends_with("replace earlier ones; 2 earlier rows of other stay\n"), "{said}");
}

#[test]
fn claims_that_cannot_be_judged_say_what_they_lack() {
    let shop = Workshop::new();
    let compare = |rows: &str, algorithm: &str| {
        std::fs::write(shop.path("rows.csv"), rows).unwrap();
        shop.succeed(&format!("import rows.csv --algorithm {algorithm} --out {algorithm}"));
        let output = shop.run(&format!("compare {algorithm}"));
        let said = String::from_utf8(output.stdout).unwrap();
        assert!(output.status.success() && said.lines().count() == 1, "{said}");
        said
    };
    let said = compare("mesh,total_seconds\nBotijo,1\nEros,2\nHappy Buddha,3\n", "ps");
    assert!(said.starts_with("ps: none of the "), "{said}");
    assert!(said.contains(" can be judged: the nearest, "), "{said}");
    assert!(
        said.contains(", lacks gargoyle and pairing_seconds of ps; see ps")
            && shop.path("ps/compare.csv").exists(),
        "{said}"
    );
    assert!(!said.contains("they need the papers' algorithms"), "{said}");
    let said = compare("mesh,total_seconds\nBotijo,1\n", "mine");
    assert!(said.contains(": they need the papers' algorithms on the papers' meshes; see "));
    std::fs::remove_file(shop.path("mine/compare.csv")).unwrap();
    let said = String::from_utf8(shop.run("compare mine").stdout).unwrap();
    assert!(said.ends_with("; 'triquad report mine' writes all reasons\n"), "{said}");
}

#[test]
fn numbers_of_meshes_of_another_size_are_not_compared() {
    let shop = Workshop::new();
    let import = |rows: &str, options: &str| {
        std::fs::write(shop.path("rows.csv"), rows).unwrap();
        shop.succeed(&format!("import rows.csv {options}"));
    };
    let rows = "mesh,unpaired_triangles,paired_percent\nbotijo,10,97\neros,20,98\n";
    import(rows, "--algorithm ps --scale demo --out demo");
    import("mesh,total_seconds\nbotijo,1\n", "--algorithm ps --scale demo --out times");
    import("mesh,total_seconds\nbotijo,1\n", "--algorithm ps --out full");
    let said = String::from_utf8(shop.run("compare demo --baseline paper").stdout).unwrap();
    let expected = "\ndemo: numbers that depend on size are left out: meshes differ in size from \
                    the baseline's (botijo, eros 100 times smaller)\n";
    assert!(said.contains(expected), "{said}");
    assert!(said.contains("paired_percent") && !said.contains("unpaired_triangles"), "{said}");
    for baseline in ["paper", "full"] {
        let said = shop.refused(&format!("compare times --baseline {baseline}"));
        let expected = format!(
            "times: no number can be compared with {baseline}: meshes differ in size from the \
             baseline's (botijo 100 times smaller)\n"
        );
        assert!(said.ends_with(&expected), "{said}");
    }
    let said = shop.refused("compare full --baseline times");
    assert!(said.ends_with("(botijo 100 times larger)\n"), "{said}");
    // A smaller mesh under the same name, whatever the scale is called.
    import("mesh,triangles,total_seconds\nbotijo,8000,1\n", "--algorithm ps --out small");
    let said = shop.refused("compare small --baseline paper");
    assert!(said.ends_with("(botijo 5.0 times smaller)\n"), "{said}");
}

#[test]
fn without_a_number_to_compare_the_reason_is_true() {
    let shop = Workshop::new();
    let import = |rows: &str, options: &str| {
        std::fs::write(shop.path("rows.csv"), rows).unwrap();
        shop.succeed(&format!("import rows.csv {options}"));
    };
    import("mesh,seconds\nir-B1,2\n", "--algorithm rs --out rs");
    let said = shop.refused("compare rs --baseline paper");
    let expected = "rs: no number can be compared with paper: both have rs on ir-B1, but no number \
                    of it in one table: here seconds, there link_condition_tests\n";
    assert!(said.ends_with(expected), "{said}");
    import("mesh,total_seconds\nbotijo,2\n", "--algorithm mine --out mine");
    let said = shop.refused("compare mine --baseline paper");
    assert!(said.ends_with("the two share no mesh with the same algorithm\n"), "{said}");
}

#[test]
fn a_total_without_one_of_its_parts_is_left_out_and_named() {
    let shop = Workshop::new();
    let import = |name: &str, rows: &str| {
        std::fs::write(shop.path("rows.csv"), rows).unwrap();
        let output = shop.run(&format!("import rows.csv --algorithm {name} --out {name}"));
        assert!(output.status.success());
        let table = text(&shop, &format!("{name}/table_4_3.csv"));
        let row = table.lines().find(|line| line.starts_with(&format!("botijo,{name},")));
        (String::from_utf8(output.stderr).unwrap(), row.expect("a row").to_owned())
    };
    let (said, row) = import("one", "mesh,pairing_seconds\nbotijo,0.5\n");
    let expected = "triquad: rows.csv: 1 run has no total, which is pairing_seconds + \
                    augmentation_seconds: augmentation_seconds is missing; add it, with 0 for a \
                    stage that does not exist, or give total_seconds\n";
    assert_eq!(said, expected);
    assert!(row.contains(",0.50000000,") && row.matches("0.5").count() == 1, "{row}");
    let rows = "mesh,pairing_seconds,augmentation_seconds\nbotijo,0.5,\nbotijo,0.5,\n";
    let (said, _) = import("two", rows);
    assert!(said.contains("2 runs have no total") && said.contains("is empty; fill"), "{said}");
    let rows = "mesh,pairing_seconds,augmentation_seconds\nbotijo,0.5,0.25\n";
    let (said, row) = import("three", rows);
    assert!(said.is_empty() && row.contains(",0.75000000,"), "{said} {row}");
}

#[test]
fn tables_are_compared_with_a_baseline_number_by_number() {
    let shop = Workshop::new();
    let rows = "mesh,unpaired_triangles,total_seconds\nbotijo,10,0.5\nbotijo,20,0.7\n";
    std::fs::write(shop.path("rows.csv"), rows).unwrap();
    shop.succeed("import rows.csv --algorithm ps --out one");
    let halved = rows.replace("0.5", "0.25").replace("0.7", "0.35");
    std::fs::write(shop.path("rows.csv"), halved).unwrap();
    shop.succeed("import rows.csv --algorithm ps --out two");
    shop.succeed("compare one --baseline paper");
    let table = text(&shop, "one/baseline/table_4_3.csv");
    assert!(table.starts_with("mesh,algorithm,number,ours,theirs,ratio,ratio_low,ratio_high\n"));
    assert!(
        table.contains("botijo,PS,unpaired_triangles,15.0,10.6,1.415,0.9434,1.887\n"),
        "{table}"
    );
    let output = shop.run("compare one --baseline two");
    let said = String::from_utf8(output.stdout).unwrap();
    assert!(said.contains("total_seconds") && said.contains("2.000"), "{said}");
    let spread =
        ["total_seconds_median", "total_seconds_upper_quartile", "unpaired_triangles_least"];
    assert!(spread.iter().all(|number| said.contains(number)), "{said}");
    // Nothing was run for this table, and the numbers of runs alone are none to compare.
    assert!(!shop.path("one/baseline/table_6.csv").exists(), "{said}");
    let table = text(&shop, "one/baseline/table_4_3.csv");
    let row = table.lines().find(|line| line.contains(",total_seconds,")).unwrap();
    assert!(row.starts_with("botijo,PS,total_seconds,0.60000000,0.30000000,2.000,"), "{row}");
    assert!(shop.refused("compare one --baseline three").contains("three"));
    // One run has no spread to compare.
    std::fs::write(shop.path("rows.csv"), rows.replace("botijo,20,0.7\n", "")).unwrap();
    shop.succeed("import rows.csv --algorithm ps --out single");
    for (one, other) in [("one", "single"), ("single", "one")] {
        let said = shop.run(&format!("compare {one} --baseline {other}")).stdout;
        let said = String::from_utf8(said).unwrap();
        assert!(said.contains("total_seconds"), "{said}");
        assert!(spread.iter().all(|number| !said.contains(number)), "{said}");
    }
}

#[test]
fn the_papers_tables_are_printed() {
    let shop = Workshop::new();
    let said = |arguments: &str| String::from_utf8(shop.run(arguments).stdout).unwrap();
    assert_eq!(said("paper").lines().count(), 16);
    let table = include_str!("../../../experiments/paper/table_4_3.csv");
    for name in ["4.3", "table_4_3", "table_4_3.csv"] {
        assert_eq!(said(&format!("paper {name}")), table);
    }
    assert!(shop.refused("paper 4.4(iii)").contains("the nearest is \"4.4(ii)\""));
}
