//! Counts of the meshes, Tables 4.1 and 4.2 of the comparison paper, Tables 2 to 5 of the other.

use super::ReportTable;
use super::columns::{cells_of, header, notes, printed};
use crate::experiment::RunRecord;
use crate::report::number::or_empty;
use crate::report::paper::MeshRow;
use crate::report::summary::{Cell, Summary};

/// Number and file of a table.
type Names = (&'static str, &'static str);

/// Tables 4.1 and 4.2.
pub fn comparison(summary: &Summary) -> Vec<ReportTable> {
    let tables: [Names; 3] =
        [("4.1", "table_4_1.csv"), ("4.2(a)", "table_4_2_a.csv"), ("4.2(b)", "table_4_2_b.csv")];
    tables.map(|names| table(summary, "comparison", names)).into()
}

/// Tables 2 to 5.
pub fn irreducible(summary: &Summary) -> Vec<ReportTable> {
    let tables: [Names; 4] =
        [("2", "table_2.csv"), ("3", "table_3.csv"), ("4", "table_4.csv"), ("5", "table_5.csv")];
    tables.map(|names| table(summary, "irreducible", names)).into()
}

fn table(summary: &Summary, experiment: &str, (number, file): Names) -> ReportTable {
    let table = printed(number);
    let mut rows = Vec::new();
    let mut shown: Vec<&Cell> = Vec::new();
    for printed in table.mesh_rows() {
        let cells = cells_of(summary, experiment, &printed.mesh);
        rows.push(row(&printed, cells.clone()));
        // Sizes and kinds alone are shown, not how runs ended.
        shown.extend(cells.take(1));
    }
    let mut notes = notes(&shown);
    notes.retain(|note| note.starts_with("Scale") || note.starts_with("A stand-in"));
    ReportTable {
        number,
        file,
        title: table.title().into(),
        header: header(&[
            &["mesh", "vertices", "edges", "triangles", "genus", "mesh_kind", "agrees"],
            &["paper_vertices", "paper_edges", "paper_triangles", "paper_genus", "paper_errata"],
        ]),
        rows,
        notes,
    }
}

fn row<'a>(printed: &MeshRow, cells: impl Iterator<Item = &'a Cell> + Clone) -> Vec<String> {
    let count = |number: fn(&RunRecord) -> Option<u64>| {
        cells.clone().find_map(|cell: &Cell| cell.count(number))
    };
    let ours = [
        count(|run| run.vertices),
        count(|run| run.edges),
        count(|run| run.triangles),
        count(|run| run.genus),
    ];
    let paper = [printed.vertices, printed.edges, printed.triangles, printed.genus];
    let agrees = match ours {
        [None, None, None, None] => "not run",
        _ if ours.iter().zip(paper).all(|(ours, paper)| *ours == Some(u64::from(paper))) => "yes",
        _ => "no",
    };
    let kind = cells.clone().next().map(|cell| cell.mesh_kind.clone()).unwrap_or_default();
    let mut row = vec![printed.mesh.clone()];
    row.extend(ours.map(|count| or_empty(count, |count| count.to_string())));
    row.extend([kind, agrees.into()]);
    row.extend(paper.map(|count| count.to_string()));
    row.push(printed.errata.clone());
    row
}
