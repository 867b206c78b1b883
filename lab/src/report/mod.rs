//! The report on a folder of results: tables, verdicts on the papers' claims, plots, and one page
//! with all of it.
//!
//! Everything is made of records, of the pictures beside them and of the papers' printed values.
//! No mesh is read or made here and no algorithm runs. Data flows from records through the summary
//! to tables, verdicts and plots, and from these to the page.

pub mod baseline;
pub mod claims;
pub mod compare;
pub mod defects;
pub mod documents;
pub mod files;
mod notes;
mod number;
pub mod page;
mod path_price;
pub mod plots;
mod power_law;
mod statistics;
mod summary;
pub mod tables;

pub use compare::{Comparison, Judged, Verdict};
pub use files::{Extent, Report, ReportError, write, write_baseline};
pub use notes::Note;
pub use statistics::Statistics;
pub use summary::{Cell, Summary};
pub use tables::ReportTable;
