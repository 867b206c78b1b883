//! `triquad paper`.

use triquad_lab::paper::Table;

use crate::failure::Failure;
use crate::stdio;

/// Print the papers' tables as comma-separated values
///
/// Without TABLE it lists the tables.
#[derive(clap::Args)]
#[command(after_help = "Example: triquad paper 4.3 > table_4_3.csv")]
pub struct Arguments {
    /// Number in the paper, such as 4.3, 4.4(i) or 10, or the name of its file
    #[arg(value_name = "TABLE")]
    table: Option<String>,
}

/// Prints a table, or the list of all.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let Some(name) = &arguments.table else { return stdio::say(&list()) };
    match Table::named(name) {
        Ok(table) => stdio::say(table.text.trim_end()),
        Err(error) => Err(Failure::bad(format!("{error}; 'triquad paper' lists the tables"))),
    }
}

fn list() -> String {
    let line = |table: Table| {
        let Table { paper, number, title, file, .. } = table;
        format!("{number:<8} {:<12} {file:<18} {title}", paper.experiment())
    };
    Table::ALL.map(line).join("\n")
}
