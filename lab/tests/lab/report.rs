//! Tables from records that never happened.

use std::collections::BTreeSet;

use crate::records::{conversion, of_the_papers, planned, run};
use proptest::prelude::*;
use triquad::augmentation::Augmentation;
use triquad::irreducible::Contractor;
use triquad::pairing::{Algorithm, Expansion};
use triquad_lab::experiment::import::{self, ImportSettings, Imported};
use triquad_lab::experiment::{Job, Measured, Outcome, Results, RunRecord};
use triquad_lab::meshes::MeshKind;
use triquad_lab::meshes::paper::Scale;
use triquad_lab::paper::{PairingRow, Paper, Table};
use triquad_lab::report::{Note, ReportTable, Summary, compare, tables};

fn table(results: &Results, file: &str) -> ReportTable {
    let tables = tables::all(&Summary::new(results));
    tables.into_iter().find(|table| table.file == file).expect(file)
}

/// The field of a row of a table, found by the first fields of the row.
fn field(table: &ReportTable, row: &[&str], column: &str) -> String {
    let (header, rows) = table.fields();
    let column = header.iter().position(|name| name == column).expect(column);
    let mut rows = rows.iter().filter(|fields| fields.iter().zip(row).all(|(f, r)| f == r));
    let found = rows.next().unwrap_or_else(|| panic!("{row:?}"));
    assert_eq!(rows.next(), None, "{row:?} stands twice");
    found[column].clone()
}

#[test]
fn cells_are_in_the_order_of_the_papers_whatever_the_order_of_the_rows() {
    let mut results = of_the_papers();
    let with = |run: &RunRecord, change: &dyn Fn(&mut RunRecord)| {
        let mut run = run.clone();
        change(&mut run);
        run
    };
    let local = |run: &RunRecord| {
        with(run, &|run| run.id.job = run.id.job.with_augmentation(Augmentation::Local))
    };
    let few = Job::published(Algorithm::Lrs(Expansion::FewFlips));
    let is_lrs = |run: &&RunRecord| run.id.job.algorithm() == "lrs";
    let lrs = results.records.iter().find(is_lrs).unwrap().clone();
    let few = with(&lrs, &|run| run.id.job = few);
    let named = |name: &str, triangles| {
        with(&lrs, &|run| {
            run.id.mesh.group = "data".into();
            run.id.mesh.name = name.into();
            run.measured.triangles = triangles;
        })
    };
    let triangles = lrs.measured.triangles;
    results.records.extend([local(&lrs), local(&few), few]);
    results.records.extend([named("zebra", triangles), named("ape", triangles)]);
    results.records.push(named("ant", Some(4)));
    let summary = Summary::new(&results);
    results.records.reverse();
    results.planned.reverse();
    assert_eq!(Summary::new(&results), summary);
    let first = summary.cells().iter().take(9).map(|cell| (cell.mesh(), cell.label()));
    let labels = ["SG", "PS", "DS", "LRS", "LRS local", "LRS few-flips", "LRS few-flips local"];
    let expected = labels.iter().map(|label| ("botijo", (*label).to_owned()));
    let velho = [("botijo", "Velho".into()), ("eros", "SG".into())];
    assert!(first.eq(expected.chain(velho)));
    let mut groups: Vec<_> = summary
        .cells()
        .iter()
        .map(|c| (c.id.mesh.experiment.as_str(), c.id.mesh.group.as_str()))
        .collect();
    groups.dedup();
    let comparison = ["scans", "A", "B", "data"].into_iter();
    let irreducible = ["scans", "B", "C", "D", "figure-6"].into_iter();
    let expected = comparison.map(|group| ("comparison", group));
    assert!(groups.into_iter().eq(expected.chain(irreducible.map(|group| ("irreducible", group)))));
    let data: Vec<_> =
        summary.of_group(Paper::Comparison, "data").map(|cell| cell.mesh()).collect();
    assert_eq!(data, ["ant", "ape", "zebra"]);
}

#[test]
fn a_cell_is_found_by_what_was_run() {
    let mut results = of_the_papers();
    let mut small = results.records[0].clone();
    small.id.mesh.scale = Scale::Small;
    results.records.insert(0, small);
    let summary = Summary::new(&results);
    let cell = |mesh, algorithm| summary.cell(Paper::Comparison, mesh, Job::published(algorithm));
    let found = cell("eros", Algorithm::Lrs(Expansion::Printed)).unwrap();
    assert_eq!((found.label().as_str(), found.runs.len()), ("LRS", 2));
    assert_eq!(cell("eros", Algorithm::Lrs(Expansion::FewFlips)), None);
    let local = found.id.job.with_augmentation(Augmentation::Local);
    assert_eq!(summary.cell(Paper::Comparison, "eros", local), None);
    let rs = Job::in_file_order(Contractor::RamaswamiSiqueira);
    assert_eq!(summary.cell(Paper::Irreducible, "eros", rs).unwrap().label(), "RS");
    // Of two scales, the larger.
    let botijo = cell("botijo", Algorithm::SimpleGreedy).unwrap();
    assert_eq!(botijo.id.mesh.scale, Scale::Full);
}

#[test]
fn only_runs_that_ended_well_count_and_none_vanishes() {
    let row = &Table::numbered("4.3").unwrap().pairing_rows()[1];
    let good = conversion("scans", row);
    let bad = |repetition, outcome| {
        let measured = Measured { pairing_seconds: Some(1e9), ..good.measured.clone() };
        RunRecord { repetition, outcome, measured, ..good.clone() }
    };
    let results = Results {
        planned: vec![planned(&good, 5), planned(&good, 5)],
        records: vec![bad(3, Outcome::Crash), bad(1, Outcome::Timeout), good.clone()],
        ..Results::default()
    };
    let summary = Summary::new(&results);
    let [cell] = summary.cells() else { panic!("one cell") };
    assert_eq!(cell.outcome_text(), "ok 1, timeout 1, crash 1, missing 2");
    let statistics = cell.statistics(|run| run.measured.pairing_seconds).unwrap();
    assert_eq!((statistics.n, statistics.maximum), (1, row.pairing_seconds));
    assert_eq!(cell.statistics(|run| run.measured.seconds), None);
}

#[test]
fn tables_hold_the_papers_own_numbers_when_they_are_the_records() {
    let results = of_the_papers();
    for number in ["4.3", "4.4(i)", "4.4(ii)"] {
        let printed = Table::numbered(number).unwrap();
        let ours = table(&results, printed.file);
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
        let ours = table(&results, Table::numbered(number).unwrap().file);
        let (header, rows) = ours.fields();
        let column = header.iter().position(|name| name.starts_with("ratio")).unwrap();
        assert!(rows.iter().all(|row| row[column..column + 5].iter().all(|r| r == "1.000")));
    }
    for number in ["7", "9", "11"] {
        let printed = Table::numbered(number).unwrap();
        let ours = table(&results, printed.file);
        for row in printed.ratio_rows() {
            let found: f64 = field(&ours, &[&row.mesh], "schipper_to_rs_seconds").parse().unwrap();
            assert!((found - row.schipper_to_rs_seconds).abs() < 0.005, "{}", row.mesh);
        }
    }
    for number in ["4.1", "4.2(a)", "4.2(b)", "2", "3", "4", "5"] {
        let ours = table(&results, Table::numbered(number).unwrap().file);
        for row in ours.fields().1 {
            let agrees = row.iter().any(|field| field == "yes");
            let errata = row.last().unwrap();
            assert_eq!(agrees, errata.is_empty(), "{row:?}");
        }
    }
}

#[test]
fn what_is_missing_or_went_wrong_stands_in_the_tables() {
    let mut results = of_the_papers();
    results
        .records
        .retain(|run| (run.id.mesh.name.as_str(), run.id.job.algorithm()) != ("eros", "ds"));
    for run in results.records.iter_mut().filter(|run| run.id.mesh.name == "gargoyle") {
        run.outcome = Outcome::Timeout;
    }
    results.records.retain(|run| run.id.mesh.name != "filigree");
    results.planned.retain(|cell| cell.id.mesh.name != "filigree");
    let ours = table(&results, "table_4_3.csv");
    assert_eq!(ours.rows.len(), 24);
    assert_eq!(field(&ours, &["eros", "ds"], "outcomes"), "missing 2");
    assert_eq!(field(&ours, &["eros", "ds"], "total_seconds"), "");
    assert_eq!(field(&ours, &["eros", "ds"], "triangles"), "394456");
    assert_eq!(field(&ours, &["gargoyle", "ps"], "outcomes"), "timeout 10");
    assert_eq!(field(&ours, &["gargoyle", "ps"], "pairing_seconds"), "");
    assert_eq!(field(&ours, &["filigree", "ps"], "outcomes"), "not planned");
    assert!(ours.notes.contains(&Note::Incomplete), "{:?}", ours.notes);
    assert_eq!(field(&table(&results, "table_4_1.csv"), &["filigree"], "agrees"), "not run");
    // Nothing at all makes tables too.
    for table in tables::all(&Summary::new(&Results::default())) {
        let (header, rows) = table.fields();
        assert!(rows.iter().all(|row| row.len() == header.len()), "{}", table.file);
        assert!(table.csv().starts_with("mesh,"));
    }
}

#[test]
fn stand_ins_extrapolation_and_disturbed_runs_are_told() {
    let mut results = of_the_papers();
    for run in results.records.iter_mut().filter(|run| run.id.mesh.name == "eros") {
        run.mesh_kind = MeshKind::StandIn;
        if run.id.job.algorithm() == "sg" {
            run.stopped_after_paths = Some(run.measured.unpaired_triangles.unwrap() / 20);
        }
    }
    results.records.iter_mut().for_each(|run| run.parallel_jobs = 2);
    let ours = table(&results, "table_4_3.csv");
    assert_eq!(field(&ours, &["eros", "sg"], "mesh_kind"), "stand-in");
    assert_eq!(field(&ours, &["eros", "sg"], "extrapolated"), "yes");
    let time: f64 = field(&ours, &["eros", "sg"], "augmentation_seconds").parse().unwrap();
    assert!((time / 8132.045 - 1.0).abs() < 0.01, "{time}: a tenth of the paths took 813.2 s");
    for note in [Note::StandIn, Note::Extrapolated, Note::Parallel] {
        assert!(ours.notes.contains(&note), "{note:?}");
    }
    let ratios = table(&results, "table_7.csv");
    assert_eq!(field(&ratios, &["ir-B0"], "schipper_to_rs_seconds"), "");
    assert_eq!(field(&ratios, &["ir-B0"], "schipper_to_rs_tests"), "1.008");
}

/// Takes a table of results of a program of others, on meshes of the papers.
fn theirs(text: &str) -> Imported {
    let settings = ImportSettings {
        algorithm: "theirs".into(),
        task: None,
        scale: Scale::Full,
        mapping: Vec::new(),
        allows_other_meshes: false,
    };
    import::read(text, &settings).unwrap()
}

#[test]
fn imported_rows_and_ours_keep_the_kind_of_their_own_mesh() {
    let text = "mesh,total_seconds,triangles,quads\nbotijo,0.02,28544,14272\n";
    let imported = theirs(text);
    let is_botijo = |run: &&mut RunRecord| run.id.mesh.name == "botijo";
    for ours in [MeshKind::StandIn, MeshKind::Generated] {
        let mut results = of_the_papers();
        results.records.iter_mut().filter(is_botijo).for_each(|run| run.mesh_kind = ours);
        results.planned.extend(imported.planned());
        // Whichever stands first.
        results.records.splice(0..0, imported.records.clone());
        let pairings = table(&results, "table_4_3.csv");
        let kind = |algorithm| field(&pairings, &["botijo", algorithm], "mesh_kind");
        assert_eq!([kind("ps"), kind("ds"), kind("theirs")], [ours.id(), ours.id(), "file"]);
        assert_eq!(field(&table(&results, "table_4_1.csv"), &["botijo"], "mesh_kind"), ours.id());
    }
}

/// Tables of one kind of number have no rows of results that lack it, unless a run failed.
#[test]
fn rows_without_a_number_are_left_out_of_tables_of_memory_and_quality() {
    let has_rows = |text: &str| {
        let imported = theirs(text);
        let mut results = of_the_papers();
        results.planned.extend(imported.planned());
        results.records.extend(imported.records);
        ["table_memory.csv", "table_quality.csv"].map(|file| {
            let (_, rows) = table(&results, file).fields();
            assert!(rows.iter().any(|row| row[..2] == ["botijo", "PS"]));
            rows.iter().any(|row| row[..2] == ["botijo", "theirs"])
        })
    };
    let header = "mesh,total_seconds,peak_memory_bytes,quality_mean,edge_flips,outcome\n";
    let row = |row: &str| has_rows(&format!("{header}botijo,{row}\n"));
    assert_eq!(row("0.5,,,,"), [false, false]);
    assert_eq!(row("0.5,9000000,,,"), [true, false]);
    assert_eq!(row("0.5,,0.5,,"), [false, true]);
    assert_eq!(row("0.5,,,7,"), [false, true]);
    assert_eq!(row(",,,,timeout"), [true, true]);
}

#[test]
fn costs_of_tests_stand_beside_their_numbers_and_shuffles_apart() {
    let mut results = of_the_papers();
    let tests = table(&results, "table_8.csv");
    let found = |column: &str| field(&tests, &["ir-C3"], column);
    assert_eq!(found("schipper_link_condition_tests"), "615112.0");
    assert_eq!(found("schipper_link_vertices_visited"), "1230224.0");
    assert_eq!(found("schipper_link_vertices_visited_a_test"), "2.000");
    assert_eq!(found("brute_force_degree_products_a_test"), "40.00");
    let shown = tests.columns.iter().filter(|column| column.is_shown);
    assert_eq!(shown.filter(|column| column.name.ends_with("_a_test")).count(), 6);

    for run in &mut results.records {
        run.measured.shuffle_seconds = run.measured.pairing_seconds.map(|seconds| seconds / 4.0);
    }
    let pairings = table(&results, "table_4_3.csv");
    let seconds = |column| -> f64 { field(&pairings, &["eros", "sg"], column).parse().unwrap() };
    let ratio = seconds("pairing_seconds_without_shuffle") / seconds("pairing_seconds");
    assert!((ratio - 0.75).abs() < 1e-3, "{ratio}");
}

#[test]
fn both_augmentations_stand_side_by_side() {
    let mut results = of_the_papers();
    let conversions = results.records.clone().into_iter();
    let conversions = conversions.filter(|run| run.id.mesh.experiment == "comparison");
    results.records.extend(conversions.map(|mut run| {
        run.id.job = run.id.job.with_augmentation(Augmentation::Local);
        run.measured.augmentation_seconds =
            run.measured.augmentation_seconds.map(|seconds| seconds / 100.0);
        run
    }));
    let mut only_local = results.records.last().unwrap().clone();
    only_local.id.job = Job::default();
    results.records.push(only_local);
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
    let mut zebra = run("comparison", "data", "socket", "tq");
    zebra.id.mesh.name = "zebra".into();
    results.records.push(zebra);
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
fn names_of_groups_change_no_table() {
    let mut results = of_the_papers();
    let mut own = run("comparison", "data", "socket", "tq");
    own.id.mesh.name = "zebra".into();
    results.planned.push(planned(&own, 2));
    results.records.push(own);
    let csv = |results: &Results| {
        let tables = tables::all(&Summary::new(results));
        tables.iter().map(|table| (table.file, table.csv())).collect::<Vec<_>>()
    };
    let expected = csv(&results);
    assert!(expected.iter().any(|table| table.1.contains("\nzebra,TQ,")));
    for group in ["scans", "A", "data", "mine"] {
        results.records.iter_mut().for_each(|run| run.id.mesh.group = group.into());
        results.planned.iter_mut().for_each(|planned| planned.id.mesh.group = group.into());
        assert_eq!(csv(&results), expected, "{group}");
    }
}

#[test]
fn every_table_is_rectangular_and_has_a_file_of_its_own() {
    let tables = tables::all(&Summary::new(&of_the_papers()));
    let files: BTreeSet<&str> = tables.iter().map(|table| table.file).collect();
    assert_eq!(files.len(), tables.len());
    for printed in Table::ALL {
        let ours = tables.iter().find(|table| table.paper == Some(printed)).unwrap();
        assert_eq!(ours.file, printed.file);
    }
    for table in tables {
        let (header, rows) = table.fields();
        let names: BTreeSet<&String> = header.iter().collect();
        assert_eq!(names.len(), header.len(), "{}", table.file);
        assert!(rows.iter().all(|row| row.len() == header.len()), "{}", table.file);
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
            let measured = &mut run.measured;
            (measured.unpaired_triangles, measured.edges, measured.triangles) = (None, None, None);
            (measured.augmentation_seconds, measured.seconds, measured.genus) = (None, None, None);
        }
        Blow::NotANumber => {
            let measured = &mut run.measured;
            (measured.pairing_seconds, measured.seconds) = (Some(f64::NAN), Some(f64::INFINITY));
        }
        Blow::Zeroed => {
            let measured = &mut run.measured;
            (measured.unpaired_triangles, measured.augmenting_paths) = (Some(0), Some(0));
            (measured.pairing_seconds, measured.seconds) = (Some(0.0), Some(0.0));
            (measured.triangles, measured.link_condition_tests) = (Some(0), Some(0));
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

    /// Rows that are lost, failed, empty or nonsense make no report fail, and no row vanishes from
    /// it.
    #[test]
    fn broken_records_make_a_report(
        blows in prop::collection::vec((any::<prop::sample::Index>(), blow()), 0..600),
    ) {
        let mut results = of_the_papers();
        for (row, blow) in blows {
            let row = row.index(results.records.len());
            strike(&mut results.records, row, blow);
        }
        let summary = Summary::new(&results);
        let runs: usize = summary.cells().iter().map(|cell| cell.runs.len()).sum();
        prop_assert_eq!(runs, results.records.len());
        for table in tables::all(&summary) {
            let (header, rows) = table.fields();
            prop_assert!(rows.iter().all(|row| row.len() == header.len()));
            prop_assert!(!table.csv().contains("NaN") && !table.csv().contains("inf"));
        }
        let comparison = compare::judge(&summary);
        for judged in &comparison.verdicts {
            let is_number = !judged.ours.contains("NaN") && !judged.detail().contains("NaN");
            prop_assert!(is_number, "{judged:?}");
        }
        prop_assert_eq!(compare::judge(&Summary::new(&results)), comparison);
    }
}
