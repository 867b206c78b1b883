//! A table as a page shows it: the paper's number under ours, and how they differ.

use serde::Serialize;

use super::facts::commands_id;
use crate::report::number::significant;
use crate::report::summary::Summary;
use crate::report::tables::ReportTable;

/// A table.
#[derive(Clone, Serialize)]
pub struct View {
    /// Where links lead.
    pub id: String,
    name: String,
    title: String,
    file: &'static str,
    columns: Vec<String>,
    rows: Vec<Row>,
    notes: Vec<String>,
    commands: Option<String>,
}

#[derive(Clone, Serialize)]
struct Row {
    /// Whether it is the first of its mesh.
    first: bool,
    name: String,
    about: String,
    cells: Vec<Field>,
}

#[derive(Clone, Default, Serialize)]
struct Field {
    text: String,
    paper: String,
    difference: String,
    class: &'static str,
}

/// Columns that stand elsewhere: under another, beside the mesh, in the notes, or in the file alone.
fn is_folded(name: &str) -> bool {
    let folded = ["mesh", "mesh_kind", "agrees", "extrapolated", "tarjan_extrapolated"];
    let within = ["paper_", "ratio_"].iter().any(|prefix| name.starts_with(prefix));
    within || folded.contains(&name) || name.ends_with("_quartile")
}

impl View {
    /// A table of `summary`, with the number of its paper or without.
    pub fn of(table: &ReportTable, summary: &Summary) -> Self {
        let shown: Vec<usize> =
            (0..table.header.len()).filter(|&c| !is_folded(&table.header[c])).collect();
        let is_comparable = !table.notes.iter().any(|note| note.starts_with("Scale "));
        let mut rows: Vec<Row> = Vec::new();
        let mut before = "";
        for fields in &table.rows {
            let mut row = row(table, &shown, fields, is_comparable);
            row.first = fields[0] != before;
            before = &fields[0];
            rows.push(row);
        }
        let name = if table.number.is_empty() {
            "Table".into()
        } else {
            format!("Table {}", table.number)
        };
        Self {
            id: id_of(table),
            name,
            title: table.title.clone(),
            file: table.file,
            columns: std::iter::once("mesh".to_owned())
                .chain(shown.iter().map(|&c| heading(&table.header[c])))
                .collect(),
            rows,
            notes: notes(table),
            commands: commands_id(summary, table.number, table.file),
        }
    }

    /// Whether there is no row.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }
}

/// Where links to a table lead: `table-4-4-ii` for 4.4(ii).
pub fn id_of(table: &ReportTable) -> String {
    let name = table.file.trim_end_matches(".csv").trim_start_matches("table_");
    format!("table-{}", name.replace('_', "-"))
}

fn row(table: &ReportTable, shown: &[usize], fields: &[String], is_comparable: bool) -> Row {
    let value = |name: &str| {
        let at = table.header.iter().position(|other| other == name);
        at.map_or("", |at| fields[at].as_str())
    };
    let kind = value("mesh_kind");
    let mark = if kind == "stand-in" { "†" } else { "" };
    let star = ["extrapolated", "tarjan_extrapolated"].iter().any(|name| value(name) == "yes");
    let cells = shown.iter().map(|&c| {
        let name = &table.header[c];
        let paper = value(&format!("paper_{name}"));
        let times = name.contains("augmentation_seconds") || name.contains("total_seconds");
        let (difference, class) =
            if is_comparable { difference(&fields[c], paper) } else { ("".into(), "") };
        let text = display(name, &fields[c]);
        let text = if star && times && !text.is_empty() { format!("{text} *") } else { text };
        Field {
            text: if text.is_empty() { "–".into() } else { text },
            paper: display(name, paper),
            difference,
            class,
        }
    });
    Row {
        first: false,
        name: format!("{}{mark}", fields[0]),
        about: kind.into(),
        cells: cells.collect(),
    }
}

/// How ours differs from the paper's, in words that need no colour.
fn difference(ours: &str, paper: &str) -> (String, &'static str) {
    let (Ok(ours), Ok(paper)) = (ours.parse::<f64>(), paper.parse::<f64>()) else {
        return (String::new(), "");
    };
    if ours == paper {
        return ("= equal".into(), "same");
    }
    if paper == 0.0 || ours == 0.0 {
        return ("≠".into(), "more");
    }
    let ratio = ours / paper;
    if (ratio - 1.0).abs() <= 0.05 {
        return (format!("≈ × {ratio:.3}"), "same");
    }
    let (arrow, class) = if ratio > 1.0 { ("▲", "more") } else { ("▼", "less") };
    (format!("{arrow} × {}", significant(ratio)), class)
}

/// A number in the digits that a reader needs; the file has all of them.
fn display(name: &str, text: &str) -> String {
    match text.parse::<f64>() {
        Ok(value) if name.contains("seconds") => significant(value),
        Ok(_) if name == "algorithm" => text.into(),
        Ok(_) => grouped(text),
        Err(_) if name == "algorithm" => label(text),
        Err(_) => text.into(),
    }
}

/// What the papers call an algorithm.
fn label(id: &str) -> String {
    match id {
        "sg" | "ps" | "ds" | "lrs" | "gw" | "tq" | "rs" => id.to_uppercase(),
        other => other.into(),
    }
}

/// Commas between thousands.
fn grouped(number: &str) -> String {
    let (whole, rest) = number.split_at(number.find(['.', 'e']).unwrap_or(number.len()));
    let digits = whole.trim_start_matches('-');
    let mut grouped = String::from(&whole[..whole.len() - digits.len()]);
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            grouped.push(',');
        }
        grouped.push(digit);
    }
    grouped + rest
}

/// A column's name in words, with the paper's letter where it has one.
fn heading(name: &str) -> String {
    let known = match name {
        "pairing_seconds" => "(a) pairing, s",
        "paired_percent" => "(b) paired, %",
        "unpaired_triangles" => "(c) unpaired",
        "augmentation_seconds" => "(d) augmentation, s",
        "total_seconds" => "(e) total, s",
        "total_seconds_median" => "(e) median, s",
        "n" => "runs",
        "schipper_to_rs_tests" => "ℓ_s / ℓ_rs",
        "brute_force_to_rs_tests" => "ℓ_bf / ℓ_rs",
        "schipper_to_brute_force_tests" => "ℓ_s / ℓ_bf",
        "schipper_to_rs_seconds" => "t_s / t_rs",
        "brute_force_to_rs_seconds" => "t_bf / t_rs",
        "schipper_to_brute_force_seconds" => "t_s / t_bf",
        _ => return words(name),
    };
    known.into()
}

fn words(name: &str) -> String {
    let counts = [("rs", "rs"), ("schipper", "s"), ("brute_force", "bf")];
    for (prefix, letter) in counts {
        match name.strip_prefix(prefix).unwrap_or_default() {
            "_link_condition_tests" => return format!("ℓ_{letter}"),
            "_edges_tested_more_than_once" => return format!("ε_{letter}"),
            "_outcomes" => return format!("{} runs", letter.to_uppercase()),
            _ => {}
        }
    }
    name.replace('_', " ")
}

/// The table's notes, and what is wrong with the paper's rows.
fn notes(table: &ReportTable) -> Vec<String> {
    let mut notes = table.notes.clone();
    let Some(at) = table.header.iter().position(|name| name == "paper_errata") else {
        return notes;
    };
    let algorithm = table.header.iter().position(|name| name == "algorithm");
    for row in table.rows.iter().filter(|row| !row[at].is_empty()) {
        let of = algorithm.map_or(String::new(), |at| format!(" {}", label(&row[at])));
        notes.push(format!("The paper's row {}{of}: {}", row[0], row[at]));
    }
    notes
}
