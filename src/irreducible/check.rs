//! Checks of results, from their triangles alone.

use crate::counted::counted;
use crate::mesh::Mesh;
use crate::triangulation::{Survey, Triangulation, VertexId};

/// Reason why a result is no irreducible triangulation.
#[derive(Clone, Debug, thiserror::Error)]
#[non_exhaustive]
pub enum IrreducibleError {
    /// The result breaks a law.
    #[error("what is left is no triangulation: {0}")]
    Broken(Box<Survey>),
    /// The result triangulates another surface.
    #[error(
        "what is left has {} of genus {genus} in all",
        counted(*.components, "component", "components")
    )]
    OtherSurface {
        /// Connected components.
        components: usize,
        /// Genus, summed over them.
        genus: usize,
    },
    /// An edge could still be contracted.
    #[error(
        "the edge from vertex {} to vertex {} of what is left could still be contracted",
        .0[0], .0[1]
    )]
    Contractible([usize; 2]),
}

/// Checks that `list` is an irreducible triangulation with as many `components` and the `genus` of
/// what it was made from. Shares nothing with the algorithms but the laws.
///
/// # Errors
/// The first defect found; vertices count from 1.
///
/// # Cost
/// O(d d') for an edge whose ends have d and d' neighbours: what is left is small.
pub fn check_irreducible(
    list: &Mesh,
    components: usize,
    genus: usize,
) -> Result<(), IrreducibleError> {
    let left = Triangulation::build(list).map_err(IrreducibleError::Broken)?;
    if (left.component_count(), left.genus()) != (components, genus) {
        let (components, genus) = (left.component_count(), left.genus());
        return Err(IrreducibleError::OtherSurface { components, genus });
    }
    match contractible_edge(&left) {
        Some(ends) => Err(IrreducibleError::Contractible(ends.map(|v| v.index() + 1))),
        None => Ok(()),
    }
}

/// Returns an edge whose ends have no common neighbours but its two apexes and are not in a
/// tetrahedron (Proposition 3.1 of Lemos et al.).
fn contractible_edge(t: &Triangulation) -> Option<[VertexId; 2]> {
    let mut neighbours: Vec<Vec<VertexId>> = vec![Vec::new(); t.vertex_id_count()];
    for f in t.triangles() {
        let [a, b, c] = t.corners(f);
        for (from, to) in [(a, b), (b, c), (c, a)] {
            neighbours[from.index()].push(to);
        }
    }
    for f in t.triangles() {
        let [a, b, c] = t.corners(f);
        for (u, v) in [(a, b), (b, c), (c, a)] {
            let [near, far] = [u, v].map(|end| &neighbours[end.index()]);
            let common = far.iter().filter(|w| near.contains(w)).count();
            if common == 2 && near.len().max(far.len()) > 3 {
                return Some([u, v]);
            }
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use triquad_generators::{Surface, classic};

    fn verdict(surface: &Surface, genus: usize) -> Result<(), IrreducibleError> {
        let list = Mesh::from_triangles(surface.positions.clone(), surface.triangles.clone());
        check_irreducible(&list, 1, genus)
    }

    #[test]
    fn the_smallest_are_irreducible_and_others_are_not() {
        assert!(verdict(&classic::tetrahedron(), 0).is_ok());
        assert!(verdict(&classic::seven_vertex_torus(), 1).is_ok());
        assert!(matches!(
            verdict(&classic::octahedron(), 0),
            Err(IrreducibleError::Contractible(_))
        ));
        assert!(matches!(
            verdict(&classic::tetrahedron(), 1),
            Err(IrreducibleError::OtherSurface { components: 1, genus: 0 })
        ));
        let mut open = classic::tetrahedron();
        open.triangles.pop();
        assert!(matches!(verdict(&open, 0), Err(IrreducibleError::Broken(_))));
    }
}
