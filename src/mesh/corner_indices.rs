//! One optional index a corner, in 4 bytes.

/// Stored for a corner without an index.
const NONE: u32 = u32::MAX;

/// For every corner an index from 0 or none; empty if no corner has one. 4 bytes a corner.
///
/// ```
/// use triquad::mesh::CornerIndices;
///
/// let indices: CornerIndices = [Some(4), None, Some(0)].into_iter().collect();
/// assert_eq!((indices.get(0), indices.get(1), indices.get(9)), (Some(4), None, None));
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct CornerIndices(Vec<u32>);

impl CornerIndices {
    /// Returns the number of corners.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Returns whether no corner is listed.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Returns the index of `corner`, or `None` if it has none or does not exist.
    #[inline]
    pub fn get(&self, corner: usize) -> Option<u32> {
        self.0.get(corner).copied().and_then(stored)
    }

    /// Iterates over the indices of all corners in order.
    pub fn iter(
        &self,
    ) -> impl ExactSizeIterator<Item = Option<u32>> + DoubleEndedIterator + Clone + '_ {
        self.0.iter().map(|&index| stored(index))
    }

    /// Appends the index of the next corner.
    ///
    /// # Panics
    /// If the index is 2^32 - 1.
    pub fn push(&mut self, index: Option<u32>) {
        assert_ne!(index, Some(NONE), "an index is at most 2^32 - 2");
        self.0.push(index.unwrap_or(NONE));
    }

    /// Appends corners without index until there are `corners`.
    #[cfg(feature = "files")]
    #[inline]
    pub(super) fn pad(&mut self, corners: usize) {
        self.0.resize(corners, NONE);
    }

    /// Appends those of other corners, which begin at corner `first`.
    #[cfg(feature = "files")]
    pub(super) fn append(&mut self, first: usize, other: &Self) {
        if !other.is_empty() {
            self.pad(first);
            self.0.extend_from_slice(&other.0);
        }
    }

    /// Returns whether every corner in `range` has an index.
    #[cfg(feature = "files")]
    pub(super) fn has_all(&self, range: std::ops::Range<usize>) -> bool {
        self.0.get(range).is_some_and(|indices| !indices.contains(&NONE))
    }

    /// Takes the index from each corner where it is not below `count`; returns the number of them.
    ///
    /// Nothing is listed any more if no corner has an index then.
    #[cfg(feature = "files")]
    pub(super) fn drop_beyond(&mut self, count: usize) -> usize {
        let mut dropped = 0;
        for index in &mut self.0 {
            if *index != NONE && *index as usize >= count {
                *index = NONE;
                dropped += 1;
            }
        }
        if self.0.iter().all(|&index| index == NONE) {
            self.0 = Vec::new();
        }
        dropped
    }

    /// Returns the first corner whose index is not below `count`, with that index.
    pub(super) fn first_beyond(&self, count: usize) -> Option<(usize, u32)> {
        let beyond = |index: u32| index as usize >= count;
        self.iter()
            .enumerate()
            .find_map(|(corner, index)| Some((corner, index.filter(|&index| beyond(index))?)))
    }

    /// Reverses the corners in `range` but for the first.
    pub(super) fn reverse_after_first(&mut self, range: std::ops::Range<usize>) {
        if !self.0.is_empty() {
            self.0[range][1..].reverse();
        }
    }

    /// Returns the index of each corner of `sources`; none at all if there are none here.
    pub(crate) fn gather(&self, sources: impl Iterator<Item = usize>) -> Self {
        match self.0[..] {
            [] => Self::default(),
            _ => sources.map(|corner| self.get(corner)).collect(),
        }
    }
}

fn stored(index: u32) -> Option<u32> {
    (index != NONE).then_some(index)
}

impl Extend<Option<u32>> for CornerIndices {
    fn extend<T: IntoIterator<Item = Option<u32>>>(&mut self, indices: T) {
        let indices = indices.into_iter();
        self.0.reserve(indices.size_hint().0);
        indices.for_each(|index| self.push(index));
    }
}

impl FromIterator<Option<u32>> for CornerIndices {
    fn from_iter<T: IntoIterator<Item = Option<u32>>>(indices: T) -> Self {
        let mut collected = Self::default();
        collected.extend(indices);
        collected
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn indices_are_read_back_as_they_were_given() {
        let given = [None, Some(0), Some(NONE - 1), None];
        let mut indices = CornerIndices::from_iter(given);
        assert!(indices.iter().eq(given));
        assert_eq!(indices.first_beyond(1), Some((2, NONE - 1)));
        assert_eq!(indices.first_beyond(NONE as usize), None);
        indices.reverse_after_first(1..4);
        assert!(indices.iter().eq([None, Some(0), None, Some(NONE - 1)]));
        assert!(indices.gather([3, 0].into_iter()).iter().eq([Some(NONE - 1), None]));
        assert!(CornerIndices::default().gather([3, 0].into_iter()).is_empty());
    }

    #[test]
    #[should_panic(expected = "at most")]
    fn the_largest_number_is_no_index() {
        CornerIndices::default().push(Some(NONE));
    }
}
