//! Parts of the page.

use crate::experiment::Results;
use crate::pictures::PictureRecord;
use crate::report::compare::{Comparison, ToleranceRow};
use crate::report::defects::Defect;
use crate::report::plots::Plot;
use crate::report::summary::Summary;
use crate::report::tables::ReportTable;

/// A picture with its record.
#[derive(Clone, Debug, PartialEq)]
pub struct PictureFile {
    /// The subject.
    pub record: PictureRecord,
    /// The file.
    pub png: Vec<u8>,
}

/// Everything that the page shows.
#[derive(Clone, Copy, Debug)]
pub struct Parts<'a> {
    /// The records.
    pub results: &'a Results,
    /// The records in cells.
    pub summary: &'a Summary,
    /// Every table.
    pub tables: &'a [ReportTable],
    /// Every verdict.
    pub comparison: &'a Comparison,
    /// Verdicts under other limits of their tests.
    pub tolerances: &'a [ToleranceRow],
    /// Every plot that could be made.
    pub plots: &'a [Plot],
    /// Every picture that is there.
    pub pictures: &'a [PictureFile],
    /// Missing and damaged parts.
    pub defects: &'a [Defect],
}
