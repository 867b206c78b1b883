//! The lists lue and lte of Ramaswami and Siqueira (section 4.1), linked through arrays.

use std::ops::{Index, IndexMut};

use crate::names::named;
use crate::prefetch::prefetch;
use crate::triangulation::{IdVec, VertexId};

/// The end of the list of untested edges at which edges that are new at u enter.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Discipline {
    /// `queue`: at the rear, as published; those to vertices of degree 3 at the front.
    #[default]
    FirstInFirstOut,
    /// `stack`: at the front. Tests more edges, and contracts in an order that suits expansion
    /// better.
    LastInFirstOut,
}

impl Discipline {
    /// Both disciplines.
    pub const ALL: [Self; 2] = [Self::FirstInFirstOut, Self::LastInFirstOut];

    /// Returns the name on the command line and in records.
    pub fn id(self) -> &'static str {
        match self {
            Self::FirstInFirstOut => "queue",
            Self::LastInFirstOut => "stack",
        }
    }
}

named!(Discipline, "order of untested edges", id);

/// One of the two lists of edges at the vertex u that is being processed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum List {
    /// lue: edges not yet tested against the link condition.
    Untested,
    /// lte: edges that failed the test.
    Tested,
}

/// Both lists, and a `T` for every vertex v that may be the other end of an edge. Edge [u, v] is
/// named by v and is in one list at most. Every operation is O(1).
///
/// The lists are rings through one bound each, kept behind the vertices, so that an edge can be
/// removed without its list being known. 8 bytes a vertex, beside the `T` because both are needed
/// at once.
#[derive(Debug)]
pub(super) struct EdgeLists<T> {
    nodes: IdVec<VertexId, ListNode<T>>,
    vertices: usize,
}

/// Aligned so that no node of the size that occurs lies across two cache lines.
#[derive(Clone, Copy, Debug, bytemuck::Zeroable)]
#[repr(align(32))]
struct ListNode<T> {
    links: Links,
    end: T,
}

#[derive(Clone, Copy, Debug, bytemuck::Zeroable)]
struct Links {
    before: VertexId,
    after: VertexId,
}

impl<T: Copy + bytemuck::Zeroable> EdgeLists<T> {
    /// Makes two empty lists of edges to any of `vertices` vertices, with a zeroed `T` for each.
    /// O(n); the system supplies zeroed memory on first use.
    pub(super) fn new(vertices: usize) -> Self {
        let mut lists = Self { nodes: bytemuck::zeroed_vec(vertices + 2).into(), vertices };
        lists.clear(List::Untested);
        lists.clear(List::Tested);
        lists
    }

    /// Prefetches the entry of `v`.
    #[inline]
    pub(super) fn prefetch(&self, v: VertexId) {
        prefetch(self.nodes.as_slice(), v.index());
    }

    /// Empties `list`.
    pub(super) fn clear(&mut self, list: List) {
        let bound = self.bound(list);
        self.nodes[bound].links = Links { before: bound, after: bound };
    }

    /// Returns the first edge of `list`.
    #[inline]
    pub(super) fn front(&self, list: List) -> Option<VertexId> {
        let bound = self.bound(list);
        let first = self.nodes[bound].links.after;
        (first != bound).then_some(first)
    }

    /// Takes the first edge out of `list`.
    #[inline]
    pub(super) fn pop_front(&mut self, list: List) -> Option<VertexId> {
        let first = self.front(list)?;
        self.remove(first);
        Some(first)
    }

    /// Puts an edge that is in no list at the front of `list`.
    #[inline]
    pub(super) fn push_front(&mut self, list: List, v: VertexId) {
        let bound = self.bound(list);
        let after = self.nodes[bound].links.after;
        self.insert(v, Links { before: bound, after });
    }

    /// Puts an edge that is in no list at the rear of `list`.
    #[inline]
    pub(super) fn push_rear(&mut self, list: List, v: VertexId) {
        let bound = self.bound(list);
        let before = self.nodes[bound].links.before;
        self.insert(v, Links { before, after: bound });
    }

    /// Puts an edge that is new at u among the untested ones, at the end that `discipline` names.
    #[inline]
    pub(super) fn enter(&mut self, v: VertexId, degree: u32, discipline: Discipline) {
        if degree == 3 || discipline == Discipline::LastInFirstOut {
            self.push_front(List::Untested, v);
        } else {
            self.push_rear(List::Untested, v);
        }
    }

    /// Takes an edge out of the list that it is in.
    #[inline]
    pub(super) fn remove(&mut self, v: VertexId) {
        let Links { before, after } = self.nodes[v].links;
        self.nodes[before].links.after = after;
        self.nodes[after].links.before = before;
    }

    /// Iterates over the edges of `list` in order.
    #[cfg(test)]
    pub(super) fn iter(&self, list: List) -> impl Iterator<Item = VertexId> {
        let bound = self.bound(list);
        let next = move |&v: &VertexId| Some(self.nodes[v].links.after);
        std::iter::successors(Some(bound), next).skip(1).take_while(move |&v| v != bound)
    }

    #[inline]
    fn insert(&mut self, v: VertexId, links: Links) {
        self.nodes[v].links = links;
        self.nodes[links.before].links.after = v;
        self.nodes[links.after].links.before = v;
    }

    #[inline]
    fn bound(&self, list: List) -> VertexId {
        VertexId::new(self.vertices + list as usize)
    }
}

impl<T> Index<VertexId> for EdgeLists<T> {
    type Output = T;
    #[inline]
    fn index(&self, v: VertexId) -> &T {
        &self.nodes[v].end
    }
}

impl<T> IndexMut<VertexId> for EdgeLists<T> {
    #[inline]
    fn index_mut(&mut self, v: VertexId) -> &mut T {
        &mut self.nodes[v].end
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn content(lists: &EdgeLists<u8>, list: List) -> Vec<usize> {
        lists.iter(list).map(VertexId::index).collect()
    }

    #[test]
    fn edges_move_from_anywhere_to_either_end() {
        let [a, b, c] = [0, 1, 2].map(VertexId::new);
        let mut lists = EdgeLists::<u8>::new(3);
        lists.push_rear(List::Untested, a);
        lists.push_rear(List::Untested, b);
        lists.push_front(List::Untested, c);
        assert_eq!(content(&lists, List::Untested), [2, 0, 1]);
        lists.remove(a);
        lists.push_front(List::Tested, a);
        assert_eq!(lists.pop_front(List::Untested), Some(c));
        lists.push_rear(List::Tested, c);
        assert_eq!(content(&lists, List::Tested), [0, 2]);
        assert_eq!(content(&lists, List::Untested), [1]);
        lists.clear(List::Tested);
        assert_eq!((lists.front(List::Tested), lists.front(List::Untested)), (None, Some(b)));
    }
}
