//! Many short texts in one block of memory.

use std::iter::FusedIterator;

/// A list of short texts in one block of memory. 8 bytes a text beyond its own.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct TextList {
    bytes: Vec<u8>,
    ends: Vec<usize>,
}

impl TextList {
    /// Returns the number of texts.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Returns whether there is no text.
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// Returns the text at `index`, or `None` if there are not so many.
    pub fn get(&self, index: usize) -> Option<&[u8]> {
        let end = *self.ends.get(index)?;
        let start = if index == 0 { 0 } else { self.ends[index - 1] };
        Some(&self.bytes[start..end])
    }

    /// Appends a text.
    pub fn push(&mut self, text: &[u8]) {
        self.bytes.extend_from_slice(text);
        self.ends.push(self.bytes.len());
    }

    /// Appends all texts of another list.
    #[cfg(feature = "files")]
    pub(super) fn append(&mut self, other: &Self) {
        let before = self.bytes.len();
        self.bytes.extend_from_slice(&other.bytes);
        self.ends.extend(other.ends.iter().map(|end| before + end));
    }

    /// Iterates over all texts in order.
    pub fn iter(&self) -> TextListIter<'_> {
        TextListIter { bytes: &self.bytes, start: 0, ends: self.ends.iter() }
    }
}

impl<'a> IntoIterator for &'a TextList {
    type Item = &'a [u8];
    type IntoIter = TextListIter<'a>;

    fn into_iter(self) -> TextListIter<'a> {
        self.iter()
    }
}

impl<T: AsRef<[u8]>> Extend<T> for TextList {
    fn extend<Texts: IntoIterator<Item = T>>(&mut self, texts: Texts) {
        texts.into_iter().for_each(|text| self.push(text.as_ref()));
    }
}

impl<T: AsRef<[u8]>> FromIterator<T> for TextList {
    fn from_iter<Texts: IntoIterator<Item = T>>(texts: Texts) -> Self {
        let mut collected = Self::default();
        collected.extend(texts);
        collected
    }
}

/// Iterator over texts in order.
#[derive(Clone, Debug)]
pub struct TextListIter<'a> {
    bytes: &'a [u8],
    /// Beginning of the next text in `bytes`.
    start: usize,
    ends: std::slice::Iter<'a, usize>,
}

impl<'a> Iterator for TextListIter<'a> {
    type Item = &'a [u8];

    fn next(&mut self) -> Option<&'a [u8]> {
        let end = *self.ends.next()?;
        let start = std::mem::replace(&mut self.start, end);
        Some(&self.bytes[start..end])
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.ends.size_hint()
    }
}

impl ExactSizeIterator for TextListIter<'_> {}

impl FusedIterator for TextListIter<'_> {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_come_back_in_order() {
        let texts = ["0 1", "", "2"];
        let list = TextList::from_iter(texts);
        assert_eq!((list.len(), list.iter().len()), (3, 3));
        assert!(list.iter().eq(texts.map(str::as_bytes)));
        assert!((0..3).map(|i| list.get(i)).eq(texts.map(|text| Some(text.as_bytes()))));
        assert_eq!(list.get(3), None);
    }
}
