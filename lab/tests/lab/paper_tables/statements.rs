//! What the papers' sentences say of their tables: those that do not hold are exactly those listed.

use std::collections::BTreeSet;

use serde::Deserialize;
use serde::de::DeserializeOwned;
use triquad_lab::paper::PairingRow;

use super::{agrees, mesh_row, number, printed_rows, table};

/// A measurement that stands in a sentence only: a row of `printed_in_text.csv`.
#[derive(Debug, Deserialize)]
struct TextRow {
    /// A mesh's name, or which meshes.
    mesh: String,
    algorithm: String,
    /// What was measured, in the words of the records.
    quantity: String,
    /// Digit by digit as printed.
    value: String,
}

/// A sentence that the tables or other sentences contradict: a row of `errata_text.csv`.
#[derive(Debug, Deserialize)]
struct TextErratum {
    id: String,
    source: String,
    statement: String,
    contradiction: String,
    reading: String,
    /// `recomputing` or `reading`.
    found_by: String,
}

fn rows<Row: DeserializeOwned>(text: &str) -> Vec<Row> {
    let rows = csv::Reader::from_reader(text.as_bytes()).into_deserialize();
    rows.collect::<Result<_, _>>().unwrap()
}

fn printed_in_text() -> Vec<TextRow> {
    rows(include_str!("../../../experiments/paper/printed_in_text.csv"))
}

fn text_errata() -> Vec<TextErratum> {
    rows(include_str!("../../../experiments/paper/errata_text.csv"))
}

type Statement = (&'static str, bool);

/// A column of a table, in the order of its rows: from the most triangles to the fewest, or from
/// the largest genus to the smallest.
fn column(table_number: &str, column: &str) -> Vec<f64> {
    printed_rows(&table(table_number)).iter().map(|(_, row)| number(row, column)).collect()
}

fn grows(values: &[f64]) -> bool {
    values.is_sorted()
}

fn falls(values: &[f64]) -> bool {
    values.iter().rev().is_sorted()
}

/// `values / divisors`, one by one.
fn ratios(values: &[f64], divisors: &[f64]) -> Vec<f64> {
    values.iter().zip(divisors).map(|(value, divisor)| value / divisor).collect()
}

/// Which of the rows a condition holds for.
fn rows_where(values: &[f64], others: &[f64], condition: fn(&f64, &f64) -> bool) -> Vec<usize> {
    let pairs = values.iter().zip(others).enumerate();
    pairs.filter(|(_, (value, other))| condition(value, other)).map(|(row, _)| row).collect()
}

/// What a sentence prints.
fn text(mesh: &str, algorithm: &str, quantity: &str) -> String {
    let mut rows = printed_in_text().into_iter().filter(|row| {
        (row.mesh.as_str(), row.algorithm.as_str(), row.quantity.as_str())
            == (mesh, algorithm, quantity)
    });
    let row = rows.next().unwrap_or_else(|| panic!("nothing on {quantity}, {algorithm}, {mesh}"));
    assert!(rows.next().is_none(), "twice: {row:?}");
    row.value
}

fn text_number(mesh: &str, algorithm: &str, quantity: &str) -> f64 {
    text(mesh, algorithm, quantity).parse().unwrap()
}

/// The rows of an algorithm in a table.
fn of(algorithm: &str, number: &str) -> Vec<PairingRow> {
    let rows = table(number).pairing_rows().into_iter();
    rows.filter(|row| row.algorithm == algorithm).collect()
}

fn share(row: &PairingRow) -> f64 {
    row.unpaired_triangles / f64::from(mesh_row(&row.mesh).triangles)
}

fn shares(rows: &[PairingRow]) -> Vec<f64> {
    rows.iter().map(share).collect()
}

fn values(rows: &[PairingRow], column: fn(&PairingRow) -> f64) -> Vec<f64> {
    rows.iter().map(column).collect()
}

/// Rows of Table 4.3, in its order: Botijo, Eros, Filigree, Gargoyle, Happy Buddha, Iphigenia.
fn of_the_first_group() -> Vec<Statement> {
    let [sg, ps, ds, lrs] = ["sg", "ps", "ds", "lrs"].map(|algorithm| of(algorithm, "4.3"));
    let less = |a: &[PairingRow], b: &[PairingRow], column: fn(&PairingRow) -> f64| {
        rows_where(&values(a, column), &values(b, column), |a, b| a < b)
    };
    let total = |row: &PairingRow| row.total_seconds;
    let unpaired = |row: &PairingRow| row.unpaired_triangles;
    let share_of = |which, algorithm| {
        text_number(
            "every mesh of Table 4.3",
            algorithm,
            &format!("{which} unpaired_triangles / triangles"),
        )
    };
    let between = |rows: &[PairingRow], algorithm, half_unit: f64| {
        let most = share_of("most", algorithm) + half_unit;
        shares(rows).iter().all(|&share| share >= share_of("least", algorithm) && share < most)
    };
    let mut by_genus = ps.clone();
    by_genus.sort_by_key(|row| mesh_row(&row.mesh).genus);
    let sg_to_ps = ratios(&values(&sg, total), &values(&ps, total));
    let pairing_of_ps_to_sg =
        ratios(&values(&ps, |row| row.pairing_seconds), &values(&sg, |row| row.pairing_seconds));
    let at_least = "least total_seconds / total_seconds of ps";
    let least = text_number("eros, gargoyle, iphigenia", "sg", at_least);
    vec![
        ("sg-share", between(&sg, "sg", 0.005)),
        ("ps share of the first group", between(&ps, "ps", 0.00005)),
        ("ps-share-grows-with-genus", grows(&shares(&by_genus))),
        ("sg pairs about 87 %", sg.iter().all(|row| (row.paired_percent - 87.0).abs() < 1.0)),
        ("ps pairs more than 99 %", ps.iter().all(|row| row.paired_percent > 99.0)),
        ("lrs leaves less than 2 %", shares(&lrs).iter().all(|&share| share < 0.02)),
        ("ps is 300 times faster than sg", [1, 3, 5].iter().all(|&row| sg_to_ps[row] > least)),
        (
            "sg pairs ten times faster than ps",
            pairing_of_ps_to_sg.iter().all(|&ratio| ratio > 10.0),
        ),
        ("ds is faster than sg", less(&ds, &sg, total) == [0, 1, 2, 3, 4, 5]),
        ("ps is faster than ds", less(&ps, &ds, total) == [0, 1, 2, 3, 4, 5]),
        ("lrs is faster than ds", less(&lrs, &ds, total) == [0, 1, 2, 3, 4, 5]),
        ("lrs is faster than ps on two", less(&lrs, &ps, total) == [4, 5]),
        ("lrs leaves less than ps on three", less(&lrs, &ps, unpaired) == [1, 3, 5]),
        ("lrs augments faster", less(&lrs, &ps, |row| row.augmentation_seconds) == [1, 3, 4, 5]),
        ("lrs-faster-initial-pairing", less(&lrs, &ps, |row| row.pairing_seconds).contains(&4)),
    ]
}

/// Rows of Table 4.4, and all of Lemos et al. together.
fn of_the_boxes() -> Vec<Statement> {
    let [ps_a, lrs_a] = ["ps", "lrs"].map(|algorithm| of(algorithm, "4.4(i)"));
    let [ps_b, lrs_b] = ["ps", "lrs"].map(|algorithm| of(algorithm, "4.4(ii)"));
    let every_ps = [of("ps", "4.3"), ps_a.clone(), ps_b.clone()].concat();
    let below = |bound: f64| shares(&every_ps).iter().all(|&share| share < bound + 0.00005);
    let bound = |mesh| text_number(mesh, "ps", "most unpaired_triangles / triangles");
    let [first, every] = ["every mesh of Table 4.3", "every mesh"].map(bound);
    let unpaired_ps = values(&ps_a, |row| row.unpaired_triangles);
    let speed_up = |row: usize| ps_a[row].total_seconds / lrs_a[row].total_seconds;
    let printed = |mesh| text(mesh, "ps", "total_seconds / total_seconds of lrs");
    let pairing = |row: &PairingRow| row.pairing_seconds;
    let unpaired = |row: &PairingRow| row.unpaired_triangles;
    let all_equal =
        |rows: &[PairingRow]| rows.iter().all(|row| unpaired(row) == unpaired(&rows[0]));
    let times = ratios(&values(&lrs_b, unpaired), &values(&ps_b, unpaired));
    let times_at_least =
        text_number("B1 to B5", "lrs", "least unpaired_triangles / unpaired_triangles of ps");
    vec![
        ("ps-share-bound", below(first)),
        ("ps share of section 5", below(every)),
        ("ps share of A1 to A5 rises", grows(&shares(&ps_a))),
        ("ps-unpaired-fall-with-triangles", falls(&unpaired_ps)),
        ("ps-unpaired-rise-as-triangles-fall", grows(&unpaired_ps)),
        ("lrs speed-up on A1", agrees(&printed("A1"), speed_up(0))),
        ("lrs-speed-up-a5", agrees(&printed("A5"), speed_up(4))),
        ("lrs leaves 66 times more", times.iter().all(|&ratio| ratio >= times_at_least)),
        ("lrs leaves as many on A1 to A5", all_equal(&lrs_a)),
        ("lrs-unpaired-depends-on-genus-only", all_equal(&lrs_a) && all_equal(&lrs_b)),
        (
            "lrs to ps pairing grows",
            grows(&ratios(&values(&lrs_b, pairing), &values(&ps_b, pairing))),
        ),
    ]
}

/// Ramaswami-Siqueira, sections 5.2 and 5.3: first group, by figures of the text alone.
fn of_the_scans() -> Vec<Statement> {
    let ratio = |mesh, algorithm| text_number(mesh, algorithm, "seconds / seconds of rs");
    let s_to_bf = ratio("socket", "schipper") / ratio("socket", "brute-force");
    let to_bf = |mesh, which| {
        text_number(mesh, "schipper", &format!("{which}seconds / seconds of brute-force"))
    };
    let least = to_bf("every mesh of Table 2", "least ");
    let meshes = table("2").mesh_rows();
    let largest = meshes.iter().max_by_key(|row| row.triangles).unwrap();
    let smallest = meshes.iter().min_by_key(|row| row.triangles).unwrap();
    vec![
        ("largest-of-first-group", largest.mesh == "iphigenia"),
        ("smallest of the first group", smallest.mesh == "socket"),
        // By as much as rounding leaves: 2.135 / 1.135.
        ("least-s-to-bf-of-first-group", s_to_bf + 0.02 > least),
        ("most s to bf of the first group", to_bf("eros", "") > least),
    ]
}

/// Rows from B0 to B9: triangles become fewer.
fn of_genus_0() -> Vec<Statement> {
    let s_to_rs = column("7", "schipper_to_rs_seconds");
    let bf_to_rs = column("7", "brute_force_to_rs_seconds");
    let s_to_bf = column("7", "schipper_to_brute_force_seconds");
    let s_tests = column("6", "schipper_link_condition_tests");
    let bf_tests = column("6", "brute_force_link_condition_tests");
    let s_twice = column("6", "schipper_edges_tested_more_than_once");
    let bf_twice = column("6", "brute_force_edges_tested_more_than_once");
    let printed = |mesh| text(mesh, "schipper", "seconds / seconds of rs");
    let of_tests =
        ["schipper_to_rs_tests", "brute_force_to_rs_tests"].map(|name| column("7", name));
    vec![
        ("bf-beats-s-at-genus-0", s_to_bf.iter().all(|&ratio| ratio > 1.0)),
        ("s-to-rs-falls-with-triangles", grows(&s_to_rs)),
        ("bf-to-rs-falls-with-triangles", grows(&bf_to_rs)),
        ("bf to rs falls from B3 to B0", grows(&bf_to_rs[..4])),
        ("test-ratios-fall-with-triangles", of_tests.iter().all(|ratios| grows(ratios))),
        ("s to rs on B0", agrees(&printed("ir-B0"), s_to_rs[0])),
        ("s to rs on B9", agrees(&printed("ir-B9"), s_to_rs[9])),
        ("bf tests more than s at genus 0", bf_tests.iter().zip(&s_tests).all(|(bf, s)| bf > s)),
        ("bf repeats more than s at genus 0", bf_twice.iter().zip(&s_twice).all(|(bf, s)| bf > s)),
    ]
}

/// Rows from C0 to C7: triangles become fewer.
fn of_genus_3500() -> Vec<Statement> {
    let s_to_rs = column("9", "schipper_to_rs_seconds");
    let bf_to_rs = column("9", "brute_force_to_rs_seconds");
    let s_to_bf = column("9", "schipper_to_brute_force_seconds");
    let rs_tests = column("8", "rs_link_condition_tests");
    let s_tests = column("8", "schipper_link_condition_tests");
    let bf_tests = column("8", "brute_force_link_condition_tests");
    let s_twice = column("8", "schipper_edges_tested_more_than_once");
    let bf_twice = column("8", "brute_force_edges_tested_more_than_once");
    let bf_to_s_tests = ratios(&bf_tests, &s_tests);
    let printed =
        |mesh| text(mesh, "brute-force", "link_condition_tests / link_condition_tests of schipper");
    let large = |number| column(number, "triangles").iter().filter(|&&n| n > 500_000.0).count();
    vec![
        ("bf beats s on C0 and C1", rows_where(&s_to_bf, &[1.0; 8], |a, b| a > b) == [0, 1]),
        ("s-to-rs-grows-with-triangles", falls(&s_to_rs)),
        ("s to rs grows from C2 to C0", falls(&s_to_rs[..3])),
        ("bf-to-rs-grows-with-triangles", falls(&bf_to_rs[..3])),
        ("B0 to B3 have more than 500,000 triangles", large("3") == 4),
        ("above-500000-triangles", large("4") == 3),
        ("rs tests more on C0 to C2", rows_where(&rs_tests, &s_tests, |a, b| a > b) == [0, 1, 2]),
        ("bf repeats more on C7", rows_where(&bf_twice, &s_twice, |a, b| a > b) == [7]),
        ("bf to s tests fall with triangles", bf_to_s_tests[0] > 1.0 && grows(&bf_to_s_tests)),
        ("bf to s tests on C0", agrees(&printed("ir-C0"), bf_to_s_tests[0])),
        ("bf to s tests on C7", agrees(&printed("ir-C7"), bf_to_s_tests[7])),
    ]
}

/// Rows from D0 to D9: the genus becomes smaller. And all groups together.
fn of_falling_genus() -> Vec<Statement> {
    let s_to_rs = column("11", "schipper_to_rs_seconds");
    let bf_to_rs = column("11", "brute_force_to_rs_seconds");
    let s_to_bf = column("11", "schipper_to_brute_force_seconds");
    let s_to_rs_tests = column("11", "schipper_to_rs_tests");
    let s_to_bf_tests = column("11", "schipper_to_brute_force_tests");
    let most = s_to_rs.iter().copied().fold(0.0, f64::max);
    let of_rs = ["schipper_to_rs_seconds", "brute_force_to_rs_seconds"];
    let every = ["7", "9", "11"].map(|number| of_rs.map(|name| column(number, name)));
    vec![
        ("bf beats s on the fourth group", s_to_bf.iter().all(|&ratio| ratio > 1.0)),
        ("s-to-rs-grows-with-genus", falls(&s_to_rs)),
        ("s-to-bf-grows-with-genus", falls(&s_to_bf)),
        ("most s to rs on D0", agrees(&text("ir-D0", "schipper", "seconds / seconds of rs"), most)),
        ("D0 is where it is most", s_to_rs[0] == most),
        ("bf-to-rs-falls-with-genus", grows(&bf_to_rs)),
        ("bf to rs from D0 to D3", bf_to_rs[..4].iter().all(|&ratio| agrees("2.4", ratio))),
        ("s to rs tests fall with genus", grows(&s_to_rs_tests)),
        ("s-to-bf-tests-fall-with-genus", grows(&s_to_rs_tests) && grows(&s_to_bf_tests)),
        ("rs beats both", every.as_flattened().concat().iter().all(|&ratio| ratio > 1.0)),
    ]
}

#[test]
fn sentences_that_do_not_hold_are_exactly_those_listed() {
    let groups = [
        of_the_first_group(),
        of_the_boxes(),
        of_the_scans(),
        of_genus_0(),
        of_genus_3500(),
        of_falling_genus(),
    ];
    let statements = groups.concat();
    let ids: BTreeSet<&str> = statements.iter().map(|&(id, _)| id).collect();
    assert_eq!(ids.len(), statements.len(), "two statements of one name");
    let wrong: BTreeSet<String> =
        statements.iter().filter(|(_, holds)| !holds).map(|(id, _)| (*id).to_owned()).collect();
    let listed = text_errata().into_iter().filter(|erratum| erratum.found_by == "recomputing");
    assert_eq!(wrong, listed.map(|erratum| erratum.id).collect());
}

#[test]
fn every_erratum_of_the_text_is_told_in_full() {
    let errata = text_errata();
    let ids: BTreeSet<&str> = errata.iter().map(|erratum| erratum.id.as_str()).collect();
    assert_eq!(ids.len(), errata.len());
    for erratum in &errata {
        assert!(["recomputing", "reading"].contains(&erratum.found_by.as_str()), "{erratum:?}");
        let told = [&erratum.source, &erratum.statement, &erratum.contradiction, &erratum.reading];
        assert!(told.iter().all(|text| !text.is_empty()), "{erratum:?}");
    }
}

/// The flips that section 5 of Lemos et al. counts on Botijo are among the percentages it gives.
#[test]
fn flips_of_botijo_are_within_the_percentages() {
    let flips = text_number("botijo", "lrs", "edge_flips");
    let percent = 100.0 * flips / f64::from(mesh_row("botijo").edges);
    let bound = |which| {
        let quantity = format!("{which} edge_flips in percent of edges");
        text_number("every mesh of Table 4.3", "lrs", &quantity)
    };
    assert!((bound("least")..bound("most")).contains(&percent), "{percent}");
}
