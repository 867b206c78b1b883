//! The name that was probably meant.

/// Returns the one of `known` that takes the fewest edits to become `name`, letters of either case
/// being the same; `None` if there is none.
pub(crate) fn nearest<'n>(name: &str, known: impl IntoIterator<Item = &'n str>) -> Option<&'n str> {
    let name = name.to_lowercase();
    let edits = |other: &&str| strsim::damerau_levenshtein(&name, &other.to_lowercase());
    known.into_iter().min_by_key(edits)
}

/// Returns the nearest of `known` if at most a third of the letters of `name` are slips.
pub(crate) fn slip_of<'n>(name: &str, known: impl IntoIterator<Item = &'n str>) -> Option<&'n str> {
    let nearest = nearest(name, known)?;
    let edits = strsim::damerau_levenshtein(&name.to_lowercase(), &nearest.to_lowercase());
    (3 * edits <= name.chars().count()).then_some(nearest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_name_is_that_of_the_fewest_slips() {
        let known = ["mesh", "total_seconds", "pairing_seconds"];
        assert_eq!(nearest("Meshes", known), Some("mesh"));
        assert_eq!(nearest("totalseconds", known), Some("total_seconds"));
        assert_eq!(nearest("x", []), None);
        assert_eq!(slip_of("pairing_second", known), Some("pairing_seconds"));
        assert_eq!(slip_of("mytorus", known), None);
    }
}
