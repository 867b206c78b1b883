//! Tables of documents, made of records.
//!
//! A document has the lines `<!-- table: NAME -->` and `<!-- end -->`; what stands between them is
//! replaced by a Markdown table. Its numbers are those of the report's tables, to the digits of the
//! page. A table for which the records have no number stays as it is, so that a document may have
//! tables of several folders.

use super::compare::{self, Comparison, Verdict};
use super::summary::Summary;
use super::tables::{self, ReportTable, Row};
use crate::experiment::Results;

/// A document whose tables cannot be filled.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum DocumentError {
    /// No table is called so.
    #[error("{line}: no table is called '{name}'; there are {}", names())]
    UnknownTable {
        /// Line of the marker, from 1.
        line: usize,
        /// The name in it.
        name: String,
    },
    /// A table does not end.
    #[error("{line}: the table does not end; put '{END}' on a line of its own behind it")]
    NoEnd {
        /// Line of the marker, from 1.
        line: usize,
    },
}

/// A cell for which the records have nothing.
const NOTHING: &str = "–";

/// Columns that say what a row is about.
const NAMES: [&str; 4] = ["mesh", "algorithm", "command", "program"];

/// Most characters of a line.
const LINE: usize = 100;

/// The line after a table.
const END: &str = "<!-- end -->";

/// A table of documents.
struct DocumentTable {
    name: &'static str,
    rows: Rows,
    /// Headings, and columns of the report's tables; `paper_` stands before the paper's.
    columns: &'static [(&'static str, &'static str)],
    /// What was run, and the column of the number of runs whose mean the table has.
    runs: &'static [(&'static str, &'static str)],
}

/// The rows of a table of documents.
enum Rows {
    /// All of these tables of the report.
    Of(&'static [&'static str]),
    /// All of one table that belong to these meshes.
    OfMeshes(&'static str, &'static [&'static str]),
    /// These meshes and algorithms, wherever they stand.
    These(&'static [(&'static str, &'static str)]),
}

const VERDICTS: &str = "verdicts";

const COUNTS_AND_TIMES: &[(&str, &str)] = &[
    ("mesh", "mesh"),
    ("algorithm", "algorithm"),
    ("unpaired: paper", "paper_unpaired_triangles"),
    ("here", "unpaired_triangles"),
    ("seconds: paper", "paper_total_seconds"),
    ("`tarjan`", "total_seconds"),
    ("`local`", "local_total_seconds"),
];

const RUNS_OF_BOTH: &[(&str, &str)] = &[("`tarjan`", "n"), ("`local`", "local_n")];

const SPEED: &[(&str, &str)] =
    &[("command", "command"), ("triangles", "triangles"), ("seconds", "local_total_seconds")];

const TABLES: &[DocumentTable] = &[
    DocumentTable {
        name: "conversions",
        rows: Rows::These(&[
            ("botijo", "PS"),
            ("eros", "SG"),
            ("eros", "LRS"),
            ("A2", "PS"),
            ("A2", "LRS"),
            ("B2", "PS"),
            ("B2", "LRS"),
        ]),
        columns: COUNTS_AND_TIMES,
        // README has few words: the runs stand under the whole tables.
        runs: &[],
    },
    DocumentTable {
        name: "4.3",
        rows: Rows::Of(&["table_4_3.csv"]),
        columns: COUNTS_AND_TIMES,
        runs: RUNS_OF_BOTH,
    },
    DocumentTable {
        name: "4.4",
        rows: Rows::Of(&["table_4_4_i.csv", "table_4_4_ii.csv"]),
        columns: COUNTS_AND_TIMES,
        runs: RUNS_OF_BOTH,
    },
    DocumentTable {
        name: "6 to 11",
        rows: Rows::Of(&["table_6.csv", "table_8.csv", "table_10.csv"]),
        columns: &[
            ("mesh", "mesh"),
            ("tests of RS: paper", "paper_rs_link_condition_tests"),
            ("here", "rs_link_condition_tests"),
            ("S / RS: paper", "paper_schipper_to_rs_tests"),
            ("here", "schipper_to_rs_tests"),
            ("BF / RS: paper", "paper_brute_force_to_rs_tests"),
            ("here", "brute_force_to_rs_tests"),
            ("seconds, S / RS: paper", "paper_schipper_to_rs_seconds"),
            ("here", "schipper_to_rs_seconds"),
            ("BF / RS: paper", "paper_brute_force_to_rs_seconds"),
            ("here", "brute_force_to_rs_seconds"),
        ],
        runs: &[("RS", "rs_n"), ("S", "schipper_n"), ("BF", "brute_force_n")],
    },
    DocumentTable {
        name: "speed",
        rows: Rows::These(&[("A1", "TQ"), ("A1", "PS")]),
        columns: SPEED,
        runs: &[],
    },
    DocumentTable {
        name: "speed of all",
        rows: Rows::These(&[
            ("happy-buddha", "TQ"),
            ("happy-buddha", "PS"),
            ("happy-buddha", "LRS"),
            ("happy-buddha", "GW"),
            ("A1", "TQ"),
            ("A1", "PS"),
            ("A1", "LRS"),
            ("A1", "GW"),
        ]),
        columns: SPEED,
        runs: &[("", "local_n")],
    },
    DocumentTable {
        name: "memory",
        rows: Rows::These(&[
            ("A1", "TQ local"),
            ("A1", "PS local"),
            ("A1", "LRS local"),
            ("A1", "GW local"),
            ("ir-B0", "RS"),
            ("ir-B0", "S"),
            ("ir-B0", "BF"),
        ]),
        columns: &[
            ("mesh", "mesh"),
            ("algorithm", "algorithm"),
            ("triangles", "triangles"),
            ("bytes a triangle", "peak_memory_bytes_per_triangle"),
        ],
        runs: &[("", "n")],
    },
    DocumentTable {
        name: "quality",
        rows: Rows::OfMeshes("table_quality.csv", &["eros"]),
        columns: &[
            ("algorithm", "algorithm"),
            ("mean scaled Jacobian", "scaled_jacobian_mean"),
            ("least", "scaled_jacobian_minimum"),
            ("edges flipped, %", "edge_flips_percent"),
        ],
        runs: &[("", "n")],
    },
    DocumentTable {
        name: "side by side",
        rows: Rows::OfMeshes(
            "table_side_by_side.csv",
            &["casting", "fandisk_12946", "joint_41808_g2", "armadillo_52000"],
        ),
        columns: &[
            ("mesh", "mesh"),
            ("program", "program"),
            ("triangles left", "triangles_left"),
            ("mean J", "scaled_jacobian_mean"),
            ("worst 1 %", "scaled_jacobian_one_percent"),
            ("least", "scaled_jacobian_minimum"),
            ("folded", "folded_quads"),
            ("sharp edges kept", "sharp_edges_kept"),
            ("of", "sharp_edges"),
            ("flipped", "edge_flips"),
            ("degree 2", "degree_two_vertices"),
            ("pairing, s", "total_seconds"),
            ("file to file, s", "process_seconds"),
            ("memory, bytes", "peak_memory_bytes"),
        ],
        runs: &[("", "n")],
    },
];

/// Returns `document` with its tables made anew from `results`. O(tables + claims).
///
/// # Errors
/// A marker names no table, or its table does not end.
pub fn fill(document: &str, results: &Results) -> Result<String, DocumentError> {
    let summary = Summary::new(results);
    let (tables, comparison) = (tables::all(&summary), compare::judge(&summary));
    let mut filled = String::with_capacity(document.len());
    let mut lines = document.split_inclusive('\n').enumerate();
    while let Some((number, line)) = lines.next() {
        filled.push_str(line);
        let Some(name) = marker(line) else { continue };
        let text = if name == VERDICTS {
            Some(verdicts(&comparison))
        } else {
            let table = TABLES.iter().find(|table| table.name == name).ok_or_else(|| {
                DocumentError::UnknownTable { line: number + 1, name: name.to_owned() }
            })?;
            table.markdown(&tables)
        };
        let mut old = String::new();
        let end = lines.find(|(_, line)| {
            let is_end = line.trim_end() == END;
            old.push_str(if is_end { "" } else { line });
            is_end
        });
        let (_, end) = end.ok_or(DocumentError::NoEnd { line: number + 1 })?;
        let text = text.map_or(old, |text| format!("\n{text}\n"));
        filled.extend([text.as_str(), end]);
    }
    Ok(filled)
}

/// Returns the name of the table that a marker announces.
fn marker(line: &str) -> Option<&str> {
    line.trim_end().strip_prefix("<!-- table: ")?.strip_suffix(" -->")
}

fn names() -> String {
    let names: Vec<&str> = TABLES.iter().map(|table| table.name).collect();
    format!("{VERDICTS}, {}", names.join(", "))
}

/// Counts the claims by verdict.
fn verdicts(comparison: &Comparison) -> String {
    let row = |verdict: Verdict| [verdict.name().to_owned(), comparison.count(verdict).to_string()];
    let all = ["all".to_owned(), comparison.verdicts.len().to_string()];
    let rows = Verdict::ALL.map(row).into_iter().chain([all]).map(|row| row.to_vec());
    markdown(&["verdict", "claims"], rows)
}

impl DocumentTable {
    /// Writes the table, and the numbers of runs; `None` if the records have no number for it.
    fn markdown(&self, tables: &[ReportTable]) -> Option<String> {
        let headings: Vec<&str> = self.columns.iter().map(|column| column.0).collect();
        let keys = self.rows.keys(tables);
        let of_table = |table: &&ReportTable| self.rows.may_use(table);
        let tables: Vec<&ReportTable> = tables.iter().filter(of_table).collect();
        let row = |(mesh, algorithm): &(String, String)| -> Vec<String> {
            let cell = |&(_, column): &(&str, &str)| field(&tables, mesh, algorithm, column);
            self.columns.iter().map(cell).collect()
        };
        let rows: Vec<Vec<String>> = keys.iter().map(row).collect();
        let is_number = |column: &&(&str, &str)| !NAMES.contains(&column.1);
        let numbers = self.columns.iter().filter(is_number).count();
        let has_one =
            |row: &Vec<String>| row.iter().filter(|cell| *cell == NOTHING).count() < numbers;
        rows.iter().any(has_one).then(|| {
            let runs = self.runs.iter().filter_map(|&(what, column)| {
                let numbers = numbers_of_runs(&tables, &keys, column)?;
                Some(if what.is_empty() { numbers } else { format!("{what} {numbers}") })
            });
            let runs = runs.collect::<Vec<_>>().join("; ");
            let table = markdown(&headings, rows.into_iter());
            match runs.is_empty() {
                true => table,
                false => {
                    let runs = format!("Runs of each mean: {runs}.");
                    format!("{table}\n{}", filled_lines(&runs))
                }
            }
        })
    }
}

impl Rows {
    /// Returns whether numbers of a table may stand in these rows.
    fn may_use(&self, table: &ReportTable) -> bool {
        !matches!(self, Self::OfMeshes(file, _) if *file != table.file)
    }

    /// Returns mesh and algorithm of each row; the latter is empty where a row has all algorithms.
    fn keys(&self, tables: &[ReportTable]) -> Vec<(String, String)> {
        let of = |files: &[&str]| -> Vec<(String, String)> {
            let tables = tables.iter().filter(|table| files.contains(&table.file));
            tables.flat_map(|table| table.rows.iter().map(|row| key(table, row))).collect()
        };
        match self {
            Self::Of(files) => of(files),
            Self::OfMeshes(file, meshes) => {
                of(&[file]).into_iter().filter(|key| meshes.contains(&&*key.0)).collect()
            }
            Self::These(keys) => {
                keys.iter().map(|key| (key.0.to_owned(), key.1.to_owned())).collect()
            }
        }
    }
}

/// Returns the numbers of runs in a column with the algorithms that have them; `None` if none is
/// known. A number alone stands for all rows.
fn numbers_of_runs(
    tables: &[&ReportTable],
    keys: &[(String, String)],
    column: &str,
) -> Option<String> {
    let mut known: Vec<(String, u64, u64)> = Vec::new();
    for (mesh, algorithm) in keys {
        let Ok(n) = field(tables, mesh, algorithm, column).replace(',', "").parse::<u64>() else {
            continue;
        };
        match known.iter_mut().find(|(name, ..)| name == algorithm) {
            _ if n == 0 => {}
            Some((_, least, most)) => (*least, *most) = (n.min(*least), n.max(*most)),
            None => known.push((algorithm.clone(), n, n)),
        }
    }
    let range = |&(_, least, most): &(String, u64, u64)| match least == most {
        true => least.to_string(),
        false => format!("{least} to {most}"),
    };
    let mut ranges: Vec<String> = known.iter().map(range).collect();
    ranges.sort_unstable();
    ranges.dedup();
    let of = |wanted: &String| {
        let own = known.iter().filter(|&one| range(one) == *wanted).map(|one| one.0.as_str());
        format!("{wanted} ({})", own.collect::<Vec<_>>().join(", "))
    };
    match &*ranges {
        [] => None,
        [one] => Some(one.clone()),
        several => Some(several.iter().map(of).collect::<Vec<_>>().join(", ")),
    }
}

/// Breaks a text into lines of at most 100 characters.
fn filled_lines(text: &str) -> String {
    let (mut lines, mut length) = (String::new(), 0);
    for word in text.split(' ') {
        let width = word.chars().count();
        let joint = match length {
            0 => "",
            _ if length + 1 + width > LINE => "\n",
            _ => " ",
        };
        length = if joint == " " { length + 1 + width } else { width };
        lines.extend([joint, word]);
    }
    lines + "\n"
}

fn key(table: &ReportTable, row: &Row) -> (String, String) {
    let algorithm = table.columns.iter().position(|column| column.name == "algorithm");
    (row.mesh.clone(), algorithm.map_or_else(String::new, |at| row.cells[at].ours.display()))
}

/// Returns a field of the first table that has it; a dash if none has.
fn field(tables: &[&ReportTable], mesh: &str, algorithm: &str, column: &str) -> String {
    match column {
        "mesh" => return mesh.to_owned(),
        "algorithm" => return algorithm.to_owned(),
        "command" => {
            let id = algorithm.to_lowercase();
            return format!("`triquad convert {mesh}.ply --algorithm {id} --stats -`");
        }
        "program" => return algorithm.trim_end_matches(" local").to_lowercase(),
        _ => {}
    }
    let (name, is_printed) = match column.strip_prefix("paper_") {
        Some(name) => (name, true),
        None => (column, false),
    };
    let found = tables.iter().find_map(|table| {
        let at = table.columns.iter().position(|column| column.name == name)?;
        let row =
            table.rows.iter().find(|row| key(table, row) == (mesh.into(), algorithm.into()))?;
        let cell = &row.cells[at];
        let text = if is_printed { cell.paper.display() } else { cell.ours.display() };
        (!text.is_empty()).then_some(text)
    });
    found.unwrap_or_else(|| NOTHING.into())
}

/// Writes a table in Markdown, numbers and all.
fn markdown(headings: &[&str], rows: impl Iterator<Item = Vec<String>>) -> String {
    let line = |cells: &[&str]| format!("| {} |\n", cells.join(" | "));
    let mut text = line(headings) + &"|---".repeat(headings.len()) + "|\n";
    for row in rows {
        text += &line(&row.iter().map(String::as_str).collect::<Vec<_>>());
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_stands_between_the_markers_is_replaced_and_nothing_else() {
        let filled = |inside: &str| {
            let document = format!("a\n<!-- table: verdicts -->\n{inside}<!-- end -->\nb");
            fill(&document, &Results::default()).unwrap()
        };
        let once = filled("");
        assert!(
            once.starts_with("a\n<!-- table: verdicts -->\n\n| verdict | claims |\n|---|---|\n")
        );
        assert!(once.ends_with("\n\n<!-- end -->\nb"));
        assert_eq!(filled("| old | table |\n"), once);
        assert_eq!(fill(&once, &Results::default()).unwrap(), once);
    }

    #[test]
    fn a_table_that_the_records_have_no_number_for_stays() {
        let document = "<!-- table: side by side -->\n\n| of another folder |\n\n<!-- end -->\n";
        assert_eq!(fill(document, &Results::default()).unwrap(), document);
    }

    #[test]
    fn long_texts_are_broken_between_words() {
        let text = "Runs of each mean: 10.";
        assert_eq!(filled_lines(text), format!("{text}\n"));
        let filled = filled_lines(&[text; 9].join(" "));
        assert_eq!(filled.replace('\n', " ").trim_end(), [text; 9].join(" "));
        let lengths: Vec<usize> = filled.lines().map(str::len).collect();
        assert!(lengths.iter().all(|&length| length <= LINE), "{lengths:?}");
        assert!(lengths.len() == 3, "{lengths:?}");
    }

    #[test]
    fn unknown_tables_and_missing_ends_are_named_with_their_line() {
        let error = |document: &str| fill(document, &Results::default()).unwrap_err().to_string();
        assert!(error("a\n<!-- table: 4.9 -->\n").starts_with("2: no table is called '4.9'"));
        assert!(error("<!-- table: 4.3 -->\na\n").starts_with("1: the table does not end"));
    }
}
