//! The columns that `results/README.md` lists are those of the tables in the folders there.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// A name of a column, or its end behind `*`, and the tables that have it.
struct Listed {
    name: String,
    tables: Vec<String>,
}

/// A column of a table.
struct Column {
    name: String,
    table: String,
}

fn results() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../results")
}

/// The tables that stand for others in the list.
fn table_of(file: &str) -> &str {
    let stem = file.strip_prefix("table_").unwrap().strip_suffix(".csv").unwrap();
    match stem {
        "2" | "3" | "4" | "5" | "4_1" | "4_2_a" | "4_2_b" => "2",
        "4_3" | "4_4_i" | "4_4_ii" => "4.3",
        "6" | "8" | "10" => "6",
        "7" | "9" | "11" => "7",
        own => own,
    }
}

/// The columns in the section of that name.
fn listed(section: &str) -> Vec<Listed> {
    let text = std::fs::read_to_string(results().join("README.md")).unwrap();
    let (_, columns) = text.split_once(&format!("\n## {section}\n")).expect(section);
    let columns = columns.split("\n## ").next().unwrap();
    let rows = columns.lines().filter(|line| line.starts_with("| `"));
    let mut listed = Vec::new();
    for row in rows {
        let cells: Vec<&str> = row.trim_matches('|').split('|').map(str::trim).collect();
        let tables: Vec<String> = cells[3].split(", ").map(str::to_owned).collect();
        for name in cells[0].split(", ") {
            let name = name.trim_matches('`').to_owned();
            listed.push(Listed { name, tables: tables.clone() });
        }
    }
    listed
}

/// The columns of every table in a folder of results.
fn columns() -> Vec<Column> {
    let folders = std::fs::read_dir(results()).unwrap().map(|entry| entry.unwrap().path());
    let files = folders
        .filter(|path| path.is_dir())
        .flat_map(|folder| std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()));
    let mut columns = Vec::new();
    for path in files {
        let file = path.file_name().unwrap().to_str().unwrap();
        if !file.starts_with("table_") {
            continue;
        }
        let text = std::fs::read_to_string(&path).unwrap();
        let names = text.lines().next().unwrap().split(',');
        columns
            .extend(names.map(|name| Column { name: name.into(), table: table_of(file).into() }));
    }
    columns
}

impl Listed {
    fn is(&self, column: &Column) -> bool {
        let is_printed = ["2", "4.3", "6", "7"].contains(&column.table.as_str());
        let own = |prefix: &str| column.name.strip_prefix(prefix).filter(|_| is_printed);
        let mut names = [Some(column.name.as_str()), own("paper_"), own("ratio_")].into_iter();
        let is_named = names.any(|name| match (name, self.name.strip_prefix('*')) {
            (None, _) => false,
            (Some(name), Some(end)) => name.strip_suffix(end).is_some_and(|word| !word.is_empty()),
            (Some(name), None) => name == self.name,
        });
        is_named && (self.tables == ["all"] || self.tables.contains(&column.table))
    }
}

#[test]
fn every_column_of_the_tables_is_listed() {
    let (listed, columns) = (listed("Columns"), columns());
    assert!(columns.iter().any(|column| column.table == "side_by_side"));
    let unlisted = columns.iter().filter(|column| !listed.iter().any(|one| one.is(column)));
    let unlisted: BTreeSet<String> =
        unlisted.map(|column| format!("{} in {}", column.name, column.table)).collect();
    assert!(unlisted.is_empty(), "results/README.md does not list {unlisted:#?}");
}

#[test]
fn every_column_that_is_listed_is_in_the_tables_named_beside_it() {
    let columns = columns();
    for one in listed("Columns") {
        for table in &one.tables {
            let has =
                |column: &Column| (table == "all" || column.table == *table) && one.is(column);
            assert!(columns.iter().any(has), "{} is not in {table}", one.name);
        }
    }
}

/// Both ways: what is there is listed, what is listed is in some folder. Older records have fewer
/// columns.
#[test]
fn the_columns_of_runs_plan_and_verdicts_are_those_of_the_files() {
    let listed = listed("Columns of runs, plan and verdicts");
    for file in ["runs", "plan", "compare", "tolerances"] {
        let folders = std::fs::read_dir(results()).unwrap().map(|entry| entry.unwrap().path());
        let files =
            folders.filter(|path| path.is_dir()).map(|path| path.join(format!("{file}.csv")));
        let header = |path: PathBuf| {
            let text = std::fs::read_to_string(path).unwrap();
            text.lines().next().unwrap().to_owned()
        };
        let headers: Vec<String> = files.map(header).collect();
        let found: BTreeSet<&str> = headers.iter().flat_map(|header| header.split(',')).collect();
        let of_file = listed.iter().filter(|one| one.tables.iter().any(|name| name == file));
        let expected: BTreeSet<&str> = of_file.map(|one| one.name.as_str()).collect();
        assert_eq!(found, expected, "{file}.csv");
    }
}
