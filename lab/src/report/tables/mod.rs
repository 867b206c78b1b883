//! Tables made of records: those of the papers, column by column with the printed values beside
//! ours, and others that the papers do not have.
//!
//! Nothing is left out for going wrong: a cell that was planned and has no row, or rows that did not
//! end well, stands in its table with its outcomes and without numbers.

mod columns;
mod extra;
mod links;
mod meshes;
mod pairing;

use super::summary::Summary;

/// A table, ready to be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReportTable {
    /// The number of the printed table that it mirrors, such as `4.3`; empty for those of our own.
    pub number: &'static str,
    /// Its file in the results folder.
    pub file: &'static str,
    /// What is in it.
    pub title: String,
    /// Names of its columns, with units.
    pub header: Vec<String>,
    /// One field for each column.
    pub rows: Vec<Vec<String>>,
    /// What must be known to read it.
    pub notes: Vec<String>,
}

impl ReportTable {
    /// The table as comma-separated values, names first, lines ended by `\n`.
    pub fn csv(&self) -> String {
        let mut writer = csv::Writer::from_writer(Vec::new());
        for row in std::iter::once(&self.header).chain(&self.rows) {
            writer.write_record(row).expect("a table is rectangular and memory takes it");
        }
        let bytes = writer.into_inner().expect("memory takes everything");
        String::from_utf8(bytes).expect("made of strings")
    }
}

/// Every table: those of the comparison paper, those of the paper on irreducible triangulations, ours.
/// O(cells²).
pub fn all(summary: &Summary) -> Vec<ReportTable> {
    let mut tables = Vec::new();
    tables.extend(meshes::comparison(summary));
    tables.extend(pairing::all(summary));
    tables.extend(meshes::irreducible(summary));
    tables.extend(links::all(summary));
    tables.extend(extra::all(summary));
    tables
}
