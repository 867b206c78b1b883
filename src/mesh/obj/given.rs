//! Elements of an OBJ file that indices count.

use std::ops::Add;

/// Numbers of vertices, texture coordinates and normals.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Given {
    pub(super) vertices: usize,
    pub(super) texture: usize,
    pub(super) normals: usize,
}

impl Given {
    /// Counts the elements that whole lines give, by their keywords.
    ///
    /// Unusual white space hides a keyword from it, so the counts are to be compared with what is
    /// read.
    pub(super) fn count(text: &[u8]) -> Self {
        let mut given = Self::default();
        for at in memchr::memchr_iter(b'v', text) {
            let count = match text[at + 1..] {
                [b't', ..] => &mut given.texture,
                [b'n', ..] => &mut given.normals,
                [b' ' | b'\t', ..] => &mut given.vertices,
                _ => continue,
            };
            *count += usize::from(begins_line(&text[..at]));
        }
        given
    }
}

impl Add for Given {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            vertices: self.vertices + other.vertices,
            texture: self.texture + other.texture,
            normals: self.normals + other.normals,
        }
    }
}

/// Returns whether nothing but blanks comes before, in the line.
fn begins_line(before: &[u8]) -> bool {
    let mut last = before.iter().rev().skip_while(|byte| matches!(byte, b' ' | b'\t' | b'\r'));
    last.next().is_none_or(|&byte| byte == b'\n')
}
