//! Text read in blocks of whole lines.

use std::io::Read;

use super::statements::Continued;
use crate::mesh::error::{MeshError, Place};
use crate::mesh::line_ends;

/// Number of bytes that a thread parses at a time, at most.
pub(super) const BLOCK: usize = 1 << 20;

/// Lines up to this length are read whatever the blocks; continued lines count as one.
const LONGEST_LINE: usize = 1 << 24;

/// The text in blocks of whole lines that end in line feeds, continued ones joined.
#[derive(Default)]
pub(super) struct Blocks {
    /// Number of bytes requested at a time.
    length: usize,
    /// What was read behind the last block.
    behind: Vec<u8>,
    /// Length of the front of `behind` whose line ends are unified.
    unified: usize,
    lines_given: usize,
}

/// Some whole lines.
#[derive(Default)]
pub(super) struct Block {
    text: Vec<u8>,
    lines_before: usize,
    /// Positions of line breaks that were replaced to join lines.
    joined: Vec<usize>,
}

impl Block {
    /// Returns the lines.
    pub(super) fn text(&self) -> &[u8] {
        &self.text
    }

    /// Returns whether the file begins here.
    pub(super) fn is_first(&self) -> bool {
        self.lines_before == 0
    }

    /// Returns the number in the file of the line at `position`.
    pub(super) fn line_at(&self, position: usize) -> usize {
        self.lines().at(position)
    }

    /// Returns what finds the lines of ascending positions in one pass.
    pub(super) fn lines(&self) -> Lines<'_> {
        Lines { block: self, line: self.lines_before + 1, position: 0, joined: 0 }
    }
}

/// The lines of positions in a block, requested in ascending order.
pub(super) struct Lines<'b> {
    block: &'b Block,
    line: usize,
    position: usize,
    joined: usize,
}

impl Lines<'_> {
    /// Returns the number in the file of the line at `position`.
    pub(super) fn at(&mut self, position: usize) -> usize {
        let Block { text, joined, .. } = &self.block;
        self.line += memchr::memchr_iter(b'\n', &text[self.position..position]).count();
        let passed = joined[self.joined..].iter().take_while(|&&at| at < position).count();
        self.line += passed;
        self.joined += passed;
        self.position = position;
        self.line
    }
}

impl Blocks {
    /// Makes blocks of about `length` bytes.
    pub(super) fn new(length: usize) -> Self {
        Self { length, ..Self::default() }
    }

    /// Reads the next block in the room of an earlier one, or none at the end.
    pub(super) fn next(
        &mut self,
        input: &mut dyn Read,
        room: Block,
    ) -> Result<Option<Block>, MeshError> {
        let mut text = room.text;
        text.clear();
        text.append(&mut self.behind);
        let mut end;
        loop {
            let before = text.len();
            // Doubling where a line is longer than a block, or searching it would be quadratic.
            input.take(before.max(self.length) as u64).read_to_end(&mut text)?;
            let at_end = text.len() == before;
            self.unify_line_ends(&mut text, at_end);
            let whole = &text[..self.unified];
            end = if at_end { whole.len() } else { end_of_whole_lines(whole) };
            if end > 0 || at_end {
                break;
            }
            if text.len() > LONGEST_LINE {
                let problem = format!("a line of more than {LONGEST_LINE} bytes");
                return Err(MeshError::malformed(Place::Line(self.lines_given + 1), problem));
            }
        }
        self.behind.extend_from_slice(&text[end..]);
        self.unified -= end;
        text.truncate(end);
        let mut block = Block { text, lines_before: self.lines_given, joined: room.joined };
        block.join_continued_lines();
        self.lines_given += memchr::memchr_iter(b'\n', &block.text).count() + block.joined.len();
        Ok((end > 0).then_some(block))
    }

    /// Makes every line that was read end in a line feed.
    ///
    /// Carriage returns at the end of what was read wait for what follows them.
    fn unify_line_ends(&mut self, text: &mut [u8], at_end: bool) {
        let text = &mut text[self.unified..];
        let is_return = |byte: &u8| *byte == b'\r';
        let waiting =
            if at_end { 0 } else { text.iter().rev().take_while(|b| is_return(b)).count() };
        let length = text.len() - waiting;
        line_ends::unify(&mut text[..length]);
        self.unified += length;
    }
}

impl Block {
    /// Replaces each backslash that continues a line, and the line break, by as many spaces.
    ///
    /// Linear: nothing is searched twice.
    fn join_continued_lines(&mut self) {
        let Self { text, joined, .. } = self;
        joined.clear();
        let (mut from, mut scanned) = (0, 0);
        let mut line = None;
        while let Some(found) = memchr::memchr(b'\\', &text[from..]) {
            let slash = from + found;
            from = slash + 1;
            let behind = &text[slash + 1..];
            let returns = behind.iter().take_while(|&&byte| byte == b'\r').count();
            if behind.get(returns) != Some(&b'\n') {
                continue;
            }
            let length = 1 + returns + 1;
            let start = memchr::memrchr(b'\n', &text[scanned..slash]);
            let begun = start.map_or(scanned, |newline| scanned + newline + 1);
            if start.is_some() || line.is_none() {
                line = Some(Continued::new(&text[begun..slash]));
            }
            scanned = slash;
            let next = &text[slash + length..];
            if line.is_some_and(|line: Continued| line.goes_on(next)) {
                text[slash..slash + length].fill(b' ');
                joined.push(slash + length - 1);
                scanned = slash + length;
            }
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
        if !text[..at].trim_ascii_end().ends_with(b"\\") || is_in_comment(text, at) {
            return at + 1;
        }
        end = at;
    }
    0
}
