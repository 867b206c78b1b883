//! The global dictionary of Schipper's algorithm: vertices by degree.

use crate::random::Random;
use crate::triangulation::{IdVec, VertexId};

/// Vertices by degree, in one array for each degree. O(1) an operation, but for the search of the
/// least degree after it has grown; 12 bytes a vertex.
#[derive(Debug)]
pub(super) struct DegreeQueue {
    /// The vertices of each degree, in no order.
    buckets: Vec<Vec<VertexId>>,
    /// Place of each vertex.
    places: IdVec<VertexId, Place>,
    /// No vertex has a lesser degree.
    least: usize,
}

#[derive(Clone, Copy, Debug)]
struct Place {
    degree: u32,
    /// Index among the vertices of that degree, or [`ABSENT`].
    index: u32,
}

const ABSENT: u32 = u32::MAX;

impl DegreeQueue {
    /// Makes a queue of pairs of degree and id, where ids are below `vertices`. O(n).
    pub(super) fn new(entries: impl Iterator<Item = (u32, VertexId)>, vertices: usize) -> Self {
        let places = IdVec::filled(Place { degree: 0, index: ABSENT }, vertices);
        let mut queue = Self { buckets: Vec::new(), places, least: 0 };
        entries.for_each(|(degree, v)| queue.put(v, degree));
        queue
    }

    /// Draws one of the vertices of least degree.
    pub(super) fn draw_least(&mut self, random: &mut Random) -> Option<VertexId> {
        let from_least = self.buckets.get(self.least..)?;
        self.least += from_least.iter().position(|bucket| !bucket.is_empty())?;
        let bucket = &self.buckets[self.least];
        Some(bucket[random.below(bucket.len() as u32) as usize])
    }

    /// Removes `v`, which must be in the queue.
    pub(super) fn remove(&mut self, v: VertexId) {
        let Place { degree, index } = self.places[v];
        self.places[v].index = ABSENT;
        let bucket = &mut self.buckets[degree as usize];
        bucket.swap_remove(index as usize);
        if let Some(&moved) = bucket.get(index as usize) {
            self.places[moved].index = index;
        }
    }

    /// Changes the degree of `v`, if it is in the queue.
    pub(super) fn update(&mut self, v: VertexId, degree: u32) {
        if self.places[v].index != ABSENT {
            self.remove(v);
            self.put(v, degree);
        }
    }

    fn put(&mut self, v: VertexId, degree: u32) {
        let at = degree as usize;
        if at >= self.buckets.len() {
            self.buckets.resize_with(at + 1, Vec::new);
        }
        self.places[v] = Place { degree, index: self.buckets[at].len() as u32 };
        self.buckets[at].push(v);
        self.least = self.least.min(at);
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;

    const VERTICES: u32 = 200;

    fn id(v: u32) -> VertexId {
        VertexId::new(v as usize)
    }

    #[test]
    fn it_agrees_with_a_search_through_all_vertices() {
        let mut random = Random::stream(1, &["degree-queue"]);
        let mut degrees: BTreeMap<_, _> = (0..VERTICES).map(|v| (id(v), random.below(9))).collect();
        let entries = degrees.iter().map(|(&v, &degree)| (degree, v));
        let mut queue = DegreeQueue::new(entries, VERTICES as usize);
        while let Some(&least) = degrees.values().min() {
            let drawn = queue.draw_least(&mut random).unwrap();
            assert_eq!(degrees[&drawn], least);
            for _ in 0..3 {
                let (v, degree) = (id(random.below(VERTICES)), random.below(12));
                queue.update(v, degree);
                degrees.entry(v).and_modify(|old| *old = degree);
            }
            let at = random.below(degrees.len() as u32) as usize;
            let gone = *degrees.keys().nth(at).unwrap();
            queue.remove(gone);
            degrees.remove(&gone);
        }
        assert_eq!(queue.draw_least(&mut random), None);
    }

    #[test]
    fn vertices_of_equal_degree_are_drawn_equally_often() {
        let mut random = Random::stream(2, &["degree-queue"]);
        let mut queue = DegreeQueue::new((0..8).map(|v| (5 + v / 4, id(v))), 8);
        let mut drawn = [0; 8];
        for _ in 0..4000 {
            drawn[queue.draw_least(&mut random).unwrap().index()] += 1;
        }
        assert!(drawn[..4].iter().all(|count| (850..1150).contains(count)), "{drawn:?}");
        assert_eq!(drawn[4..], [0; 4]);
    }
}
