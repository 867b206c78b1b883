//! Counts of an augmentation.

/// Counts of one augmentation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct AugmentationStats {
    /// Number of augmenting paths.
    pub paths: usize,
    /// Sum of the lengths of the paths; a path's length is its number of dual edges, at least 1.
    pub total_length: usize,
    /// Length of the longest path.
    pub longest: usize,
    /// Triangles that entered a search tree, once for every time that they did; and all of them
    /// once if `local` gave its search up.
    pub triangles_visited: usize,
}

impl AugmentationStats {
    /// Returns the mean length of a path in dual edges; 0 without paths.
    pub fn mean_length(&self) -> f64 {
        if self.paths == 0 { 0.0 } else { self.total_length as f64 / self.paths as f64 }
    }

    /// Counts a path of `length` edges.
    pub(super) fn add_path(&mut self, length: usize) {
        self.paths += 1;
        self.total_length += length;
        self.longest = self.longest.max(length);
    }
}
