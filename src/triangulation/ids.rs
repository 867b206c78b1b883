//! Typed 32-bit indices and arrays indexed by them.

use std::fmt;
use std::marker::PhantomData;
use std::ops::{Index, IndexMut};
use std::str::FromStr;

/// An index of one kind of element, for arrays that are generic in it.
pub trait Id: Copy + Eq + Ord + fmt::Debug {
    /// Returns the element with position `index`.
    fn new(index: usize) -> Self;
    /// Returns the position in arrays over all elements of the kind.
    fn index(self) -> usize;
}

/// Text or a number that is no id: ids are whole numbers from 0 to 2^32 - 2.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0:?} is no id; ids are whole numbers from 0 to 4294967294")]
pub struct ParseIdError(String);

macro_rules! id {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, bytemuck::Zeroable)]
        #[cfg_attr(
            feature = "serde",
            derive(serde::Serialize, serde::Deserialize),
            serde(into = "u32", try_from = "u32")
        )]
        #[repr(transparent)]
        pub struct $name(pub(crate) u32);

        impl $name {
            /// Stands for "no element" in arrays; never indexes anything.
            pub(crate) const NONE: Self = Self(u32::MAX);

            /// Returns the element with position `index`.
            ///
            /// # Panics
            /// In debug builds, if `index` exceeds 2^32 - 2.
            #[inline]
            pub const fn new(index: usize) -> Self {
                debug_assert!(index < u32::MAX as usize);
                Self(index as u32)
            }

            /// Returns the position in arrays over all elements of the kind.
            #[inline]
            pub const fn index(self) -> usize {
                self.0 as usize
            }

            /// Returns the element, or `None` for [`Self::NONE`].
            #[inline]
            pub(crate) fn some(self) -> Option<Self> {
                (self != Self::NONE).then_some(self)
            }
        }

        impl Id for $name {
            #[inline]
            fn new(index: usize) -> Self {
                Self::new(index)
            }
            #[inline]
            fn index(self) -> usize {
                self.index()
            }
        }

        impl From<$name> for u32 {
            fn from(id: $name) -> Self {
                id.0
            }
        }

        impl TryFrom<u32> for $name {
            type Error = ParseIdError;

            fn try_from(index: u32) -> Result<Self, ParseIdError> {
                Self(index).some().ok_or_else(|| ParseIdError(index.to_string()))
            }
        }

        impl fmt::Display for $name {
            /// Writes the position, counted from 0.
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                self.0.fmt(f)
            }
        }

        impl FromStr for $name {
            type Err = ParseIdError;

            fn from_str(text: &str) -> Result<Self, ParseIdError> {
                let index = text.parse().ok().and_then(|index: u32| Self::try_from(index).ok());
                index.ok_or_else(|| ParseIdError(text.to_owned()))
            }
        }
    };
}

id!(
    /// A vertex: its position in the file, from 0.
    VertexId
);
id!(
    /// A triangle: its position in the file, from 0.
    TriangleId
);
id!(
    /// One side of an edge. Triangle `f` owns sides `3f`, `3f + 1`, `3f + 2`, counter-clockwise.
    HalfEdgeId
);

impl HalfEdgeId {
    /// Returns the next side of the same triangle, counter-clockwise.
    pub fn next(self) -> Self {
        Self(if self.0 % 3 == 2 { self.0 - 2 } else { self.0 + 1 })
    }

    /// Returns the previous side of the same triangle.
    pub fn prev(self) -> Self {
        Self(if self.0.is_multiple_of(3) { self.0 + 2 } else { self.0 - 1 })
    }

    /// Returns the triangle that owns the side.
    pub fn triangle(self) -> TriangleId {
        TriangleId(self.0 / 3)
    }
}

impl TriangleId {
    /// Returns the three sides, counter-clockwise.
    pub fn half_edges(self) -> [HalfEdgeId; 3] {
        [HalfEdgeId(3 * self.0), HalfEdgeId(3 * self.0 + 1), HalfEdgeId(3 * self.0 + 2)]
    }
}

/// A vector indexed by one kind of id.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct IdVec<I, T> {
    items: Vec<T>,
    id: PhantomData<fn(I)>,
}

impl<I: Id, T> IdVec<I, T> {
    /// Makes a vector that holds `value` for each of `len` elements. O(n).
    pub fn filled(value: T, len: usize) -> Self
    where
        T: Clone,
    {
        vec![value; len].into()
    }

    /// Returns the number of elements.
    pub fn len(&self) -> usize {
        self.items.len()
    }

    /// Returns whether there is no element.
    pub fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    /// Returns the values in order of ids.
    pub fn as_slice(&self) -> &[T] {
        &self.items
    }

    /// Iterates over all ids in order.
    pub fn ids(&self) -> impl ExactSizeIterator<Item = I> + DoubleEndedIterator + use<I, T> {
        (0..self.items.len()).map(I::new)
    }
}

impl<I, T> From<Vec<T>> for IdVec<I, T> {
    fn from(items: Vec<T>) -> Self {
        Self { items, id: PhantomData }
    }
}

impl<I, T> FromIterator<T> for IdVec<I, T> {
    fn from_iter<Items: IntoIterator<Item = T>>(items: Items) -> Self {
        Vec::from_iter(items).into()
    }
}

impl<I, T> IntoIterator for IdVec<I, T> {
    type Item = T;
    type IntoIter = std::vec::IntoIter<T>;

    fn into_iter(self) -> Self::IntoIter {
        self.items.into_iter()
    }
}

impl<'a, I, T> IntoIterator for &'a IdVec<I, T> {
    type Item = &'a T;
    type IntoIter = std::slice::Iter<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.items.iter()
    }
}

impl<I: Id, T> Index<I> for IdVec<I, T> {
    type Output = T;
    #[inline]
    fn index(&self, id: I) -> &T {
        &self.items[id.index()]
    }
}

impl<I: Id, T> IndexMut<I> for IdVec<I, T> {
    #[inline]
    fn index_mut(&mut self, id: I) -> &mut T {
        &mut self.items[id.index()]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_are_read_back_as_they_are_written() {
        for index in [0, 1, 41, u32::MAX as usize - 1] {
            assert_eq!(VertexId::new(index).to_string().parse(), Ok(VertexId::new(index)));
            assert_eq!(HalfEdgeId::try_from(index as u32), Ok(HalfEdgeId::new(index)));
        }
        for text in ["", "-1", "1.0", "4294967295", "4294967296", "v1"] {
            assert_eq!(text.parse::<TriangleId>(), Err(ParseIdError(text.to_owned())));
        }
        assert!(TriangleId::try_from(u32::MAX).is_err());
    }

    #[cfg(feature = "serde")]
    #[test]
    fn ids_are_numbers_in_json() {
        assert_eq!(serde_json::to_string(&VertexId::new(7)).unwrap(), "7");
        assert_eq!(serde_json::from_str::<VertexId>("7").unwrap(), VertexId::new(7));
        assert!(serde_json::from_str::<VertexId>("4294967295").is_err());
    }

    #[test]
    fn vectors_are_collected_and_walked_through_in_the_order_of_ids() {
        let squares: IdVec<VertexId, _> = (0..4).map(|i| i * i).collect();
        assert_eq!(squares[VertexId::new(3)], 9);
        assert!((&squares).into_iter().eq(&[0, 1, 4, 9]));
        assert!(squares.into_iter().eq([0, 1, 4, 9]));
    }
}
