//! Typed 32-bit indices and arrays indexed by them.

use std::marker::PhantomData;
use std::ops::{Index, IndexMut};

/// An index of one kind of element.
pub trait Id: Copy + Eq + Ord + std::fmt::Debug {
    /// The element with position `index`.
    fn new(index: usize) -> Self;
    /// Position in arrays over all elements of the kind.
    fn index(self) -> usize;
}

macro_rules! id {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, bytemuck::Zeroable)]
        #[repr(transparent)]
        pub struct $name(pub(crate) u32);

        impl $name {
            /// Stands for "no element"; never indexes anything.
            pub const NONE: Self = Self(u32::MAX);

            /// The element, or `None` for [`Self::NONE`].
            pub fn some(self) -> Option<Self> {
                (self != Self::NONE).then_some(self)
            }
        }

        impl Id for $name {
            fn new(index: usize) -> Self {
                debug_assert!(index < u32::MAX as usize);
                Self(index as u32)
            }
            fn index(self) -> usize {
                self.0 as usize
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
    /// The next side of the same triangle, counter-clockwise.
    pub fn next(self) -> Self {
        Self(if self.0 % 3 == 2 { self.0 - 2 } else { self.0 + 1 })
    }

    /// The previous side of the same triangle.
    pub fn prev(self) -> Self {
        Self(if self.0.is_multiple_of(3) { self.0 + 2 } else { self.0 - 1 })
    }

    /// The triangle that owns the side.
    pub fn triangle(self) -> TriangleId {
        TriangleId(self.0 / 3)
    }
}

impl TriangleId {
    /// The three sides, counter-clockwise.
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
    /// `value` for each of `len` elements.
    pub fn filled(value: T, len: usize) -> Self
    where
        T: Clone,
    {
        vec![value; len].into()
    }

    /// Number of elements.
    pub fn len(&self) -> usize {
        self.items.len()
    }

    /// Whether there is no element.
    pub fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    /// The values in order of ids.
    pub fn as_slice(&self) -> &[T] {
        &self.items
    }

    /// All ids in order.
    pub fn ids(&self) -> impl ExactSizeIterator<Item = I> + DoubleEndedIterator + use<I, T> {
        (0..self.items.len()).map(I::new)
    }
}

impl<I, T> From<Vec<T>> for IdVec<I, T> {
    fn from(items: Vec<T>) -> Self {
        Self { items, id: PhantomData }
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
