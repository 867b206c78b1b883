//! The sides of the faces of any mesh, those of an edge next to each other.

use super::laws::{Element, Law};
use super::violations::Violations;
use crate::mesh::Mesh;

/// One side of an edge: corner `from` of a face and the next corner `to` of the same face.
#[derive(Clone, Copy)]
pub(super) struct FaceSide {
    pub(super) low: u32,
    pub(super) high: u32,
    /// Positions in the list of all corners.
    pub(super) from: u32,
    pub(super) to: u32,
    pub(super) face: u32,
}

/// All sides of sound faces, those of the same edge next to each other.
pub(super) struct SidesByEdge(Vec<FaceSide>);

impl SidesByEdge {
    pub(super) fn gather(list: &Mesh, sound: &[bool]) -> Self {
        let corners = list.faces().corners();
        let mut sides = Vec::with_capacity(corners.len());
        for face in (0..sound.len()).filter(|&face| sound[face]) {
            let range = list.faces().range(face);
            for from in range.clone() {
                let to = if from + 1 == range.end { range.start } else { from + 1 };
                let (a, b) = (corners[from], corners[to]);
                let (low, high) = (a.min(b), a.max(b));
                sides.push(FaceSide {
                    low,
                    high,
                    from: from as u32,
                    to: to as u32,
                    face: face as u32,
                });
            }
        }
        sides.sort_unstable_by_key(|side| (side.low, side.high, side.from));
        Self(sides)
    }

    /// Returns all sides.
    pub(super) fn all(&self) -> &[FaceSide] {
        &self.0
    }

    /// Iterates over the sides of each edge.
    pub(super) fn groups(&self) -> impl Iterator<Item = &[FaceSide]> {
        self.0.chunk_by(|a, b| (a.low, a.high) == (b.low, b.high))
    }

    /// Pairs of sides of the edges that belong to exactly two faces.
    pub(super) fn pairs(&self) -> impl Iterator<Item = (&FaceSide, &FaceSide)> {
        self.groups().filter_map(|group| match group {
            [one, other] => Some((one, other)),
            _ => None,
        })
    }

    /// Reports edges with one face or more than two, those of the lowest face first.
    pub(super) fn check_degrees(&self, list: &Mesh, violations: &mut Violations) {
        let mut broken: Vec<&[FaceSide]> = self.groups().filter(|group| group.len() != 2).collect();
        broken.sort_unstable_by_key(|group| group[0].from);
        for group in broken {
            let law = if group.len() == 1 { Law::NoBoundary } else { Law::AtMostTwoFaces };
            let edge = Element::Edge(group[0].low, group[0].high);
            violations.add_at(law, edge, || faces_of(group, list));
        }
    }
}

/// Returns the faces of some sides, by their index in the file.
pub(super) fn faces_of<'s>(
    sides: impl IntoIterator<Item = &'s FaceSide>,
    list: &Mesh,
) -> Vec<usize> {
    sides.into_iter().map(|side| list.face_in_file(side.face as usize)).collect()
}
