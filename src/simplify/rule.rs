//! The two rules of simplification: where an edge goes, and when.

use super::key;
use super::placement::{Placement, Point};
use crate::triangulation::{HalfEdgeId, IdVec, ShrinkingTriangulation, VertexId};

/// The order in which edges are contracted, and what else refuses one than the link condition.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Rule {
    /// By quadric error and, where it is equal, length, shuffled among the nearly equal. Each edge
    /// goes to its best point. Triangles that would turn over or become needles and vertices of
    /// large degree are put off.
    #[default]
    Guarded,
    /// By quadric error alone, in the order of the file where it is equal. Each edge goes to its
    /// better end. The link condition alone refuses. The hierarchies of the papers' boxes are made
    /// so; degrees reach some hundreds.
    Plain,
}

/// Returns the key of an edge that has not been refused.
#[inline]
pub(super) fn price(
    rule: Rule,
    k: &ShrinkingTriangulation,
    points: &IdVec<VertexId, Point>,
    h: HalfEdgeId,
) -> u32 {
    let cost = placement(rule, k, points, h).cost;
    match rule {
        Rule::Guarded => key::shuffled(cost, h.index()),
        Rule::Plain => key::plain(cost),
    }
}

/// Returns the place by `rule` of the vertex that the edge of `h` becomes.
#[inline]
pub(super) fn placement(
    rule: Rule,
    k: &ShrinkingTriangulation,
    points: &IdVec<VertexId, Point>,
    h: HalfEdgeId,
) -> Placement {
    let [u, v] = [k.origin(h), k.destination(h)].map(|end| &points[end]);
    match rule {
        Rule::Guarded => Placement::best(u, v),
        Rule::Plain => Placement::cheaper_end(u, v),
    }
}
