//! Events of a search, by time.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::number::Number;

/// A queue of codes by time; equal times in order of codes.
pub(super) struct Queue<N: Number> {
    heap: BinaryHeap<Reverse<N::Event>>,
    /// Time from which on no event matters, because an earlier one ends the search.
    bound: N,
}

impl<N: Number> Queue<N> {
    pub(super) fn new() -> Self {
        Self { heap: BinaryHeap::new(), bound: N::GREATEST }
    }

    /// Removes all events.
    pub(super) fn clear(&mut self) {
        self.heap.clear();
        self.bound = N::GREATEST;
    }

    /// Adds an event, unless it comes too late to matter.
    #[inline]
    pub(super) fn push(&mut self, time: N, code: u32) {
        if time < self.bound {
            self.heap.push(Reverse(N::event(time, code)));
        }
    }

    /// Adds an event that will end the search for certain.
    #[inline]
    pub(super) fn push_last(&mut self, time: N, code: u32) {
        if time < self.bound {
            self.bound = time;
            self.heap.push(Reverse(N::event(time, code)));
        }
    }

    /// Returns the number of events.
    pub(super) fn len(&self) -> usize {
        self.heap.len()
    }

    /// Keeps one of each event that still matters. O(events · log events).
    pub(super) fn purge(&mut self, mut matters: impl FnMut(N, u32) -> bool) {
        let mut events = std::mem::take(&mut self.heap).into_vec();
        events.retain(|&Reverse(event)| {
            let (time, code) = N::unpack(event);
            matters(time, code)
        });
        events.sort_unstable();
        events.dedup();
        self.heap = events.into();
    }

    /// Removes the first event, if its time is this.
    pub(super) fn pop_at(&mut self, time: N) -> Option<u32> {
        let &Reverse(event) = self.heap.peek()?;
        let (first, _) = N::unpack(event);
        if first == time { self.pop().map(|(_, code)| code) } else { None }
    }

    /// Removes the first event.
    #[inline]
    pub(super) fn pop(&mut self) -> Option<(N, u32)> {
        self.heap.pop().map(|Reverse(event)| N::unpack(event))
    }
}
