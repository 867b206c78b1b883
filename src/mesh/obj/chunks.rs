//! The lines of a block, read in chunks at once.
//!
//! The elements before each chunk are counted first: indices depend on them and on nothing else.
//! Where anything is unusual, the block is to be read line by line, as that gives the first fault.

use super::cursor::Cursor;
use super::given::Given;
use super::parser::Parser;
use crate::mesh::faces::MAX_CORNERS;
use crate::parallel::map;

/// Reads whole lines in chunks of about `length` bytes, and returns whether it did.
///
/// If not, nothing has changed: the text is one chunk, or has a fault, or has elements whose
/// keywords were not counted.
pub(super) fn read_chunks(parser: &mut Parser, text: &[u8], length: usize) -> bool {
    if text.len() <= length {
        return false;
    }
    let chunks = split(text, length);
    let befores = sums(parser.given(), map(chunks.clone(), Given::count));
    let work = chunks.iter().copied().zip(befores.windows(2)).collect();
    let parts = map(work, |(chunk, given)| read_chunk(chunk, given[0], given[1]));
    let Some(parts) = parts.into_iter().collect::<Option<Vec<Parser>>>() else { return false };
    let corners: usize = parts.iter().map(Parser::corner_count).sum();
    if parser.corner_count() + corners > MAX_CORNERS {
        return false;
    }
    let mut behind = text.len();
    for (part, chunk) in parts.into_iter().zip(chunks) {
        behind -= chunk.len();
        parser.append(part, behind);
    }
    true
}

/// Splits whole lines into chunks that end with the first line end behind `length` bytes.
fn split(text: &[u8], length: usize) -> Vec<&[u8]> {
    let mut chunks = Vec::new();
    let mut rest = text;
    while !rest.is_empty() {
        let least = length.min(rest.len());
        let end = memchr::memchr(b'\n', &rest[least..]).map_or(rest.len(), |at| least + at + 1);
        let (chunk, behind) = rest.split_at(end);
        chunks.push(chunk);
        rest = behind;
    }
    chunks
}

/// Returns `first`, and the sums of that and the counts up to each.
fn sums(first: Given, counts: Vec<Given>) -> Vec<Given> {
    let mut given = first;
    let mut sums = vec![first];
    for count in counts {
        given = given + count;
        sums.push(given);
    }
    sums
}

/// Reads the lines between these numbers of elements; none if that is not what they give.
fn read_chunk(text: &[u8], before: Given, after: Given) -> Option<Parser> {
    let mut part = Parser::after(before);
    let is_whole = part.lines(&mut Cursor { rest: text }).is_ok();
    (is_whole && part.given() == after).then_some(part)
}
