//! Keywords of OBJ files: which lines go on behind a backslash, and what is left out.

/// Keywords of lines that end in a name, where a backslash may be a part of the name.
const NAMES: [&[u8]; 5] = [b"mtllib", b"usemtl", b"o", b"g", b"s"];

/// Keywords that begin a line of their own even after a name with a backslash at its end.
const STATEMENTS: [&[u8]; 12] =
    [b"v", b"vt", b"vn", b"vp", b"f", b"l", b"p", b"mtllib", b"usemtl", b"o", b"g", b"s"];

/// A line that ends in a backslash.
#[derive(Clone, Copy)]
pub(super) enum Continued {
    /// A comment ends with its line.
    Comment,
    /// A name, such as that of a folder: the line goes on if words follow that begin no statement.
    Name,
    /// Numbers and indices: the line goes on unless a statement follows.
    Numbers,
}

impl Continued {
    /// Classifies a line by its beginning.
    pub(super) fn new(line: &[u8]) -> Self {
        match first_word(line) {
            [b'#', ..] => Self::Comment,
            word if NAMES.contains(&word) => Self::Name,
            _ => Self::Numbers,
        }
    }

    /// Returns whether the line goes on with what `follows` the line break.
    pub(super) fn goes_on(self, follows: &[u8]) -> bool {
        let word = first_word(follows);
        // The keyword itself may stand before a backslash.
        let word = word.strip_suffix(b"\\").unwrap_or(word);
        match self {
            Self::Comment => false,
            _ if STATEMENTS.contains(&word) => false,
            Self::Name => word.first().is_some_and(|&first| first != b'#'),
            Self::Numbers => true,
        }
    }
}

/// Returns the first word of the line that `text` begins with; none if that is blank.
fn first_word(text: &[u8]) -> &[u8] {
    let is_blank = |byte: &u8| matches!(byte, b' ' | b'\t' | b'\r');
    let start = text.iter().position(|byte| !is_blank(byte)).unwrap_or(text.len());
    let word = &text[start..];
    &word[..word.iter().position(u8::is_ascii_whitespace).unwrap_or(word.len())]
}

/// A kind of statements that are known and not read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Unread {
    Points,
    Lines,
    Curves,
    Rendering,
}

impl Unread {
    pub(super) const ALL: [Self; 4] = [Self::Points, Self::Lines, Self::Curves, Self::Rendering];

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Points => "points",
            Self::Lines => "lines",
            Self::Curves => "curves and surfaces",
            Self::Rendering => "rendering settings",
        }
    }

    /// Returns the kind of statements with this keyword; none if that is unknown.
    pub(super) fn of(keyword: &[u8]) -> Option<Self> {
        Some(match keyword {
            b"p" => Self::Points,
            b"l" => Self::Lines,
            b"vp" | b"deg" | b"bmat" | b"step" | b"cstype" | b"curv" | b"curv2" | b"surf"
            | b"parm" | b"trim" | b"hole" | b"scrv" | b"sp" | b"end" | b"con" => Self::Curves,
            b"mg" | b"bevel" | b"c_interp" | b"d_interp" | b"lod" | b"shadow_obj"
            | b"trace_obj" | b"ctech" | b"stech" | b"maplib" | b"usemap" | b"call" | b"csh"
            | b"bsp" | b"bzp" | b"cdc" | b"cdp" | b"res" => Self::Rendering,
            _ => return None,
        })
    }
}
