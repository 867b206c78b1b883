//! Columns by how their cells come from a line: name, heading and number in one place.

use super::table::{Beside, Column, ReportTable, Row, TableCell, Value};
use crate::experiment::{Measured, RunRecord};
use crate::meshes::Origin;
use crate::paper::{Paper, Table};
use crate::report::notes::Note;
use crate::report::number::quotient;
use crate::report::summary::{Cell, Summary};

/// Source of a row of a table.
pub struct Line<'a, P> {
    /// Name of the mesh.
    pub mesh: String,
    /// Every cell of the mesh.
    pub of_mesh: Vec<&'a Cell>,
    /// The cells that are shown, one for each algorithm that the table has columns for.
    pub cells: Vec<Option<&'a Cell>>,
    /// The paper's row.
    pub paper: Option<P>,
}

/// Makes a cell of a line.
type MakeCell<'c, P> = dyn Fn(&Line<P>) -> TableCell + 'c;

/// A column and how its cells are made.
pub struct ColumnOf<'c, P> {
    column: Column,
    cell: Box<MakeCell<'c, P>>,
}

impl<'a, P> Line<'a, P> {
    /// Returns a line on a mesh of a paper, without shown cells.
    pub fn new(summary: &'a Summary, paper: Paper, mesh: &str, printed: Option<P>) -> Self {
        let of_mesh = summary.of_mesh(paper, mesh).collect();
        Self { mesh: mesh.into(), of_mesh, cells: Vec::new(), paper: printed }
    }

    /// Returns the origin of the mesh: that of the cells shown, else that of ours.
    fn origin(&self) -> Option<Origin> {
        let shown = self.cells.iter().flatten();
        let ours = self.of_mesh.iter().filter(|cell| !cell.was_imported());
        shown.chain(ours).chain(&self.of_mesh).find_map(|cell| cell.origin)
    }

    /// Returns a count of the mesh from whichever of its cells has it.
    pub fn count(&self, count: fn(&Measured) -> Option<u64>) -> Option<u64> {
        self.of_mesh.iter().find_map(|cell| cell.count(count))
    }
}

/// Returns a column of that name; its cells are made by `ours`.
pub fn column<'c, P>(
    name: impl Into<String>,
    ours: impl Fn(&Line<P>) -> Value + 'c,
) -> ColumnOf<'c, P> {
    let name = name.into();
    let heading = name.replace('_', " ");
    let column = Column { name, heading, is_shown: true, beside: Beside::Nothing };
    let cell = move |line: &Line<P>| TableCell { ours: ours(line), ..TableCell::default() };
    ColumnOf { column, cell: Box::new(cell) }
}

/// Returns a column of a shown cell.
pub fn of_cell<'c, P>(
    name: impl Into<String>,
    at: usize,
    ours: impl Fn(&Cell) -> Option<Value> + 'c,
) -> ColumnOf<'c, P> {
    column(name, move |line: &Line<P>| line.cells[at].and_then(&ours).unwrap_or_default())
}

/// Returns a column of the mean of a number over the runs of a shown cell.
pub fn mean<'c, P: 'c>(
    name: impl Into<String>,
    at: usize,
    unit: fn(f64) -> Value,
    number: fn(&RunRecord) -> Option<f64>,
) -> ColumnOf<'c, P> {
    of_cell(name, at, move |cell| cell.mean(number).map(unit)).sampled(at, number)
}

/// Returns a column of the mean of a count over the runs of a shown cell.
pub fn mean_count<'c, P: 'c>(
    name: impl Into<String>,
    at: usize,
    count: fn(&Measured) -> Option<u64>,
) -> ColumnOf<'c, P> {
    let number = move |run: &RunRecord| count(&run.measured).map(|count| count as f64);
    of_cell(name, at, move |cell| cell.mean_count(count).map(Value::Mean)).sampled(at, number)
}

/// Returns a column of the quotient of two counts of a shown cell, each the mean over its runs.
pub fn quotient_of<'c, P>(
    name: impl Into<String>,
    at: usize,
    [top, bottom]: [fn(&Measured) -> Option<u64>; 2],
) -> ColumnOf<'c, P> {
    of_cell(name, at, move |cell| {
        quotient(cell.mean_count(top), cell.mean_count(bottom)).map(Value::Ratio)
    })
}

/// Words for a cell that is in no plan and has no run.
pub const NOT_PLANNED: &str = "not planned";

/// Returns a column of how the runs of a cell ended, or `not planned`.
pub fn outcomes<'c, P: 'c>(name: impl Into<String>, at: usize) -> ColumnOf<'c, P> {
    outcomes_or(name, at, |_| NOT_PLANNED)
}

/// Returns a column of how the runs of a cell ended, or why there is no cell.
pub fn outcomes_or<'c, P: 'c>(
    name: impl Into<String>,
    at: usize,
    absent: fn(&Line<P>) -> &'static str,
) -> ColumnOf<'c, P> {
    column(name, move |line: &Line<P>| {
        Value::Text(line.cells[at].map_or_else(|| absent(line).into(), Cell::outcome_text))
    })
}

/// Returns a column of the number of runs that ended well.
pub fn ok_runs<'c, P>(name: impl Into<String>, at: usize) -> ColumnOf<'c, P> {
    let runs = move |line: &Line<P>| {
        Value::Count(line.cells[at].map_or(0, |cell| cell.ok_runs().count() as u64))
    };
    column(name, runs)
}

/// Returns a column with `yes` where times of a cell are extrapolated.
pub fn extrapolated<'c, P>(name: impl Into<String>, at: usize) -> ColumnOf<'c, P> {
    let yes = |cell: &Cell| cell.is_extrapolated().then(|| Value::Text("yes".into()));
    of_cell(name, at, yes).hidden()
}

/// Returns the columns of origin and size of the mesh. The page has triangles and genus, of which
/// the number of vertices follows.
pub fn mesh<'c, P>() -> Vec<ColumnOf<'c, P>> {
    vec![
        mesh_kind(),
        size("vertices", |measured| measured.vertices).hidden(),
        size("triangles", |measured| measured.triangles),
        size("genus", |measured| measured.genus),
    ]
}

/// Returns the same columns for a table of the papers: the page has them in the tables of meshes.
pub fn hidden_mesh<'c, P>() -> impl Iterator<Item = ColumnOf<'c, P>> {
    mesh().into_iter().map(ColumnOf::hidden)
}

/// Returns the column of the origin of the mesh.
pub fn mesh_kind<'c, P>() -> ColumnOf<'c, P> {
    let origin = |line: &Line<P>| line.origin().map_or("", Origin::id).to_owned();
    column("mesh_kind", move |line| Value::Text(origin(line))).hidden()
}

/// Returns a column of a count of the mesh.
pub fn size<'c, P>(name: &'static str, count: fn(&Measured) -> Option<u64>) -> ColumnOf<'c, P> {
    column(name, move |line: &Line<P>| line.count(count).map_or(Value::Missing, Value::Count))
}

impl<'c, P> ColumnOf<'c, P> {
    /// Sets the name on the page.
    pub fn heading(mut self, heading: impl Into<String>) -> Self {
        self.column.heading = heading.into();
        self
    }

    /// Keeps the numbers of the runs of a shown cell beside their mean.
    fn sampled(mut self, at: usize, number: impl Fn(&RunRecord) -> Option<f64> + 'c) -> Self
    where
        P: 'c,
    {
        let ours = self.cell;
        self.cell = Box::new(move |line| TableCell {
            sample: line.cells[at].map_or(Vec::new(), |cell| cell.sample(&number)),
            ..ours(line)
        });
        self
    }

    /// Leaves the column out of the page.
    pub fn hidden(mut self) -> Self {
        self.column.is_shown = false;
        self
    }

    /// Puts the paper's number beside ours.
    pub fn printed(mut self, paper: impl Fn(&P) -> Value + 'c) -> Self
    where
        P: 'c,
    {
        self.column.beside = Beside::Printed;
        let ours = self.cell;
        self.cell = Box::new(move |line| TableCell {
            paper: line.paper.as_ref().map_or(Value::Missing, &paper),
            ..ours(line)
        });
        self
    }

    /// Adds the ratio of ours to the paper's to the file.
    pub fn with_ratio(mut self) -> Self {
        self.column.beside = Beside::PrintedAndRatio;
        self
    }

    /// Marks the numbers that are extrapolated in one of these shown cells.
    pub fn starred(mut self, at: &'c [usize]) -> Self
    where
        P: 'c,
    {
        let ours = self.cell;
        self.cell = Box::new(move |line| TableCell {
            is_extrapolated: at.iter().any(|&at| line.cells[at].is_some_and(Cell::is_extrapolated)),
            ..ours(line)
        });
        self
    }
}

/// Makes a table: a row for each line, and the notes on the shown cells.
pub fn table<P>(
    file: &'static str,
    title: &'static str,
    columns: Vec<ColumnOf<P>>,
    lines: &[Line<P>],
) -> ReportTable {
    let row = |line: &Line<P>| Row {
        mesh: line.mesh.clone(),
        origin: line.origin(),
        cells: columns.iter().map(|column| (column.cell)(line)).collect(),
        errata: String::new(),
    };
    let rows = lines.iter().map(row).collect();
    let shown = lines.iter().flat_map(|line| line.cells.iter().copied().flatten());
    let notes = Note::on(shown);
    let columns = columns.into_iter().map(|column| column.column).collect();
    ReportTable { paper: None, group: None, file, title, columns, rows, notes }
}

/// Makes the counterpart of a printed table.
pub fn counterpart<P>(
    printed: Table,
    columns: Vec<ColumnOf<P>>,
    lines: &[Line<P>],
    errata: fn(&P) -> &str,
) -> ReportTable {
    let mut table = table(printed.file, printed.title, columns, lines);
    table.paper = Some(printed);
    table.group = Some((printed.paper, printed.group));
    for (row, line) in table.rows.iter_mut().zip(lines) {
        row.errata = line.paper.as_ref().map_or(String::new(), |paper| errata(paper).into());
    }
    table
}
