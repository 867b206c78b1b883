//! Line ends of all kinds: line feeds, carriage returns with a line feed, carriage returns alone.
//!
//! Carriage returns before a line feed belong to it, however many they are.

/// Returns the number of lines that end in `text`.
pub(super) fn count(text: &[u8]) -> usize {
    memchr::memchr_iter(b'\n', text).count() + lone_returns(text).count()
}

/// Replaces carriage returns that end a line by line feeds.
pub(super) fn unify(text: &mut [u8]) {
    if !has_lone_return(text) {
        return;
    }
    let lone: Vec<usize> = lone_returns(text).collect();
    lone.into_iter().for_each(|at| text[at] = b'\n');
}

/// Iterates over the carriage returns that end a line, from the last to the first.
fn lone_returns(text: &[u8]) -> impl Iterator<Item = usize> {
    let mut is_before_feed = false;
    text.iter().enumerate().rev().filter_map(move |(at, byte)| {
        is_before_feed = match byte {
            b'\n' => true,
            b'\r' => is_before_feed,
            _ => false,
        };
        (*byte == b'\r' && !is_before_feed).then_some(at)
    })
}

/// Returns whether a carriage return may end a line; without branches, as most texts have none.
fn has_lone_return(text: &[u8]) -> bool {
    let Some(first) = memchr::memchr(b'\r', text) else { return false };
    let text = &text[first..];
    let pairs = text.iter().zip(&text[1..]);
    pairs.fold(text.ends_with(b"\r"), |lone, (byte, next)| {
        lone | ((*byte == b'\r') & (*next != b'\n'))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn returns_end_lines_unless_a_line_feed_follows() {
        for (text, unified, lines) in [
            ("a\rb\r\rc", "a\nb\n\nc", 3),
            ("a\r\nb\r\r\nc\n", "a\r\nb\r\r\nc\n", 3),
            ("a\n\rb\r", "a\n\nb\n", 3),
            ("a\rb\r\n", "a\nb\r\n", 2),
            ("", "", 0),
        ] {
            assert_eq!(count(text.as_bytes()), lines, "{text:?}");
            let mut bytes = text.as_bytes().to_vec();
            unify(&mut bytes);
            assert_eq!(bytes, unified.as_bytes(), "{text:?}");
        }
    }
}
