//! Lines of an OBJ file that hold from a face on, in little memory: a file may have one a face.

/// An `o`, `g`, `s` or `usemtl` line and the first face after it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct FaceSection<'s> {
    /// Index (from 0) of the first face that the line holds for.
    pub first_face: usize,
    /// The whole line.
    pub line: &'s str,
}

impl<'s> FaceSection<'s> {
    /// Returns the first word of the line.
    pub fn keyword(&self) -> &'s str {
        self.line.split_whitespace().next().unwrap_or_default()
    }
}

/// Lines that hold from a face on, in the order of the file. 12 bytes a line beyond its text.
///
/// ```
/// use triquad::mesh::{FaceSection, FaceSections};
///
/// let mut sections = FaceSections::default();
/// sections.push(FaceSection { first_face: 0, line: "usemtl red" });
/// sections.push(FaceSection { first_face: 4, line: "usemtl blue" });
/// assert_eq!((sections.len(), sections.count_before(4)), (2, 1));
/// assert_eq!(sections.iter().last().map(|section| section.line), Some("usemtl blue"));
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct FaceSections {
    first_faces: Vec<u32>,
    /// All lines, one after the other.
    text: String,
    /// End of each line in `text`.
    ends: Vec<usize>,
}

impl FaceSections {
    /// Returns the number of lines.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Returns whether there is no line.
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// Appends a line. Faces from 2^32 - 1 on, which no mesh has, are one.
    pub fn push(&mut self, section: FaceSection<'_>) {
        self.first_faces.push(u32::try_from(section.first_face).unwrap_or(u32::MAX));
        self.text.push_str(section.line);
        self.ends.push(self.text.len());
    }

    /// Iterates over the lines in order.
    pub fn iter(
        &self,
    ) -> impl ExactSizeIterator<Item = FaceSection<'_>> + DoubleEndedIterator + Clone {
        self.iter_from(0)
    }

    /// Iterates over the lines from the one at `first` on.
    pub(super) fn iter_from(
        &self,
        first: usize,
    ) -> impl ExactSizeIterator<Item = FaceSection<'_>> + DoubleEndedIterator + Clone {
        (first..self.len()).map(|index| {
            let start = if index == 0 { 0 } else { self.ends[index - 1] };
            let first_face = self.first_faces[index] as usize;
            FaceSection { first_face, line: &self.text[start..self.ends[index]] }
        })
    }

    /// Returns the number of lines whose first face comes before `face`, if the lines are in the
    /// order of their faces. O(log n).
    pub fn count_before(&self, face: usize) -> usize {
        self.first_faces.partition_point(|&first| (first as usize) < face)
    }

    /// Returns the same lines with other first faces, each given by the old one.
    pub(crate) fn moved(&self, to: impl Fn(usize) -> usize) -> Self {
        let Self { first_faces, text, ends } = self;
        let moved = |&first: &u32| u32::try_from(to(first as usize)).unwrap_or(u32::MAX);
        let first_faces = first_faces.iter().map(moved).collect();
        Self { first_faces, text: text.clone(), ends: ends.clone() }
    }
}

impl<'s> Extend<FaceSection<'s>> for FaceSections {
    fn extend<T: IntoIterator<Item = FaceSection<'s>>>(&mut self, sections: T) {
        sections.into_iter().for_each(|section| self.push(section));
    }
}

impl<'s> FromIterator<FaceSection<'s>> for FaceSections {
    fn from_iter<T: IntoIterator<Item = FaceSection<'s>>>(sections: T) -> Self {
        let mut collected = Self::default();
        collected.extend(sections);
        collected
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_come_back_in_order_with_their_faces() {
        let lines = [(0, "g a"), (0, ""), (3, "usemtl ü"), (usize::MAX, "s 1")];
        let section =
            |&(first_face, line): &(usize, &'static str)| FaceSection { first_face, line };
        let sections: FaceSections = lines.iter().map(section).collect();
        let found: Vec<_> = sections.iter().map(|s| (s.first_face.min(9), s.keyword())).collect();
        assert_eq!(found, [(0, "g"), (0, ""), (3, "usemtl"), (9, "s")]);
        assert!(sections.iter().map(|section| section.line).eq(lines.map(|line| line.1)));
        assert_eq!([0, 1, 3, 4].map(|face| sections.count_before(face)), [0, 2, 2, 3]);
        let moved = sections.moved(|face| 2 * face);
        assert_eq!(moved.iter().nth(2), Some(FaceSection { first_face: 6, line: "usemtl ü" }));
    }
}
