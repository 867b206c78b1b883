//! Tables from records that never happened.

use std::collections::BTreeSet;

use crate::records::{conversion, of_the_papers, planned, run};
use proptest::prelude::*;
use triquad_lab::experiment::{Outcome, Results, RunRecord};
use triquad_lab::report::paper::{PairingRow, Table};
use triquad_lab::report::{ReportTable, Summary, compare, tables};

fn table(results: &Results, file: &str) -> ReportTable {
    let tables = tables::all(&Summary::of(results));
    tables.into_iter().find(|table| table.file == file).expect(file)
}

/// The field of a row of a table, found by the first fields of the row.
fn field<'a>(table: &'a ReportTable, row: &[&str], column: &str) -> &'a str {
    let column = table.header.iter().position(|name| name == column).expect(column);
    let mut rows = table.rows.iter().filter(|fields| fields.iter().zip(row).all(|(f, r)| f == r));
    let found = rows.next().unwrap_or_else(|| panic!("{row:?}"));
    assert_eq!(rows.next(), None, "{row:?} stands twice");
    &found[column]
}

#[test]
fn cells_are_in_the_order_of_the_papers_whatever_the_order_of_the_rows() {
    let mut results = of_the_papers();
    let local = |run: &RunRecord| RunRecord { augmentation: Some("local".into()), ..run.clone() };
    let few = |run: &RunRecord| RunRecord { lrs_variant: Some("few-flips".into()), ..run.clone() };
    let lrs = results.records.iter().find(|run| run.algorithm == "lrs").unwrap().clone();
    let of_user = RunRecord { group: "data".into(), mesh: "zebra".into(), ..lrs.clone() };
    results.records.extend([local(&lrs), few(&lrs), local(&few(&lrs)), of_user.clone()]);
    results.records.push(RunRecord { mesh: "ape".into(), ..of_user.clone() });
    results.records.push(RunRecord { mesh: "ant".into(), triangles: Some(4), ..of_user });
    let summary = Summary::of(&results);
    results.records.reverse();
    results.planned.reverse();
    assert_eq!(Summary::of(&results), summary);
    let first = summary.cells().iter().take(8).map(|cell| (cell.mesh.as_str(), cell.label()));
    let labels = ["SG", "PS", "DS", "LRS", "LRS local", "LRS few-flips", "LRS few-flips local"];
    let expected = labels.iter().map(|label| ("botijo", (*label).to_owned()));
    assert!(first.eq(expected.chain([("eros", "SG".into())])));
    let mut groups: Vec<_> =
        summary.cells().iter().map(|c| (c.experiment.as_str(), c.group.as_str())).collect();
    groups.dedup();
    let [comparison, irreducible] =
        [["scans", "A", "B", "data"], ["scans", "B", "C", "D"]].map(|groups| groups.into_iter());
    let expected = comparison.map(|group| ("comparison", group));
    assert!(groups.into_iter().eq(expected.chain(irreducible.map(|group| ("irreducible", group)))));
    let data: Vec<_> =
        summary.of_group("comparison", Some("data")).map(|cell| cell.mesh.as_str()).collect();
    assert_eq!(data, ["ant", "ape", "zebra"]);
}

#[test]
fn a_cell_is_found_by_what_was_run() {
    let mut results = of_the_papers();
    let small = RunRecord { scale: "small".into(), ..results.records[0].clone() };
    results.records.insert(0, small);
    let summary = Summary::of(&results);
    let found = summary.cell("comparison", "eros", "lrs", None, "tarjan").unwrap();
    assert_eq!((found.label().as_str(), found.runs.len()), ("LRS", 2));
    assert_eq!(
        found,
        summary.cell("comparison", "eros", "lrs", Some("printed"), "tarjan").unwrap()
    );
    assert_eq!(summary.cell("comparison", "eros", "lrs", Some("few-flips"), "tarjan"), None);
    assert_eq!(summary.cell("comparison", "eros", "lrs", None, "local"), None);
    assert_eq!(summary.cell("irreducible", "eros", "rs", None, "file").unwrap().label(), "RS");
    // Of two scales, the larger.
    assert_eq!(summary.cell("comparison", "botijo", "sg", None, "tarjan").unwrap().scale, "full");
}

#[test]
fn only_runs_that_ended_well_count_and_none_vanishes() {
    let row = &Table::numbered("4.3").unwrap().pairing_rows()[1];
    let good = conversion("scans", row);
    let bad = |repetition, outcome| RunRecord {
        repetition,
        outcome,
        pairing_seconds: Some(1e9),
        ..good.clone()
    };
    let results = Results {
        planned: vec![planned(&good, 5), planned(&good, 5)],
        records: vec![bad(3, Outcome::Crash), bad(1, Outcome::Timeout), good.clone()],
        ..Results::default()
    };
    let summary = Summary::of(&results);
    let [cell] = summary.cells() else { panic!("one cell") };
    assert_eq!(cell.outcome_text(), "ok 1, timeout 1, crash 1, missing 2");
    let statistics = cell.statistics(|run| run.pairing_seconds).unwrap();
    assert_eq!((statistics.n, statistics.maximum), (1, row.pairing_seconds));
    assert_eq!(cell.statistics(|run| run.seconds), None);
}

#[test]
fn tables_hold_the_papers_own_numbers_when_they_are_the_records() {
    let results = of_the_papers();
    for number in ["4.3", "4.4(i)", "4.4(ii)"] {
        let printed = Table::numbered(number).unwrap();
        let ours = table(&results, printed.file());
        for PairingRow { mesh, algorithm, unpaired_triangles, pairing_seconds, errata, .. } in
            printed.pairing_rows()
        {
            let field = |column| field(&ours, &[&mesh, &algorithm], column);
            assert_eq!(field("pairing_seconds"), format!("{pairing_seconds:.8}"));
            assert_eq!(field("paper_pairing_seconds"), field("pairing_seconds"));
            assert_eq!(field("unpaired_triangles"), format!("{unpaired_triangles:.1}"));
            assert_eq!(field("paper_unpaired_triangles"), field("unpaired_triangles"));
            let same = if unpaired_triangles == 0.0 { "" } else { "1.000" };
            assert_eq!(field("ratio_unpaired_triangles"), same);
            assert_eq!(field("paper_errata"), errata);
            assert_eq!(field("extrapolated"), "");
        }
    }
    for number in ["6", "8", "10"] {
        let ours = table(&results, Table::numbered(number).unwrap().file());
        let column = ours.header.iter().position(|name| name.starts_with("ratio")).unwrap();
        assert!(ours.rows.iter().all(|row| row[column..column + 5].iter().all(|r| r == "1.000")));
    }
    for number in ["7", "9", "11"] {
        let printed = Table::numbered(number).unwrap();
        let ours = table(&results, printed.file());
        for row in printed.ratio_rows() {
            let found: f64 = field(&ours, &[&row.mesh], "schipper_to_rs_seconds").parse().unwrap();
            assert!((found - row.schipper_to_rs_seconds).abs() < 0.005, "{}", row.mesh);
        }
    }
    for number in ["4.1", "4.2(a)", "4.2(b)", "2", "3", "4", "5"] {
        let ours = table(&results, Table::numbered(number).unwrap().file());
        for row in &ours.rows {
            let agrees = row.iter().any(|field| field == "yes");
            let errata = row.last().unwrap();
            assert_eq!(agrees, errata.is_empty(), "{row:?}");
        }
    }
}

#[test]
fn what_is_missing_or_went_wrong_stands_in_the_tables() {
    let mut results = of_the_papers();
    results.records.retain(|run| (run.mesh.as_str(), run.algorithm.as_str()) != ("eros", "ds"));
    for run in results.records.iter_mut().filter(|run| run.mesh == "gargoyle") {
        run.outcome = Outcome::Timeout;
    }
    results.records.retain(|run| run.mesh != "filigree");
    results.planned.retain(|cell| cell.mesh != "filigree");
    let ours = table(&results, "table_4_3.csv");
    assert_eq!(ours.rows.len(), 24);
    assert_eq!(field(&ours, &["eros", "ds"], "outcomes"), "missing 2");
    assert_eq!(field(&ours, &["eros", "ds"], "total_seconds"), "");
    assert_eq!(field(&ours, &["eros", "ds"], "triangles"), "394456");
    assert_eq!(field(&ours, &["gargoyle", "ps"], "outcomes"), "timeout 10");
    assert_eq!(field(&ours, &["gargoyle", "ps"], "pairing_seconds"), "");
    assert_eq!(field(&ours, &["filigree", "ps"], "outcomes"), "not planned");
    assert!(ours.notes.iter().any(|note| note.contains("missing")), "{:?}", ours.notes);
    assert_eq!(field(&table(&results, "table_4_1.csv"), &["filigree"], "agrees"), "not run");
    // Nothing at all makes tables too.
    for table in tables::all(&Summary::of(&Results::default())) {
        assert!(table.rows.iter().all(|row| row.len() == table.header.len()), "{}", table.file);
        assert!(table.csv().starts_with("mesh,"));
    }
}

#[test]
fn stand_ins_extrapolation_and_disturbed_runs_are_told() {
    let mut results = of_the_papers();
    for run in results.records.iter_mut().filter(|run| run.mesh == "eros") {
        run.mesh_kind = "stand-in".into();
        if run.algorithm == "sg" {
            run.stopped_after_paths = Some(run.unpaired_triangles.unwrap() / 20);
        }
    }
    results.records.iter_mut().for_each(|run| run.parallel_jobs = 2);
    let ours = table(&results, "table_4_3.csv");
    assert_eq!(field(&ours, &["eros", "sg"], "mesh_kind"), "stand-in");
    assert_eq!(field(&ours, &["eros", "sg"], "extrapolated"), "yes");
    let time: f64 = field(&ours, &["eros", "sg"], "augmentation_seconds").parse().unwrap();
    assert!((time / 8132.045 - 1.0).abs() < 0.01, "{time}: a tenth of the paths took 813.2 s");
    for words in ["A stand-in", "Extrapolated", "beside others"] {
        assert!(ours.notes.iter().any(|note| note.contains(words)), "{words}");
    }
    let ratios = table(&results, "table_7.csv");
    assert_eq!(field(&ratios, &["ir-B0"], "schipper_to_rs_seconds"), "");
    assert_eq!(field(&ratios, &["ir-B0"], "schipper_to_rs_tests"), "1.008");
}

#[test]
fn both_augmentations_stand_side_by_side() {
    let mut results = of_the_papers();
    let locals = results.records.clone().into_iter().filter(|run| run.experiment == "comparison");
    results.records.extend(locals.map(|run| RunRecord {
        augmentation: Some("local".into()),
        augmentation_seconds: run.augmentation_seconds.map(|seconds| seconds / 100.0),
        ..run
    }));
    let only_local =
        RunRecord { algorithm: "tq".into(), ..results.records.last().unwrap().clone() };
    results.records.push(RunRecord { lrs_variant: None, ..only_local });
    let ours = table(&results, "table_augmentation.csv");
    let found = |column| field(&ours, &["eros", "PS"], column);
    assert_eq!(found("tarjan_augmentation_seconds"), "0.06892860");
    assert_eq!(found("local_augmentation_seconds"), "0.00068929");
    assert_eq!(found("tarjan_unpaired_triangles"), found("local_unpaired_triangles"));
    assert_eq!(found("total_seconds_tarjan_to_local"), "1.110");
    assert_eq!(field(&ours, &["B5", "TQ"], "tarjan_outcomes"), "not planned");
    assert_eq!(field(&ours, &["B5", "TQ"], "local_outcomes"), "ok 1");
}

#[test]
fn what_edge_flips_and_memory_cost_has_a_table() {
    let mut results = of_the_papers();
    results.records.push(RunRecord {
        group: "data".into(),
        mesh: "zebra".into(),
        ..run("comparison", "data", "socket", "tq")
    });
    let quality = table(&results, "table_quality.csv");
    assert_eq!(field(&quality, &["botijo", "LRS"], "scaled_jacobian_minimum"), "-0.9000");
    assert_eq!(field(&quality, &["botijo", "LRS"], "edge_flips_percent"), "5.651");
    let memory = table(&results, "table_memory.csv");
    assert_eq!(field(&memory, &["ir-B0", "BF"], "peak_memory_bytes_per_triangle"), "100.0");
    let data = table(&results, "table_data.csv");
    assert_eq!(data.rows.len(), 1);
    assert_eq!(field(&data, &["zebra", "TQ"], "triangles"), "1696");
}

#[test]
fn every_table_is_rectangular_and_has_a_file_of_its_own() {
    let tables = tables::all(&Summary::of(&of_the_papers()));
    let files: BTreeSet<&str> = tables.iter().map(|table| table.file).collect();
    assert_eq!(files.len(), tables.len());
    for printed in Table::ALL {
        let ours = tables.iter().find(|table| table.number == printed.number()).unwrap();
        assert_eq!(ours.file, printed.file());
    }
    for table in tables {
        let names: BTreeSet<&String> = table.header.iter().collect();
        assert_eq!(names.len(), table.header.len(), "{}", table.file);
        assert!(table.rows.iter().all(|row| row.len() == table.header.len()), "{}", table.file);
    }
}

/// What a row may suffer.
#[derive(Clone, Copy, Debug)]
enum Blow {
    Lost,
    Failed(Outcome),
    Emptied,
    NotANumber,
    Zeroed,
    Doubled,
}

fn strike(records: &mut Vec<RunRecord>, row: usize, blow: Blow) {
    let run = &mut records[row];
    match blow {
        Blow::Lost => drop(records.remove(row)),
        Blow::Failed(outcome) => run.outcome = outcome,
        Blow::Emptied => {
            (run.unpaired_triangles, run.edges, run.triangles) = (None, None, None);
            (run.augmentation_seconds, run.seconds, run.genus) = (None, None, None);
        }
        Blow::NotANumber => {
            (run.pairing_seconds, run.seconds) = (Some(f64::NAN), Some(f64::INFINITY));
        }
        Blow::Zeroed => {
            (run.unpaired_triangles, run.augmenting_paths) = (Some(0), Some(0));
            (run.pairing_seconds, run.seconds) = (Some(0.0), Some(0.0));
            (run.triangles, run.link_condition_tests) = (Some(0), Some(0));
        }
        Blow::Doubled => records.push(records[row].clone()),
    }
}

fn blow() -> impl Strategy<Value = Blow> {
    prop_oneof![
        4 => Just(Blow::Lost),
        1 => Just(Blow::Failed(Outcome::Timeout)),
        1 => Just(Blow::Failed(Outcome::Invalid)),
        1 => Just(Blow::Emptied),
        1 => Just(Blow::NotANumber),
        1 => Just(Blow::Zeroed),
        1 => Just(Blow::Doubled),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    /// Rows that are lost, failed, empty or nonsense make no report fail, and no row vanishes from it.
    #[test]
    fn broken_records_make_a_report(
        blows in prop::collection::vec((any::<prop::sample::Index>(), blow()), 0..600),
    ) {
        let mut results = of_the_papers();
        for (row, blow) in blows {
            let row = row.index(results.records.len());
            strike(&mut results.records, row, blow);
        }
        let summary = Summary::of(&results);
        let runs: usize = summary.cells().iter().map(|cell| cell.runs.len()).sum();
        prop_assert_eq!(runs, results.records.len());
        for table in tables::all(&summary) {
            prop_assert!(table.rows.iter().all(|row| row.len() == table.header.len()));
            prop_assert!(!table.csv().contains("NaN") && !table.csv().contains("inf"));
        }
        let comparison = compare::judge(&summary);
        for judged in &comparison.verdicts {
            prop_assert!(!judged.ours.contains("NaN") && !judged.detail.contains("NaN"), "{judged:?}");
        }
        prop_assert_eq!(compare::judge(&Summary::of(&results)), comparison);
    }
}
