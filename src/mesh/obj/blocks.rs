//! Text read in blocks of whole lines.

use std::io::Read;

use crate::mesh::error::MeshError;

/// Number of bytes requested at a time.
pub(super) const BLOCK: usize = 1 << 20;

/// The text in blocks of whole lines, continued ones joined.
#[derive(Default)]
pub(super) struct Blocks {
    buffer: Vec<u8>,
    /// Length of the last block given out, at the front of `buffer`.
    given: usize,
    lines_given: usize,
    /// Positions in the block of line breaks that were replaced to join lines.
    joined: Vec<usize>,
}

/// Some whole lines.
pub(super) struct Block<'b> {
    pub(super) text: &'b [u8],
    pub(super) lines_before: usize,
    joined: &'b [usize],
}

impl Block<'_> {
    /// Returns the number in the file of the line at `position`.
    pub(super) fn line_at(&self, position: usize) -> usize {
        let breaks = memchr::memchr_iter(b'\n', &self.text[..position]).count();
        let joined = self.joined.iter().filter(|&&at| at < position).count();
        self.lines_before + breaks + joined + 1
    }
}

impl Blocks {
    /// Reads the next block, or none at the end.
    pub(super) fn next(&mut self, input: &mut dyn Read) -> Result<Option<Block<'_>>, MeshError> {
        self.drop_given();
        let mut end;
        loop {
            let before = self.buffer.len();
            // Doubling where a line is longer than a block, or searching it would be quadratic.
            input.take(before.max(BLOCK) as u64).read_to_end(&mut self.buffer)?;
            let at_end = self.buffer.len() == before;
            end = if at_end { self.buffer.len() } else { end_of_whole_lines(&self.buffer) };
            if end > 0 || at_end {
                break;
            }
        }
        self.given = end;
        self.join_continued_lines();
        let text = &self.buffer[..end];
        let block = Block { text, lines_before: self.lines_given, joined: &self.joined };
        Ok((end > 0).then_some(block))
    }

    fn drop_given(&mut self) {
        let given = &self.buffer[..self.given];
        self.lines_given += memchr::memchr_iter(b'\n', given).count() + self.joined.len();
        self.joined.clear();
        self.buffer.drain(..self.given);
    }

    /// Replaces each backslash at the end of a line, and the line break, by as many spaces.
    fn join_continued_lines(&mut self) {
        let mut from = 0;
        while let Some(found) = memchr::memchr(b'\\', &self.buffer[from..self.given]) {
            let slash = from + found;
            let length = match self.buffer[slash + 1..self.given] {
                _ if is_in_comment(&self.buffer, slash) => 0,
                [b'\n', ..] => 2,
                [b'\r', b'\n', ..] => 3,
                _ => 0,
            };
            if length > 0 {
                self.buffer[slash..slash + length].fill(b' ');
                self.joined.push(slash + length - 1);
            }
            from = slash + 1;
        }
    }
}

/// Returns whether the line of `text` around `at` is a comment.
///
/// A backslash does not continue that: it may be the end of a folder's name.
fn is_in_comment(text: &[u8], at: usize) -> bool {
    let start = memchr::memrchr(b'\n', &text[..at]).map_or(0, |newline| newline + 1);
    text[start..at].trim_ascii_start().starts_with(b"#")
}

/// Returns the end of the last line that is whole and not continued; 0 if there is none.
fn end_of_whole_lines(text: &[u8]) -> usize {
    let mut end = text.len();
    while let Some(at) = memchr::memrchr(b'\n', &text[..end]) {
        match text[..at] {
            [.., b'\\'] | [.., b'\\', b'\r'] if !is_in_comment(text, at) => end = at,
            _ => return at + 1,
        }
    }
    0
}
