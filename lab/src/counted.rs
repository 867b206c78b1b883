//! Numbers of things in words.

use std::fmt::Display;

/// Returns the number with the word that it takes: `1 run`, `2 runs`.
pub fn counted(count: usize, one: impl Display, many: impl Display) -> String {
    if count == 1 { format!("1 {one}") } else { format!("{count} {many}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_takes_the_singular_and_nothing_the_plural() {
        let meshes = [0, 1, 2].map(|count| counted(count, "mesh", "meshes"));
        assert_eq!(meshes, ["0 meshes", "1 mesh", "2 meshes"]);
    }
}
