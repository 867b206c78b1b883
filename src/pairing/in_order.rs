//! Pairs in the order of the triangles, where that leaves none unpaired.

use crate::dual::{Matching, Sides};
use crate::triangulation::TriangleId;

/// Pairs each triangle with the next unpaired one of its neighbours, in the order of the triangles.
///
/// Ends as soon as a triangle has no unpaired neighbour: on irregular meshes after a few hundred
/// triangles. Then all are unpaired as before, and false is returned. It succeeds where the
/// triangles come from a mesh of quads and the halves of each follow each other, as most programs
/// write them: then the pairs are these quads. O(n).
pub(super) fn pair_in_order(graph: &impl Sides, matching: &mut Matching) -> bool {
    for f in (0..matching.len()).map(TriangleId::new) {
        if matching.is_paired(f) {
            continue;
        }
        let sides = graph.sides_or_none(f).into_iter();
        let is_free = |g: &TriangleId| *g != TriangleId::NONE && !matching.is_paired(*g);
        match sides.filter(is_free).min() {
            Some(next) => matching.pair_unpaired(f, next),
            None => {
                (0..f.index()).for_each(|before| matching.unpair(TriangleId::new(before)));
                return false;
            }
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use triquad_generators::grids;

    use super::*;
    use crate::DualGraph;
    use crate::samples::triangulation;

    #[test]
    fn the_halves_of_quads_find_each_other() {
        let torus = grids::torus(9, 14);
        let graph = DualGraph::new(&triangulation(&torus));
        let mut matching = Matching::empty(graph.len());
        assert!(pair_in_order(&graph, &mut matching));
        for (f, pair) in torus.triangles.as_chunks::<2>().0.iter().enumerate() {
            assert_eq!(matching.mate(TriangleId::new(2 * f)), Some(TriangleId::new(2 * f + 1)));
            let common = pair[0].iter().filter(|v| pair[1].contains(v)).count();
            assert_eq!(common, 2);
        }
    }

    #[test]
    fn a_triangle_that_would_stay_alone_ends_it() {
        let path = |[a, b, c, d]: [u32; 4]| {
            let graph = DualGraph::from_edges(4, &[(a, b), (b, c), (c, d)]).unwrap();
            let mut matching = Matching::empty(4);
            (pair_in_order(&graph, &mut matching), matching.unpaired_count())
        };
        assert_eq!(path([0, 1, 2, 3]), (true, 0));
        // The pair of 0 and 1 in the middle leaves both ends alone.
        assert_eq!(path([2, 0, 1, 3]), (false, 4));
    }
}
