//! The global dictionary of Schipper's algorithm: vertices ordered by degree.

use crate::triangulation::{IdVec, VertexId};

/// Vertices ordered by degree, and by id where degrees are equal: a binary heap in an array, with
/// the place of each vertex in it. O(log n) an operation; 12 bytes a vertex.
#[derive(Debug)]
pub(super) struct DegreeQueue {
    /// Degree and id, in heap order: no entry is less than its parent, that of `i` at `(i - 1) /
    /// 2`.
    heap: Vec<(u32, VertexId)>,
    /// Place of each vertex in the heap, or [`ABSENT`].
    place: IdVec<VertexId, u32>,
}

const ABSENT: u32 = u32::MAX;

impl DegreeQueue {
    /// Makes a queue of `entries`, pairs of degree and id, where ids are below `vertices`. O(n).
    pub(super) fn new(entries: Vec<(u32, VertexId)>, vertices: usize) -> Self {
        let mut queue = Self { heap: entries, place: IdVec::filled(ABSENT, vertices) };
        for i in 0..queue.heap.len() {
            queue.place[queue.heap[i].1] = i as u32;
        }
        for i in (0..queue.heap.len() / 2).rev() {
            queue.sink(i);
        }
        queue
    }

    /// Returns a vertex of least degree.
    pub(super) fn first(&self) -> Option<VertexId> {
        self.heap.first().map(|&(_, v)| v)
    }

    /// Removes `v`, which must be in the queue.
    pub(super) fn remove(&mut self, v: VertexId) {
        let i = self.place[v] as usize;
        self.place[v] = ABSENT;
        let last = self.heap.pop().expect("the vertex is in");
        if i < self.heap.len() {
            self.heap[i] = last;
            self.restore(i);
        }
    }

    /// Changes the degree of `v`, if it is in the queue.
    pub(super) fn update(&mut self, v: VertexId, degree: u32) {
        let i = self.place[v];
        if i != ABSENT {
            self.heap[i as usize].0 = degree;
            self.restore(i as usize);
        }
    }

    /// Moves entry `i` up or down to its place.
    fn restore(&mut self, i: usize) {
        if i > 0 && self.heap[i] < self.heap[(i - 1) / 2] {
            self.rise(i);
        } else {
            self.sink(i);
        }
    }

    fn rise(&mut self, mut i: usize) {
        let entry = self.heap[i];
        while i > 0 && entry < self.heap[(i - 1) / 2] {
            self.put(i, self.heap[(i - 1) / 2]);
            i = (i - 1) / 2;
        }
        self.put(i, entry);
    }

    fn sink(&mut self, mut i: usize) {
        let entry = self.heap[i];
        while let Some(&left) = self.heap.get(2 * i + 1) {
            let right = self.heap.get(2 * i + 2).filter(|&&right| right < left);
            let (child, lesser) = right.map_or((2 * i + 1, left), |&right| (2 * i + 2, right));
            if entry <= lesser {
                break;
            }
            self.put(i, lesser);
            i = child;
        }
        self.put(i, entry);
    }

    fn put(&mut self, i: usize, entry: (u32, VertexId)) {
        self.heap[i] = entry;
        self.place[entry.1] = i as u32;
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::random::Random;

    #[test]
    fn it_agrees_with_an_ordered_set() {
        const VERTICES: u32 = 200;
        let mut random = Random::stream(1, &["degree-queue"]);
        let degrees: Vec<u32> = (0..VERTICES).map(|_| random.below(9)).collect();
        let id = |v: u32| VertexId::new(v as usize);
        let mut entries: Vec<_> = (0..VERTICES).map(|v| (degrees[v as usize], id(v))).collect();
        random.shuffle(&mut entries);
        let mut set: BTreeSet<_> = entries.iter().copied().collect();
        let mut queue = DegreeQueue::new(entries, VERTICES as usize);
        while let Some(&first) = set.first() {
            assert_eq!(queue.first(), Some(first.1));
            for _ in 0..3 {
                let (v, degree) = (id(random.below(VERTICES)), random.below(12));
                queue.update(v, degree);
                let old = set.iter().find(|entry| entry.1 == v).copied();
                if let Some(old) = old {
                    set.remove(&old);
                    set.insert((degree, v));
                }
            }
            let &(_, gone) = set.iter().nth(random.below(set.len() as u32) as usize).unwrap();
            queue.remove(gone);
            set.retain(|entry| entry.1 != gone);
        }
        assert_eq!(queue.first(), None);
    }
}
