//! Words, numbers and indices of a line.

use crate::mesh::error::{MeshError, Place};
use crate::mesh::tokens::decimal_comma;

/// A defect of a line. Boxed, so that results without one fit in registers.
pub(super) struct Fault(Box<Problem>);

enum Problem {
    Malformed(String),
    TooLarge,
}

impl Fault {
    pub(super) fn too_large() -> Self {
        Self(Box::new(Problem::TooLarge))
    }

    pub(super) fn at(self, line: usize) -> MeshError {
        match *self.0 {
            Problem::Malformed(problem) => MeshError::malformed(Place::Line(line), problem),
            Problem::TooLarge => MeshError::TooLarge,
        }
    }
}

impl From<String> for Fault {
    #[cold]
    fn from(problem: String) -> Self {
        Self(Box::new(Problem::Malformed(problem)))
    }
}

impl From<&str> for Fault {
    #[cold]
    fn from(problem: &str) -> Self {
        problem.to_owned().into()
    }
}

/// The unread rest of the text.
pub(super) struct Cursor<'t> {
    pub(super) rest: &'t [u8],
}

impl<'t> Cursor<'t> {
    /// Skips the mark with which some programs begin a UTF-8 text: it would hide the first keyword.
    pub(super) fn skip_byte_order_mark(&mut self) {
        self.rest = self.rest.strip_prefix(b"\xef\xbb\xbf").unwrap_or(self.rest);
    }

    #[inline]
    pub(super) fn skip_blanks(&mut self) {
        while let [b' ' | b'\t' | b'\r', rest @ ..] = self.rest {
            self.rest = rest;
        }
    }

    /// Returns whether only a comment is left of the line, or nothing.
    #[inline]
    pub(super) fn at_end(&self) -> bool {
        matches!(self.rest, [] | [b'\n' | b'#', ..])
    }

    /// Returns what is left of the line.
    pub(super) fn line(&self) -> &'t [u8] {
        &self.rest[..memchr::memchr(b'\n', self.rest).unwrap_or(self.rest.len())]
    }

    #[inline]
    pub(super) fn skip_line(&mut self) {
        self.rest = match self.rest {
            [b'\n', rest @ ..] => rest,
            rest => rest.get(self.line().len() + 1..).unwrap_or_default(),
        };
    }

    #[inline]
    pub(super) fn take(&mut self, byte: u8) -> bool {
        let found = self.rest.first() == Some(&byte);
        if found {
            self.rest = &self.rest[1..];
        }
        found
    }

    /// Returns whether an index is omitted here: another slash follows, or the word ends.
    #[inline]
    pub(super) fn is_omitted(&self) -> bool {
        matches!(self.rest, [] | [b'/' | b' ' | b'\t' | b'\r' | b'\n', ..])
    }

    #[inline]
    pub(super) fn end_of_word(&self) -> Result<(), Fault> {
        match self.rest {
            [] | [b' ' | b'\t' | b'\r' | b'\n', ..] => Ok(()),
            _ => Err(format!("unexpected '{}' in a face", word(self.rest)).into()),
        }
    }

    #[inline]
    pub(super) fn number(&mut self) -> Result<f64, Fault> {
        self.skip_blanks();
        if self.at_end() {
            return Err("a vertex needs three coordinates".into());
        }
        let (value, length) =
            fast_float2::parse_partial(self.rest).map_err(|_| no_number(self.rest))?;
        match self.rest[length..] {
            [] | [b' ' | b'\t' | b'\r' | b'\n', ..] => {
                self.rest = &self.rest[length..];
                Ok(value)
            }
            _ => Err(no_number(self.rest)),
        }
    }

    /// Reads a whole number of at most ten digits, with or without a minus sign.
    #[inline]
    pub(super) fn integer(&mut self) -> Result<i64, Fault> {
        let start = self.rest;
        let negative = self.take(b'-');
        let (mut value, mut digits) = leading_digits(self.rest);
        self.rest = &self.rest[digits..];
        while let [digit @ b'0'..=b'9', rest @ ..] = self.rest
            && digits < 11
        {
            value = value * 10 + i64::from(digit - b'0');
            digits += 1;
            self.rest = rest;
        }
        match digits {
            1..=10 => Ok(if negative { -value } else { value }),
            _ => Err(format!("'{}' is not an index", word(start)).into()),
        }
    }
}

/// Returns the value and number of the digits among the first eight bytes, up to the first other
/// byte. All eight are handled at once; there are none if the text is shorter.
#[inline]
pub(super) fn leading_digits(text: &[u8]) -> (i64, usize) {
    let Some(&bytes) = text.first_chunk::<8>() else { return (0, 0) };
    // Digits become 0 to 9; of any other byte the top bit is set in `others`.
    let word = u64::from_le_bytes(bytes) ^ 0x3030_3030_3030_3030;
    let others =
        (word | ((word & 0x7f7f_7f7f_7f7f_7f7f) + 0x7676_7676_7676_7676)) & 0x8080_8080_8080_8080;
    let digits = others.trailing_zeros() as usize / 8;
    if digits == 0 {
        return (0, 0);
    }
    // As if zeros stood in front; then neighbouring digits are joined, pairs, and fours.
    let ones = word << (64 - 8 * digits);
    let pairs = (ones.wrapping_mul(10) + (ones >> 8)) & 0x00ff_00ff_00ff_00ff;
    let fours = (pairs.wrapping_mul(100) + (pairs >> 16)) & 0x0000_ffff_0000_ffff;
    (i64::from((fours.wrapping_mul(10_000) + (fours >> 32)) as u32), digits)
}

/// Makes the complaint that `text` begins with no number.
#[cold]
fn no_number(text: &[u8]) -> Fault {
    let word = word(text);
    format!("'{word}' is not a number{}", decimal_comma(word.as_bytes())).into()
}

/// Returns the first word of `text`, shortened, for messages.
fn word(text: &[u8]) -> String {
    let end = text.iter().position(u8::is_ascii_whitespace).unwrap_or(text.len());
    String::from_utf8_lossy(&text[..end.min(40)]).into_owned()
}
