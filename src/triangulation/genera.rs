//! The genus of every component of a mesh of surfaces, with boundary or without.
//!
//! A component with Euler characteristic χ and b boundary loops becomes a closed surface when b
//! discs are glued in. Then χ + b = 2 − 2 g for g handles, or 2 − k for k cross-caps.

use super::face_sides::SidesByEdge;
use crate::disjoint_sets::DisjointSets;
use crate::mesh::Faces;

/// Genera, summed over the components.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Genera {
    /// Handles of the two-sided components.
    pub(super) handles: usize,
    /// Cross-caps of the one-sided components.
    pub(super) cross_caps: usize,
}

impl Genera {
    /// Counts, given some face of every one-sided component. O(n α).
    pub(super) fn new(
        faces: &Faces,
        edges: &SidesByEdge,
        one_sided: &[u32],
        vertices: usize,
    ) -> Self {
        let mut sets = DisjointSets::new(vertices);
        let mut loops = DisjointSets::new(vertices);
        // At the root of each component, χ + b; at other vertices 0, once all is counted.
        let mut euler = vec![0_i64; vertices];
        let mut is_used = vec![false; vertices];
        for face in faces.iter().filter(|face| face.len() >= 3) {
            for &v in face {
                sets.join(face[0], v);
                euler[v as usize] += i64::from(!std::mem::replace(&mut is_used[v as usize], true));
            }
            euler[face[0] as usize] += 1;
        }
        for edge in edges.groups() {
            let ends = [edge[0].low, edge[0].high];
            euler[ends[0] as usize] -= 1;
            if edge.len() == 1 {
                // A loop has as many vertices as edges that join two sets, and one that does not.
                euler[ends[0] as usize] += i64::from(!loops.join(ends[0], ends[1]));
            }
        }
        let mut is_one_sided = vec![false; vertices];
        for &face in one_sided {
            is_one_sided[sets.find(faces[face as usize][0]) as usize] = true;
        }
        let mut by_component = vec![0_i64; vertices];
        (0..vertices).for_each(|v| by_component[sets.find(v as u32) as usize] += euler[v]);
        let mut genera = Self { handles: 0, cross_caps: 0 };
        for v in (0..vertices).filter(|&v| is_used[v] && sets.find(v as u32) == v as u32) {
            let missing = (2 - by_component[v]) as usize;
            if is_one_sided[v] {
                genera.cross_caps += missing;
            } else {
                genera.handles += missing / 2;
            }
        }
        genera
    }
}

#[cfg(test)]
mod tests {
    use crate::mesh::Mesh;
    use crate::triangulation::Survey;
    use triquad_generators::Surface;
    use triquad_generators::testing::{beside, random_of};
    use triquad_generators::{classic, grids, random::Mix};

    fn survey(surface: &Surface) -> Survey {
        Survey::new(&Mesh::from_triangles(surface.positions.clone(), surface.triangles.clone()))
    }

    /// Genus, that with holes filled, non-orientable genus, handles of two-sided and cross-caps of
    /// one-sided components.
    fn genera(surface: &Surface) -> [Option<usize>; 5] {
        let survey = survey(surface);
        let genus = [survey.genus(), survey.filled_genus(), survey.non_orientable_genus()];
        [genus[0], genus[1], genus[2], survey.handles, survey.cross_caps]
    }

    #[test]
    fn classical_surfaces_have_their_genera() {
        let [plane, bottle] = [classic::projective_plane(), classic::klein_bottle(5, 4)];
        assert_eq!(genera(&plane), [None, None, Some(1), Some(0), Some(1)]);
        assert_eq!(genera(&bottle), [None, None, Some(2), Some(0), Some(2)]);
        assert_eq!(genera(&classic::moebius_strip(7)), [None, None, Some(1), Some(0), Some(1)]);
        assert_eq!(genera(&grids::torus(5, 4)), [Some(1), Some(1), None, Some(1), Some(0)]);
    }

    #[test]
    fn components_and_holes_are_counted_one_by_one() {
        let mut three = random_of(3, 60, Mix::Balanced, 1);
        three.triangles.truncate(three.triangles.len() - 1);
        assert_eq!(genera(&three), [None, Some(3), None, Some(3), Some(0)]);
        let mixed = beside(&beside(&three, &classic::klein_bottle(5, 4)), &grids::torus(5, 4));
        assert_eq!(genera(&mixed), [None, Some(4), Some(2), Some(4), Some(2)]);
    }

    #[test]
    fn what_is_no_surface_has_no_genus() {
        let mut torn = grids::torus(5, 4);
        torn.triangles.push(torn.triangles[0]);
        assert_eq!(genera(&torn), [None; 5]);
    }
}
