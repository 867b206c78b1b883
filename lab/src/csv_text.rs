//! Comma-separated values in memory.

use std::io;

use serde::Serialize;

/// Returns `rows` as a file's text, the names of their fields first.
pub(crate) fn with_header<T: Serialize>(rows: impl IntoIterator<Item = T>) -> io::Result<Vec<u8>> {
    serialized(rows, true)
}

/// Returns `rows` without a line of names.
pub(crate) fn without_header<T: Serialize>(
    rows: impl IntoIterator<Item = T>,
) -> io::Result<Vec<u8>> {
    serialized(rows, false)
}

fn serialized<T: Serialize>(
    rows: impl IntoIterator<Item = T>,
    has_header: bool,
) -> io::Result<Vec<u8>> {
    let mut writer = csv::WriterBuilder::new().has_headers(has_header).from_writer(Vec::new());
    rows.into_iter().try_for_each(|row| writer.serialize(row))?;
    writer.into_inner().map_err(|error| io::Error::other(error.to_string()))
}

/// Returns rows of texts, all of the same length, as a file's text.
pub(crate) fn of_texts<R>(rows: impl IntoIterator<Item = R>) -> String
where
    R: IntoIterator<Item: AsRef<[u8]>>,
{
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        writer.write_record(row).expect("rows are equally long and memory takes everything");
    }
    let bytes = writer.into_inner().expect("memory takes everything");
    String::from_utf8(bytes).expect("made of texts")
}
