//! Words of a text file: the scanner that the text formats share.

use std::fmt::Display;

use super::error::{MeshError, Place};
use super::line_ends;
use super::text::BYTE_ORDER_MARK;

/// The beginning of what is said where a line lacks a word.
pub(super) const LINE_ENDS: &str = "the line ends before";

/// Makes the error that the file ends where `missing` should be.
pub(super) fn truncated(missing: impl Display) -> MeshError {
    MeshError::Truncated { place: Place::End, missing: missing.to_string(), element: None }
}

/// Makes the error that the file ends before or within record `index`, from 0, of `count`.
pub(super) fn truncated_record(name: &str, index: usize, count: usize) -> MeshError {
    let element = format!("{name} {}", index + 1);
    let missing = format!("{element} of {count}");
    MeshError::Truncated { place: Place::End, missing, element: Some(element) }
}

/// A text and a position in it. White space separates its words.
///
/// Lines end with line feeds, carriage returns or both, mixed as they may be. A byte-order mark at
/// the beginning is no part of the text. A comment begins at the start of a word only.
#[derive(Clone, Copy)]
pub(super) struct Tokens<'a> {
    bytes: &'a [u8],
    /// First byte behind the current word.
    position: usize,
    /// First byte of the current word, or of the place where there was none.
    start: usize,
    /// The byte that begins a comment, which runs to the end of its line.
    comment: Option<u8>,
}

impl<'a> Tokens<'a> {
    /// Begins a text without comments.
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        let position = if bytes.starts_with(BYTE_ORDER_MARK) { BYTE_ORDER_MARK.len() } else { 0 };
        Self { bytes, position, start: position, comment: None }
    }

    /// Begins a text in which `#` begins a comment.
    pub(super) fn with_comments(bytes: &'a [u8]) -> Self {
        Self { comment: Some(b'#'), ..Self::new(bytes) }
    }

    /// Reads the next word, on whatever line it is.
    pub(super) fn next_word(&mut self) -> Option<&'a [u8]> {
        loop {
            let word = self.next_in_line();
            if word.is_some() || self.position == self.bytes.len() {
                return word;
            }
            self.position += 1; // The line feed or carriage return.
        }
    }

    /// Reads the next word of the current line.
    pub(super) fn next_in_line(&mut self) -> Option<&'a [u8]> {
        let is_blank = |byte: u8| byte.is_ascii_whitespace() && !is_line_end(byte);
        while self.bytes.get(self.position).copied().is_some_and(is_blank) {
            self.position += 1;
        }
        if self.comment.is_some() && self.bytes.get(self.position).copied() == self.comment {
            self.position = self.line_end();
        }
        self.start = self.position;
        let rest = &self.bytes[self.start..];
        let word = &rest[..rest.iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len())];
        self.position += word.len();
        (!word.is_empty()).then_some(word)
    }

    /// Moves to the beginning of the next line.
    pub(super) fn skip_line(&mut self) {
        self.position = self.line_end();
        self.position += match self.rest() {
            [b'\r', b'\n', ..] => 2,
            [_, ..] => 1,
            [] => 0,
        };
    }

    /// Moves behind the line of the current word, where binary data begin.
    ///
    /// They may begin with what looks like a line end. So a line feed belongs to the line only if
    /// nothing but blanks comes before it, and never if `returns_alone` end the lines.
    pub(super) fn skip_last_line(&mut self, returns_alone: bool) {
        let rest = self.rest();
        let is_blank = |byte: &u8| matches!(byte, b' ' | b'\t' | b'\r');
        let blanks = rest.iter().take_while(|byte| is_blank(byte)).count();
        if !returns_alone && rest.get(blanks) == Some(&b'\n') {
            self.position += blanks + 1;
        } else {
            self.position = self.bytes.len().min(self.line_end() + 1);
        }
    }

    /// Returns whether the current line ends with a carriage return alone.
    pub(super) fn ends_with_return(&self) -> bool {
        let rest = &self.bytes[self.line_end()..];
        let returns = rest.iter().take_while(|&&byte| byte == b'\r').count();
        returns > 0 && rest.get(returns) != Some(&b'\n')
    }

    /// Moves back to byte `offset` of the current word, where the next word begins.
    pub(super) fn split_word(&mut self, offset: usize) {
        self.position = self.start + offset;
    }

    fn line_end(&self) -> usize {
        let rest = &self.bytes[self.position..];
        self.position + memchr::memchr2(b'\n', b'\r', rest).unwrap_or(rest.len())
    }

    /// Reads the next word, on whatever line it is, by `parse`.
    ///
    /// `expected` names such a word, article included, for the error if there is none.
    #[inline]
    pub(super) fn read<T>(
        &mut self,
        expected: &str,
        parse: impl FnOnce(&[u8]) -> Option<T>,
    ) -> Result<T, MeshError> {
        let word = self.next_word().ok_or_else(|| truncated(expected))?;
        parse(word).ok_or_else(|| self.unexpected(expected))
    }

    /// Reads the next word of the current line by `parse`, as [`Tokens::read`] does.
    #[inline]
    pub(super) fn read_in_line<T>(
        &mut self,
        expected: &str,
        parse: impl FnOnce(&[u8]) -> Option<T>,
    ) -> Result<T, MeshError> {
        match self.next_in_line() {
            Some(word) => parse(word).ok_or_else(|| self.unexpected(expected)),
            None if self.position == self.bytes.len() => Err(truncated(expected)),
            None => Err(self.malformed(format!("{LINE_ENDS} {expected}"))),
        }
    }

    /// Makes the error that the current word is not what was expected.
    #[cold]
    pub(super) fn unexpected(&self, expected: &str) -> MeshError {
        const SHOWN: usize = 40;
        let word = &self.bytes[self.start..self.position];
        let shown = String::from_utf8_lossy(&word[..word.len().min(SHOWN)]);
        let dots = if word.len() > SHOWN { "..." } else { "" };
        let comma = decimal_comma(word);
        self.malformed(format!("'{}{dots}' is not {expected}{comma}", shown.escape_debug()))
    }

    /// Returns the error that the file ends within the current word, if that is the beginning of
    /// `whole` in letters of either case.
    pub(super) fn cut_off_within(&self, whole: &str) -> Option<MeshError> {
        let word = &self.bytes[self.start..self.position];
        let start = whole.as_bytes().get(..word.len()).filter(|_| word.len() < whole.len())?;
        let is_cut_off =
            !word.is_empty() && self.rest().is_empty() && start.eq_ignore_ascii_case(word);
        is_cut_off.then(|| truncated(format_args!("the end of the word '{whole}'")))
    }

    /// Makes the error that something is wrong with the line of the current word.
    #[cold]
    pub(super) fn malformed(&self, problem: impl Into<String>) -> MeshError {
        let line = 1 + line_ends::count(&self.bytes[..self.start]);
        MeshError::malformed(Place::Line(line), problem)
    }

    /// Returns the end of the current word, in bytes from the beginning.
    pub(super) fn position(&self) -> usize {
        self.position
    }

    /// Returns everything behind the current word.
    pub(super) fn rest(&self) -> &'a [u8] {
        &self.bytes[self.position..]
    }
}

fn is_line_end(byte: u8) -> bool {
    matches!(byte, b'\n' | b'\r')
}

/// Parses a number in decimal notation, or an infinity, or NaN.
pub(super) fn float(word: &[u8]) -> Option<f64> {
    fast_float2::parse(word).ok()
}

/// Parses a vertex index: an integer from 0 that fits 32 bits.
pub(super) fn index(word: &[u8]) -> Option<u32> {
    count(word)?.try_into().ok()
}

/// Parses an integer from 0 that fits the address space.
pub(super) fn count(word: &[u8]) -> Option<usize> {
    let digits = word.strip_prefix(b"+").unwrap_or(word);
    if digits.is_empty() {
        return None;
    }
    digits.iter().try_fold(0_usize, |value, byte| {
        let digit = byte.wrapping_sub(b'0');
        if digit > 9 {
            return None;
        }
        value.checked_mul(10)?.checked_add(digit.into())
    })
}

/// Returns what to add to the complaint about a word that is a number but for its decimal comma.
pub(super) fn decimal_comma(word: &[u8]) -> &'static str {
    let point = |&byte: &u8| if byte == b',' { b'.' } else { byte };
    let is_number =
        word.contains(&b',') && float(&word.iter().map(point).collect::<Vec<_>>()).is_some();
    if is_number { ": it has a decimal comma for a point" } else { "" }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words<'a>(mut tokens: Tokens<'a>) -> Vec<&'a str> {
        std::iter::from_fn(|| tokens.next_word())
            .map(|word| str::from_utf8(word).unwrap())
            .collect()
    }

    #[test]
    fn words_end_at_white_space_and_comments() {
        let text = b"# one\r\n two\tthree # four\r\n\r\n#\nfive\r# six\r1.#INF";
        assert_eq!(words(Tokens::with_comments(text)), ["two", "three", "five", "1.#INF"]);
        assert_eq!(words(Tokens::new(b"\xef\xbb\xbfOFF")), ["OFF"]);
        assert_eq!(words(Tokens::new(b" a #b\n")), ["a", "#b"]);
        assert_eq!(words(Tokens::new(b" \r\n ")), [""; 0]);
    }

    #[test]
    fn a_line_keeps_its_words_to_itself() {
        let mut tokens = Tokens::with_comments(b"a b # c\r\n\nd");
        assert_eq!(tokens.next_in_line(), Some(&b"a"[..]));
        assert_eq!(tokens.next_in_line(), Some(&b"b"[..]));
        assert_eq!(tokens.next_in_line(), None);
        assert_eq!(tokens.next_in_line(), None);
        tokens.skip_line();
        assert_eq!(tokens.next_in_line(), None);
        tokens.skip_line();
        assert_eq!(tokens.next_in_line(), Some(&b"d"[..]));
        tokens.skip_line();
        assert_eq!((tokens.next_word(), tokens.rest()), (None, &b""[..]));
    }

    #[test]
    fn errors_name_word_and_line() {
        let mut tokens = Tokens::new(b"1\n\n x\n\n");
        assert_eq!(tokens.read("a count", count).unwrap(), 1);
        let error = tokens.read("a count", count).unwrap_err();
        assert_eq!(error.to_string(), "line 3: 'x' is not a count");
        let error = tokens.read_in_line("a count", count).unwrap_err();
        assert_eq!(error.to_string(), "line 3: the line ends before a count");
        let error = tokens.read("a count", count).unwrap_err();
        assert_eq!(error.to_string(), "the file ends before a count");
    }

    #[test]
    fn numbers_are_whole_words() {
        assert_eq!(index(b"4294967295"), Some(u32::MAX));
        for word in [&b"4294967296"[..], b"-1", b"", b"+", b"1x", b"1.0", b":"] {
            assert_eq!(index(word), None, "{}", word.escape_ascii());
        }
        assert_eq!(count(b"99999999999999999999999999"), None);
        assert_eq!(float(b"+1.5e3"), Some(1500.0));
        assert!(float(b"nan").is_some_and(f64::is_nan));
        for word in [&b""[..], b".", b"1.5x", b"1,5", b"0x1"] {
            assert_eq!(float(word), None, "{}", word.escape_ascii());
        }
    }
}
