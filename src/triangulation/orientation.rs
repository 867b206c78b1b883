//! True if the faces of a mesh can be oriented alike, and which ones to flip for it.

use super::face_sides::{FaceSide, SidesByEdge, faces_of};
use super::laws::{Element, Law};
use super::violations::Violations;
use crate::disjoint_sets::ParitySets;
use crate::mesh::Mesh;

/// Faces to flip so that neighbours agree.
pub(super) struct Orientation {
    pub(super) faces_to_flip: Vec<usize>,
    /// Some faces of one-sided components, at least one of each.
    pub(super) one_sided: Vec<u32>,
}

impl Orientation {
    /// Examines all edges of two faces. O(n α).
    pub(super) fn new(list: &Mesh, edges: &SidesByEdge, violations: &mut Violations) -> Self {
        let corners = list.faces().corners();
        let agree = |one: &FaceSide, other: &FaceSide| {
            corners[one.from as usize] != corners[other.from as usize]
        };
        let mut sets = ParitySets::new(list.faces().len());
        let mut twisted = Vec::new();
        let mut disagreeing = Vec::new();
        for (one, other) in edges.pairs() {
            let flip = !agree(one, other);
            if !sets.join(one.face, other.face, flip) {
                twisted.push((one, other));
            }
            if flip {
                disagreeing.push((one, other));
            }
        }
        let mut add = |law, (one, other): (&FaceSide, &FaceSide)| {
            let edge = Element::Edge(one.low, one.high);
            violations.add_at(law, edge, || faces_of([one, other], list));
        };
        twisted.sort_unstable_by_key(|(one, _)| one.from);
        for &sides in &twisted {
            add(Law::Orientable, sides);
        }
        let one_sided: Vec<u32> = twisted.iter().map(|(one, _)| one.face).collect();
        let mut is_one_sided = vec![false; list.faces().len()];
        for &face in &one_sided {
            is_one_sided[sets.find(face).0 as usize] = true;
        }
        disagreeing.retain(|(one, _)| !is_one_sided[sets.find(one.face).0 as usize]);
        disagreeing.sort_unstable_by_key(|(one, _)| one.from);
        for sides in disagreeing {
            add(Law::ConsistentOrientation, sides);
        }
        Self { faces_to_flip: fewest_flips(&mut sets, list.faces().len()), one_sided }
    }
}

/// Returns in each set the faces of the rarer parity, or on a tie those unlike the first face.
fn fewest_flips(sets: &mut ParitySets, faces: usize) -> Vec<usize> {
    let mut balance = vec![0i64; faces];
    for face in 0..faces as u32 {
        let (root, odd) = sets.find(face);
        balance[root as usize] += if odd { -1 } else { 1 };
    }
    let mut first_parity = vec![None; faces];
    let mut flips = Vec::new();
    for face in 0..faces as u32 {
        let (root, odd) = sets.find(face);
        let first = *first_parity[root as usize].get_or_insert(odd);
        let keep_odd = match balance[root as usize] {
            0 => first,
            balance => balance < 0,
        };
        if odd != keep_odd {
            flips.push(face as usize);
        }
    }
    flips
}
