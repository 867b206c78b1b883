//! Tests of the lab through its public items, in one program.

mod claims;
mod columns;
mod damaged_files;
mod documents;
mod figures;
mod generate;
mod imports;
mod page;
mod paper_tables;
mod plots;
mod records;
mod report;
