//! Counts of the meshes, Tables 4.1 and 4.2 of the comparison paper, Tables 2 to 5 of the other.

use super::columns::{Line, column, counterpart, mesh_kind, size};
use super::table::{ReportTable, Value};
use crate::paper::{MeshRow, Paper, Table, TableKind};
use crate::report::notes::Note;
use crate::report::summary::{Cell, Summary};

/// Makes the tables of a paper.
pub fn of_paper(summary: &Summary, paper: Paper) -> impl Iterator<Item = ReportTable> {
    Table::of_kind(paper, TableKind::Meshes).map(move |printed| table(summary, printed))
}

fn table(summary: &Summary, printed: Table) -> ReportTable {
    let line = |row: MeshRow| {
        let mesh = row.mesh.clone();
        Line::new(summary, printed.paper, &mesh, Some(row))
    };
    let lines: Vec<Line<MeshRow>> = printed.mesh_rows().into_iter().map(line).collect();
    let count = |count: u32| Value::Count(count.into());
    let columns = vec![
        size("vertices", |measured| measured.vertices)
            .printed(move |row: &MeshRow| count(row.vertices)),
        size("edges", |measured| measured.edges).printed(move |row: &MeshRow| count(row.edges)),
        size("triangles", |measured| measured.triangles)
            .printed(move |row: &MeshRow| count(row.triangles)),
        size("genus", |measured| measured.genus).printed(move |row: &MeshRow| count(row.genus)),
        mesh_kind(),
        column("agrees", |line| Value::Text(agrees(line).into())).hidden(),
    ];
    let mut table = counterpart(printed, columns, &lines, |row| &row.errata);
    // No runs are shown, so that there are no commands to repeat them.
    table.group = None;
    // Sizes and kinds alone are shown, not how runs ended.
    let firsts = lines.iter().filter_map(|line: &Line<_>| line.of_mesh.first().copied());
    let firsts: Vec<&Cell> = firsts.collect();
    table.notes = Note::on(firsts.into_iter());
    table.notes.retain(|note| matches!(note, Note::Scale(_) | Note::StandIn));
    table
}

fn agrees(line: &Line<MeshRow>) -> &'static str {
    let ours = [
        line.count(|measured| measured.vertices),
        line.count(|measured| measured.edges),
        line.count(|measured| measured.triangles),
        line.count(|measured| measured.genus),
    ];
    let row = line.paper.as_ref().expect("every line is a row of the paper");
    let paper = [row.vertices, row.edges, row.triangles, row.genus].map(|n| Some(u64::from(n)));
    match ours {
        [None, None, None, None] => "not run",
        _ if ours == paper => "yes",
        _ => "no",
    }
}
