//! Wavefront OBJ.
//!
//! Reads `v`, `vt`, `vn` and `f` in all their forms, negative indices, continued lines and line
//! ends of every kind. Objects, groups, smoothing groups and materials are kept as lines. What else
//! the file holds is skipped and named. Numbers are parsed in place, in blocks. Several threads
//! read chunks of a block at once; the mesh and the errors are those of one thread.

mod blocks;
#[cfg(all(test, feature = "threads"))]
mod chunk_tests;
mod chunks;
mod cursor;
mod given;
mod left_out;
mod parser;
mod statements;
#[cfg(test)]
mod tests;
mod write;

use std::io::Read;

use blocks::{BLOCK, Block, Blocks};
use chunks::read_chunks;
use cursor::Cursor;
use parser::Parser;
pub(super) use write::write;

use super::error::MeshError;
use super::polygon_mesh::Mesh;
use crate::parallel::{beside, threads};

/// Reads an OBJ file, a block at a time: the text is never held as a whole.
///
/// # Errors
/// The first defect with its line, or an error of `input`.
pub(super) fn read(input: &mut dyn Read) -> Result<Mesh, MeshError> {
    match threads() {
        // A tenth faster: the block stays in the cache beside what is read from it.
        1 => read_blocks(input, BLOCK / 4, BLOCK),
        // One reads the file, and the other has no parts to put together.
        2 => read_blocks(input, 8 * BLOCK, usize::MAX),
        threads => read_blocks(input, 2 * threads * BLOCK, BLOCK),
    }
}

/// Reads an OBJ file by blocks of `block` bytes, each in chunks of `chunk` bytes; of 0, by the
/// line.
///
/// The next block is read from the file while one is parsed.
fn read_blocks(input: &mut dyn Read, block: usize, chunk: usize) -> Result<Mesh, MeshError> {
    let mut parser = Parser::default();
    let mut blocks = Blocks::new(block);
    let mut room = Block::default();
    let mut next = blocks.next(input, Block::default())?;
    while let Some(block) = next {
        let parse = || parse(&mut parser, &block, chunk);
        let (parsed, read) = beside(parse, || blocks.next(input, std::mem::take(&mut room)));
        parsed?;
        next = read?;
        room = block;
    }
    Ok(parser.finish())
}

/// Reads the lines of a block.
fn parse(parser: &mut Parser, block: &Block, chunk: usize) -> Result<(), MeshError> {
    let mut cursor = Cursor { rest: block.text() };
    if block.is_first() {
        cursor.skip_byte_order_mark();
    }
    let is_read = read_chunks(parser, cursor.rest, chunk);
    let fault = if is_read { None } else { parser.lines(&mut cursor).err() };
    parser.settle(block);
    match fault {
        None => Ok(()),
        Some(fault) => {
            let line = block.line_at(block.text().len() - cursor.rest.len());
            let error = parser.explain(fault.at(line));
            // Only the last line of a file can have no end.
            let is_cut = !cursor.rest.contains(&b'\n');
            Err(if is_cut { end_of_file(error) } else { error })
        }
    }
}

/// Adds to an error in the last line that the rest of the file may be missing: OBJ files do not
/// announce how much is in them.
fn end_of_file(error: MeshError) -> MeshError {
    match error {
        MeshError::Malformed { place, problem } => {
            let problem = format!("{problem}, where the file ends: it may be cut off");
            MeshError::Malformed { place, problem }
        }
        error => error,
    }
}
