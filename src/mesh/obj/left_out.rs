//! Content of an OBJ file that the mesh does not hold: counted, with the first line of each kind.

use super::blocks::Block;
use super::statements::Unread;
use crate::counted::counted;

/// A place in a block, as the number of bytes from it to the end, and the line once that is known.
#[derive(Clone, Copy)]
struct Mark {
    left: usize,
    line: usize,
}

impl Mark {
    fn new(left: usize) -> Self {
        Self { left, line: 0 }
    }
}

/// References of corners to elements of one kind that were not given before them.
#[derive(Default)]
pub(super) struct Absent {
    /// Each reference beyond all before it, in ascending order.
    beyond: Vec<(u32, Mark)>,
    /// Number of references in `beyond` whose line is known.
    settled: usize,
    /// References that cannot be met whatever follows; they are read as none.
    never: usize,
}

impl Absent {
    /// Notes a reference to `index`, where `left` bytes of the block are left.
    #[cold]
    pub(super) fn note(&mut self, index: u32, left: usize) {
        if self.beyond.last().is_none_or(|&(last, _)| last < index) {
            self.beyond.push((index, Mark::new(left)));
        }
    }

    /// Notes a reference that is no index.
    #[cold]
    pub(super) fn note_never(&mut self, left: usize) {
        self.never += 1;
        self.note(u32::MAX, left);
    }

    /// Adds what was noted in the next chunk, with `behind` bytes of the block after it.
    pub(super) fn append(&mut self, chunk: Self, behind: usize) {
        self.never += chunk.never;
        for (index, mark) in chunk.beyond {
            self.note(index, mark.left + behind);
        }
    }

    /// Finds the lines of what was noted in `block`, and drops what is given by now.
    pub(super) fn settle(&mut self, block: &Block, given: usize) {
        let met = self.beyond.partition_point(|&(index, _)| (index as usize) < given);
        self.beyond.drain(..met);
        self.settled = self.settled.saturating_sub(met);
        let mut lines = block.lines();
        for (_, mark) in &mut self.beyond[self.settled..] {
            mark.line = lines.at(block.text().len() - mark.left);
        }
        self.settled = self.beyond.len();
    }

    /// Returns the note that `dropped` references beyond the `given` elements were dropped.
    pub(super) fn note_text(&self, kind: &str, dropped: usize, given: usize) -> Option<String> {
        let (_, first) = self.beyond.iter().find(|&&(index, _)| index as usize >= given)?;
        let (count, line) = (dropped + self.never, first.line);
        let references = counted(
            count,
            format_args!("reference to an absent {kind}"),
            format_args!("references to absent {kind}s"),
        );
        let first = if count == 1 { "" } else { "the first in " };
        Some(format!("{references} ({first}line {line})"))
    }
}

/// Lines that are not read.
#[derive(Default)]
pub(super) struct Skipped {
    kinds: [bool; Unread::ALL.len()],
    unknown: usize,
    /// The beginning and the place of the first unknown line.
    first: Option<(String, Mark)>,
    settled: bool,
}

impl Skipped {
    /// Notes a line with `left` bytes of the block from its end on.
    pub(super) fn note(&mut self, keyword: &[u8], line: &[u8], left: usize) {
        if let Some(kind) = Unread::of(keyword) {
            self.kinds[kind as usize] = true;
            return;
        }
        self.unknown += 1;
        if self.first.is_none() {
            let shown = String::from_utf8_lossy(&line[..line.len().min(30)]);
            self.first = Some((shown.escape_debug().to_string(), Mark::new(left)));
        }
    }

    /// Adds what was noted in the next chunk, with `behind` bytes of the block after it.
    pub(super) fn append(&mut self, chunk: Self, behind: usize) {
        for (seen, also) in self.kinds.iter_mut().zip(chunk.kinds) {
            *seen |= also;
        }
        self.unknown += chunk.unknown;
        let first = chunk.first.map(|(text, mark)| (text, Mark::new(mark.left + behind)));
        self.first = self.first.take().or(first);
    }

    /// Finds the line of what was noted in `block`.
    pub(super) fn settle(&mut self, block: &Block) {
        if let Some((_, mark)) = &mut self.first
            && !std::mem::replace(&mut self.settled, true)
        {
            mark.line = block.line_at(block.text().len() - mark.left);
        }
    }

    /// Returns the names of the known kinds of lines seen.
    pub(super) fn kinds(&self) -> impl Iterator<Item = String> {
        let seen = |kind: &Unread| self.kinds[*kind as usize];
        Unread::ALL.into_iter().filter(seen).map(|kind| kind.name().to_owned())
    }

    /// Returns the note on unknown lines, if there are any.
    pub(super) fn unknown(&self) -> Option<String> {
        let (text, Mark { line, .. }) = self.first.as_ref()?;
        let lines = counted(self.unknown, "line that begins", "lines that begin");
        let first = if self.unknown == 1 { "" } else { "the first is " };
        Some(format!("{lines} with no keyword ({first}line {line}: '{text}')"))
    }
}
