//! Tables made of records: those of the papers, column by column with the printed values beside
//! ours, and others that the papers do not have.
//!
//! No cell is left out for going wrong: one that was planned and has no row, or rows that did not
//! end well, stands in its table with its outcomes and without numbers.

mod columns;
mod link_tests;
mod mesh_counts;
mod own;
mod pairings;
mod side_by_side;
mod table;

pub use own::AUGMENTATION;
pub use pairings::with_programs;
pub use table::{Beside, Column, ReportTable, Row, TableCell, Value};

use super::summary::Summary;
use crate::paper::Paper;

/// Makes every table: those of the comparison paper, those of the paper on irreducible
/// triangulations, ours. O(cells²).
pub fn all(summary: &Summary) -> Vec<ReportTable> {
    let mut tables = Vec::new();
    tables.extend(mesh_counts::of_paper(summary, Paper::Comparison));
    tables.extend(pairings::all(summary));
    tables.extend(mesh_counts::of_paper(summary, Paper::Irreducible));
    tables.extend(link_tests::all(summary));
    tables.extend(own::all(summary));
    tables.extend(side_by_side::table(summary));
    tables
}
