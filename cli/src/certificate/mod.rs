//! Certificate files: the proof that a pairing is the best, as text.
//!
//! A file states the aims of the pairing, then the dual values that prove it. Lines in order:
//!
//! ```text
//! triquad-certificate 1
//! cost default                 or shape, or listed: the costs of a file of their own
//! keep-sharp 30                if given
//! keep-seams                   if given
//! strict                       if given
//! quad-dominant 22938          the price as an integer, if given
//! keep-edges 2                 edges listed, then one a line
//! 13 14
//! 14 22
//! triangles 4                  then for each its potential and its innermost odd set, 0 for none
//! 1203 0
//! ...
//! sets 1                       then for each odd set the set around it, 0 for none, and its value
//! 0 17
//! barrier 1                    if triangles may be left but not at a price; then its triangles
//! 3
//! end
//! ```
//!
//! Triangles, vertices and sets count from 1. Values are in halves, as those of
//! [`Certificate`](triquad::matching::weighted::Certificate).

mod format;
mod read;
mod write;

pub use read::{Stated, read};
pub use write::write;
