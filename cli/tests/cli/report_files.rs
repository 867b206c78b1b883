//! Results folders and what `report` and `compare` make of them.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::{Command, Output};

use crate::records::{conversion, of_the_papers, planned, run};
use tempfile::TempDir;
use triquad_lab::experiment::results::Planned;
use triquad_lab::experiment::{Measured, Outcome, Results, RunRecord};
use triquad_lab::meshes::MeshKind;
use triquad_lab::paper::Table;
use triquad_lab::report::{self, Extent};

/// A results folder with these records and this plan.
fn folder(results: &Results) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(
        folder.path().join("runs.csv"),
        csv_of(results.records.iter().map(RunRecord::to_row)),
    )
    .unwrap();
    if !results.planned.is_empty() {
        std::fs::write(
            folder.path().join("plan.csv"),
            csv_of(results.planned.iter().map(Planned::to_row)),
        )
        .unwrap();
    }
    folder
}

fn csv_of<T: serde::Serialize>(rows: impl Iterator<Item = T>) -> Vec<u8> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    rows.for_each(|row| writer.serialize(row).unwrap());
    writer.into_inner().unwrap()
}

/// All files of a folder, by name.
fn content(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let files = entries.filter(|path| path.is_file());
    let name = |path: &Path| path.file_name().unwrap().to_str().unwrap().to_owned();
    files.map(|path| (name(&path), std::fs::read(&path).unwrap())).collect()
}

fn triquad(verb: &str, folder: &Path) -> Output {
    Command::new(env!("CARGO_BIN_EXE_triquad")).arg(verb).arg(folder).output().unwrap()
}

/// Writes the report on a folder into it.
fn write(folder: &Path) {
    let results = Results::read(folder).unwrap();
    report::write(folder, &results, Extent::Everything).unwrap();
}

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).unwrap()
}

/// A little of everything: repetitions, a timeout, a stopped augmentation, RS.
fn scripted() -> Results {
    let rows = Table::numbered("4.3").unwrap().pairing_rows();
    let repeated = |row: usize, repetition: u32, seconds: f64| {
        let run = conversion("scans", &rows[row]);
        let measured = Measured {
            pairing_seconds: Some(seconds),
            augmentation_seconds: Some(2.0 * seconds),
            ..run.measured
        };
        RunRecord { repetition, measured, ..run }
    };
    let stopped = RunRecord { stopped_after_paths: Some(251), ..repeated(0, 0, 0.25) };
    let timeout = RunRecord {
        outcome: Outcome::Timeout,
        reason: "after 900 s".into(),
        ..run("comparison", "scans", "botijo", "ds")
    };
    let mut stand_in = run("irreducible", "B", "ir-B9", "rs");
    stand_in.mesh_kind = MeshKind::StandIn;
    stand_in.measured.seconds = Some(0.5);
    stand_in.measured.link_condition_tests = Some(1000);
    stand_in.measured.edges_tested_more_than_once = Some(0);
    let mut records = vec![stopped, timeout.clone(), stand_in];
    records.extend([1.0, 2.0, 4.0].iter().zip(0..).map(|(&seconds, i)| repeated(1, i, seconds)));
    let planned = vec![planned(&timeout, 1), planned(&repeated(1, 0, 1.0), 4)];
    Results { records, planned, ..Results::default() }
}

const TABLE_4_3: &str = "\
mesh,algorithm,pairing_seconds,paired_percent,unpaired_triangles,augmentation_seconds,total_seconds,\
mesh_kind,vertices,triangles,genus,pairing_seconds_without_shuffle,n,total_seconds_median,\
total_seconds_lower_quartile,total_seconds_upper_quartile,unpaired_triangles_least,\
unpaired_triangles_greatest,edge_flips,edge_flips_percent,outcomes,extrapolated,\
paper_pairing_seconds,paper_paired_percent,paper_unpaired_triangles,paper_augmentation_seconds,\
paper_total_seconds,ratio_unpaired_triangles,ratio_pairing_seconds,ratio_total_seconds,paper_errata
botijo,sg,0.25000000,87.4455,5023.0,5.00298805,5.25298805,\
file,20000,40016,5,,1,5.25298805,5.25298805,\
5.25298805,5023,5023,0.0,0,ok 1,yes,\
0.00165190,87.4455,5023.8,4.98534900,\
4.98700090,0.9998,151.3,1.053,
botijo,ps,2.33333333,99.9735,10.0,4.66666667,7.00000000,\
file,20000,40016,5,,3,6.00000000,3.50000000,\
11.00000000,10,10,0.0,0,\"ok 3, missing 1\",,\
0.05538500,99.9735,10.6,0.01776800,\
0.07315300,0.9434,42.13,95.69,
botijo,ds,,,,,,\
file,20000,40016,5,,0,,,\
,,,,,timeout 1,,\
1.93481000,100.0000,0.0,0.00000000,\
1.93481000,,,,
botijo,lrs,,,,,,\
file,20000,40016,5,,0,,,\
,,,,,not planned,,\
0.70350300,99.8471,62.0,0.01820400,\
0.72170700,,,,paired_percent: 62 of 40016 triangles unpaired leave 99.8451 paired; a digit slipped
";

const TABLE_6_LAST: &str = "\
ir-B9,1000.0,,,0.0,,,,,,,,,,,,,,,stand-in,4400,8796,0,1,ok 1,0,not planned,0,not planned,\
4063.0,4408.0,5246.4,6.0,92.1,0.2461,,,,,
";

#[test]
fn tables_are_what_they_were() {
    let folder = folder(&scripted());
    write(folder.path());
    let files = content(folder.path());
    let table = text(&files["table_4_3.csv"]);
    assert!(table.starts_with(TABLE_4_3), "{}", &table[..TABLE_4_3.len().min(table.len())]);
    let table = text(&files["table_6.csv"]);
    assert!(table.ends_with(TABLE_6_LAST), "{table}");
    let compare = text(&files["compare.csv"]);
    let row = compare.lines().find(|line| line.starts_with("sg-percent,")).unwrap();
    assert_eq!(
        row,
        "sg-percent,not comparable,machine-free,SG pairs about 87 % of the triangles on every mesh.,\
         \"comparison, section 3.1\",87.45 on 1 mesh,about 87 %; in its tables 87.45 to 87.86 on 6 \
         meshes,\"only 1 of 6 meshes. botijo (file) 87.45. without: eros (sg not planned), filigree \
         (sg not planned), gargoyle (sg not planned), happy-buddha (sg not planned), iphigenia (sg \
         not planned)\",,,rounding"
    );
}

#[test]
fn a_report_made_twice_is_the_same_and_replaces_only_its_own_files() {
    let folder = folder(&of_the_papers());
    let before = content(folder.path());
    let found = triquad("report", folder.path());
    assert_eq!(found.status.code(), Some(0), "{found:?}");
    assert!(found.stderr.is_empty(), "{}", text(&found.stderr));
    assert!(text(&found.stdout).starts_with(&folder.path().display().to_string()));
    let first = content(folder.path());
    assert!(before.iter().all(|(name, bytes)| first[name] == *bytes));
    assert!(Table::ALL.iter().all(|table| first.contains_key(table.file)));
    std::fs::write(folder.path().join("table_6.csv"), "old").unwrap();
    assert_eq!(triquad("report", folder.path()).status.code(), Some(0));
    assert_eq!(content(folder.path()), first);
    // In another order of the rows too.
    let mut results = of_the_papers();
    results.records.reverse();
    let other = self::folder(&results);
    write(other.path());
    let same = |name: &str| content(other.path())[name] == first[name];
    assert!(first.keys().filter(|name| *name != "runs.csv").all(|name| same(name)));
}

#[test]
fn damage_is_told_and_spoils_nothing_else() {
    let folder = folder(&scripted());
    let path = folder.path().join("runs.csv");
    let runs = std::fs::read_to_string(&path).unwrap();
    let cut = runs.trim_end();
    std::fs::write(&path, &cut[..cut.len() - 40]).unwrap();
    let found = triquad("report", folder.path());
    assert_eq!(found.status.code(), Some(0), "{found:?}");
    let stderr = text(&found.stderr);
    assert!(stderr.contains("runs.csv, line 7: damaged and left out"), "{stderr}");
    assert!(stderr.contains("comparison: PS on botijo: 2 planned runs have no row"), "{stderr}");
    let table = std::fs::read_to_string(folder.path().join("table_4_3.csv")).unwrap();
    assert!(table.contains("\"ok 2, missing 2\""), "{table}");
}

#[test]
fn a_file_that_cannot_be_written_replaces_nothing() {
    let folder = folder(&scripted());
    std::fs::create_dir(folder.path().join("compare.csv")).unwrap();
    let before = content(folder.path());
    let found = triquad("report", folder.path());
    assert_eq!(found.status.code(), Some(2), "{found:?}");
    assert!(text(&found.stderr).contains("compare.csv"), "{}", text(&found.stderr));
    assert_eq!(content(folder.path()), before);
}

#[test]
fn verdicts_are_printed_and_counted_and_a_difference_is_no_failure() {
    let mut results = of_the_papers();
    for run in results.records.iter_mut().filter(|run| run.id.job.algorithm() == "lrs") {
        run.measured.unpaired_triangles = Some(1_000_000);
    }
    let folder = folder(&results);
    let found = triquad("compare", folder.path());
    assert_eq!(found.status.code(), Some(0), "{found:?}");
    let stdout = text(&found.stdout);
    for verdict in
        ["reproduced ", "by construction ", "differs ", "not comparable ", "paper inconsistent "]
    {
        assert!(stdout.lines().any(|line| line.starts_with(verdict)), "{verdict}");
    }
    let line = stdout.lines().find(|line| line.contains(" lrs-genus-0 ")).unwrap();
    assert!(line.starts_with("differs") && line.contains("ours 1000000 on 7 meshes"), "{line}");
    assert!(line.contains("paper ℓ = 4; in its tables 4.000 on 7 meshes"), "{line}");
    let last = stdout.lines().last().unwrap();
    let claims = stdout.lines().count() - 1;
    assert!(last.starts_with(&format!("{claims} claims: ")), "{last}");
    let numbers = last.split([' ', ',']).filter_map(|word| word.parse::<usize>().ok());
    assert_eq!(numbers.sum::<usize>(), 2 * claims);
}

#[test]
fn what_is_no_results_folder_is_refused_in_one_line() {
    let empty = tempfile::tempdir().unwrap();
    let no_records = folder(&Results::default());
    let cases = [
        ("report", &empty),
        ("compare", &empty),
        ("compare", &no_records),
        ("report", &no_records),
    ];
    for (verb, folder) in cases {
        let found = triquad(verb, folder.path());
        assert_eq!(found.status.code(), Some(2), "{verb} {found:?}");
        assert_eq!(text(&found.stderr).lines().count(), 1, "{found:?}");
        assert!(text(&found.stderr).contains("runs.csv"), "{found:?}");
    }
    // An error, not an empty page.
    assert!(!no_records.path().join("index.html").exists());
}

#[test]
fn report_fills_the_tables_of_documents() {
    let folder = folder(&of_the_papers());
    let document = folder.path().join("notes.md");
    let report = |text: &str| {
        std::fs::write(&document, text).unwrap();
        let mut report = Command::new(env!("CARGO_BIN_EXE_triquad"));
        report.arg("report").arg(folder.path()).arg("--docs").arg(&document).output().unwrap()
    };
    assert!(report("a\n<!-- table: 4.3 -->\n<!-- end -->\n").status.success());
    let filled = std::fs::read_to_string(&document).unwrap();
    assert!(filled.contains("\n| botijo | PS | 10.6 |"), "{filled}");
    let refused = report("<!-- table: 9.9 -->\n");
    assert_eq!(refused.status.code(), Some(2));
    let message = String::from_utf8(refused.stderr).unwrap();
    assert!(message.contains("notes.md:1: no table is called '9.9'"), "{message}");
}
