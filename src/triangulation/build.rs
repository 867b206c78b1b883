//! From a face list to a triangulation, or to a survey of its defects.
//!
//! Linear time without hashing: corners are gathered by vertex (counting sort), and round each
//! vertex an array over all vertices remembers which half-edge leads where. A mesh that breaks a
//! law is given up at the first sign and left to the slower, exhaustive [`Survey`].

use std::ops::Range;
use std::sync::atomic::{AtomicU32, Ordering};

use super::half_edges::{Side, Triangulation};
use super::ids::{HalfEdgeId, IdVec, VertexId};
use super::laws::is_too_large;
use super::survey::Survey;
use crate::disjoint_sets::DisjointSets;
use crate::mesh::Mesh;
use crate::parallel::{collect, join, map, ranges};

impl Triangulation {
    /// Checks every law of Definition 2.2 on `list` and builds the half-edge structure.
    ///
    /// # Errors
    /// The survey of the mesh, which lists every broken law with a place.
    ///
    /// # Cost
    /// O(n) time but for the count of components, O(n log n) in the worst case and linear in
    /// practice; no hashing. 40 bytes a triangle while it runs and 24 afterwards, the list not
    /// counted.
    pub fn build(list: &Mesh) -> Result<Self, Box<Survey>> {
        try_build(list).ok_or_else(|| {
            let survey = Survey::new(list);
            assert!(!survey.violations.is_empty(), "a mesh was refused that breaks no law");
            Box::new(survey)
        })
    }

    /// Flips faces of `list` until neighbours agree, and builds like [`Triangulation::build`].
    ///
    /// # Errors
    /// As for [`Triangulation::build`]. The survey is that of `list` with its faces flipped.
    pub fn build_oriented(list: &mut Mesh) -> Result<Self, Box<Survey>> {
        match Self::build(list) {
            Err(survey) if !survey.faces_to_flip.is_empty() => {
                survey.orient(list);
                Self::build(list)
            }
            result => result,
        }
    }
}

/// Builds the triangulation, or returns `None` at the first broken law.
fn try_build(list: &Mesh) -> Option<Triangulation> {
    let corners = list.faces().corners();
    let vertices = list.positions().len();
    let sizes_fit = !corners.is_empty() && !is_too_large(vertices, corners.len());
    let triangles = list.faces().arity() == Some(3);
    let in_range = corners.iter().all(|&vertex| (vertex as usize) < vertices);
    let finite = list.positions().as_flattened().iter().all(|coordinate| coordinate.is_finite());
    if !(sizes_fit && triangles && in_range && finite) {
        return None;
    }
    let stars = Stars::gather(corners, vertices);
    let unreferenced = (0..vertices).filter(|&v| stars.of(v).is_empty()).count();
    let (sides, components) =
        join(|| find_twins(corners, &stars), || count_components(corners, vertices, unreferenced));
    Some(Triangulation { sides: sides?, vertices, unreferenced, components })
}

/// The half-edges that leave each vertex, gathered by a counting sort.
struct Stars {
    ends: Vec<u32>,
    half_edges: Vec<HalfEdgeId>,
}

impl Stars {
    fn gather(corners: &[u32], vertices: usize) -> Self {
        let ranges = ranges(vertices);
        let starts = || ranges.iter().map(|range| range.start);
        let vertex_ends: Vec<usize> = ranges.iter().map(|range| range.end).collect();
        let mut ends = vec![0u32; vertices + 1];
        let counts = split(&mut ends[1..], &vertex_ends);
        map(starts().zip(counts).collect(), |(start, counts)| count(corners, start, counts));
        for v in 1..=vertices {
            ends[v] += ends[v - 1];
        }
        let mut half_edges = collect(corners.len(), |_| HalfEdgeId::NONE);
        let slot_ends: Vec<usize> = vertex_ends.iter().map(|&v| ends[v] as usize).collect();
        let slots = split(&mut half_edges, &slot_ends);
        let cursors = split(&mut ends[..vertices], &vertex_ends);
        let parts = starts().zip(cursors).zip(slots).collect();
        map(parts, |((start, cursors), slots)| fill(corners, start, cursors, slots));
        Self { ends, half_edges }
    }

    fn of(&self, v: usize) -> &[HalfEdgeId] {
        let start = if v == 0 { 0 } else { self.ends[v - 1] };
        &self.half_edges[start as usize..self.ends[v] as usize]
    }
}

/// Cuts an array into the parts that end there.
fn split<'a, T>(mut rest: &'a mut [T], ends: &[usize]) -> Vec<&'a mut [T]> {
    let mut start = 0;
    let mut part = |&end: &usize| {
        let (part, tail) = std::mem::take(&mut rest).split_at_mut(end - start);
        (rest, start) = (tail, end);
        part
    };
    ends.iter().map(&mut part).collect()
}

/// Counts the corners at each of the vertices from `start` on.
fn count(corners: &[u32], start: usize, counts: &mut [u32]) {
    for &vertex in corners {
        if let Some(count) = counts.get_mut((vertex as usize).wrapping_sub(start)) {
            *count += 1;
        }
    }
}

/// Puts the half-edges that leave the vertices from `start` on into their slots. Each cursor is
/// moved from the first slot of its vertex to the end of the last, which is the next one's start.
fn fill(corners: &[u32], start: usize, cursors: &mut [u32], slots: &mut [HalfEdgeId]) {
    let first = cursors.first().copied().unwrap_or(0);
    for (h, &vertex) in corners.iter().enumerate() {
        if let Some(cursor) = cursors.get_mut((vertex as usize).wrapping_sub(start)) {
            slots[(*cursor - first) as usize] = HalfEdgeId::new(h);
            *cursor += 1;
        }
    }
}

/// Finds the twin of every half-edge, or `None` if the triangles are not those of closed, oriented
/// surfaces.
fn find_twins(corners: &[u32], stars: &Stars) -> Option<IdVec<HalfEdgeId, Side>> {
    let unknown = || AtomicU32::new(HalfEdgeId::NONE.0);
    let side = |h: usize| Growing { origin: VertexId(corners[h]), twin: unknown() };
    let twins = Twins { corners, stars, sides: collect(corners.len(), side) };
    let found = map(ranges(stars.ends.len() - 1), |centres| twins.find_round(centres));
    if found.contains(&None) {
        return None;
    }
    let grown =
        |side: Growing| Side { origin: side.origin, twin: HalfEdgeId(side.twin.into_inner()) };
    Some(twins.sides.into_iter().map(grown).collect::<Vec<_>>().into())
}

/// A [`Side`] on its way.
struct Growing {
    origin: VertexId,
    twin: AtomicU32,
}

/// Twins on their way into the half-edges.
///
/// Each is written once, by the thread that has the vertex to which its half-edge leads, and read
/// by that thread alone until all is done: no order between threads is needed.
struct Twins<'a> {
    corners: &'a [u32],
    stars: &'a Stars,
    sides: Vec<Growing>,
}

impl Twins<'_> {
    /// Finds the twins of all half-edges that lead to `centres`, or `None` at the first broken law.
    fn find_round(&self, centres: Range<usize>) -> Option<()> {
        // Entry w is the last half-edge found that leads to w. It belongs to the current star if
        // and only if it leaves the current centre, so nothing is cleared between stars.
        let mut leads_to = vec![HalfEdgeId::NONE; self.stars.ends.len() - 1];
        centres.into_iter().try_for_each(|centre| self.find_at(centre as u32, &mut leads_to))
    }

    fn find_at(&self, centre: u32, leads_to: &mut [HalfEdgeId]) -> Option<()> {
        let star = self.stars.of(centre as usize);
        for &h in star {
            let entry = &mut leads_to[self.origin(h.next()) as usize];
            let repeated = *entry != HalfEdgeId::NONE && self.origin(*entry) == centre;
            if repeated || self.origin(h.next()) == centre {
                return None;
            }
            *entry = h;
        }
        for &h in star {
            let incoming = h.prev();
            let outgoing = leads_to[self.origin(incoming) as usize];
            if outgoing == HalfEdgeId::NONE || self.origin(outgoing) != centre {
                return None;
            }
            self.sides[incoming.index()].twin.store(outgoing.0, Ordering::Relaxed);
        }
        self.is_one_fan(star).then_some(())
    }

    /// Returns whether turning about the centre of `star` passes all its triangles, at least three.
    fn is_one_fan(&self, star: &[HalfEdgeId]) -> bool {
        let Some(&first) = star.first() else { return true };
        let mut h = self.twin(first.prev());
        let mut turned = 1;
        // Where an edge is doubled the walk may never come back to `first`.
        while h != first && turned < star.len() {
            h = self.twin(h.prev());
            turned += 1;
        }
        h == first && turned == star.len() && turned >= 3
    }

    #[inline]
    fn origin(&self, h: HalfEdgeId) -> u32 {
        self.corners[h.index()]
    }

    #[inline]
    fn twin(&self, h: HalfEdgeId) -> HalfEdgeId {
        HalfEdgeId(self.sides[h.index()].twin.load(Ordering::Relaxed))
    }
}

/// Counts components: every triangle joins the sets of its corners.
fn count_components(corners: &[u32], vertices: usize, unreferenced: usize) -> usize {
    let mut sets = DisjointSets::new(vertices);
    let mut components = vertices - unreferenced;
    for &[a, b, c] in corners.as_chunks::<3>().0 {
        components -= usize::from(sets.join(a, b)) + usize::from(sets.join(a, c));
    }
    components
}
