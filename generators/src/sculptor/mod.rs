//! A mutable closed triangulation for building test surfaces step by step.
//!
//! Every operation takes any `u32` as its place, modulo the number of elements, and leaves a valid
//! simple closed oriented triangulation. A property test can therefore generate and shrink plain
//! lists of [`Operation`]s without ever leaving the surfaces under test.
//!
//! The implementation is deliberately independent of any library it is used to test.

mod half_edges;
mod surgery;
mod twins;

#[cfg(test)]
mod tests;

use crate::surface::Surface;
use half_edges::{HalfEdge, previous};

pub use half_edges::Sculptor;

/// One edit of a surface; the number is taken modulo the number of faces or half-edges.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operation {
    /// [`Sculptor::split_face`] of a face.
    SplitFace(u32),
    /// [`Sculptor::split_edge`] of a half-edge.
    SplitEdge(u32),
    /// [`Sculptor::flip`] of a half-edge; nothing happens if that is not possible.
    Flip(u32),
}

impl Sculptor {
    /// A copy of `surface`, ready for editing. O(n log n).
    ///
    /// # Panics
    /// If `surface` is not simple, closed and consistently oriented with one fan of triangles at
    /// each vertex, or has no triangles, or its half-edges do not fit a `u32`.
    pub fn from(surface: &Surface) -> Self {
        assert!(!surface.triangles.is_empty(), "a closed surface has triangles");
        let half_edges = twins::match_half_edges(surface.triangles.as_flattened());
        twins::assert_one_fan_each(&half_edges, surface.positions.len());
        Self { positions: surface.positions.clone(), half_edges }
    }

    /// The number of faces. O(1).
    pub fn face_count(&self) -> u32 {
        self.half_edge_count() / 3
    }

    /// The number of half-edges, twice the number of edges. O(1).
    pub fn half_edge_count(&self) -> u32 {
        self.half_edges.len() as u32
    }

    /// Does one edit. Costs what the operation costs.
    pub fn apply(&mut self, operation: Operation) {
        match operation {
            Operation::SplitFace(face) => self.split_face(face),
            Operation::SplitEdge(half_edge) => self.split_edge(half_edge),
            Operation::Flip(half_edge) => {
                self.flip(half_edge);
            }
        }
    }

    /// Puts a new vertex of degree 3 at the centroid of a face, which becomes three. O(1).
    ///
    /// # Panics
    /// If the half-edges no longer fit a `u32`.
    pub fn split_face(&mut self, face: u32) {
        let h = self.first_half_edge(face);
        self.insert_vertex(h, self.centroid(h));
    }

    /// Puts a new vertex of degree 4 in the middle of an edge; its two triangles become four.
    /// O(1).
    ///
    /// # Panics
    /// If the half-edges no longer fit a `u32`.
    pub fn split_edge(&mut self, half_edge: u32) {
        let h = self.half_edge(half_edge);
        let middle = self.middle(h);
        // A vertex beside the edge, then the edge flipped towards it: legal, because the new
        // vertex has no neighbours but the corners of its face.
        self.insert_vertex(h, middle);
        self.turn_edge(h);
    }

    /// Replaces an edge by the other diagonal of its two triangles, unless that diagonal is
    /// already an edge; returns whether it did. O(smaller degree of the two new ends).
    ///
    /// An edge with an end of degree 3 is never flipped: the neighbours of that end are joined to
    /// each other already. So no degree falls below 3.
    pub fn flip(&mut self, half_edge: u32) -> bool {
        let h = self.half_edge(half_edge);
        let possible = !self.are_joined(previous(h), previous(self.twin(h)));
        if possible {
            self.turn_edge(h);
        }
        possible
    }

    /// Connected sum: glues `other` on along its first face and a face of this surface, both of
    /// which disappear. The genera add up. O(m log m) for `other` of size m.
    ///
    /// The copy of `other` is moved so that the centroids of the two faces coincide; the glued
    /// corners stay where they are on this surface. Joining a tetrahedron is a face split, with
    /// the new vertex in another place.
    ///
    /// # Panics
    /// If [`Sculptor::from`] would refuse `other`, or the half-edges no longer fit a `u32`.
    pub fn join(&mut self, other: &Surface, face: u32) {
        let other = Self::from(other);
        let h = self.first_half_edge(face);
        let names = self.adopt_vertices(&other, h);
        // Where half-edge 0 of `other` would be; its face 0 itself is left out.
        let offset = self.reserve(other.half_edges.len() - 3) - 3;
        self.half_edges.extend(other.half_edges[3..].iter().map(|theirs| HalfEdge {
            origin: names[theirs.origin as usize],
            twin: theirs.twin + offset,
        }));
        // The two faces are seen from opposite sides: the edges of one follow each other in
        // the reverse order of those of the other.
        for (mine, theirs) in [(0, 0), (1, 2), (2, 1)] {
            self.link(self.twin(h + mine), other.twin(theirs) + offset as usize);
        }
        self.remove_face(h);
    }

    /// Renumbers vertices and faces at random and turns the corners of each face by a random
    /// amount; the surface stays the same. `below(n)` is a uniform draw from `0..n`. O(n).
    pub fn relabel(&mut self, below: &mut dyn FnMut(u32) -> u32) {
        let new_vertex = permutation(self.positions.len() as u32, below);
        let new_face = permutation(self.face_count(), below);
        let mut new_half_edge = Vec::with_capacity(self.half_edges.len());
        for face in new_face {
            let turn = below(3);
            new_half_edge.extend([0, 1, 2].map(|corner| 3 * face + (corner + turn) % 3));
        }
        let old = self.clone();
        for (v, &position) in old.positions.iter().enumerate() {
            self.positions[new_vertex[v] as usize] = position;
        }
        for (h, &new) in new_half_edge.iter().enumerate() {
            self.half_edges[new as usize] = HalfEdge {
                origin: new_vertex[old.origin(h) as usize],
                twin: new_half_edge[old.twin(h)],
            };
        }
    }

    /// A copy of the surface as plain arrays. O(n).
    pub fn surface(&self) -> Surface {
        self.clone().into_surface()
    }

    /// The surface with each face cut in four at the middles of its edges. Old vertices keep their
    /// numbers and degrees, new ones follow and have degree 6. O(n).
    ///
    /// # Panics
    /// If the vertices of the result do not fit a `u32`.
    pub fn subdivided(&self) -> Surface {
        let mut positions = self.positions.clone();
        let mut middle = vec![0; self.half_edges.len()];
        for h in (0..middle.len()).filter(|&h| h < self.twin(h)) {
            let new = u32::try_from(positions.len()).expect("the vertices of a surface fit a u32");
            [middle[h], middle[self.twin(h)]] = [new; 2];
            positions.push(self.middle(h));
        }
        let cut = |first: usize| {
            let sides = [first, first + 1, first + 2];
            let at_corner = |h: usize| [self.origin(h), middle[h], middle[previous(h)]];
            let [a, b, c] = sides.map(at_corner);
            [a, b, c, sides.map(|h| middle[h])]
        };
        let triangles = (0..self.half_edges.len()).step_by(3).flat_map(cut).collect();
        Surface { positions, triangles }
    }

    /// The surface as plain arrays. O(n).
    pub fn into_surface(self) -> Surface {
        let (faces, _) = self.half_edges.as_chunks();
        let triangles = faces.iter().map(|face: &[HalfEdge; 3]| face.map(|side| side.origin));
        Surface { triangles: triangles.collect(), positions: self.positions }
    }
}

/// The numbers `0..n` in random order (Fisher and Yates).
fn permutation(n: u32, below: &mut dyn FnMut(u32) -> u32) -> Vec<u32> {
    let mut numbers: Vec<_> = (0..n).collect();
    for i in (1..n).rev() {
        numbers.swap(i as usize, below(i + 1) as usize);
    }
    numbers
}
