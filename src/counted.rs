//! Numbers of things in words.

// Hidden: it is public for the messages of the lab and the command, and may change in any release.
#![doc(hidden)]

use std::fmt::Display;

/// Returns the number with the word that it takes.
///
/// ```
/// assert_eq!(triquad::counted::counted(1, "quad", "quads"), "1 quad");
/// ```
pub fn counted(count: usize, one: impl Display, many: impl Display) -> String {
    if count == 1 { format!("1 {one}") } else { format!("{count} {many}") }
}

/// Returns the words of a list.
///
/// ```
/// let words = ["1", "2", "3"].map(String::from);
/// assert_eq!(triquad::counted::listed(&words), "1, 2 and 3");
/// ```
pub fn listed(words: &[String]) -> String {
    match words {
        [] => String::new(),
        [one] => one.clone(),
        [before @ .., last] => format!("{} and {last}", before.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_takes_the_singular_and_nothing_the_plural() {
        let quads = [0, 1, 2].map(|count| counted(count, "quad", "quads"));
        assert_eq!(quads, ["0 quads", "1 quad", "2 quads"]);
    }

    #[test]
    fn the_last_of_a_list_has_no_comma() {
        let words = ["1", "2", "3"].map(String::from);
        let lists = [0, 1, 2, 3].map(|length| listed(&words[..length]));
        assert_eq!(lists, ["", "1", "1 and 2", "1, 2 and 3"]);
    }
}
