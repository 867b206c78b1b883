//! The name that was probably meant.

use std::cmp::Reverse;

/// Returns the one of `known` that shares the most words with `name`, however they are ordered;
/// where none shares any, the one that is but a slip away. `None` if none is near.
///
/// Letters of either case are the same. Words of up to four letters differ at their end at most. Of
/// several, the one with the fewest other words is taken, then the one that takes the fewest edits.
/// O(known · letters²).
///
/// ```
/// use triquad_lab::nearest::likely;
///
/// assert_eq!(likely("Total Time", ["mesh", "total_seconds"]), Some("total_seconds"));
/// assert_eq!(likely("BEST", ["best", "tq"]), Some("best"));
/// ```
pub fn likely<'n>(name: &str, known: impl IntoIterator<Item = &'n str> + Clone) -> Option<&'n str> {
    let words = words_of(name);
    // Each word of the other name stands for one of this.
    let shared = |other: &str| {
        let mut others = words_of(other);
        let all = others.len();
        for word in &words {
            if let Some(at) = others.iter().position(|other| is_same_word(word, other)) {
                others.remove(at);
            }
        }
        (all - others.len(), all)
    };
    let near = known.clone().into_iter().filter(|other| shared(other).0 > 0);
    let best = near.min_by_key(|other| {
        let (count, all) = shared(other);
        (Reverse(count), all, edits(name, other))
    });
    best.or_else(|| slip_of(name, known))
}

/// Returns the one of `known` that takes the fewest edits to become `name`, if at most a third of
/// the letters of `name` are slips. O(known · letters²).
///
/// ```
/// assert_eq!(triquad_lab::nearest::slip_of("botjo", ["botijo", "eros"]), Some("botijo"));
/// ```
pub fn slip_of<'n>(name: &str, known: impl IntoIterator<Item = &'n str>) -> Option<&'n str> {
    let nearest = known.into_iter().min_by_key(|other| edits(name, other))?;
    is_slip(name, nearest).then_some(nearest)
}

/// Returns the words of a name, in small letters: `Total_Seconds` has `total` and `seconds`.
fn words_of(name: &str) -> Vec<String> {
    let parts = name.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    parts.map(str::to_lowercase).collect()
}

fn is_slip(name: &str, other: &str) -> bool {
    3 * edits(name, other) <= name.chars().count()
}

/// Returns whether a word may stand for another: the same but for slips. A short word that begins
/// or goes on otherwise is another word: `lone` is not `one`, and `real` is not `read`.
fn is_same_word(word: &str, other: &str) -> bool {
    const SHORT: usize = 4;
    let differs_at_end = || word.starts_with(other) || other.starts_with(word);
    is_slip(word, other) && (word.chars().count() > SHORT || differs_at_end())
}

fn edits(name: &str, other: &str) -> usize {
    strsim::damerau_levenshtein(&name.to_lowercase(), &other.to_lowercase())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slip_is_known_and_what_is_far_is_not() {
        let known = ["mesh", "total_seconds", "pairing_seconds"];
        assert_eq!(slip_of("Meshs", known), Some("mesh"));
        assert_eq!(slip_of("totalseconds", known), Some("total_seconds"));
        assert_eq!(slip_of("pairing_second", known), Some("pairing_seconds"));
        assert_eq!(slip_of("mytorus", known), None);
        assert_eq!(slip_of("x", []), None);
    }

    #[test]
    fn words_count_more_than_letters_whatever_their_order() {
        let known = [
            "mesh",
            "seed",
            "seconds",
            "total_seconds",
            "triangles",
            "unpaired_triangles",
            "result_triangles",
            "edge_flips",
            "peak_memory_bytes",
            "read_seconds",
            "quality_one_percent",
        ];
        let likely = |name| likely(name, known);
        assert_eq!(likely("unpaired"), Some("unpaired_triangles"));
        assert_eq!(likely("seconds_total"), Some("total_seconds"));
        assert_eq!(likely("Total Time"), Some("total_seconds"));
        assert_eq!(likely("num-triangles"), Some("triangles"));
        assert_eq!(likely("memory"), Some("peak_memory_bytes"));
        assert_eq!(likely("flips"), Some("edge_flips"));
        assert_eq!(likely("totalseconds"), Some("total_seconds"));
        assert_eq!(likely("num_triangle"), Some("triangles"));
        assert_eq!(likely("flip_count"), Some("edge_flips"));
        for far in ["time", "graph", "nodes", "lone", "real", "x", ""] {
            assert_eq!(likely(far), None, "{far}");
        }
    }

    #[test]
    fn a_word_counts_once() {
        let tables = ["4.1", "4.2", "4.4(i)", "4.4(ii)"];
        assert_eq!(likely("4.4(iii)", tables), Some("4.4(ii)"));
        assert_eq!(likely("4.4(xi)", tables), Some("4.4(i)"));
        assert_eq!(likely("4.0", tables), Some("4.1"));
    }
}
