//! Wavefront OBJ.
//!
//! Reads `v`, `vt`, `vn` and `f` in all their forms, negative indices, continued lines and line
//! ends of every kind. Objects, groups, smoothing groups and materials are kept as lines. What else
//! the file holds is skipped and named. Reading is most of what users wait for, so numbers are
//! parsed in place and in blocks.

mod blocks;
mod cursor;
mod left_out;
mod parser;
mod statements;
#[cfg(test)]
mod tests;
mod write;

use std::io::Read;

use blocks::Blocks;
use cursor::Cursor;
use parser::Parser;
pub(super) use write::write;

use super::error::MeshError;
use super::polygon_mesh::Mesh;

/// Reads an OBJ file, a block at a time: the text is never held as a whole.
///
/// # Errors
/// The first defect with its line, or an error of `input`.
pub(super) fn read(input: &mut dyn Read) -> Result<Mesh, MeshError> {
    let mut parser = Parser::default();
    let mut blocks = Blocks::default();
    while let Some(block) = blocks.next(input)? {
        let mut cursor = Cursor { rest: block.text };
        if block.lines_before == 0 {
            cursor.skip_byte_order_mark();
        }
        let mut fault = None;
        while fault.is_none() && !cursor.rest.is_empty() {
            fault = parser.line(&mut cursor).err();
            if fault.is_none() {
                cursor.skip_line();
            }
        }
        parser.settle(block);
        if let Some(fault) = fault {
            let line = block.line_at(block.text.len() - cursor.rest.len());
            return Err(parser.explain(fault.at(line)));
        }
    }
    Ok(parser.finish())
}
