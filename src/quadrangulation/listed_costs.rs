//! Costs that are given edge by edge.

use crate::counted::counted;
use crate::triangulation::Surface;

/// A list of costs that does not have one for each edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "{} given for {}",
    counted(*.given, "cost is", "costs are"),
    counted(*.edges, "edge", "edges")
)]
pub struct CostCountError {
    /// Number of costs.
    pub given: usize,
    /// Number of edges of the mesh.
    pub edges: usize,
}

/// Returns for each side of each triangle the cost of its edge in a list.
///
/// The list is in the order of [`Surface::edges`]: that in which the triangles first pass the
/// edges. Edges on the boundary are in it, and their costs do not matter. O(n).
///
/// # Errors
/// There is not one cost for each edge.
pub fn listed_costs(surface: &impl Surface, list: &[i32]) -> Result<Vec<[i32; 3]>, CostCountError> {
    let edges = surface.edges().count();
    if edges != list.len() {
        return Err(CostCountError { given: list.len(), edges });
    }
    let mut costs = vec![[0; 3]; surface.triangle_count()];
    for (side, &cost) in surface.edges().zip(list) {
        for h in [Some(side), surface.across(side)].into_iter().flatten() {
            costs[h.triangle().index()][h.index() % 3] = cost;
        }
    }
    Ok(costs)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Mesh;
    use crate::triangulation::Triangulation;

    #[test]
    fn edges_are_numbered_as_the_triangles_first_pass_them() {
        let positions = vec![[0.0; 3]; 4];
        let triangles = vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
        let mesh = Mesh::from_triangles(positions, triangles);
        let surface = Triangulation::build(&mesh).unwrap();
        // 0-2, 2-1, 1-0; then 1-3, 3-0; then 2-3.
        let costs = listed_costs(&surface, &[10, 11, 12, 13, 14, 15]);
        let expected = vec![[10, 11, 12], [12, 13, 14], [11, 15, 13], [10, 14, 15]];
        assert_eq!(costs, Ok(expected));
        let error = listed_costs(&surface, &[1; 5]).unwrap_err();
        assert_eq!(error, CostCountError { given: 5, edges: 6 });
    }
}
