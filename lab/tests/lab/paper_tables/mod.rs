//! The papers' printed tables: everything in them that can be recomputed is, and what disagrees is
//! exactly what their errata name.

mod statements;

use std::collections::{BTreeMap, BTreeSet};

use triquad_lab::meshes::paper::{self as presets, named};
use triquad_lab::paper::{LinkTestRow, MeshRow, Table, TableKind};

/// A number in a table: number of the table, row (mesh, algorithm if there is one), column.
type Cell = (&'static str, String, String);

fn table(number: &str) -> Table {
    Table::numbered(number).unwrap_or_else(|| panic!("no table {number}"))
}

/// The rows of `table` as printed: what they are called, and their fields by column.
fn printed_rows(table: &Table) -> Vec<(String, BTreeMap<String, String>)> {
    let mut reader = csv::Reader::from_reader(table.text.as_bytes());
    let row = |row: csv::Result<BTreeMap<String, String>>| row.unwrap();
    let named = |fields: BTreeMap<String, String>| match fields.get("algorithm") {
        Some(algorithm) => (format!("{} {algorithm}", fields["mesh"]), fields),
        None => (fields["mesh"].clone(), fields),
    };
    reader.deserialize().map(row).map(named).collect()
}

/// Whether `printed` is `value`, rounded to the digits printed.
fn agrees(printed: &str, value: f64) -> bool {
    let digits = printed.split_once('.').map_or(0, |(_, fraction)| fraction.len());
    let unit = 0.1_f64.powi(digits as i32);
    let number: f64 = printed.parse().unwrap_or_else(|_| panic!("not a number: {printed}"));
    (number - value).abs() <= 0.5001 * unit
}

/// Number `column` of a row, as a number.
fn number(fields: &BTreeMap<String, String>, column: &str) -> f64 {
    fields[column].parse().unwrap_or_else(|_| panic!("{column}: not a number: {}", fields[column]))
}

/// What a row's columns must be by its other columns and by other tables.
fn recomputed(table: &Table, fields: &BTreeMap<String, String>) -> Vec<(&'static str, f64)> {
    let value = |column| number(fields, column);
    match table.kind {
        TableKind::Meshes => {
            let thirds = value("vertices") - 2.0 + 2.0 * value("genus");
            vec![("edges", 3.0 * thirds), ("triangles", 2.0 * thirds)]
        }
        TableKind::Pairings => {
            let triangles = f64::from(mesh_row(&fields["mesh"]).triangles);
            let paired = 100.0 * (triangles - value("unpaired_triangles")) / triangles;
            let total = value("pairing_seconds") + value("augmentation_seconds");
            vec![("paired_percent", paired), ("total_seconds", total)]
        }
        TableKind::Ratios => {
            let LinkTestRow {
                rs_link_condition_tests: rs,
                schipper_link_condition_tests: schipper,
                brute_force_link_condition_tests: brute_force,
                ..
            } = tests_of_ratios(table, &fields["mesh"]);
            vec![
                ("schipper_to_rs_tests", schipper / rs),
                ("brute_force_to_rs_tests", brute_force / rs),
                ("schipper_to_brute_force_tests", schipper / brute_force),
            ]
        }
        TableKind::LinkTests => Vec::new(),
    }
}

/// The row of Tables 6, 8 or 10 behind a row of Tables 7, 9 or 11.
fn tests_of_ratios(ratios: &Table, mesh: &str) -> LinkTestRow {
    let before: u32 = ratios.number.parse().unwrap();
    let rows = table(&(before - 1).to_string()).link_test_rows();
    rows.into_iter().find(|row| row.mesh == mesh).unwrap_or_else(|| panic!("no tests of {mesh}"))
}

fn mesh_rows() -> impl Iterator<Item = MeshRow> {
    Table::ALL.into_iter().flat_map(|table| table.mesh_rows())
}

/// Size of a mesh of the comparison paper, where all of them are consistent.
fn mesh_row(mesh: &str) -> MeshRow {
    mesh_rows().find(|row| row.mesh == mesh).unwrap_or_else(|| panic!("no mesh {mesh}"))
}

/// The columns that the sentence begins with, before the colon.
fn columns_named(errata: &str) -> Vec<String> {
    let (columns, _) = errata.split_once(": ").unwrap_or_else(|| panic!("no column: {errata}"));
    columns.split(" and ").map(str::to_owned).collect()
}

#[test]
fn recomputing_finds_exactly_the_errata() {
    let (mut found, mut stated) = (BTreeSet::<Cell>::new(), BTreeSet::<Cell>::new());
    for table in Table::ALL {
        for (row, fields) in printed_rows(&table) {
            let cell = |column: &str| (table.number, row.clone(), column.to_owned());
            let wrong = recomputed(&table, &fields).into_iter();
            let wrong = wrong.filter(|&(column, value)| !agrees(&fields[column], value));
            found.extend(wrong.map(|(column, _)| cell(column)));
            if !fields["errata"].is_empty() {
                stated.extend(columns_named(&fields["errata"]).iter().map(|column| cell(column)));
            }
        }
    }
    let unstated: Vec<_> = found.difference(&stated).collect();
    let unfounded: Vec<_> = stated.difference(&found).collect();
    assert!(unstated.is_empty(), "disagree, but have no erratum: {unstated:#?}");
    assert!(unfounded.is_empty(), "have an erratum, but agree: {unfounded:#?}");
    assert_eq!(found.len(), 12);
}

/// The laws themselves, so that no erratum rests on how a count was recomputed.
#[test]
fn meshes_without_errata_are_closed_surfaces() {
    for row in mesh_rows() {
        let [v, e, f, g] = [row.vertices, row.edges, row.triangles, row.genus].map(i64::from);
        let lawful = 3 * f == 2 * e && v - e + f == 2 - 2 * g;
        assert_eq!(lawful, row.errata.is_empty(), "{row:?}");
    }
}

#[test]
fn meshes_are_those_that_can_be_generated() {
    let printed: BTreeSet<String> = mesh_rows().map(|row| row.mesh).collect();
    let known = BTreeSet::from(presets::ALL.map(|mesh| mesh.name.to_owned()));
    // What the papers draw or leave open has no row in their tables.
    let not_printed = ["A1-drawn", "A1-equal", "A1-paired", "ir-F1", "ir-F2", "ir-F3"];
    let others: Vec<&String> = known.difference(&printed).collect();
    assert_eq!(others, not_printed);
    assert!(printed.is_subset(&known));
    for row in mesh_rows() {
        let mesh = named(&row.mesh).unwrap();
        assert_eq!((row.vertices, row.genus), (mesh.vertices, mesh.genus), "{row:?}");
        let same = (row.edges, row.triangles) == (mesh.edges(), mesh.triangles());
        assert_eq!(same, row.errata.is_empty(), "{row:?}");
    }
}

/// Each table of results has the meshes of a table of meshes, in its order.
#[test]
fn results_are_of_the_meshes_of_their_group() {
    let groups = [
        ("4.1", "4.3"),
        ("4.2(a)", "4.4(i)"),
        ("4.2(b)", "4.4(ii)"),
        ("3", "6"),
        ("3", "7"),
        ("4", "8"),
        ("4", "9"),
        ("5", "10"),
        ("5", "11"),
    ];
    for (meshes, results) in groups {
        let names = |number| -> Vec<_> {
            let rows = printed_rows(&table(number)).into_iter();
            rows.map(|(_, mut row)| (row.remove("mesh"), row.remove("mesh_printed"))).collect()
        };
        let mut of_results = names(results);
        of_results.dedup();
        assert_eq!(names(meshes), of_results, "{meshes} and {results}");
    }
}

#[test]
fn every_mesh_has_a_row_for_every_algorithm() {
    for (number, expected) in [
        ("4.3", &["sg", "ps", "ds", "lrs"][..]),
        ("4.4(i)", &["ps", "lrs"]),
        ("4.4(ii)", &["ps", "lrs"]),
    ] {
        let rows = table(number).pairing_rows();
        for rows in rows.chunks(expected.len()) {
            let algorithms: Vec<_> = rows.iter().map(|row| row.algorithm.as_str()).collect();
            assert_eq!(algorithms, expected, "{}", rows[0].mesh);
            assert!(rows.iter().all(|row| row.mesh == rows[0].mesh), "{rows:?}");
        }
    }
}

/// An even number of triangles is unpaired, and the mean of ten such numbers has an even tenth.
#[test]
fn numbers_of_unpaired_triangles_are_possible() {
    for table in Table::ALL {
        for row in table.pairing_rows() {
            let tenths = (10.0 * row.unpaired_triangles).round() as u64;
            let of_all_runs = if matches!(row.algorithm.as_str(), "sg" | "ps") { 2 } else { 20 };
            assert_eq!(tenths % of_all_runs, 0, "{row:?}");
            let most = match (row.algorithm.as_str(), mesh_row(&row.mesh).genus) {
                ("ds", _) => 0,
                ("lrs", 0) => 4,
                ("lrs", genus) => 56 * genus - 12,
                _ => mesh_row(&row.mesh).triangles,
            };
            assert!(tenths <= 10 * u64::from(most), "{row:?}");
        }
    }
}

/// Each contraction is preceded by a test, except those that RS makes at vertices of degree 3; an
/// irreducible triangulation has at most 26 g - 4 vertices, or 4; RS tests no edge twice.
#[test]
fn numbers_of_link_condition_tests_are_possible() {
    for table in Table::ALL {
        for row in table.link_test_rows() {
            let mesh = named(&row.mesh).unwrap();
            let contractions =
                mesh.vertices.saturating_sub((26 * mesh.genus).saturating_sub(4).max(4));
            assert!(row.schipper_link_condition_tests >= f64::from(contractions), "{row:?}");
            assert!(row.brute_force_link_condition_tests >= f64::from(contractions), "{row:?}");
            assert!(row.rs_link_condition_tests <= f64::from(mesh.edges()), "{row:?}");
        }
    }
}

/// The three ratios of times have two degrees of freedom, within the digits printed.
#[test]
fn ratios_of_times_fit_together() {
    const HALF: f64 = 0.005;
    for row in Table::ALL.iter().flat_map(Table::ratio_rows) {
        let (s, bf) = (row.schipper_to_rs_seconds, row.brute_force_to_rs_seconds);
        let least = (s - HALF) / (bf + HALF) - HALF;
        let most = (s + HALF) / (bf - HALF) + HALF;
        assert!((least..=most).contains(&row.schipper_to_brute_force_seconds), "{row:?}");
    }
}

#[test]
fn rows_are_the_same_typed_and_printed() {
    for table in Table::ALL {
        assert_eq!(Table::numbered(table.number), Some(table));
        assert!(table.text.lines().next().unwrap().ends_with(",errata"));
        let typed: Vec<(String, String)> = match table.kind {
            TableKind::Meshes => typed(table.mesh_rows(), |row| (row.mesh, row.errata)),
            TableKind::Pairings => {
                typed(table.pairing_rows(), |row| (row.mesh + " " + &row.algorithm, row.errata))
            }
            TableKind::LinkTests => typed(table.link_test_rows(), |row| (row.mesh, row.errata)),
            TableKind::Ratios => typed(table.ratio_rows(), |row| (row.mesh, row.errata)),
        };
        let printed = printed_rows(&table).into_iter();
        let printed: Vec<_> =
            printed.map(|(row, mut fields)| (row, fields.remove("errata").unwrap())).collect();
        assert_eq!(typed, printed, "{}", table.number);
        let rows = [
            table.mesh_rows().len(),
            table.pairing_rows().len(),
            table.link_test_rows().len(),
            table.ratio_rows().len(),
        ];
        assert_eq!(rows.iter().sum::<usize>(), typed.len(), "rows of one kind only");
    }
    assert_eq!(Table::numbered("4.5"), None);
}

fn typed<Row>(rows: Vec<Row>, name: fn(Row) -> (String, String)) -> Vec<(String, String)> {
    rows.into_iter().map(name).collect()
}
